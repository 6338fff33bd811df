// From the world to the screen: how an eye's rays run, and in which rows heights at a depth appear.
//
//     row r's centre is r + 0.5, rows grow downwards
//     a height h at perpendicular depth t appears at row   y = horizon - (h - eye height) * d / t
//
// Ties, where a ray meets an edge exactly, are broken as if the eye lay an infinitely small step
// further east, a far smaller one south and a still smaller one up. A border is then met a little
// sooner if it is crossed eastward or southward and a little later otherwise, so a ray that rises
// is a little lower there (or higher), which decides the rows that touch an edge.
#pragma once

#include "base/coordinate.h"
#include "render/eye.h"
#include "render/options.h"

#include <cmath>

namespace slicecast {

// A level direction.
struct GroundDirection {
    double x = 0.0;
    double y = 0.0;
};

struct Projection {
    int width = 0;              // pixels
    int height = 0;             // pixels
    double distance = 1.0;      // d, pixels
    double horizon = 0.0;       // row of the horizon, real
    double horizonBelow = 0.0;  // half a row below it, for comparing with row numbers
    double heightBelow = 0.0;   // half a row below the last one's lower edge
    int firstFallingRow =
        0;  // rows from here on look downwards (slope < 0), clamped to [0, height]
    GroundDirection forward;
    GroundDirection right;

    Projection(const Eye& eye, const RenderOptions& options, int pictureWidth, int pictureHeight);

    // The same upside down: row r of it has the slope of row height - 1 - r, the other way.
    // Reflected rays are drawn so.
    Projection mirrored() const;

    double sidewaysSlope(int column) const { return (column + 0.5 - width / 2.0) / distance; }
    double upwardSlope(int row) const { return (horizon - (row + 0.5)) / distance; }

    // The ground direction of a column's rays, in units per `distance` units of perpendicular
    // depth: d * (forward + k * right) without the division by d, which would round, so that a ray
    // that meets a corner or the middle of a row exactly is found to do so.
    GroundDirection ray(int column) const {
        const double sideways = column + 0.5 - width / 2.0;
        return {distance * forward.x + sideways * right.x,
                distance * forward.y + sideways * right.y};
    }

    // Row (real) of a height `rise` above the eye at `depth`; infinite at depth 0. Not for rise = 0
    // at depth 0.
#if defined(__clang__)
    __attribute__((no_sanitize("float-divide-by-zero")))
#endif
    double
    rowOf(double rise, double depth) const {
        return horizon - rise * distance / depth;
    }

    // The first row whose centre lies below `row`, and whose centre lies on it if `tieIsBelow`;
    // clamped to [0, height].
    int firstRowBelowRow(double row, bool tieIsBelow) const {
        if (!(row > 0.0)) return 0;
        if (row >= height) return height;
        const double above = row + 0.5;  // >= 0, so truncation is the floor
        const int whole = static_cast<int>(above);
        return tieIsBelow && static_cast<double>(whole) == above ? whole - 1 : whole;
    }

private:
    void setHorizon(double row);
};

}  // namespace slicecast
