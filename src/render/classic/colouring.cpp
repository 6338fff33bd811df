#include "render/classic/colouring.h"

#include "base/pixels.h"

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

Colouring::Colouring(const World& world, const Map& map, const View& view, const ColumnRay& ray,
                     const RenderOptions& options, const ClassicOptions& classic)
    : world_(world),
      map_(map),
      view_(view),
      ray_(ray),
      options_(options),
      classic_(classic),
      lighting_(map, options) {}

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
                   .vReversed = surface.face == Face::bottom,
                   .light = surface.light,
                   .glow = surface.glow};
    if (!surface.isUpright()) {
        texel.plain =
            surface.what != FilledRows::What::ceiling && classic_.roofs == ClassicRoofs::flat;
        Shown roof = shown(surface.what, texel);
        roof.mirror = mirrorStrength(surface.mirror);
        if (roof.mirror > 0) roof.colour |= kOpaque;
        if (classic_.flippedMirrors) roof.mirror = 0;
        return roof;
    }

    const double height = view_.eyeZ + depth * surface.stretch * view_.upwardSlopeAt(y);
    texel.vReversed = false;
    texel.v = (surface.textureTop - height) / (surface.textureTop - surface.textureBottom);
    if (surface.textureRise > 0.0) {
        texel.v = std::clamp(texel.v, 0.0, 1.0) + surface.textureRise;
        if (texel.v >= 1.0) texel.v -= 1.0;
    }
    if (surface.what == FilledRows::What::object) {
        texel.u = surface.u;
        texel.side = surface.side;
    } else {
        if (surface.face == Face::east || surface.face == Face::west) texel.u = south;
        texel.uReversed = !classic_.mirroredTextures &&
                          (surface.face == Face::north || surface.face == Face::east);
    }
    return shown(surface.what, texel);
}

Shown Colouring::ofBackground(double y) const {
    const double slope = view_.upwardSlopeAt(y);
    if (slope >= 0.0) return {.what = FilledRows::What::sky, .colour = ofSky(slope)};
    const double depth = view_.depthOfPlane(0.0, y);
    if (!(depth <= map_.far)) return ofHaze();
    const double along = depth / ray_.depthPerAlong;
    const double east = view_.eyeX + along * ray_.x;
    const double south = view_.eyeY + along * ray_.y;
    const int tileX = static_cast<int>(std::floor(east));
    const int tileY = static_cast<int>(std::floor(south));
    const TextureId texture = map_.contains(tileX, tileY)
                                  ? map_.floor.tiles[map_.tileIndex(tileX, tileY)]
                                  : map_.floor.texture;
    Shown floor = shown(FilledRows::What::floor, {.texture = texture,
                                                  .depth = depth,
                                                  .u = east - tileX,
                                                  .v = south - tileY,
                                                  .light = map_.floor.light,
                                                  .glow = map_.floor.glow});
    floor.mirror = mirrorStrength(map_.floor.mirror);
    // Below the floor is haze, but a mirror has no holes
    floor.colour =
        floor.mirror > 0 ? floor.colour | kOpaque : laidOver(floor.colour, toPixel(map_.haze));
    return floor;
}

Shown Colouring::ofHaze() const {
    return {.what = FilledRows::What::haze, .colour = toPixel(map_.haze) | kOpaque};
}

bool Colouring::isSeeThrough(const Surface& surface) const {
    if (surface.what == FilledRows::What::object) return true;
    return surface.texture != kNoTexture && world_.textures[surface.texture].seeThrough;
}

int Colouring::mirrorStrength(int strength) const {
    return static_cast<int>(std::min(255.0, std::floor(strength * options_.mirrors + 0.5)));
}

Pixel Colouring::ofSky(double slope) const {
    const Sky& sky = map_.sky;
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
    return sky.panorama.at(column, std::min(height - 1, static_cast<int>((1.0 - share) * height)));
}

Shown Colouring::shown(FilledRows::What what, const Texel& at) const {
    const bool plain = at.plain || !options_.textures;
    int width = 0;
    int height = 0;
    int detail = 0;
    const Pixel* texels = nullptr;  // column after column
    const auto use = [&](const auto& levels) -> const auto& {
        detail = plain ? static_cast<int>(levels.size()) - 1 : 0;
        return levels[static_cast<std::size_t>(detail)];
    };
    if (what == FilledRows::What::object) {
        const SpriteLevel& level = use(world_.sprites[at.texture].levelsAt(world_.steps, at.side));
        width = level.width;
        height = level.height;
        texels = level.texels.data();
    } else {
        const Texture& texture = world_.textures[at.texture];
        const TextureLevel& level = use(texture.levelsOf(texture.frameAt(world_.steps)));
        width = height = level.size;
        texels = level.texels.data();
    }
    // Rounding or a march's stride may put a fraction just outside [0, 1]
    const auto index = [](double fraction, int size, bool reversed) {
        const int i = std::min(size - 1, static_cast<int>(std::clamp(fraction, 0.0, 1.0) * size));
        return reversed ? size - 1 - i : i;
    };
    const int u = index(at.u, width, at.uReversed);
    const int v = index(at.v, height, at.vReversed);
    const Shade shade = lighting_.at(at.depth, at.light, at.glow);
    return {.what = what,
            .texture = at.texture,
            .texel = {at.depth, detail, u, v, shade.factor, shade.fog},
            .colour = shaded(texels[u * height + v], shade)};
}

Pixel Colouring::shaded(Pixel texel, const Shade& shade) const {
    const Colour from = toColour(texel);
    const Colour haze = toColour(lighting_.haze);
    const auto channel = [&](std::uint32_t c, std::uint32_t fogged) {
        const std::uint32_t lit = (c * shade.factor + 128) >> 8;
        return static_cast<std::uint8_t>((fogged * shade.fog + lit * (255 - shade.fog) + 127) /
                                         255);
    };
    return toPixel(
        {channel(from.r, haze.r), channel(from.g, haze.g), channel(from.b, haze.b), from.a});
}

}  // namespace slicecast::classic
