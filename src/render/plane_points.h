// Which points of a level plane the rows of a slice see.
#pragma once

#include "render/column_fill.h"
#include "render/slice_spans.h"
#include "render/vista.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace slicecast {

class PlanePoints {
public:
    // A plane seen from a vista by the rays of a column, `ray` in the coordinates of its map.
    PlanePoints(const Vista& vista, GroundDirection ray, const Plane& plane,
                const TileRange& tiles);

    // A point, as fractions of its tile in 1/2^32.
    struct Point {
        std::uint32_t east;
        std::uint32_t south;
    };

    // What a row sees, by its 1 / |horizon - (row + 0.5)|. It is held within the tiles: roundings
    // never lead out of them.
    Point at(double inverseOffset) const;
    // Whether a point lies within the tiles, and by more than a rounding.
    bool isInside(double inverseOffset) const;
    // Whether one of the rows [first, last) may see a point on the border of two tiles exactly, for
    // which a rule behind portals applies (see `at`).
    bool anyOnBorder(const double* inverseOffsets, int first, int last) const {
        return turn_ != 0 && anyOnBorderTurned(inverseOffsets, first, last);
    }

    PlaneLine line;
    double depthPerInverse;  // the depth of a row's point, by the same number

private:
    // The tiles, relative to the eye's: points are in [east, eastEnd) x [south, southEnd).
    struct Box {
        double east;
        double eastEnd;
        double south;
        double southEnd;
    };

    // Half a step of the fraction that is kept; nearer to the end of a tile than that, it would
    // round up to the next one.
    static constexpr double kHalfStep = 1.0 / 8589934592.0;

    static double distanceTo(const Plane& plane) {
        return Coordinate{plane.rise < 0 ? -plane.rise : plane.rise}.value();
    }
    bool anyOnBorderTurned(const double* inverseOffsets, int first, int last) const;
    static std::uint32_t held(double first, double end, double start, double perInverse,
                              double inverse, bool before);
    // Whether a position lies within a rounding before the border on which the eye is.
    static bool isRoundedToEye(double position) { return position < 0.0 && position >= -kHalfStep; }

    Box box_;
    int turn_;
};

inline PlanePoints::PlanePoints(const Vista& vista, GroundDirection ray, const Plane& plane,
                                const TileRange& tiles)
    : line{vista.viewpoint.fractionX(), vista.viewpoint.fractionY(), distanceTo(plane) * ray.x,
           distanceTo(plane) * ray.y, plane.southReversed},
      depthPerInverse(distanceTo(plane) * vista.projection->distance),
      turn_(vista.viewpoint.turn) {
    const int eyeX = vista.viewpoint.tileX();
    const int eyeY = vista.viewpoint.tileY();
    box_ = {static_cast<double>(std::min(tiles.fromX, tiles.toX) - eyeX),
            static_cast<double>(std::max(tiles.fromX, tiles.toX) + 1 - eyeX),
            static_cast<double>(std::min(tiles.fromY, tiles.toY) - eyeY),
            static_cast<double>(std::max(tiles.fromY, tiles.toY) + 1 - eyeY)};
    if (!tiles.endless) return;
    constexpr double kNever = std::numeric_limits<double>::infinity();
    if (ray.x > 0.0) box_.eastEnd = kNever;
    if (ray.x < 0.0) box_.east = -kNever;
    if (ray.y > 0.0) box_.southEnd = kNever;
    if (ray.y < 0.0) box_.south = -kNever;
}

inline bool PlanePoints::isInside(double inverseOffset) const {
    const double east = line.eastStart + line.eastPerInverse * inverseOffset;
    const double south = line.southStart + line.southPerInverse * inverseOffset;
    return east >= box_.east && east < box_.eastEnd - kHalfStep && south >= box_.south &&
           south < box_.southEnd - kHalfStep && !isRoundedToEye(east) && !isRoundedToEye(south);
}

}  // namespace slicecast
