#include "world/solids.h"

#include "world/traveller.h"
#include "world/water.h"

#include <algorithm>

namespace slicecast {
namespace {

// What a box meets of a thing in a tile.
struct Obstacle {
    Box whole;
    Box box;  // around what is above or below the box that meets it
    const SolidSlopes& slopes;
    int x;
    int y;
    Half half;
};

// What a box meets of a plan while it goes along one axis, or up or down. The corner of the box
// that is nearest to a cut meets it, so to this box a half ends where the cut is at that corner:
//
//     +.
//     | `+---+
//     |  |box|  goes west, or south
//     +--+---+
Box reachOf(const Plan& plan, int x, int y, const Box& box, bool alongX) {
    Box reach = {tileEdge(x) + plan.west,
                 tileEdge(x) + plan.east,
                 tileEdge(y) + plan.north,
                 tileEdge(y) + plan.south,
                 {},
                 {}};
    if (plan.half == Half::none) return reach;
    const auto within = [](Coordinate at, int tile) {
        return std::clamp(at - tileEdge(tile), Coordinate{0}, tileEdge(1));
    };
    const bool isEast = isEastern(plan.half);
    const bool isSouth = isSouthern(plan.half);
    const Coordinate corner = alongX ? within(isSouth ? box.south : box.north, y)
                                     : within(isEast ? box.east : box.west, x);
    const Coordinate end = isCutFalling(plan.half) ? corner : tileEdge(1) - corner;
    if (alongX) {
        (isEast ? reach.west : reach.east) = tileEdge(x) + end;
    } else {
        (isSouth ? reach.north : reach.south) = tileEdge(y) + end;
    }
    return reach;
}

// The heights of a thing with slopes are those of its highest and its lowest point over `place` or
// under it, rounded outwards. False if nothing is left: portals may cut off a part of a thing too.
bool cutToSlopes(Obstacle& met, const Box& place) {
    met.box = met.whole;
    const Slopes& slopes = met.slopes.slopes;
    const bool alongX = slopes.alongX;
    const Coordinate low =
        alongX ? std::max(met.box.west, place.west) : std::max(met.box.north, place.north);
    const Coordinate high =
        alongX ? std::min(met.box.east, place.east) : std::min(met.box.south, place.south);
    const std::int64_t tile = tileEdge(alongX ? met.x : met.y).raw;
    const std::int64_t a = low.raw - tile;
    const std::int64_t b = high.raw - tile;
    const std::int64_t most = std::max(slopes.top.heightAt(a), slopes.top.heightAt(b));
    const std::int64_t least = std::min(slopes.bottom.heightAt(a), slopes.bottom.heightAt(b));
    const Coordinate base = met.slopes.base;
    met.box.top =
        std::min(met.box.top, base + Coordinate{static_cast<std::int32_t>((most + 0xffff) >> 16)});
    met.box.bottom =
        std::max(met.box.bottom, base + Coordinate{static_cast<std::int32_t>(least >> 16)});
    return met.box.bottom < met.box.top;
}

bool overlapOnGround(const Box& a, const Box& b) {
    return a.west < b.east && a.east > b.west && a.north < b.south && a.south > b.north;
}

// Calls met() for the solid things above the box's place that it meets along an axis.
void visitBox(const Solids& solids, const Box& box, bool alongX, Visitor<const Obstacle&> met) {
    const SolidRange columns = reached(box.west, box.east);
    const SolidRange rows = reached(box.north, box.south);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            solids.visit(x, y, box.bottom, box.top,
                         [&](Coordinate bottom, Coordinate top, const Plan& plan,
                             const SolidSlopes& slopes) {
                             Box solid = reachOf(plan, x, y, box, alongX);
                             solid.bottom = bottom;
                             solid.top = top;
                             if (!overlapOnGround(solid, box)) return;
                             Obstacle obstacle = {solid, solid, slopes, x, y, plan.half};
                             if (!slopes.slopes.any() || cutToSlopes(obstacle, box)) met(obstacle);
                         });
        }
    }
}

// The same for a box that goes up or down, or stays where it is.
void visitBox(const Solids& solids, const Box& box, Visitor<const Box&> met) {
    visitBox(solids, box, true, [&](const Obstacle& obstacle) { met(obstacle.box); });
}

bool isSteep(const Slant& top) {
    return top.rise() > kSteepest.raw || top.rise() < -kSteepest.raw;
}

// How far a box gets along the rise of a thing with slopes, from the end `from` of its way. It
// does not get to the end `to`: nothing solid `stops` it in a part of the way before that place.
template <typename Stops>
Coordinate endAtSlopes(const Obstacle& obstacle, const Box& way, Coordinate Box::*from,
                       Coordinate Box::*to, const Stops& stops) {
    Coordinate isFree = way.*from;
    Coordinate isStopped = way.*to;
    Obstacle met = obstacle;
    while (isStopped.raw - isFree.raw > 1 || isFree.raw - isStopped.raw > 1) {
        const Coordinate middle = {isFree.raw + (isStopped.raw - isFree.raw) / 2};
        Box part = way;
        part.*to = middle;
        const bool isMet = overlapOnGround(met.whole, part) && cutToSlopes(met, part);
        (isMet && stops(met.box) ? isStopped : isFree) = middle;
    }
    return isFree;
}

// How far the box gets along an axis whose ends are `low` and `high`.
Coordinate sweepAcross(const Solids& solids, const Box& box, Coordinate distance,
                       Coordinate Box::*low, Coordinate Box::*high) {
    const bool isUp = distance.raw > 0;
    Coordinate end = (isUp ? box.*high : box.*low) + distance;
    Box way = box;
    way.*low = isUp ? box.*high : end;
    way.*high = isUp ? end : box.*low;
    const auto stops = [&](const Box& solid) {
        return solid.bottom < box.top && solid.top > box.bottom;
    };
    visitBox(solids, way, low == &Box::west, [&](const Obstacle& obstacle) {
        const Box& solid = obstacle.box;
        if (!stops(solid)) return;
        if (obstacle.slopes.slopes.any() && obstacle.slopes.slopes.alongX == (low == &Box::west)) {
            end = isUp ? std::min(end, endAtSlopes(obstacle, way, low, high, stops))
                       : std::max(end, endAtSlopes(obstacle, way, high, low, stops));
            return;
        }
        if (isUp && solid.*low >= box.*high) end = std::min(end, solid.*low);
        if (!isUp && solid.*high <= box.*low) end = std::max(end, solid.*high);
    });
    return end - (isUp ? box.*high : box.*low);
}

// Whether a box that goes along an axis meets the cut of a half: not a side, and not a corner.
bool isAtCut(const Obstacle& obstacle, const Box& box, bool alongX, bool isUp) {
    const auto& [whole, solid, slopes, x, y, half] = obstacle;
    const bool isEast = isEastern(half);
    const bool isSouth = isSouthern(half);
    if (half == Half::none || isUp != (alongX ? isEast : isSouth)) return false;
    if (alongX) return isSouth ? box.south <= tileEdge(y + 1) : box.north >= tileEdge(y);
    return isEast ? box.east <= tileEdge(x + 1) : box.west >= tileEdge(x);
}

}  // namespace

bool isOver(const Plan& plan, int x, int y, const Box& box) {
    return overlapOnGround(reachOf(plan, x, y, box, true), box);
}

void MapSolids::visit(int x, int y, Coordinate low, Coordinate high, Meeting met) const {
    if (!map_.contains(x, y))
        return met(Coordinate{-kBoundless.raw}, kBoundless, kWholeTile, kNoSlopes);
    const std::size_t tile = map_.tileIndex(x, y);
    const bool isWaded = !floats_ && map_.isWaterFloor(tile);
    met(Coordinate{-kBoundless.raw}, isWaded ? Coordinate{-kFloorWade.raw} : Coordinate{0},
        kWholeTile, kNoSlopes);
    met(kMaxBodyHeight, kBoundless, kWholeTile, kNoSlopes);
    const std::uint32_t occupied = map_.occupied[tile];
    const int first = std::max(0, Coordinate{low.raw - 1}.tile());
    const int last = std::min(map_.levels - 1, high.tile());
    for (int level = first; level <= last; ++level) {
        if ((occupied >> level & 1u) == 0) continue;
        const CellBlueprint& block = world_.blueprints[map_.cells[map_.cellIndex(x, y, level)]];
        if (block.passable || (block.isWater && !floats_)) continue;
        met(tileEdge(level) + block.bottom, tileEdge(level) + block.top, block.plan,
            block.slopes.any() ? SolidSlopes{block.slopes, tileEdge(level)} : kNoSlopes);
    }
    if (!map_.ceiling.tiles.empty() && map_.ceiling.tiles[tile] != kNoTexture)
        met(map_.ceiling.height, map_.ceiling.height, kWholeTile, kNoSlopes);
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

namespace {

std::optional<Coordinate> leastRise(const Solids& solids, const Box& box, Coordinate limit,
                                    bool climbs) {
    // Raise it onto the highest obstacle, until nothing is in the way
    Box raised = box;
    for (;;) {
        Coordinate bottom = raised.bottom;
        bool isSlippery = false;
        visitBox(solids, raised, true, [&](const Obstacle& obstacle) {
            const Box& solid = obstacle.box;
            if (solid.bottom >= raised.top || solid.top <= raised.bottom) return;
            bottom = std::max(bottom, solid.top);
            isSlippery = isSlippery || isSteep(obstacle.slopes.slopes.top);
        });
        if (climbs && isSlippery) return std::nullopt;
        const Coordinate rise = bottom - box.bottom;
        if (rise > limit) return std::nullopt;
        if (bottom == raised.bottom) return rise;
        raised = moved(box, {.x = {}, .y = {}, .z = rise});
    }
}

// The same for a step: nobody steps onto a steep slope.
std::optional<Coordinate> climbAmong(const Solids& solids, const Box& box, Coordinate limit) {
    return leastRise(solids, box, limit, true);
}

}  // namespace

std::optional<Coordinate> leastRiseAmong(const Solids& solids, const Box& box, Coordinate limit) {
    return leastRise(solids, box, limit, false);
}

int slipAmong(const Solids& solids, const Box& box, Coordinate Offset::*axis, bool isUp) {
    const bool alongX = axis == &Offset::x;
    Offset further;
    further.*axis = {isUp ? 1 : -1};
    const Box next = moved(box, further);
    bool isMet[] = {false, false, false};  // by a rising cut, by something else, by a falling cut
    visitBox(solids, next, alongX, [&](const Obstacle& obstacle) {
        if (obstacle.box.bottom >= box.top || obstacle.box.top <= box.bottom) return;
        const int slip = !isAtCut(obstacle, box, alongX, isUp) ? 0
                         : isCutFalling(obstacle.half)         ? 1
                                                               : -1;
        isMet[slip + 1] = true;
    });
    return isMet[1] || isMet[0] == isMet[2] ? 0 : isMet[2] ? 1 : -1;
}

Fall fallAmong(const Solids& solids, const Box& box) {
    Box below = box;
    below.bottom = {box.bottom.raw - 1};
    below.top = box.bottom;
    Fall fall;
    bool isFirm = false;
    visitBox(solids, below, true, [&](const Obstacle& obstacle) {
        if (obstacle.box.top != box.bottom) return;
        const Slant& top = obstacle.slopes.slopes.top;
        isFirm = isFirm || !isSteep(top);
        (obstacle.slopes.slopes.alongX ? fall.x : fall.y) -= Coordinate{top.rise()}.value();
    });
    return isFirm ? Fall{} : fall;
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
        step.raw > 0 ? climbAmong(solids, moved(state.box, wholeWay), step) : std::nullopt;
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
