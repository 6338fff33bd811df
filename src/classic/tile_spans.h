// Finds the tiles that a column's ground line passes: by the exact walk from border to border, or
// by a march that checks its position after every step.
//
//     +-----+-----+          The march goes from the eye e in equal strides. It finds the wall #
//     |     | #.  |          up to a stride behind its border, never finds a corner that lies
//     |     .     |          between two strides, and guesses the face from the quadrant of the
//     | e . |     |          tile in which it arrived.
//     +-----+-----+
#pragma once

#include "classic/classic_options.h"
#include "classic/column_ray.h"
#include "world/map.h"
#include "world/plan.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast::classic {

struct TileSpan {
    int x = 0;
    int y = 0;
    double enter = 0.0;  // `along` of the ray
    double leave = 0.0;
    bool first = false;          // the first tile of a walk, which was not entered
    Face entered = Face::north;  // face of this tile by which the line entered
    Face left = Face::north;     // and by which it leaves
};

// The part of the way over a tile that lies over a block's plan, whose edges count as borders.
// Nothing if the line passes beside it.
std::optional<TileSpan> spanOver(const Plan& plan, const View& view, const ColumnRay& ray,
                                 const TileSpan& tile);

// The start of a walk: in the eye's tile, or in the exit tile of a portal.
struct TileStart {
    int x = 0;
    int y = 0;
    double along = 0.0;
};

// Replace `spans` by the passed tiles of the grid in order. Return the number of places examined.
std::int64_t walkTiles(const Map& map, const View& view, const ColumnRay& ray,
                       const TileStart& start, std::vector<TileSpan>& spans);
std::int64_t marchTiles(const Map& map, const View& view, const ColumnRay& ray,
                        const TileStart& start, const ClassicOptions& classic,
                        std::vector<TileSpan>& spans);

}  // namespace slicecast::classic
