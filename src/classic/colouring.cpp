#include "classic/colouring.h"

#include "base/pixels.h"
#include "render/pixels/smooth_texels.h"

#include <algorithm>
#include <cmath>

namespace slicecast::classic {

Pixel laidOver(Pixel colour, Pixel behind) {
    const Colour over = toColour(colour);
    const Colour under = toColour(behind);
    const auto channel = [&](int c, int d) {
        return static_cast<std::uint8_t>((c * over.a + d * (255 - over.a) + 127) / 255);
    };
    return toPixel(
        {channel(over.r, under.r), channel(over.g, under.g), channel(over.b, under.b), 255});
}

Colouring::Colouring(const Palette& palette, int map, const View& view, const ColumnRay& ray)
    : palette_(palette),
      world_(palette.world),
      mapNumber_(map),
      map_(world_.maps[static_cast<std::size_t>(map)]),
      view_(view),
      ray_(ray),
      detail_(palette.options, view.distance / palette.classic.pixelSize),
      lighting_(map_, palette.options),
      lit_(palette.lit.of(map)) {
    lighting_.putInWater(palette.water, view.up < 0.0);
}

Shown Colouring::ofSurface(const Surface& surface, double y) const {
    if (surface.texture == kNoTexture) return ofHaze();
    const double depth = surface.depthAt(view_, ray_, y);
    const double along = surface.isUpright() ? surface.along : depth / ray_.depthPerAlong;
    const double east = view_.eyeX + along * ray_.x - surface.tileX;
    const double south = view_.eyeY + along * ray_.y - surface.tileY;
    Texel texel = {.texture = surface.texture,
                   .depth = depth,
                   .u = east,
                   .v = south,
                   .pictureV = south,
                   .slideU = surface.slideU,
                   .slideV = surface.slideV,
                   .vReversed = surface.face == Face::bottom,
                   .light = surface.light,
                   .glow = surface.glow,
                   .lit = surface.lit};
    if (!surface.isUpright()) {
        texel.plain = surface.what != FilledRows::What::ceiling &&
                      palette_.classic.roofs == ClassicRoofs::flat;
        Shown roof = shown(surface.what, texel, y);
        roof.mirror = mirrorStrength(surface.mirror);
        roof.ripples = surface.ripples;
        if (roof.mirror > 0) roof.colour |= kOpaque;
        if (palette_.classic.flippedMirrors) roof.mirror = 0;
        return roof;
    }

    const double height = view_.eyeZ + depth * surface.stretch * view_.upwardSlopeAt(y);
    texel.downwards = true;
    texel.vReversed = false;
    texel.pictureV = (surface.textureTop - height) / (surface.textureTop - surface.textureBottom);
    texel.v = texel.pictureV;
    if (surface.what == FilledRows::What::object) {
        texel.u = surface.u;
        texel.side = surface.side;
        texel.object = surface.object;
    } else {
        if (palette_.classic.stretched && !palette_.classic.oneLevel)
            texel.v = surface.lit.level + 1 - height;
        if (surface.face == Face::east || surface.face == Face::west) texel.u = south;
        texel.uReversed = !palette_.classic.mirroredTextures &&
                          (surface.face == Face::north || surface.face == Face::east);
    }
    return shown(surface.what, texel, y);
}

Shown Colouring::ofBackground(double y) const {
    const double slope = view_.upwardSlopeAt(y);
    if (slope >= 0.0) return {.what = FilledRows::What::sky, .colour = ofSky(slope, y)};
    const double depth = view_.depthOfPlane(0.0, y);
    if (!(depth <= map_.far)) return ofHaze();
    const double along = depth / ray_.depthPerAlong;
    const double east = view_.eyeX + along * ray_.x;
    const double south = view_.eyeY + along * ray_.y;
    const int tileX = static_cast<int>(std::floor(east));
    const int tileY = static_cast<int>(std::floor(south));
    const bool isOnMap = map_.contains(tileX, tileY);
    Shown floor = shown(
        FilledRows::What::floor,
        {.texture = isOnMap ? map_.floor.tiles[map_.tileIndex(tileX, tileY)] : map_.floor.texture,
         .depth = depth,
         .u = east - tileX,
         .v = south - tileY,
         .pictureV = south - tileY,
         .light = map_.floor.light,
         .glow = map_.floor.glow,
         .lit = isOnMap ? LitFaceAt{tileX, tileY, 0, LitFace::floor} : kOutside},
        y);
    floor.mirror = mirrorStrength(map_.floor.mirror);
    floor.ripples = map_.floor.ripples;
    // Below the floor is haze, but a mirror has no holes
    floor.colour =
        floor.mirror > 0 ? floor.colour | kOpaque : laidOver(floor.colour, lighting_.haze);
    return floor;
}

Shown Colouring::ofHaze() const {
    return {.what = FilledRows::What::haze, .colour = lighting_.haze | kOpaque};
}

bool Colouring::isSeeThrough(const Surface& surface) const {
    if (surface.what == FilledRows::What::object) return true;
    return surface.texture != kNoTexture && world_.textures[surface.texture].seeThrough;
}

int Colouring::mirrorStrength(int strength) const {
    return static_cast<int>(std::min(255.0, std::floor(strength * palette_.options.mirrors + 0.5)));
}

// Seen from water, it has the fog of the way to the surface.
Pixel Colouring::ofSky(double slope, double y) const {
    const Sky& sky = map_.sky;
    const auto inAir = [&] {
        if (sky.hasLayers()) {
            const int row = static_cast<int>(y / palette_.classic.pixelSize);
            return palette_.skies.at(mapNumber_, view_.up < 0.0, ray_.azimuthDegrees, row);
        }
        if (sky.kind == Sky::Kind::colour) return toPixel(sky.low);
        const double share = std::min(1.0, slope / sky.slope);
        if (sky.kind == Sky::Kind::gradient) {
            const auto blend = [share](int low, int high) {
                return static_cast<std::uint8_t>(std::floor(low + (high - low) * share + 0.5));
            };
            return toPixel({blend(sky.low.r, sky.high.r), blend(sky.low.g, sky.high.g),
                            blend(sky.low.b, sky.high.b), 255});
        }
        const double turn = ray_.azimuthDegrees / 360.0;
        const int width = sky.panorama.width;
        const int height = sky.panorama.height;
        const int column = std::min(width - 1, static_cast<int>((turn - std::floor(turn)) * width));
        return sky.panorama.at(column,
                               std::min(height - 1, static_cast<int>((1.0 - share) * height)));
    };
    return lighting_.inWater ? fogged(inAir(), mostFog(y)) : inAir();
}

// Where a row's ray leaves the eye's water, its fog ends.
std::uint32_t Colouring::mostFog(double y) const {
    const double slope = view_.upwardSlopeAt(y);
    if (!lighting_.inWater || view_.up < 0.0 || slope <= 0.0) return 255;
    return lighting_.fogAt(Coordinate{lighting_.surface}.value() / slope);
}

Shown Colouring::shown(FilledRows::What what, const Texel& at, double y) const {
    const bool isObject = what == FilledRows::What::object;
    int width = 0;
    int height = 0;
    int detail = 0;
    const Pixel* texels = nullptr;  // column after column
    const auto use = [&](const auto& levels, int size) -> const auto& {
        const int last = static_cast<int>(levels.size()) - 1;
        detail = at.plain ? last : detail_.levelAt(at.depth, size, last);
        return levels[static_cast<std::size_t>(detail)];
    };
    bool isSmooth = false;
    if (isObject) {
        const auto& levels = world_.sprites[at.texture].levelsAt(world_.steps, at.side);
        const SpriteLevel& level = use(levels, levels[0].height);
        width = level.width;
        height = level.height;
        texels = level.texels.data();
    } else {
        const Texture& texture = world_.textures[at.texture];
        const TextureLevel& level =
            use(texture.levelsOf(texture.frameAt(world_.steps)), texture.size());
        width = height = level.size;
        texels = level.texels.data();
        isSmooth = detail_.isSmooth(detail, at.depth, level.size);
    }

    // Rounding or a march's stride may put a fraction just outside [0, 1]. A texture that has moved
    // begins anew where it ends.
    const auto moved = [](double fraction, double by) {
        const double place = std::clamp(fraction, 0.0, 1.0) + by;
        return by == 0.0 ? place : place - std::floor(place);
    };
    const double byV = at.downwards ? at.slideV.value() : -at.slideV.value();
    const double u = moved(at.u, -at.slideU.value());
    const double v = moved(at.pictureV, byV);
    const auto index = [](double fraction, int size) {
        return std::min(size - 1, static_cast<int>(fraction * size));
    };
    const auto reversed = [](int i, int size, bool is) { return is ? size - 1 - i : i; };
    Shown found = {.what = what, .texture = at.texture};
    TracedTexel& texel = found.texel;
    texel.depth = at.depth;
    texel.detail = detail;
    texel.u = reversed(index(u, width), width, at.uReversed);
    texel.v = reversed(index(v, height), height, at.vReversed);
    const Shade shade = lighting_.at(at.depth, at.light, at.glow);
    texel.light = shade.factor;
    texel.fog = std::min(shade.fog, mostFog(y));
    Pixel colour = texels[texel.u * height + texel.v];
    // Light falls on the middles of texels, also where a picture is stretched or turned; on blended
    // ones it falls on the point itself
    const double litV = moved(at.v, byV);
    std::int32_t a = 0;
    std::int32_t b = 0;
    if (isSmooth) {
        const auto bits = [](double fraction) {
            return static_cast<std::uint32_t>(std::min(fraction * 4294967296.0, 4294967295.0));
        };
        colour = smoothTexel({texels, world_.textures[at.texture].levels[0].bits, at.uReversed,
                              at.vReversed, world_.textures[at.texture].seeThrough},
                             bits(u), bits(v));
        a = static_cast<std::int32_t>(bits(std::clamp(at.u, 0.0, 1.0)) >> 16);
        b = static_cast<std::int32_t>(bits(std::clamp(at.v, 0.0, 1.0)) >> 16);
        if (at.downwards) b = std::min(65535, 65536 - b);
    } else if (!isObject) {
        using Way = TexelAxis::Way;
        a = TexelAxis{Way::forward, at.slideU}.placeOf(index(u, width), width);
        b = TexelAxis{at.downwards ? Way::downward : Way::forward, at.slideV}.placeOf(
            index(litV, height), height);
    }
    texel.baked = bakedLight(at, a, b);
    found.colour = shaded(colour, texel);
    return found;
}

LightColour Colouring::bakedLight(const Texel& at, std::int32_t a, std::int32_t b) const {
    const LightColour none = TracedTexel().baked;
    if (lit_ == nullptr || at.glow) return none;
    if (at.object >= 0) return lit_->ofObject(at.object);
    const FaceNodes* const nodes = lit_->nodesOf(at.lit);
    return nodes != nullptr ? lightAt(*nodes, a, b) : none;
}

Pixel Colouring::shaded(Pixel texel, const TracedTexel& light) const {
    const Colour from = toColour(texel);
    const auto channel = [&](int c, int baked) {
        const auto lit = static_cast<std::uint32_t>((c * baked + 128) >> 8);
        return static_cast<std::uint8_t>((lit * light.light + 128) >> 8);
    };
    return fogged(toPixel({channel(from.r, light.baked[0]), channel(from.g, light.baked[1]),
                           channel(from.b, light.baked[2]), from.a}),
                  light.fog);
}

// Keeps the alpha.
Pixel Colouring::fogged(Pixel colour, std::uint32_t fog) const {
    const Colour from = toColour(colour);
    const Colour haze = toColour(lighting_.haze);
    const auto channel = [&](std::uint32_t c, std::uint32_t fogColour) {
        return static_cast<std::uint8_t>((fogColour * fog + c * (255 - fog) + 127) / 255);
    };
    return toPixel(
        {channel(from.r, haze.r), channel(from.g, haze.g), channel(from.b, haze.b), from.a});
}

}  // namespace slicecast::classic
