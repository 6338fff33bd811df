#include "render/classic/colouring.h"

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

Colouring::Colouring(const World& world, const Map& map, const View& view,
                     const RenderOptions& options)
    : world_(world), map_(map), view_(view), lighting_(map, options), textures_(options.textures) {}

Pixel Colouring::ofSurface(const Surface& surface, const ColumnRay& ray, double y) const {
    const double depth = surface.depthAt(view_, ray, y);
    const double along = surface.isSide() ? surface.along : depth / ray.depthPerAlong;
    const double east = view_.eyeX + along * ray.x - surface.tileX;
    const double south = view_.eyeY + along * ray.y - surface.tileY;
    if (!surface.isSide())
        return shaded(texel(surface.texture, east, south, false, surface.face == Face::bottom),
                      depth, surface.light, surface.glow);

    const double height = view_.eyeZ + depth * view_.upwardSlopeAt(y);
    const double u = surface.face == Face::north || surface.face == Face::south ? east : south;
    const double v = (surface.textureTop - height) / (surface.textureTop - surface.textureBottom);
    return shaded(texel(surface.texture, u, v,
                        surface.face == Face::north || surface.face == Face::east, false),
                  depth, surface.light, surface.glow);
}

Pixel Colouring::ofBackground(const ColumnRay& ray, double y) const {
    const double slope = view_.upwardSlopeAt(y);
    if (slope >= 0.0) return ofSky(ray, slope);
    const double depth = view_.depthOfPlane(0.0, y);
    if (!(depth <= map_.far)) return toPixel(map_.haze);
    const double along = depth / ray.depthPerAlong;
    const double east = view_.eyeX + along * ray.x;
    const double south = view_.eyeY + along * ray.y;
    const int tileX = static_cast<int>(std::floor(east));
    const int tileY = static_cast<int>(std::floor(south));
    const TextureId texture = map_.contains(tileX, tileY)
                                  ? map_.floor.tiles[map_.tileIndex(tileX, tileY)]
                                  : map_.floor.texture;
    const Pixel floor = shaded(texel(texture, east - tileX, south - tileY, false, false), depth,
                               map_.floor.light, map_.floor.glow);
    return laidOver(floor, toPixel(map_.haze));  // which is what lies below it
}

Pixel Colouring::ofSky(const ColumnRay& ray, double slope) const {
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
    const double turn = ray.azimuthDegrees / 360.0;
    const int width = sky.panorama.width;
    const int height = sky.panorama.height;
    const int column = std::min(width - 1, static_cast<int>((turn - std::floor(turn)) * width));
    return sky.panorama.at(column, std::min(height - 1, static_cast<int>((1.0 - share) * height)));
}

// A fraction just outside [0, 1], by a rounding or a march's stride, stands for the texture's edge.
Pixel Colouring::texel(TextureId texture, double u, double v, bool uReversed,
                       bool vReversed) const {
    const std::vector<TextureLevel>& levels =
        world_.textures[texture].levelsOf(world_.textures[texture].frameAt(world_.seconds));
    const TextureLevel& level = textures_ ? levels.front() : levels.back();
    const auto index = [&](double fraction, bool reversed) {
        const int i =
            std::min(level.size - 1, static_cast<int>(std::clamp(fraction, 0.0, 1.0) * level.size));
        return reversed ? level.size - 1 - i : i;
    };
    return level.texels[static_cast<std::size_t>((index(u, uReversed) << level.bits) +
                                                 index(v, vReversed))];
}

Pixel Colouring::shaded(Pixel texel, double depth, double faceLight, bool glow) const {
    const Shade shade = lighting_.at(depth, faceLight, glow);
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
