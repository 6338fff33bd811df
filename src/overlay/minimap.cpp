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

constexpr int kTilesAcross = 17;  // about
constexpr int kMarkedSide = 60;   // dots of the font from which north and the levels are marked

constexpr Colour kLowBlock = {122, 66, 46, 255};
constexpr Colour kHighBlock = {226, 142, 92, 255};
constexpr Colour kWholeBlock = {112, 142, 182, 255};
constexpr double kFloatingShade =
    0.5;  // of a block's colour, the rest is that of the ground under it
constexpr Colour kGate = {238, 186, 70, 255};
constexpr Colour kMover = {204, 170, 255, 255};
constexpr Colour kNearGround = {104, 110, 108, 255};
constexpr Colour kDeepGround = {34, 38, 46, 255};
constexpr double kLeastShade =
    0.25;  // of the way to the darkest, for ground that is at all below the level
constexpr double kDeepestShade = 5.0;  // units below the level at which the ground is darkest
constexpr Colour kWater = {24, 108, 156,
                           255};      // of any: what an eye in it sees may be grey or dark
constexpr double kWaterShade = 0.75;  // of water over the ground below it
constexpr Colour kRipple = {206, 232, 244, 96};

// Along the edges of tiles
constexpr Colour kBlockEdge = {236, 240, 244, 190};
constexpr Colour kStepEdge = {236, 240, 244, 64};
constexpr Colour kShadow = {0, 0, 0, 110};
constexpr Colour kOverhang = {236, 240, 244, 150};
constexpr Coordinate kClearStep = Coordinate{65536 / 16};  // units, of which an edge is drawn

constexpr Colour kPlayer = {255, 214, 74, 255};
constexpr Colour kPlayerRim = {20, 20, 20, 200};
constexpr int kFieldAlpha = 120;  // of the field of view, at the eye
constexpr Colour kRay = {120, 230, 140, 150};
constexpr Colour kRayEnd = {190, 255, 200, 255};
constexpr Colour kReach = {160, 170, 180, 60};
constexpr Colour kReachRim = {235, 240, 245, 200};
constexpr Colour kPortal = {64, 224, 208, 255};
constexpr double kPortalTint = 0.5;  // of a tile that is one
constexpr double kNorth = 270.0;     // degrees

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

// Ground whose surface lies so many units below the level that is shown.
Colour groundTone(double drop) {
    return mixed(
        kNearGround, kDeepGround,
        drop > 0.0 ? std::min(kLeastShade + (1.0 - kLeastShade) * drop / kDeepestShade, 1.0) : 0.0);
}

// True if there is water on a level, or one looks down at some from it.
bool isWater(const World& world, const Map& map, int x, int y, int level) {
    for (int below = level; below >= 0; --below) {
        const BlueprintId id = map.cell(x, y, below);
        if (id != kEmptyCell) return world.blueprints[id].isWater;
    }
    return map.isWaterFloor(map.tileIndex(x, y));
}

Colour groundColour(const World& world, const Map& map, int x, int y, int level) {
    const double drop = (tileEdge(level) - groundBelow(world, map, x, y, level)).value();
    const Colour ground = groundTone(drop);
    if (isWater(world, map, x, y, level)) return mixed(ground, kWater, kWaterShade);
    const BlueprintId id = map.cell(x, y, level);
    if (id == kEmptyCell) return ground;
    const CellBlueprint& block = world.blueprints[id];
    if (block.gate >= 0) return block.passable ? ground : kGate;
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

// A tile as it is drawn.
struct Tile {
    Colour colour = {0, 0, 0, 0};  // see-through outside the grid
    Coordinate surface;            // of the block of the level, or of the ground below it
    bool block = false;            // the level has one
    bool over = false;             // a level above has one
    bool openGate = false;
    bool water = false;
    bool moves = false;
    unsigned portals = 0;  // bit n is the face of that number
};

Tile makeTile(const World& world, const Map& map, int x, int y, int level) {
    Tile tile;
    if (!map.contains(x, y)) return tile;
    tile.colour = withAlpha(tileColour(world, map, x, y, level), 235);
    tile.surface = groundBelow(world, map, x, y, level);
    tile.over = (map.occupied[map.tileIndex(x, y)] >> level >> 1) != 0;
    tile.water = isWater(world, map, x, y, level);
    const BlueprintId id = map.cell(x, y, level);
    if (id == kEmptyCell) return tile;
    const CellBlueprint& block = world.blueprints[id];
    tile.openGate = block.gate >= 0 && block.passable;
    tile.block = !tile.openGate && !block.isWater;
    tile.moves = block.motion >= 0;
    if (tile.block) tile.surface = tileEdge(level) + block.top;
    for (const Face face : {Face::north, Face::east, Face::south, Face::west}) {
        if (block.face(face).portal != kNoPortal) tile.portals |= 1u << static_cast<int>(face);
    }
    return tile;
}

// The tiles around the eye, looked up once each rather than for every pixel.
class Tiles {
public:
    Tiles(const World& world, const Map& map, int level, const MinimapView& view, int scale)
        : size_(view.pixelsPerTile), line_(std::max(1, size_ / 14)), dash_(2 * scale) {
        // A turned square needs the tiles within half of its diagonal.
        const int reach = view.area.width * 3 / 4 + size_;
        firstX_ = floorDivide(view.eyeX - reach, size_);
        firstY_ = floorDivide(view.eyeY - reach, size_);
        across_ = std::min(2 * reach / size_ + 2, kMostAcross);
        for (int y = 0; y < across_; ++y) {
            for (int x = 0; x < across_; ++x)
                tiles_[index(x, y)] = makeTile(world, map, firstX_ + x, firstY_ + y, level);
        }
    }

    // The colour of a pixel of the map, and what is laid over it.
    void draw(const Picture& picture, int pictureX, int pictureY, int mapX, int mapY) const {
        const int tileX = floorDivide(mapX, size_);
        const int tileY = floorDivide(mapY, size_);
        const int x = tileX - firstX_;
        const int y = tileY - firstY_;
        if (x < 1 || y < 1 || x >= across_ - 1 || y >= across_ - 1) return;
        const Tile& tile = tiles_[index(x, y)];
        if (tile.colour.a == 0) return;
        blendPixel(picture, pictureX, pictureY, tile.colour);

        const int fromWest = mapX - tileX * size_;
        const int fromNorth = mapY - tileY * size_;
        // From the north, east, south and west edge
        const std::array<int, 4> from = {fromNorth, size_ - 1 - fromWest, size_ - 1 - fromNorth,
                                         fromWest};
        if (tile.water && isRipple(fromWest, fromNorth))
            blendPixel(picture, pictureX, pictureY, kRipple);
        if (tile.moves && (mapX + mapY) / dash_ % 3 == 0)
            blendPixel(picture, pictureX, pictureY, kMover);
        const int broad = std::max(1, size_ / 4);
        for (std::size_t i = 0; i < from.size(); ++i) {
            const bool leads = (tile.portals >> i & 1u) != 0;
            if (leads && from[i] < broad) {
                blendPixel(picture, pictureX, pictureY, kPortal);
                return;
            }
            if (tile.openGate && from[i] < std::max(1, size_ / 6)) {
                blendPixel(picture, pictureX, pictureY, kGate);
                return;
            }
        }
        if (size_ < 4) return;
        const std::array<const Tile*, 4> beside = {
            &tiles_[index(x, y - 1)], &tiles_[index(x + 1, y)], &tiles_[index(x, y + 1)],
            &tiles_[index(x - 1, y)]};
        Colour edge = {0, 0, 0, 0};
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (from[i] >= line_) continue;
            const Colour here = edgeTo(tile, *beside[i], (mapX + mapY) / dash_ % 2 == 0);
            if (here.a > edge.a) edge = here;
        }
        if (edge.a != 0) blendPixel(picture, pictureX, pictureY, edge);
    }

private:
    // Two strokes on each tile of water, one east of the other and below it.
    bool isRipple(int fromWest, int fromNorth) const {
        const int part = size_ / 6;  // none on tiles too small for strokes
        const auto isStroke = [&](int west, int north) {
            return fromWest >= west && fromWest < west + 2 * part && fromNorth >= north &&
                   fromNorth < north + line_;
        };
        return part > 1 && (isStroke(part / 2, part + part / 2) || isStroke(3 * part, 4 * part));
    }

    // A light edge where a tile is higher than the one beside it, a shadow where it is lower, a
    // dashed line where something above the level begins.
    static Colour edgeTo(const Tile& tile, const Tile& beside, bool onDash) {
        const bool under = tile.over && !tile.block;
        if (under && onDash && !beside.over && !beside.block) return kOverhang;
        if (tile.block && !beside.block) return kBlockEdge;
        if (beside.colour.a == 0) return {0, 0, 0, 0};
        if (tile.surface >= beside.surface + kClearStep) return kStepEdge;
        if (beside.surface >= tile.surface + kClearStep) return kShadow;
        return {0, 0, 0, 0};
    }

    static constexpr int kMostAcross = 40;
    static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * kMostAcross + x); }

    int size_;
    int line_;  // pixels that edges are wide
    int dash_;
    int firstX_;
    int firstY_;
    int across_;
    std::array<Tile, kMostAcross * kMostAcross> tiles_;
};

void drawTiles(const World& world, const Map& map, int level, const MinimapView& view, int scale,
               const Picture& picture) {
    const Tiles tiles(world, map, level, view, scale);
    // Along a row the place on the map goes on by the same step, in 1/65536 pixels.
    const Point step = view.toMap({1.0, 0.0});
    const int stepX = toCoordinate(step.x).raw;
    const int stepY = toCoordinate(step.y).raw;
    for (int y = view.area.y; y < view.area.y + view.area.height; ++y) {
        const Point first = view.toMap({static_cast<double>(view.area.x - view.centreX),
                                        static_cast<double>(y - view.centreY)});
        int fromEyeX = toCoordinate(first.x + 0.5).raw;
        int fromEyeY = toCoordinate(first.y + 0.5).raw;
        const int row = y - view.area.y;
        const int inset = plateInset(std::min(row, view.area.height - 1 - row), scale);
        for (int x = view.area.x; x < view.area.x + view.area.width; ++x) {
            if (x >= view.area.x + inset && x < view.area.x + view.area.width - inset)
                tiles.draw(picture, x, y, view.eyeX + (fromEyeX >> 16),
                           view.eyeY + (fromEyeY >> 16));
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
        drawLine(picture, view.area, view.centre(), to, kRay, view.line);
        if (end.met)
            drawDot(picture, view.area, to, std::max(1.0, view.area.width / 120.0),
                    end.portal ? kPortal : kRayEnd);
    }
}

// A translucent disc with a rim.
void drawReach(const MinimapView& view, double reach, const Picture& picture) {
    const double radius = reach * view.pixelsPerTile;
    drawDot(picture, view.area, view.centre(), radius, kReach);
    drawRing(picture, view.area, view.centre(), radius, kReachRim, view.line);
}

// Where north is, on the rim.
void drawNorth(const MinimapView& view, int scale, const Picture& picture) {
    const Point north = view.toPicture({0.0, -1.0});
    const double radius = view.area.width / 2.0 - 7.0 * scale;
    const Point at = {std::floor(view.centre().x + north.x * radius) + 0.5,
                      std::floor(view.centre().y + north.y * radius) + 0.5};
    drawDot(picture, view.area, at, 6.0 * scale, {16, 20, 28, 230});
    for (int i = 0; i < scale; ++i)
        drawRing(picture, view.area, at, 6.0 * scale - i, withAlpha(kPlayer, 210));
    drawText(picture, static_cast<int>(at.x - 2.5 * scale + 0.5),
             static_cast<int>(at.y - 3.5 * scale + 0.5), "N", {.scale = scale});
}

// The levels of the map as a stack of bars in the lower left corner, in the tones that they have on
// it: those below, the one that is shown with its number, and those above as outlines. A dot is the
// eye's.
void drawLevels(const Map& map, int level, int eyeLevel, const MinimapView& view, int scale,
                const Picture& picture) {
    const int room = std::min(32 * scale, view.area.height / 3);
    const int step = std::clamp(room / map.levels, 1, 5 * scale);
    const int gap = step > 2 * scale ? scale : step > 2 ? 1 : 0;
    const int stack = step * map.levels - gap;
    std::array<char, 12> text;
    const std::string_view number = write(text, level);
    const int bar = 9 * scale;
    const int left = view.area.x + 5 * scale;
    const int bottom = view.area.y + view.area.height - 3 * scale;
    const int height = std::max(stack, 7 * scale);
    blendRect(picture,
              {view.area.x, bottom - height - 3 * scale,
               bar + textWidth(number, scale) + 13 * scale, height + 6 * scale},
              kPanelColour);
    for (int i = 0; i < map.levels; ++i) {
        const PixelRect place = {left, bottom - i * step - (step - gap), bar, step - gap};
        const int more = i == level ? 2 * scale : 0;  // the one that is shown sticks out
        blendRect(picture, {place.x, place.y, bar + more, place.height},
                  i > level    ? withAlpha(kOverhang, 44)
                  : i == level ? Colour{150, 182, 224, 255}
                               : groundTone(level - 1 - i + 0.5));
        if (i == std::clamp(eyeLevel, 0, map.levels - 1))
            blendRect(picture,
                      {place.x - 3 * scale, place.y + (place.height - scale) / 2, 2 * scale,
                       std::max(scale, std::min(2 * scale, place.height))},
                      kPlayer);
    }
    const int middle = bottom - level * step - (step - gap) / 2;
    const int y = std::clamp(middle - 3 * scale, bottom - height, bottom - 7 * scale);
    drawText(picture, left + bar + 5 * scale, y, number, {.scale = scale});
}

// How much of a pixel lies inside an edge whose distance from the pixel's middle is that many
// pixels.
double coverage(double distance) {
    return std::clamp(distance + 0.5, 0.0, 1.0);
}

int toAlpha(double part, int most) {
    return static_cast<int>(part * most + 0.5);
}

// How far a place is inside an arrow head of that size, pixels: negative outside. `ahead` and
// `aside` are from its middle, aside on either side.
double insideArrow(double ahead, double aside, double size) {
    // From the tip to a corner, and from the corner back to the notch
    const double side = (1.5 * size - ahead) * 0.3810 - aside * 0.9246;
    const double notch = (ahead + 0.5 * size) * 0.8575 + aside * 0.5145;
    return std::min(side, notch);
}

// The field of view, fading with distance, and the eye as an arrow head.
void drawEye(const MinimapView& view, const Eye& eye, double fovDegrees, const Picture& picture) {
    const Point forward =
        view.toPicture({cosDegrees(eye.headingDegrees), sinDegrees(eye.headingDegrees)});
    const SineCosine half = sineCosineDegrees(fovDegrees / 2.0);
    const double reach = view.area.width * 0.42;
    const double size = std::max(2.0, view.area.width / 30.0);
    const double rimWidth = std::max(1.0, size / 4.0);
    for (int y = view.area.y; y < view.area.y + view.area.height; ++y) {
        for (int x = view.area.x; x < view.area.x + view.area.width; ++x) {
            const double right = x - view.centreX;
            const double down = y - view.centreY;
            const double ahead = right * forward.x + down * forward.y;
            const double aside = std::abs(down * forward.x - right * forward.y);
            const double squared = right * right + down * down;
            if (squared > reach * reach || ahead < -2.0 * size) continue;
            const double distance = std::sqrt(squared);
            const double inside = coverage(ahead * half.sine - aside * half.cosine);
            const double near = std::max(0.0, 1.0 - distance / reach);
            if (inside > 0.0 && near > 0.0)
                blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(inside * near, kFieldAlpha)));
            if (squared > 9.0 * size * size) continue;
            const double within = insideArrow(ahead, aside, size);
            const double rim = coverage(within + rimWidth);
            const double arrow = coverage(within);
            if (rim > 0.0)
                blendPixel(picture, x, y, withAlpha(kPlayerRim, toAlpha(rim, kPlayerRim.a)));
            if (arrow > 0.0) blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(arrow, 255)));
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

    const int scale = layoutOverlays(picture.width, picture.height).scale;
    const MinimapView view = {
        .area = {layout.left + 1, layout.top + 1, layout.side - 2, layout.side - 2},
        .pixelsPerTile = layout.pixelsPerTile,
        .eyeX = scaled(eye.x, layout.pixelsPerTile),
        .eyeY = scaled(eye.y, layout.pixelsPerTile),
        .centreX = layout.left + layout.side / 2,
        .centreY = layout.top + layout.side / 2,
        .up = sineCosineDegrees(options.turns ? eye.headingDegrees : kNorth),
        .line = lineWidth(scale)};
    drawPanel(picture, {layout.left, layout.top, layout.side, layout.side}, scale);
    drawTiles(world, map, level, view, scale, picture);
    drawMinimapObjects(world, eye.map, level, view, picture);
    if (options.reach > 0.0) drawReach(view, options.reach, picture);
    if (options.rays) drawRays(world, map, level, view, eye, options, picture);
    drawEye(view, eye, options.fovDegrees, picture);
    if (layout.side < kMarkedSide * scale) return;
    if (map.levels > 1) drawLevels(map, level, eye.z.tile(), view, scale, picture);
    drawNorth(view, scale, picture);
}

}  // namespace slicecast
