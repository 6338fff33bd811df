// From the world to the screen: the directions of an eye's rays, and the rows of heights at a
// depth.
//
//     row r's centre is r + 0.5, rows grow downwards
//     a height h at perpendicular depth t appears at row   y = horizon - (h - eye height) * d / t
//
// A tie is a ray that meets an edge exactly. Ties are broken as if the eye were moved: by an
// infinitely small step east, a far smaller one south and a still smaller one up. So a border
// crossed eastward or southward is met slightly sooner, any other slightly later. A rising ray is
// slightly lower there, or higher, and that decides the rows that touch an edge.
#pragma once

#include "base/coordinate.h"
#include "render/eye.h"
#include "render/options.h"

#include <cmath>

namespace slicecast {

// A horizontal direction.
struct GroundDirection {
    double x = 0.0;
    double y = 0.0;
};

struct Projection {
    int width = 0;              // pixels
    int height = 0;             // pixels
    double distance = 1.0;      // d, pixels
    double horizon = 0.0;       // row of the horizon, a real number
    double horizonBelow = 0.0;  // horizon + 0.5, for comparing with row numbers
    double heightBelow = 0.0;   // height + 0.5
    int firstFallingRow = 0;    // rows from here on look down (slope < 0), clamped to [0, height]
    GroundDirection forward;
    GroundDirection right;

    Projection(const Eye& eye, const RenderOptions& options, int pictureWidth, int pictureHeight);
    // Rows alone.
    Projection(int rows, double toPlane, double horizonRow) : height(rows), distance(toPlane) {
        setHorizon(horizonRow);
    }

    // The same upside down, for reflected rays: its row r has the negated slope of row height - 1 -
    // r.
    Projection mirrored() const;

    double sidewaysSlope(int column) const { return (column + 0.5 - width / 2.0) / distance; }
    double upwardSlope(int row) const { return (horizon - (row + 0.5)) / distance; }

    // #region ray
    // The ground direction of a column's rays, in units per `distance` units of perpendicular
    // depth: d * (forward + k * right). It avoids the division by d, which would round, so that
    // rays that meet a corner or the middle of a row exactly are recognised.
    GroundDirection ray(int column) const {
        const double sideways = column + 0.5 - width / 2.0;
        return {distance * forward.x + sideways * right.x,
                distance * forward.y + sideways * right.y};
    }
    // #endregion

    // The row (a real number) of a height `rise` above the eye at `depth`; infinite at depth 0. Not
    // for rise = 0 at depth 0.
#if defined(__clang__)
    __attribute__((no_sanitize("float-divide-by-zero")))
#endif
    // #region rows
    double
    rowOf(double rise, double depth) const {
        return horizon - rise * distance / depth;
    }

    // The first row whose centre lies below `row`, or on it if `tieIsBelow`; clamped to [0,
    // height].
    int firstRowBelowRow(double row, bool tieIsBelow) const {
        if (!(row > 0.0)) return 0;
        if (row >= height) return height;
        const double above = row + 0.5;  // >= 0, so truncation is the floor
        const int whole = static_cast<int>(above);
        return tieIsBelow && static_cast<double>(whole) == above ? whole - 1 : whole;
    }
    // #endregion

private:
    void setHorizon(double row);
};

}  // namespace slicecast
