#include "world/collision.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace slicecast {
namespace {

const Map* findMap(const World& world, int map) {
    return map >= 0 && static_cast<std::size_t>(map) < world.maps.size() ? &world.maps[static_cast<std::size_t>(map)] : nullptr;
}

// Tiles or levels first .. last, both included; none if last < first.
struct Range {
    int first;
    int last;
};

// Those that the open interval low < v < high reaches into.
constexpr Range reached(Coordinate low, Coordinate high) {
    return {low.tile(), Coordinate{high.raw - 1}.tile()};
}

// Calls visit(bottom, top) for the solid things above one tile that touch the heights from `low` to `high`, and maybe for some that do not.
template <typename Visit>
void visitTile(const World& world, const Map& map, int x, int y, Coordinate low, Coordinate high, Visit visit) {
    const std::size_t tile = map.tileIndex(x, y);
    const int first = std::max(0, Coordinate{low.raw - 1}.tile());
    const int last = std::min(map.levels - 1, high.tile());
    for (int level = first; level <= last; ++level) {
        if ((map.occupied[tile] >> level & 1u) == 0) continue;
        const CellBlueprint& block = world.blueprints[map.cells[map.cellIndex(x, y, level)]];
        if (block.passable) continue;
        visit(tileEdge(level) + block.bottom, tileEdge(level) + block.top);
    }
    if (!map.ceiling.tiles.empty() && map.ceiling.tiles[tile] != kNoTexture) visit(map.ceiling.height, map.ceiling.height);
}

// Calls visit(bottom, top) as above for every tile that the box reaches into. The box is inside the grid.
template <typename Visit>
void visitBox(const World& world, const Map& map, const Box& box, Visit visit) {
    const Range columns = reached(box.west, box.east);
    const Range rows = reached(box.north, box.south);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) visitTile(world, map, x, y, box.bottom, box.top, visit);
    }
}

bool isInsideOutline(const Map& map, const Box& box) {
    return box.west.raw >= 0 && box.north.raw >= 0 && box.east <= tileEdge(map.width) && box.south <= tileEdge(map.depth);
}

bool tileBlocks(const World& world, const Map& map, int x, int y, Coordinate bottom, Coordinate top) {
    if (!map.contains(x, y)) return true;
    bool blocks = false;
    visitTile(world, map, x, y, bottom, top, [&](Coordinate low, Coordinate high) { blocks = blocks || (low < top && high > bottom); });
    return blocks;
}

// How far a side at `side` gets on its way along an axis of the grid, if blocks(i) tells whether tile i of that axis is in the way. Whatever stops it begins
// at a tile's edge.
template <typename Blocks>
Coordinate sweepAcross(Coordinate low, Coordinate high, Coordinate distance, Blocks blocks) {
    if (distance.raw > 0) {
        const int last = Coordinate{high.raw + distance.raw - 1}.tile();
        for (int i = Coordinate{high.raw - 1}.tile() + 1; i <= last; ++i) {
            if (blocks(i)) return tileEdge(i) - high;
        }
    } else if (distance.raw < 0) {
        const int last = (low + distance).tile();
        for (int i = low.tile() - 1; i >= last; --i) {
            if (blocks(i)) return tileEdge(i + 1) - low;
        }
    }
    return distance;
}

// One part of a slide, along one axis and over a step if need be. True if it got all the way.
template <typename Sweep>
bool advance(const World& world, int map, Slide& state, Coordinate Offset::*axis, Coordinate distance, Coordinate step, Sweep sweep) {
    Offset way;
    way.*axis = sweep(world, map, state.box, distance);
    if (way.*axis == distance) {
        state.box = moved(state.box, way);
        return true;
    }
    // Up, if there is room, and across. The rise is the least that frees the body over there, so it comes to rest there without a way down, and nothing is
    // in its way across: the part is shorter than the body, which has reached into all the same tiles when it arrives.
    Offset wholeWay;
    wholeWay.*axis = distance;
    const std::optional<Coordinate> rise = step.raw > 0 ? leastRise(world, map, moved(state.box, wholeWay), step) : std::nullopt;
    if (rise && sweepZ(world, map, state.box, *rise) == *rise) {
        wholeWay.z = *rise;
        state.box = moved(state.box, wholeWay);
        state.rise = state.rise + *rise;
        return true;
    }
    state.box = moved(state.box, way);
    return false;
}

}  // namespace

bool isFree(const World& world, int map, const Box& box) {
    const Map* where = findMap(world, map);
    if (where == nullptr || box.bottom.raw < 0 || box.top > kMaxBodyHeight || !isInsideOutline(*where, box)) return false;
    bool free = true;
    visitBox(world, *where, box, [&](Coordinate bottom, Coordinate top) { free = free && (bottom >= box.top || top <= box.bottom); });
    return free;
}

Coordinate sweepX(const World& world, int map, const Box& box, Coordinate distance) {
    const Map* where = findMap(world, map);
    if (where == nullptr) return {};
    const Range rows = reached(box.north, box.south);
    return sweepAcross(box.west, box.east, distance, [&](int x) {
        for (int y = rows.first; y <= rows.last; ++y) {
            if (tileBlocks(world, *where, x, y, box.bottom, box.top)) return true;
        }
        return false;
    });
}

Coordinate sweepY(const World& world, int map, const Box& box, Coordinate distance) {
    const Map* where = findMap(world, map);
    if (where == nullptr) return {};
    const Range columns = reached(box.west, box.east);
    return sweepAcross(box.north, box.south, distance, [&](int y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            if (tileBlocks(world, *where, x, y, box.bottom, box.top)) return true;
        }
        return false;
    });
}

Coordinate sweepZ(const World& world, int map, const Box& box, Coordinate distance) {
    const Map* where = findMap(world, map);
    if (where == nullptr || !isInsideOutline(*where, box)) return {};
    Box way = box;
    if (distance.raw > 0) {
        Coordinate end = std::min(box.top + distance, kMaxBodyHeight);
        way.bottom = box.top;
        way.top = end;
        visitBox(world, *where, way, [&](Coordinate bottom, Coordinate) {
            if (bottom >= box.top) end = std::min(end, bottom);
        });
        return end - box.top;
    }
    Coordinate end = std::max(box.bottom + distance, Coordinate{0});
    way.bottom = end;
    way.top = box.bottom;
    visitBox(world, *where, way, [&](Coordinate, Coordinate top) {
        if (top <= box.bottom) end = std::max(end, top);
    });
    return end - box.bottom;
}

bool isSupported(const World& world, int map, const Box& box) {
    return sweepZ(world, map, box, {-1}).raw == 0;
}

std::optional<Coordinate> leastRise(const World& world, int map, const Box& box, Coordinate limit) {
    const Map* where = findMap(world, map);
    if (where == nullptr || !isInsideOutline(*where, box)) return std::nullopt;
    // Onto the highest thing in the way, again and again: each time is higher than the last.
    Box raised = box;
    for (;;) {
        Coordinate bottom = std::max(raised.bottom, Coordinate{0});
        visitBox(world, *where, raised, [&](Coordinate low, Coordinate high) {
            if (low < raised.top && high > raised.bottom) bottom = std::max(bottom, high);
        });
        const Coordinate rise = bottom - box.bottom;
        if (rise > limit || box.top + rise > kMaxBodyHeight) return std::nullopt;
        if (bottom == raised.bottom) return rise;
        raised = moved(box, {.x = {}, .y = {}, .z = rise});
    }
}

Slide slide(const World& world, int map, const Box& box, Coordinate distanceX, Coordinate distanceY, Coordinate step) {
    Slide state;
    state.box = box;
    const std::int64_t longest = std::max(std::abs(std::int64_t{distanceX.raw}), std::abs(std::int64_t{distanceY.raw}));
    const std::int64_t parts = (longest + kLongestSlide.raw - 1) / kLongestSlide.raw;
    const auto part = [parts](Coordinate whole, std::int64_t i) {
        return Coordinate{static_cast<std::int32_t>(whole.raw * (i + 1) / parts - whole.raw * i / parts)};
    };
    for (std::int64_t i = 0; i < parts; ++i) {
        const Coordinate x = part(distanceX, i);
        const Coordinate y = part(distanceY, i);
        if (x.raw != 0 && !advance(world, map, state, &Offset::x, x, step, sweepX)) state.stoppedX = true;
        if (y.raw != 0 && !advance(world, map, state, &Offset::y, y, step, sweepY)) state.stoppedY = true;
    }
    return state;
}

}  // namespace slicecast
