// Finds the points of a horizontal plane that the rows of a slice see.
#pragma once

#include "render/pixels/column_fill.h"
#include "render/pixels/vectors.h"
#include "render/spans/grid_walk.h"
#include "render/spans/slice_spans.h"
#include "render/view/vista.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

class PlanePoints {
public:
    // A plane at `height` above or below the eye (units, positive) as the rays of a column see it
    // from a vista. `ray` is the column's, in the coordinates of the vista's map. Points lie on
    // `tiles`.
    PlanePoints(const Vista& vista, GroundDirection ray, double height, bool southReversed,
                const TileRange& tiles);

    // A point in its tile, in 1/2^32 of the tile; and the tile, relative to the eye's.
    struct Point {
        std::uint32_t east;
        std::uint32_t south;
        int tileX;
        int tileY;
    };

    // The point that a row sees, from its 1 / |horizon - (row + 0.5)|. Clamped to the tiles, so
    // that rounding never leads out of them.
    Point at(double inverseOffset) const;
    // Whether a point lies within the tiles by more than the rounding error.
    bool isInside(double inverseOffset) const;
    // Whether one of the rows [first, last) may see a point exactly on a tile border. Behind
    // portals that turn, such points need at(): it decides to which of the two tiles they belong.
    bool anyOnBorder(const double* inverseOffsets, int first, int last) const {
        return turn_ != 0 && anyOnBorderTurned(inverseOffsets, first, last);
    }

    PlaneLine line;  // where the points lie, without clamping

private:
    // The tiles, relative to the eye's: points are in [first, end), east and south.
    struct Box {
        F64x2 first;
        F64x2 end;
    };

    // Half of 1/2^32, the step of a stored fraction: a position closer to the end of a tile would
    // round up into the next tile.
    static constexpr double kHalfStep = 1.0 / 8589934592.0;

    bool anyOnBorderTurned(const double* inverseOffsets, int first, int last) const;
    static std::int64_t held(double first, double end, double start, double perInverse,
                             double inverse, bool before);
    Box box_;
    int turn_;
};

inline PlanePoints::PlanePoints(const Vista& vista, GroundDirection ray, double height,
                                bool southReversed, const TileRange& tiles)
    : line{vista.viewpoint.fractionX(), vista.viewpoint.fractionY(), height * ray.x, height * ray.y,
           southReversed},
      turn_(vista.viewpoint.turn) {
    const int eyeX = vista.viewpoint.tileX();
    const int eyeY = vista.viewpoint.tileY();
    box_.first = F64x2{static_cast<double>(std::min(tiles.fromX, tiles.toX) - eyeX),
                       static_cast<double>(std::min(tiles.fromY, tiles.toY) - eyeY)};
    box_.end = F64x2{static_cast<double>(std::max(tiles.fromX, tiles.toX) + 1 - eyeX),
                     static_cast<double>(std::max(tiles.fromY, tiles.toY) + 1 - eyeY)};
    if (!tiles.endless) return;
    if (ray.x > 0.0) box_.end[0] = kNever;
    if (ray.x < 0.0) box_.first[0] = -kNever;
    if (ray.y > 0.0) box_.end[1] = kNever;
    if (ray.y < 0.0) box_.first[1] = -kNever;
}

// Checks east and south at once. Position 0 is the west or north border of the eye's tile;
// positions before it by less than the rounding error count as outside.
inline bool PlanePoints::isInside(double inverseOffset) const {
    const F64x2 start = {line.eastStart, line.southStart};
    const F64x2 perInverse = {line.eastPerInverse, line.southPerInverse};
    const F64x2 half = {kHalfStep, kHalfStep};
    const F64x2 position = start + perInverse * inverseOffset;
    const I64x2 outside = (position < box_.first) | (position >= box_.end - half) |
                          ((position < 0.0) & (position >= -half));
    return (outside[0] | outside[1]) == 0;
}

}  // namespace slicecast
