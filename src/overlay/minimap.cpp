#include "overlay/minimap.h"

#include "base/angle.h"
#include "base/words.h"
#include "overlay/blend.h"
#include "overlay/layout.h"
#include "overlay/map_ray.h"
#include "overlay/minimap_objects.h"
#include "overlay/minimap_view.h"
#include "overlay/text.h"
#include "render/classic/level_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace slicecast {
namespace {

constexpr int kTilesAcross = 17;    // about
constexpr int kLabelledSide = 120;  // pixels from which the level's number is shown

constexpr Colour kLowBlock = {112, 58, 48, 255};
constexpr Colour kHighBlock = {214, 122, 92, 255};
constexpr Colour kWholeBlock = {104, 132, 168, 255};
constexpr double kWaterShade = 0.6;  // of water over the ground below it
constexpr double kFloatingShade =
    0.5;  // of a block's colour, the rest is that of the ground under it
constexpr Colour kEdge = {226, 232, 240, 150};
constexpr Colour kNearGround = {82, 88, 97, 255};
constexpr Colour kDeepGround = {30, 34, 42, 255};
constexpr double kLeastShade =
    0.35;  // of the way to the darkest, for ground that is at all below the level
constexpr double kDeepestShade = 4.0;  // units below the level at which the ground is darkest
constexpr Colour kPlayer = {255, 214, 74, 255};
constexpr Colour kPlayerRim = {20, 20, 20, 255};
constexpr int kFieldAlpha = 120;  // of the field of view, at the eye
constexpr Colour kRay = {120, 230, 140, 150};
constexpr Colour kRayEnd = {190, 255, 200, 255};
constexpr Colour kReach = {160, 170, 180, 60};
constexpr Colour kReachRim = {235, 240, 245, 200};
constexpr Colour kPortal = {64, 224, 208, 255};
constexpr double kPortalTint = 0.45;  // of a tile that is one
constexpr double kNorth = 270.0;      // degrees

Colour mixed(Colour a, Colour b, double part) {
    const auto mix = [part](int from, int to) {
        return static_cast<std::uint8_t>(
            from + static_cast<int>((to - from) * part + (to < from ? -0.5 : 0.5)));
    };
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

Colour groundColour(const World& world, const Map& map, int x, int y, int level) {
    const double drop = (tileEdge(level) - groundBelow(world, map, x, y, level)).value();
    const Colour ground = mixed(
        kNearGround, kDeepGround,
        drop > 0.0 ? std::min(kLeastShade + (1.0 - kLeastShade) * drop / kDeepestShade, 1.0) : 0.0);
    const BlueprintId id = map.cell(x, y, level);
    if (id == kEmptyCell) {
        const bool isWaded = level == 0 && map.isWaterFloor(map.tileIndex(x, y));
        return isWaded ? mixed(ground, kWaterColour, kWaterShade) : ground;
    }
    const CellBlueprint& block = world.blueprints[id];
    if (block.isWater) return mixed(ground, block.waterColour, kWaterShade);
    const Colour colour =
        block.top == tileEdge(1) ? kWholeBlock : mixed(kLowBlock, kHighBlock, block.top.value());
    return block.bottom.raw > 0 ? mixed(ground, colour, kFloatingShade) : colour;
}

bool isPortal(const World& world, const Map& map, int x, int y, int level, Face face) {
    const BlueprintId id = map.cell(x, y, level);
    return id != kEmptyCell && world.blueprints[id].face(face).portal != kNoPortal;
}

// What leads elsewhere as a whole, or from above or below, is tinted.
Colour tileColour(const World& world, const Map& map, int x, int y, int level) {
    const Colour colour = groundColour(world, map, x, y, level);
    const bool leads = map.tilePortal(x, y) != kNoPortal ||
                       isPortal(world, map, x, y, level, Face::top) ||
                       isPortal(world, map, x, y, level, Face::bottom);
    return leads ? mixed(colour, kPortal, kPortalTint) : colour;
}

// The colours of the tiles around the eye, looked up once each rather than for every pixel.
class TileColours {
public:
    TileColours(const World& world, const Map& map, int level, const MinimapView& view)
        : size_(view.pixelsPerTile) {
        // A turned square needs the tiles within half of its diagonal.
        const int reach = view.area.width * 3 / 4 + size_;
        firstX_ = floorDivide(view.eyeX - reach, size_);
        firstY_ = floorDivide(view.eyeY - reach, size_);
        across_ = std::min(2 * reach / size_ + 2, kMostAcross);
        for (int y = 0; y < across_; ++y) {
            for (int x = 0; x < across_; ++x) {
                const int tileX = firstX_ + x;
                const int tileY = firstY_ + y;
                Colour& colour = colours_[index(x, y)];
                colour = map.contains(tileX, tileY)
                             ? withAlpha(tileColour(world, map, tileX, tileY, level), 225)
                             : Colour{0, 0, 0, 0};
                filled_[index(x, y)] = map.cell(tileX, tileY, level) != kEmptyCell;
                portals_[index(x, y)] = {isPortal(world, map, tileX, tileY, level, Face::west),
                                         isPortal(world, map, tileX, tileY, level, Face::east),
                                         isPortal(world, map, tileX, tileY, level, Face::north),
                                         isPortal(world, map, tileX, tileY, level, Face::south)};
            }
        }
    }

    // Lays over a pixel of the picture what is at a pixel of the map.
    void draw(const Picture& picture, int pictureX, int pictureY, int mapX, int mapY) const {
        const int tileX = floorDivide(mapX, size_);
        const int tileY = floorDivide(mapY, size_);
        const int x = tileX - firstX_;
        const int y = tileY - firstY_;
        if (x < 1 || y < 1 || x >= across_ - 1 || y >= across_ - 1 || colours_[index(x, y)].a == 0)
            return;
        blendPixel(picture, pictureX, pictureY, colours_[index(x, y)]);

        // A broad line along faces that are portals, a fine one where blocks end
        if (!filled_[index(x, y)]) return;
        const int insideX = mapX - tileX * size_;
        const int insideY = mapY - tileY * size_;
        const PortalSides& portals = portals_[index(x, y)];
        const int broad = std::max(1, size_ / 4);
        if ((portals.west && insideX < broad) || (portals.east && insideX >= size_ - broad) ||
            (portals.north && insideY < broad) || (portals.south && insideY >= size_ - broad)) {
            blendPixel(picture, pictureX, pictureY, kPortal);
            return;
        }
        if (size_ < 6) return;
        const bool edge = (insideX == 0 && !filled_[index(x - 1, y)]) ||
                          (insideX == size_ - 1 && !filled_[index(x + 1, y)]) ||
                          (insideY == 0 && !filled_[index(x, y - 1)]) ||
                          (insideY == size_ - 1 && !filled_[index(x, y + 1)]);
        if (edge) blendPixel(picture, pictureX, pictureY, kEdge);
    }

private:
    static constexpr int kMostAcross = 64;
    struct PortalSides {
        bool west, east, north, south;
    };
    static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * kMostAcross + x); }

    int size_;
    int firstX_;
    int firstY_;
    int across_;
    std::array<Colour, kMostAcross * kMostAcross> colours_;
    std::array<bool, kMostAcross * kMostAcross> filled_;
    std::array<PortalSides, kMostAcross * kMostAcross> portals_;
};

void drawTiles(const World& world, const Map& map, int level, const MinimapView& view,
               const Picture& picture) {
    const TileColours tiles(world, map, level, view);
    // Along a row the place on the map goes on by the same step, in 1/65536 pixels.
    const Point step = view.toMap({1.0, 0.0});
    const int stepX = toCoordinate(step.x).raw;
    const int stepY = toCoordinate(step.y).raw;
    for (int y = view.area.y; y < view.area.y + view.area.height; ++y) {
        const Point first = view.toMap({static_cast<double>(view.area.x - view.centreX),
                                        static_cast<double>(y - view.centreY)});
        int fromEyeX = toCoordinate(first.x + 0.5).raw;
        int fromEyeY = toCoordinate(first.y + 0.5).raw;
        for (int x = view.area.x; x < view.area.x + view.area.width; ++x) {
            tiles.draw(picture, x, y, view.eyeX + (fromEyeX >> 16), view.eyeY + (fromEyeY >> 16));
            fromEyeX += stepX;
            fromEyeY += stepY;
        }
    }
}

// Level rays over the field of view, as evenly as slices are, each as far as it goes.
void drawRays(const World& world, const Map& map, int level, const MinimapView& view,
              const Eye& eye, const MinimapOptions& options, const Picture& picture) {
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
            end = castClassic(world, eye, options.fovDegrees, options.classic, share, level, height,
                              most);
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
        drawLine(picture, view.area, view.centre(), to, kRay);
        if (end.met)
            drawDot(picture, view.area, to, std::max(1.0, view.area.width / 120.0),
                    end.portal ? kPortal : kRayEnd);
    }
}

// A translucent disc with a rim.
void drawReach(const MinimapView& view, double reach, const Picture& picture) {
    const double radius = reach * view.pixelsPerTile;
    drawDot(picture, view.area, view.centre(), radius, kReach);
    drawRing(picture, view.area, view.centre(), radius, kReachRim);
}

// Where north is, on the rim of a map that turns.
void drawNorth(const MinimapView& view, int scale, const Picture& picture) {
    const Point north = view.toPicture({0.0, -1.0});
    const double radius = view.area.width / 2.0 - 7.0 * scale;
    const Point at = {view.centre().x + north.x * radius, view.centre().y + north.y * radius};
    drawDot(picture, view.area, at, 5.5 * scale, kPanelColour);
    drawText(picture, static_cast<int>(at.x) - 2 * scale, static_cast<int>(at.y) - 3 * scale, "N",
             {.scale = scale});
}

// How much of a pixel lies inside an edge whose distance from the pixel's middle is that many
// pixels.
double coverage(double distance) {
    return std::clamp(distance + 0.5, 0.0, 1.0);
}

int toAlpha(double part, int most) {
    return static_cast<int>(part * most + 0.5);
}

// The field of view, fading with distance, and the eye.
void drawEye(const MinimapView& view, const Eye& eye, double fovDegrees, const Picture& picture) {
    const Point forward =
        view.toPicture({cosDegrees(eye.headingDegrees), sinDegrees(eye.headingDegrees)});
    const SineCosine half = sineCosineDegrees(fovDegrees / 2.0);
    const double reach = view.area.width * 0.42;
    const double radius = std::max(1.0, view.area.width / 48.0);
    for (int y = view.area.y; y < view.area.y + view.area.height; ++y) {
        for (int x = view.area.x; x < view.area.x + view.area.width; ++x) {
            const double right = x - view.centreX;
            const double down = y - view.centreY;
            const double ahead = right * forward.x + down * forward.y;
            const double aside = std::abs(down * forward.x - right * forward.y);
            const double squared = right * right + down * down;
            if (squared > reach * reach ||
                (ahead < -1.0 && squared > (radius + 2.0) * (radius + 2.0)))
                continue;
            const double distance = std::sqrt(squared);
            const double inside = coverage(ahead * half.sine - aside * half.cosine);
            const double near = std::max(0.0, 1.0 - distance / reach);
            if (inside > 0.0 && near > 0.0)
                blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(inside * near, kFieldAlpha)));
            const double rim = coverage(radius + 1.0 - distance);
            const double dot = coverage(radius - distance);
            if (rim > 0.0) blendPixel(picture, x, y, withAlpha(kPlayerRim, toAlpha(rim, 160)));
            if (dot > 0.0) blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(dot, 255)));
        }
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

void drawMinimap(const World& world, const Eye& eye, const MinimapOptions& options,
                 const Picture& picture) {
    const MinimapLayout layout = layoutMinimap(picture.width, picture.height);
    if (layout.side == 0 || eye.map < 0 || static_cast<std::size_t>(eye.map) >= world.maps.size())
        return;
    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    const int level = minimapLevel(map, eye, options);

    const MinimapView view = {
        .area = {layout.left + 1, layout.top + 1, layout.side - 2, layout.side - 2},
        .pixelsPerTile = layout.pixelsPerTile,
        .eyeX = scaled(eye.x, layout.pixelsPerTile),
        .eyeY = scaled(eye.y, layout.pixelsPerTile),
        .centreX = layout.left + layout.side / 2,
        .centreY = layout.top + layout.side / 2,
        .up = sineCosineDegrees(options.turns ? eye.headingDegrees : kNorth)};
    drawPanel(picture, {layout.left, layout.top, layout.side, layout.side});
    drawTiles(world, map, level, view, picture);
    drawMinimapObjects(world, eye.map, level, view, picture);
    if (options.reach > 0.0) drawReach(view, options.reach, picture);
    if (options.rays) drawRays(world, map, level, view, eye, options, picture);
    drawEye(view, eye, options.fovDegrees, picture);
    if (layout.side < kLabelledSide) return;
    const int scale = readableScale(picture.width, picture.height);
    if (options.turns) drawNorth(view, scale, picture);

    // Which level it is, where there are several
    if (map.levels > 1) {
        std::array<char, 20> text;
        const std::string_view label = write(text, {"level ", level});
        const int height = textHeight(label, scale);
        const int x = view.area.x + 3 * scale;
        const int y = view.area.y + view.area.height - height - scale;
        blendRect(
            picture,
            {view.area.x, y - 2 * scale, textWidth(label, scale) + 6 * scale, height + 3 * scale},
            kPanelColour);
        drawText(picture, x, y, label, {.scale = scale});
    }
}

}  // namespace slicecast
