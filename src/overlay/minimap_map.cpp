#include "overlay/minimap_map.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace slicecast {
namespace {

constexpr Colour kMover = {204, 170, 255, 255};
constexpr Coordinate kClearStep = Coordinate{65536 / 16};  // units; smaller steps get no edge

// The mark over a tile's colour; where several meet, the greatest number wins.
enum Mark : unsigned { none, stepEdge, shadow, overhang, blockEdge, ripple, portal, gate };
constexpr unsigned kStripe = 8;    // added to a mark on a stripe of a moving block
constexpr int kMarkShift = 24;     // bits below a pixel's mark
constexpr Pixel kSeen = 1u << 28;  // set for pixels inside the grid
constexpr int kMostAcross = 40;
constexpr std::size_t kLookNumbers = 7;
constexpr auto kMarkColours = [] {
    std::array<Pixel, 2 * kStripe> colours{};
    colours[stepEdge] = toPixel({236, 240, 244, 64});
    colours[shadow] = toPixel({0, 0, 0, 110});
    colours[overhang] = toPixel({236, 240, 244, 150});
    colours[blockEdge] = toPixel({236, 240, 244, 190});
    colours[ripple] = toPixel({206, 232, 244, 96});
    colours[portal] = toPixel(kMinimapPortal);
    colours[gate] = toPixel(kMinimapGate);
    for (unsigned i = 0; i < kStripe; ++i)
        colours[kStripe + i] = blended(toPixel(kMover), colours[i]);
    return colours;
}();

// Bits of Look::kind; from kPortalBit on one bit for each side that is a portal.
constexpr unsigned kOpenGate = 1;
constexpr unsigned kWater = 2;
constexpr unsigned kMoves = 4;
constexpr int kPortalBit = 3;
constexpr int kHalfShift = 16;  // to a Half

constexpr int floorDivide(int a, int b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

constexpr int remainder(int a, int b) {
    return a - floorDivide(a, b) * b;
}

// How a tile is marked along its border with a neighbour: by a light edge if it is higher, by a
// shadow if it is lower, and by a dashed line at the edge of a block above the level.
Mark edgeTo(const MinimapTile& tile, const MinimapTile& beside, bool onDash) {
    const bool under = tile.over && !tile.block;
    if (under && onDash && !beside.over && !beside.block) return overhang;
    if (tile.block && !beside.block) return blockEdge;
    if (beside.colour.a == 0) return none;
    if (tile.surface >= beside.surface + kClearStep) return stepEdge;
    if (beside.surface >= tile.surface + kClearStep) return shadow;
    return none;
}

// Two strokes on each water tile, the second further south-east.
bool isRipple(int size, int line, int fromWest, int fromNorth) {
    const int part = size / 6;  // none on tiles too small for strokes
    const auto isStroke = [&](int west, int north) {
        return fromWest >= west && fromWest < west + 2 * part && fromNorth >= north &&
               fromNorth < north + line;
    };
    return part > 1 && (isStroke(part / 2, part + part / 2) || isStroke(3 * part, 4 * part));
}

}  // namespace

void MinimapMap::draw(const Place& place, const MinimapView& view, int scale,
                      const Picture& picture) {
    // A turned square needs the tiles within half of its diagonal, and those need their neighbours.
    const int width = view.area.width;
    const int reach = width * 3 / 4 + 2 * view.pixelsPerTile;
    resize(std::min(2 * reach / view.pixelsPerTile + 2, kMostAcross), view.pixelsPerTile, scale);
    firstX_ = floorDivide(view.eyeX - reach, size_);
    firstY_ = floorDivide(view.eyeY - reach, size_);
    lookUp(place);

    // Along a row the map position advances by a constant step, in 1/65536 pixels
    const Point right = view.toMap({1.0, 0.0});
    const MapStep step = {toCoordinate(right.x), toCoordinate(right.y)};
    const Point corner = {view.eyeX - firstX_ * size_ + 0.5, view.eyeY - firstY_ * size_ + 0.5};
    for (int row = 0; row < view.area.height; ++row) {
        const int inset = plateInset(std::min(row, view.area.height - 1 - row), scale);
        const int y = view.area.y + row;
        const Point first = view.toMap({static_cast<double>(view.area.x - view.centreX),
                                        static_cast<double>(y - view.centreY)});
        lay(picture.row(y) + view.area.x + inset, width - 2 * inset,
            toCoordinate(corner.x + first.x) + Coordinate{inset * step.x.raw},
            toCoordinate(corner.y + first.y) + Coordinate{inset * step.y.raw}, step);
    }
}

// Forgets all tiles if a size has changed.
void MinimapMap::resize(int across, int size, int scale) {
    if (across == across_ && size == size_ && dash_ == 2 * scale) return;
    across_ = across;
    size_ = size;
    line_ = std::max(1, size / 14);
    dash_ = 2 * scale;
    looks_ = std::vector<std::uint32_t>(static_cast<std::size_t>(across * across) * kLookNumbers);
    image_ = Image(across * size, across * size);
}

void MinimapMap::lookUp(const Place& place) {
    static_assert(sizeof(Look) == kLookNumbers * sizeof(std::uint32_t));
    std::array<MinimapTile, kMostAcross * kMostAcross> tiles;
    for (int i = 0; i < across_ * across_; ++i)
        tiles[static_cast<std::size_t>(i)] = minimapTile(
            place.world, place.map, firstX_ + i % across_, firstY_ + i / across_, place.level);
    for (int y = 1; y < across_ - 1; ++y) {
        for (int x = 1; x < across_ - 1; ++x) {
            const Look look =
                lookOf(&tiles[static_cast<std::size_t>(y * across_ + x)], firstX_ + x, firstY_ + y);
            const int at = remainder(look.y, across_) * across_ + remainder(look.x, across_);
            std::uint32_t* const drawn = &looks_[static_cast<std::size_t>(at) * kLookNumbers];
            if (std::memcmp(drawn, &look, sizeof look) == 0) continue;
            std::memcpy(drawn, &look, sizeof look);
            drawTile(look, at);
            ++drawnTiles_;
        }
    }
}

MinimapMap::Look MinimapMap::lookOf(const MinimapTile* tile, int x, int y) const {
    Look look{.x = x, .y = y, .colour = toPixel(tile->colour)};
    if (look.colour == 0) return look;
    if (!tile->plan.isWhole()) {
        look.ground = toPixel(tile->ground);
        const Plan& plan = tile->plan;
        for (const Coordinate edge : {plan.west, plan.north, plan.east, plan.south})
            look.plan = look.plan << 8 | static_cast<std::uint32_t>((edge.raw + 2048) >> 12);
    }
    look.kind = (tile->openGate ? kOpenGate : 0u) | (tile->water ? kWater : 0u) |
                (tile->moves ? kMoves : 0u) | tile->portals << kPortalBit |
                static_cast<unsigned>(tile->plan.half) << kHalfShift;
    const std::array<int, 4> beside = {-across_, 1, across_, -1};
    for (int i = 0; i < 8; ++i)
        look.edges |=
            std::uint32_t{edgeTo(*tile, tile[beside[static_cast<std::size_t>(i / 2)]], i % 2 != 0)}
            << 4 * i;
    return look;
}

void MinimapMap::drawTile(const Look& look, int place) {
    const int left = place % across_ * size_;
    const int top = place / across_ * size_;
    // At least one pixel of what fills only a part of the tile
    const auto half = static_cast<Half>(look.kind >> kHalfShift);
    const auto isInHalf = [&](int x, int y) {
        const int east = isCutFalling(half) ? x - y : x + y + 1 - size_;
        return half == Half::none || (isEastern(half) ? east >= 0 : east <= 0);
    };
    const auto isWithin = [&](int at, int shift) {
        const int low = static_cast<int>(look.plan >> shift & 255u) * size_ / 16;
        const int high = static_cast<int>(look.plan >> (shift - 16) & 255u) * size_ / 16;
        return at >= low && at < std::max(low + 1, high);
    };
    for (int y = 0; y < size_; ++y) {
        for (int x = 0; x < size_; ++x) {
            const bool isBeside =
                look.ground != 0 && !(isWithin(x, 24) && isWithin(y, 16) && isInHalf(x, y));
            const Pixel colour = isBeside ? look.ground : look.colour;
            image_.at(left + x, top + y) =
                look.colour == 0 ? 0
                                 : (colour & ~kOpaque) | kSeen | markOf(look, x, y) << kMarkShift;
        }
    }
}

unsigned MinimapMap::markOf(const Look& look, int fromWest, int fromNorth) const {
    const int dash = (look.x * size_ + fromWest + look.y * size_ + fromNorth) / dash_;
    // Distances from the north, east, south and west edge
    const std::array<int, 4> from = {fromNorth, size_ - 1 - fromWest, size_ - 1 - fromNorth,
                                     fromWest};
    unsigned mark = none;
    for (unsigned i = 0; i < from.size(); ++i) {
        if ((look.kind >> kPortalBit >> i & 1u) != 0 && from[i] < std::max(1, size_ / 4))
            return portal;
        if ((look.kind & kOpenGate) != 0 && from[i] < std::max(1, size_ / 6)) return gate;
        if (from[i] < line_ && size_ >= 4)
            mark = std::max(mark, look.edges >> (8 * i + (dash % 2 == 0 ? 4 : 0)) & 15u);
    }
    if ((look.kind & kMoves) != 0 && dash % 3 == 0) return kStripe + mark;
    const bool isPlainWater = mark == none && (look.kind & kWater) != 0;
    if (isPlainWater && isRipple(size_, line_, fromWest, fromNorth)) return ripple;
    return mark;
}

// Blends a row of the kept picture over pixels. mapX and mapY are in pixels from the corner.
void MinimapMap::lay(Pixel* row, int count, Coordinate mapX, Coordinate mapY, MapStep step) const {
    constexpr int kAtOnce = 128;
    const int side = across_ * size_;
    const int cornerX = remainder(firstX_, across_) * size_;
    const int cornerY = remainder(firstY_, across_) * size_;
    std::array<Pixel, kAtOnce> under;
    std::array<Pixel, kAtOnce> over;
    for (; count > 0; count -= kAtOnce, row += kAtOnce) {
        const int some = std::min(count, kAtOnce);
        for (int i = 0; i < some; ++i) {
            int x = mapX.tile() + cornerX;
            int y = mapY.tile() + cornerY;
            x = x < side ? x : x - side;
            y = y < side ? y : y - side;
            const Pixel kept = image_.at(x, y);
            const bool isSeen = (kept & kSeen) != 0;
            under[static_cast<std::size_t>(i)] =
                isSeen ? (kept & ~kOpaque) | Pixel{kMinimapTileAlpha} << kMarkShift : 0;
            over[static_cast<std::size_t>(i)] = kMarkColours[kept >> kMarkShift & 15u];
            mapX = mapX + step.x;
            mapY = mapY + step.y;
        }
        blendRow(row, some, under.data());
        blendRow(row, some, over.data());
    }
}

}  // namespace slicecast
