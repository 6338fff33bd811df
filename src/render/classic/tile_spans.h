// Which tiles of the grid a column's ground line passes: by the exact walk from border to border,
// or by the march that looks every so often where it is.
//
//     +-----+-----+          the march steps from the eye e in equal strides. It finds the wall #
//     |     | #.  |          up to a stride behind its border, never finds a corner that lies
//     |     .     |          between two strides, and tells the face by the quadrant of the tile in
//     | e . |     |          which it came to stand
//     +-----+-----+
#pragma once

#include "render/classic/classic_options.h"
#include "render/classic/column_ray.h"
#include "world/map.h"

#include <cstdint>
#include <vector>

namespace slicecast::classic {

struct TileSpan {
    int x = 0;
    int y = 0;
    double enter = 0.0;  // `along` of the ray
    double leave = 0.0;
    bool first = false;          // where the walk begins: nothing was entered
    Face entered = Face::north;  // the face of this tile that the line came in through
    Face left = Face::north;     // and goes out through
};

// Where a walk begins: in the eye's tile, or in the exit tile of a portal.
struct TileStart {
    int x = 0;
    int y = 0;
    double along = 0.0;
};

// Replace `spans` by the tiles of the grid in the order in which they are passed, and give the
// number of places that were looked at.
std::int64_t walkTiles(const Map& map, const View& view, const ColumnRay& ray,
                       const TileStart& start, std::vector<TileSpan>& spans);
std::int64_t marchTiles(const Map& map, const View& view, const ColumnRay& ray,
                        const TileStart& start, const ClassicOptions& classic,
                        std::vector<TileSpan>& spans);

}  // namespace slicecast::classic
