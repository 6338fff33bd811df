#include "world/solids.h"

#include "world/water.h"

#include <algorithm>

namespace slicecast {
namespace {

// Calls met(bottom, top) for all tiles that the box reaches into.
void visitBox(const Solids& solids, const Box& box, Meeting met) {
    const SolidRange columns = reached(box.west, box.east);
    const SolidRange rows = reached(box.north, box.south);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x)
            solids.visit(x, y, box.bottom, box.top, met);
    }
}

bool tileBlocks(const Solids& solids, int x, int y, Coordinate bottom, Coordinate top) {
    bool blocks = false;
    solids.visit(x, y, bottom, top, [&](Coordinate low, Coordinate high) {
        blocks = blocks || (low < top && high > bottom);
    });
    return blocks;
}

// How far the box's side gets along an axis; blocks(i) is true if tile i of that axis stops it.
// Obstacles start at tile edges.
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

}  // namespace

void MapSolids::visit(int x, int y, Coordinate low, Coordinate high, Meeting met) const {
    if (!map_.contains(x, y)) return met(Coordinate{-kBoundless.raw}, kBoundless);
    const std::size_t tile = map_.tileIndex(x, y);
    const bool isWaded = !floats_ && map_.isWaterFloor(tile);
    met(Coordinate{-kBoundless.raw}, isWaded ? Coordinate{-kFloorWade.raw} : Coordinate{0});
    met(kMaxBodyHeight, kBoundless);
    const std::uint32_t occupied = map_.occupied[tile];
    const int first = std::max(0, Coordinate{low.raw - 1}.tile());
    const int last = std::min(map_.levels - 1, high.tile());
    for (int level = first; level <= last; ++level) {
        if ((occupied >> level & 1u) == 0) continue;
        const CellBlueprint& block = world_.blueprints[map_.cells[map_.cellIndex(x, y, level)]];
        if (block.passable || (block.isWater && !floats_)) continue;
        met(tileEdge(level) + block.bottom, tileEdge(level) + block.top);
    }
    if (!map_.ceiling.tiles.empty() && map_.ceiling.tiles[tile] != kNoTexture)
        met(map_.ceiling.height, map_.ceiling.height);
}

bool isFreeAmong(const Solids& solids, const Box& box) {
    bool free = true;
    visitBox(solids, box, [&](Coordinate bottom, Coordinate top) {
        free = free && (bottom >= box.top || top <= box.bottom);
    });
    return free;
}

Coordinate sweepXAmong(const Solids& solids, const Box& box, Coordinate distance) {
    const SolidRange rows = reached(box.north, box.south);
    return sweepAcross(box.west, box.east, distance, [&](int x) {
        for (int y = rows.first; y <= rows.last; ++y) {
            if (tileBlocks(solids, x, y, box.bottom, box.top)) return true;
        }
        return false;
    });
}

Coordinate sweepYAmong(const Solids& solids, const Box& box, Coordinate distance) {
    const SolidRange columns = reached(box.west, box.east);
    return sweepAcross(box.north, box.south, distance, [&](int y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            if (tileBlocks(solids, x, y, box.bottom, box.top)) return true;
        }
        return false;
    });
}

Coordinate sweepZAmong(const Solids& solids, const Box& box, Coordinate distance) {
    Box way = box;
    if (distance.raw > 0) {
        Coordinate end = box.top + distance;
        way.bottom = box.top;
        way.top = end;
        visitBox(solids, way, [&](Coordinate bottom, Coordinate) {
            if (bottom >= box.top) end = std::min(end, bottom);
        });
        return end - box.top;
    }
    Coordinate end = box.bottom + distance;
    way.bottom = end;
    way.top = box.bottom;
    visitBox(solids, way, [&](Coordinate, Coordinate top) {
        if (top <= box.bottom) end = std::max(end, top);
    });
    return end - box.bottom;
}

std::optional<Coordinate> leastRiseAmong(const Solids& solids, const Box& box, Coordinate limit) {
    // Raise it onto the highest obstacle, until nothing is in the way
    Box raised = box;
    for (;;) {
        Coordinate bottom = raised.bottom;
        visitBox(solids, raised, [&](Coordinate low, Coordinate high) {
            if (low < raised.top && high > raised.bottom) bottom = std::max(bottom, high);
        });
        const Coordinate rise = bottom - box.bottom;
        if (rise > limit) return std::nullopt;
        if (bottom == raised.bottom) return rise;
        raised = moved(box, {.x = {}, .y = {}, .z = rise});
    }
}

// #region advance
bool advanceAmong(const Solids& solids, Slide& state, Coordinate Offset::*axis, Coordinate distance,
                  Coordinate step) {
    Offset way;
    way.*axis = axis == &Offset::x ? sweepXAmong(solids, state.box, distance)
                                   : sweepYAmong(solids, state.box, distance);
    if (way.*axis == distance) {
        state.box = moved(state.box, way);
        return true;
    }
    // Up, if there is room, and across. The rise is the least that frees the body there, so it
    // lands without moving down. The way across needs no test: this part is shorter than the body,
    // so on arrival the body touches all tiles of the way.
    Offset wholeWay;
    wholeWay.*axis = distance;
    const std::optional<Coordinate> rise =
        step.raw > 0 ? leastRiseAmong(solids, moved(state.box, wholeWay), step) : std::nullopt;
    if (rise && sweepZAmong(solids, state.box, *rise) == *rise) {
        wholeWay.z = *rise;
        state.box = moved(state.box, wholeWay);
        state.rise = state.rise + *rise;
        return true;
    }
    state.box = moved(state.box, way);
    return false;
}
// #endregion

}  // namespace slicecast
