#include "overlay/minimap_map.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace slicecast {
namespace {

constexpr Colour kMover = {204, 170, 255, 255};
constexpr Coordinate kClearStep = Coordinate{65536 / 16};  // units, of which an edge is drawn

// What lies over a tile's own colour; of the edges that meet, the one with the greatest number.
enum Mark : std::uint8_t { none, stepEdge, shadow, overhang, blockEdge, ripple, portal, gate };
constexpr std::array<Pixel, 8> kMarkColours = {0,
                                               toPixel({236, 240, 244, 64}),
                                               toPixel({0, 0, 0, 110}),
                                               toPixel({236, 240, 244, 150}),
                                               toPixel({236, 240, 244, 190}),
                                               toPixel({206, 232, 244, 96}),
                                               toPixel(kMinimapPortal),
                                               toPixel(kMinimapGate)};
constexpr unsigned kMarkBits = 3;
constexpr unsigned kStripe = 1u << kMarkBits;  // of what moves, instead of the tile's colour
constexpr int kTileBits = 4;                   // from there on the tile's place
constexpr int kMostAcross = 64;                // so it has room in a mark

constexpr int floorDivide(int a, int b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

constexpr int remainder(int a, int b) {
    return a - floorDivide(a, b) * b;
}

// A light edge where a tile is higher than the one beside it, a shadow where it is lower, a dashed
// line where something above the level begins.
Mark edgeTo(const MinimapTile& tile, const MinimapTile& beside, bool onDash) {
    const bool under = tile.over && !tile.block;
    if (under && onDash && !beside.over && !beside.block) return overhang;
    if (tile.block && !beside.block) return blockEdge;
    if (beside.colour.a == 0) return none;
    if (tile.surface >= beside.surface + kClearStep) return stepEdge;
    if (beside.surface >= tile.surface + kClearStep) return shadow;
    return none;
}

// Two strokes on each tile of water, one east of the other and below it.
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
    // A turned square needs the tiles within half of its diagonal, and all of them those beside
    // them.
    const int width = view.area.width;
    const int reach = width * 3 / 4 + 2 * view.pixelsPerTile;
    resize(std::min(2 * reach / view.pixelsPerTile + 2, kMostAcross), view.pixelsPerTile, scale,
           width);
    firstX_ = floorDivide(view.eyeX - reach, size_);
    firstY_ = floorDivide(view.eyeY - reach, size_);
    lookUp(place);

    // Along a row the place on the map goes on by the same step, in 1/65536 pixels
    const Point step = view.toMap({1.0, 0.0});
    for (int row = 0; row < view.area.height; ++row) {
        const int inset = plateInset(std::min(row, view.area.height - 1 - row), scale);
        const int y = view.area.y + row;
        const Point first = view.toMap({static_cast<double>(view.area.x - view.centreX),
                                        static_cast<double>(y - view.centreY)});
        fetch(width,
              toCoordinate(first.x + 0.5) + Coordinate{(view.eyeX - firstX_ * size_) * 65536},
              toCoordinate(first.y + 0.5) + Coordinate{(view.eyeY - firstY_ * size_) * 65536},
              toCoordinate(step.x), toCoordinate(step.y));
        Pixel* const pixels = picture.row(y) + view.area.x + inset;
        const int count = width - 2 * inset;
        blendRow(pixels, count, under_.data() + inset);
        blendRow(pixels, count, over_.data() + inset);
    }
}

// Forgets everything where anything is of another size.
void MinimapMap::resize(int across, int size, int scale, int width) {
    const auto pixels = static_cast<std::size_t>(width);
    if (size == size_ && dash_ == 2 * scale && under_.size() == pixels) return;
    across_ = across;
    size_ = size;
    line_ = std::max(1, size / 14);
    dash_ = 2 * scale;
    const auto tiles = static_cast<std::size_t>(across * across);
    tiles_.assign(tiles, {});
    looks_.assign(tiles, {});
    marks_.assign(tiles * static_cast<std::size_t>(size * size), 0);
    colours_.assign(2 * tiles, 0);
    under_.assign(pixels, 0);
    over_.assign(pixels, 0);
}

void MinimapMap::lookUp(const Place& place) {
    for (int i = 0; i < across_ * across_; ++i)
        tiles_[static_cast<std::size_t>(i)] = minimapTile(
            place.world, place.map, firstX_ + i % across_, firstY_ + i / across_, place.level);
    for (int y = 1; y < across_ - 1; ++y) {
        for (int x = 1; x < across_ - 1; ++x) {
            const Look look = lookOf(x, y);
            const int slot = remainder(look.y, across_) * across_ + remainder(look.x, across_);
            Look& drawn = looks_[static_cast<std::size_t>(slot)];
            if (drawn == look) continue;
            drawn = look;
            drawTile(look, slot);
            ++drawnTiles_;
        }
    }
}

MinimapMap::Look MinimapMap::lookOf(int x, int y) const {
    const MinimapTile* const tile = &tiles_[static_cast<std::size_t>(y * across_ + x)];
    Look look{.x = firstX_ + x, .y = firstY_ + y, .colour = tile->colour};
    if (tile->colour.a == 0) return look;
    look.openGate = tile->openGate;
    look.water = tile->water;
    look.moves = tile->moves;
    look.portals = static_cast<std::uint8_t>(tile->portals);
    const std::array<const MinimapTile*, 4> beside = {tile - across_, tile + 1, tile + across_,
                                                      tile - 1};
    for (std::size_t i = 0; i < beside.size(); ++i) {
        look.edges[i] = edgeTo(*tile, *beside[i], false);
        look.dashes[i] = edgeTo(*tile, *beside[i], true);
    }
    return look;
}

void MinimapMap::drawTile(const Look& look, int slot) {
    Pixel* const colours = &colours_[static_cast<std::size_t>(2 * slot)];
    colours[0] = toPixel(look.colour);
    colours[1] = toPixel(kMover);
    const int pitch = across_ * size_;
    std::uint16_t* row =
        &marks_[static_cast<std::size_t>(slot / across_ * size_ * pitch + slot % across_ * size_)];
    for (int y = 0; y < size_; ++y, row += pitch) {
        for (int x = 0; x < size_; ++x)
            row[x] = static_cast<std::uint16_t>(static_cast<unsigned>(slot) << kTileBits |
                                                markOf(look, x, y));
    }
}

unsigned MinimapMap::markOf(const Look& look, int fromWest, int fromNorth) const {
    if (look.colour.a == 0) return none;
    const int sum = look.x * size_ + fromWest + look.y * size_ + fromNorth;
    // From the north, east, south and west edge
    const std::array<int, 4> from = {fromNorth, size_ - 1 - fromWest, size_ - 1 - fromNorth,
                                     fromWest};
    for (std::size_t i = 0; i < from.size(); ++i) {
        if ((look.portals >> i & 1u) != 0 && from[i] < std::max(1, size_ / 4)) return portal;
        if (look.openGate && from[i] < std::max(1, size_ / 6)) return gate;
    }
    const bool onDash = sum / dash_ % 2 == 0;
    std::uint8_t mark = none;
    for (std::size_t i = 0; size_ >= 4 && i < from.size(); ++i) {
        if (from[i] < line_) mark = std::max(mark, (onDash ? look.dashes : look.edges)[i]);
    }
    if (look.moves && sum / dash_ % 3 == 0) return kStripe | mark;
    if (mark == none && look.water && isRipple(size_, line_, fromWest, fromNorth)) return ripple;
    return mark;
}

// A row's colours from what is kept, from a place counted from the corner, in pixels.
void MinimapMap::fetch(int count, Coordinate mapX, Coordinate mapY, Coordinate stepX,
                       Coordinate stepY) {
    const int side = across_ * size_;
    const int cornerX = remainder(firstX_, across_) * size_;
    const int cornerY = remainder(firstY_, across_) * size_;
    const std::uint16_t* const marks = marks_.data();
    for (int i = 0; i < count; ++i) {
        int x = mapX.tile() + cornerX;
        int y = mapY.tile() + cornerY;
        x = x < side ? x : x - side;
        y = y < side ? y : y - side;
        const unsigned mark = marks[y * side + x];
        under_[static_cast<std::size_t>(i)] = colours_[mark >> kMarkBits];
        over_[static_cast<std::size_t>(i)] = kMarkColours[mark % kStripe];
        mapX = mapX + stepX;
        mapY = mapY + stepY;
    }
}

}  // namespace slicecast
