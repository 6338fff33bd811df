// The walk within a tile whose blocks fill only parts of it.
//
//      +-----------------+        A ray enters the tile at a, the block at b, leaves the block at c
//      |     +-----+     |        and the tile at d. So the tile has three stretches, and in each of
//   a  *-.   |     |     |        them a block is either there or not.
//      |   ' b.    |     |
//      |     |  ' .c     |
//      |     +-----+' -. |
//      +-----------------* d
//
// Edges of plans are met like borders of tiles: at exact distances, with the same rule for ties.
// So is the cut of a half. Whether a ray passes it follows from the borders by which it enters and
// leaves the tile, which are of one half or of both; so no ray slips through at a corner.
#pragma once

#include "render/spans/grid_walk.h"
#include "render/view/viewpoint.h"
#include "world/plan.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace slicecast {

// Where a ray enters and leaves a block in a tile. A crossing without sides is the tile's own.
struct PlanPassage {
    bool isMet = false;
    Crossing enter = {.border = false};
    Crossing leave = {.border = false};
};

// `eye` is in the coordinates of the walk's map.
class PlanWalk {
public:
    PlanWalk(const GridWalk& walk, const Viewpoint& eye, GroundDirection ray)
        : walk_(walk), eye_(eye), ray_(ray) {}

    // How the ray passes a block in the current tile.
    PlanPassage passage(const Plan& plan) const;

    // Whether a block in tile (x, y) is at both sides of a border where the ray crosses it:
    // `isAhead` if the tile is behind the border.
    bool touches(const Plan& plan, int x, int y, const Crossing& border, bool isAhead) const;

    // Whether one of two crossings of the ray comes first.
    bool isBefore(const Crossing& a, const Crossing& b) const;

private:
    // Both edges of a plan on one axis, the nearer one first.
    struct Edges {
        Crossing near;
        Crossing far;
        bool nearIsBorder;  // of the tile
        bool farIsBorder;
    };
    Edges edges(const Plan& plan, int x, int y, bool alongX) const;
    Crossing edge(int tile, Coordinate at, bool alongX) const;
    bool isEyeMovedOn(bool alongX) const;
    PlanPassage halfPassage(Half half) const;
    bool isEyeIn(Half half) const;
    Crossing cut(Half half) const;

    const GridWalk& walk_;
    const Viewpoint& eye_;
    GroundDirection ray_;
};

// An edge inside a tile where blocks begin or end: a bit for each level.
struct PlanEdge {
    Crossing at;
    std::uint32_t enters = 0;
    std::uint32_t leaves = 0;
};

// The edges that a ray crosses in a tile, in their order.
class PlanEdges {
public:
    void add(const PlanWalk& walk, const Crossing& at, std::uint32_t enters, std::uint32_t leaves);
    void clear() { count_ = 0; }
    const PlanEdge* begin() const { return edges_.data(); }
    const PlanEdge* end() const { return edges_.data() + count_; }

private:
    std::array<PlanEdge, 2 * 32> edges_;  // two for each level
    std::size_t count_ = 0;
};

}  // namespace slicecast
