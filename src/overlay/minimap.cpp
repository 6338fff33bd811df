#include "overlay/minimap.h"

#include "base/angle.h"
#include "classic/level_ray.h"
#include "overlay/blend.h"
#include "overlay/layout.h"
#include "overlay/map_ray.h"
#include "overlay/minimap_marks.h"
#include "overlay/minimap_objects.h"
#include "overlay/minimap_tiles.h"
#include "overlay/minimap_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace slicecast {
namespace {

constexpr int kTilesAcross = 17;  // approximately
constexpr int kMarkedSide = 60;   // dots of the font; larger minimaps mark north and the levels
constexpr Colour kRay = {120, 230, 140, 150};
constexpr Colour kRayEnd = {190, 255, 200, 255};
constexpr SineCosine kNorth = {-1.0, 0.0};

int scaled(Coordinate coordinate, int pixelsPerTile) {
    return static_cast<int>((std::int64_t{coordinate.raw} * pixelsPerTile) >> 16);
}

// Draws horizontal rays over the field of view, spread like slices.
void drawRays(const World& world, int level, const MinimapView& view, const Eye& eye,
              const MinimapOptions& options, const Picture& picture) {
    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    const SineCosine heading = sineCosineDegrees(eye.headingDegrees);
    const double widest = tanDegrees(options.fovDegrees / 2.0);
    const double most = 2.0 * view.area.width / view.pixelsPerTile;
    const Coordinate above = eye.z - tileEdge(level);
    const Coordinate height =
        above >= Coordinate{} && above < tileEdge(1) ? above : toCoordinate(0.5);
    for (int i = 0; i < kMinimapRays; ++i) {
        const double share = static_cast<double>(i) / (kMinimapRays - 1);
        ClassicLevelRay end;
        if (share < options.classicShare || options.classicShare >= 1.0) {
            end = castClassic(world, eye, options.classic,
                              {options.fovDegrees, share, level, height, most});
        } else {
            const double slope = widest * (2.0 * share - 1.0);
            const Point direction = {heading.cosine - slope * heading.sine,
                                     heading.sine + slope * heading.cosine};
            const MapRayEnd exact = followRay(world, map,
                                              {.x = eye.x.value(),
                                               .y = eye.y.value(),
                                               .directionX = direction.x,
                                               .directionY = direction.y,
                                               .level = level,
                                               .height = height},
                                              most);
            end = {direction.x * exact.length, direction.y * exact.length, exact.met, exact.portal};
        }
        const Point onPicture =
            view.toPicture({end.x * view.pixelsPerTile, end.y * view.pixelsPerTile});
        const Point to = {view.centre().x + onPicture.x, view.centre().y + onPicture.y};
        drawLine(picture, view.area, view.centre(), to, kRay, view.line);
        if (end.met)
            drawDot(picture, view.area, to, std::max(1.0, view.area.width / 120.0),
                    end.portal ? kMinimapPortal : kRayEnd);
    }
}

}  // namespace

MinimapLayout layoutMinimap(int pictureWidth, int pictureHeight) {
    const PixelRect place = layoutOverlays(pictureWidth, pictureHeight).minimap;
    if (place.width == 0) return {};
    return {.left = place.x,
            .top = place.y,
            .side = place.width,
            .pixelsPerTile = std::max(2, (place.width - 2 + kTilesAcross / 2) / kTilesAcross)};
}

int minimapLevel(const Map& map, const Eye& eye, const MinimapOptions& options) {
    return std::clamp(options.level < 0 ? eye.z.tile() : options.level, 0, map.levels - 1);
}

void Minimap::draw(const World& world, const Eye& eye, const MinimapOptions& options,
                   const Picture& picture) {
    const MinimapLayout layout = layoutMinimap(picture.width, picture.height);
    if (layout.side == 0 || eye.map < 0 || static_cast<std::size_t>(eye.map) >= world.maps.size())
        return;
    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    const int level = minimapLevel(map, eye, options);

    const int scale = layoutOverlays(picture.width, picture.height).scale;
    const MinimapView view = {
        .area = {layout.left + 1, layout.top + 1, layout.side - 2, layout.side - 2},
        .pixelsPerTile = layout.pixelsPerTile,
        .eyeX = scaled(eye.x, layout.pixelsPerTile),
        .eyeY = scaled(eye.y, layout.pixelsPerTile),
        .centreX = layout.left + layout.side / 2,
        .centreY = layout.top + layout.side / 2,
        .up = options.turns ? sineCosineDegrees(eye.headingDegrees) : kNorth,
        .line = lineWidth(scale)};
    drawPanel(picture, {layout.left, layout.top, layout.side, layout.side}, scale);
    map_.draw({world, map, level}, view, scale, picture);
    drawMinimapObjects(world, eye.map, level, view, picture);
    if (options.reach > 0.0) drawMinimapReach(view, options.reach, picture);
    if (options.rays) drawRays(world, level, view, eye, options, picture);
    drawMinimapEye(view, eye, options.fovDegrees, picture);
    if (layout.side < kMarkedSide * scale) return;
    if (map.levels > 1) drawMinimapLevels({map.levels, level, eye.z.tile()}, view, scale, picture);
    drawMinimapNorth(view, scale, picture);
}

}  // namespace slicecast
