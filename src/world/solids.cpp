#include "world/solids.h"

#include "world/water.h"

#include <algorithm>

namespace slicecast {
namespace {

// Calls met(solid) for the solid things above the box's place.
void visitBox(const Solids& solids, const Box& box, Visitor<const Box&> met) {
    const SolidRange columns = reached(box.west, box.east);
    const SolidRange rows = reached(box.north, box.south);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            solids.visit(x, y, box.bottom, box.top,
                         [&](Coordinate bottom, Coordinate top, const Plan& plan) {
                             const Box solid = {tileEdge(x) + plan.west,
                                                tileEdge(x) + plan.east,
                                                tileEdge(y) + plan.north,
                                                tileEdge(y) + plan.south,
                                                bottom,
                                                top};
                             if (solid.west < box.east && solid.east > box.west &&
                                 solid.north < box.south && solid.south > box.north)
                                 met(solid);
                         });
        }
    }
}

// How far the box gets along an axis whose ends are `low` and `high`.
Coordinate sweepAcross(const Solids& solids, const Box& box, Coordinate distance,
                       Coordinate Box::*low, Coordinate Box::*high) {
    const bool isUp = distance.raw > 0;
    Coordinate end = (isUp ? box.*high : box.*low) + distance;
    Box way = box;
    way.*low = isUp ? box.*high : end;
    way.*high = isUp ? end : box.*low;
    visitBox(solids, way, [&](const Box& solid) {
        if (solid.bottom >= box.top || solid.top <= box.bottom) return;
        if (isUp && solid.*low >= box.*high) end = std::min(end, solid.*low);
        if (!isUp && solid.*high <= box.*low) end = std::max(end, solid.*high);
    });
    return end - (isUp ? box.*high : box.*low);
}

}  // namespace

void MapSolids::visit(int x, int y, Coordinate low, Coordinate high, Meeting met) const {
    if (!map_.contains(x, y)) return met(Coordinate{-kBoundless.raw}, kBoundless, kWholeTile);
    const std::size_t tile = map_.tileIndex(x, y);
    const bool isWaded = !floats_ && map_.isWaterFloor(tile);
    met(Coordinate{-kBoundless.raw}, isWaded ? Coordinate{-kFloorWade.raw} : Coordinate{0},
        kWholeTile);
    met(kMaxBodyHeight, kBoundless, kWholeTile);
    const std::uint32_t occupied = map_.occupied[tile];
    const int first = std::max(0, Coordinate{low.raw - 1}.tile());
    const int last = std::min(map_.levels - 1, high.tile());
    for (int level = first; level <= last; ++level) {
        if ((occupied >> level & 1u) == 0) continue;
        const CellBlueprint& block = world_.blueprints[map_.cells[map_.cellIndex(x, y, level)]];
        if (block.passable || (block.isWater && !floats_)) continue;
        met(tileEdge(level) + block.bottom, tileEdge(level) + block.top, block.plan);
    }
    if (!map_.ceiling.tiles.empty() && map_.ceiling.tiles[tile] != kNoTexture)
        met(map_.ceiling.height, map_.ceiling.height, kWholeTile);
}

bool isFreeAmong(const Solids& solids, const Box& box) {
    bool free = true;
    visitBox(solids, box, [&](const Box& solid) {
        free = free && (solid.bottom >= box.top || solid.top <= box.bottom);
    });
    return free;
}

Coordinate sweepXAmong(const Solids& solids, const Box& box, Coordinate distance) {
    return sweepAcross(solids, box, distance, &Box::west, &Box::east);
}

Coordinate sweepYAmong(const Solids& solids, const Box& box, Coordinate distance) {
    return sweepAcross(solids, box, distance, &Box::north, &Box::south);
}

Coordinate sweepZAmong(const Solids& solids, const Box& box, Coordinate distance) {
    Box way = box;
    if (distance.raw > 0) {
        Coordinate end = box.top + distance;
        way.bottom = box.top;
        way.top = end;
        visitBox(solids, way, [&](const Box& solid) {
            if (solid.bottom >= box.top) end = std::min(end, solid.bottom);
        });
        return end - box.top;
    }
    Coordinate end = box.bottom + distance;
    way.bottom = end;
    way.top = box.bottom;
    visitBox(solids, way, [&](const Box& solid) {
        if (solid.top <= box.bottom) end = std::max(end, solid.top);
    });
    return end - box.bottom;
}

std::optional<Coordinate> leastRiseAmong(const Solids& solids, const Box& box, Coordinate limit) {
    // Raise it onto the highest obstacle, until nothing is in the way
    Box raised = box;
    for (;;) {
        Coordinate bottom = raised.bottom;
        visitBox(solids, raised, [&](const Box& solid) {
            if (solid.bottom < raised.top && solid.top > raised.bottom)
                bottom = std::max(bottom, solid.top);
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
