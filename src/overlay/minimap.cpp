#include "overlay/minimap.h"

#include "base/angle.h"
#include "overlay/blend.h"
#include "overlay/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace slicecast {
namespace {

constexpr int kLeastSide = 15;      // pixels; below it there is nothing to see
constexpr int kTilesAcross = 17;    // about
constexpr int kLabelledSide = 120;  // pixels from which the level's number is shown

constexpr Colour kLowBlock = {112, 58, 48, 255};
constexpr Colour kHighBlock = {214, 122, 92, 255};
constexpr Colour kWholeBlock = {104, 132, 168, 255};
constexpr double kFloatingShade = 0.5;  // of a block's colour, the rest is that of the ground under it
constexpr Colour kEdge = {226, 232, 240, 150};
constexpr Colour kNearGround = {82, 88, 97, 255};
constexpr Colour kDeepGround = {30, 34, 42, 255};
constexpr double kLeastShade = 0.35;   // of the way to the darkest, for ground that is at all below the level
constexpr double kDeepestShade = 4.0;  // units below the level at which the ground is darkest
constexpr Colour kPlayer = {255, 214, 74, 255};
constexpr Colour kPlayerRim = {20, 20, 20, 255};
constexpr int kFieldAlpha = 120;  // of the field of view, at the eye

Colour mixed(Colour a, Colour b, double part) {
    const auto mix = [part](int from, int to) { return static_cast<std::uint8_t>(from + static_cast<int>((to - from) * part + (to < from ? -0.5 : 0.5))); };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
}

constexpr int floorDivide(int a, int b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

int scaled(Coordinate coordinate, int pixelsPerTile) {
    return static_cast<int>((std::int64_t{coordinate.raw} * pixelsPerTile) >> 16);
}

// The height of the highest block top of a tile at or below a level's base.
Coordinate groundBelow(const World& world, const Map& map, int x, int y, int level) {
    for (int below = level - 1; below >= 0; --below) {
        const BlueprintId id = map.cell(x, y, below);
        if (id != kEmptyCell) return tileEdge(below) + world.blueprints[id].top;
    }
    return {};
}

Colour tileColour(const World& world, const Map& map, int x, int y, int level) {
    const double drop = (tileEdge(level) - groundBelow(world, map, x, y, level)).value();
    const Colour ground = mixed(kNearGround, kDeepGround, drop > 0.0 ? std::min(kLeastShade + (1.0 - kLeastShade) * drop / kDeepestShade, 1.0) : 0.0);
    const BlueprintId id = map.cell(x, y, level);
    if (id == kEmptyCell) return ground;
    const CellBlueprint& block = world.blueprints[id];
    const Colour colour = block.top == tileEdge(1) ? kWholeBlock : mixed(kLowBlock, kHighBlock, block.top.value());
    return block.bottom.raw > 0 ? mixed(ground, colour, kFloatingShade) : colour;
}

// The middle of the picture's square is the pixel in which the eye is.
struct View {
    PixelRect area;  // inside the rim
    int pixelsPerTile;
    int eyeX;  // the eye's pixel, counted from the map's corner
    int eyeY;
    int centreX;  // the same pixel of the picture
    int centreY;
};

void drawTiles(const World& world, const Map& map, int level, const View& view, const Picture& picture) {
    const int size = view.pixelsPerTile;
    const int firstX = floorDivide(view.eyeX - (view.centreX - view.area.x), size);
    const int firstY = floorDivide(view.eyeY - (view.centreY - view.area.y), size);
    const int across = view.area.width / size + 2;
    const auto filled = [&](int x, int y) { return map.cell(x, y, level) != kEmptyCell; };
    for (int y = std::max(firstY, 0); y < std::min(firstY + across, map.depth); ++y) {
        for (int x = std::max(firstX, 0); x < std::min(firstX + across, map.width); ++x) {
            // The part of the tile that is inside the area
            const int left = view.centreX + x * size - view.eyeX;
            const int top = view.centreY + y * size - view.eyeY;
            const auto blendInside = [&](PixelRect rect, Colour colour) {
                const int x0 = std::max(rect.x, view.area.x);
                const int y0 = std::max(rect.y, view.area.y);
                const int x1 = std::min(rect.x + rect.width, view.area.x + view.area.width);
                const int y1 = std::min(rect.y + rect.height, view.area.y + view.area.height);
                blendRect(picture, {x0, y0, x1 - x0, y1 - y0}, colour);
            };
            blendInside({left, top, size, size}, withAlpha(tileColour(world, map, x, y, level), 225));

            // A fine line where blocks end
            if (size < 6 || !filled(x, y)) continue;
            if (!filled(x, y - 1)) blendInside({left, top, size, 1}, kEdge);
            if (!filled(x, y + 1)) blendInside({left, top + size - 1, size, 1}, kEdge);
            if (!filled(x - 1, y)) blendInside({left, top, 1, size}, kEdge);
            if (!filled(x + 1, y)) blendInside({left + size - 1, top, 1, size}, kEdge);
        }
    }
}

// How much of a pixel lies inside an edge whose distance from the pixel's middle is that many pixels.
double coverage(double distance) {
    return std::clamp(distance + 0.5, 0.0, 1.0);
}

int toAlpha(double part, int most) {
    return static_cast<int>(part * most + 0.5);
}

// The field of view, fading with distance, and the eye.
void drawEye(const View& view, const Eye& eye, double fovDegrees, const Picture& picture) {
    const SineCosine heading = sineCosineDegrees(eye.headingDegrees);
    const SineCosine half = sineCosineDegrees(fovDegrees / 2.0);
    const double reach = view.area.width * 0.42;
    const double radius = std::max(1.0, view.area.width / 48.0);
    for (int y = view.area.y; y < view.area.y + view.area.height; ++y) {
        for (int x = view.area.x; x < view.area.x + view.area.width; ++x) {
            const double east = x - view.centreX;
            const double south = y - view.centreY;
            const double ahead = east * heading.cosine + south * heading.sine;
            const double aside = std::abs(south * heading.cosine - east * heading.sine);
            const double distance = std::sqrt(east * east + south * south);
            const double inside = coverage(ahead * half.sine - aside * half.cosine);
            const double near = std::max(0.0, 1.0 - distance / reach);
            if (inside > 0.0 && near > 0.0) blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(inside * near, kFieldAlpha)));
            const double rim = coverage(radius + 1.0 - distance);
            const double dot = coverage(radius - distance);
            if (rim > 0.0) blendPixel(picture, x, y, withAlpha(kPlayerRim, toAlpha(rim, 160)));
            if (dot > 0.0) blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(dot, 255)));
        }
    }
}

}  // namespace

MinimapLayout layoutMinimap(int pictureWidth, int pictureHeight) {
    const int margin = 2 + std::min(pictureWidth, pictureHeight) / 80;
    const int side = std::min(pictureWidth, pictureHeight) / 3;
    if (side < kLeastSide) return {};
    return {.left = margin, .top = margin, .side = side, .pixelsPerTile = std::max(2, (side - 2 + kTilesAcross / 2) / kTilesAcross)};
}

int minimapLevel(const Map& map, const Eye& eye, const MinimapOptions& options) {
    return std::clamp(options.level < 0 ? eye.z.tile() : options.level, 0, map.levels - 1);
}

void drawMinimap(const World& world, const Eye& eye, const MinimapOptions& options, const Picture& picture) {
    const MinimapLayout layout = layoutMinimap(picture.width, picture.height);
    if (layout.side == 0 || eye.map < 0 || static_cast<std::size_t>(eye.map) >= world.maps.size()) return;
    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    const int level = minimapLevel(map, eye, options);

    const View view = {.area = {layout.left + 1, layout.top + 1, layout.side - 2, layout.side - 2},
                       .pixelsPerTile = layout.pixelsPerTile,
                       .eyeX = scaled(eye.x, layout.pixelsPerTile),
                       .eyeY = scaled(eye.y, layout.pixelsPerTile),
                       .centreX = layout.left + layout.side / 2,
                       .centreY = layout.top + layout.side / 2};
    drawPanel(picture, {layout.left, layout.top, layout.side, layout.side});
    drawTiles(world, map, level, view, picture);
    drawEye(view, eye, options.fovDegrees, picture);

    // Which level it is, where there are several
    if (map.levels > 1 && layout.side >= kLabelledSide) {
        const int scale = readableScale(picture.height);
        const std::string label = "level " + std::to_string(level);
        const int height = textHeight(label, scale);
        const int x = view.area.x + 3 * scale;
        const int y = view.area.y + view.area.height - height - scale;
        blendRect(picture, {view.area.x, y - 2 * scale, textWidth(label, scale) + 6 * scale, height + 3 * scale}, kPanelColour);
        drawText(picture, x, y, label, {.scale = scale});
    }
}

}  // namespace slicecast
