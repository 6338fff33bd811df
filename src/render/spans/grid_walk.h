// The walk over the grid: the tiles that a ground ray passes, and the depths at which it crosses
// their borders.
//
//     +-----+-----+
//     |  .--|-*   |
//     | e   |  \  |
//     +-----+---*-+
//           |     |
//
// Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (1987), on two axes. The
// depth of the n-th border of an axis is (distance to the first + n) / |direction|: a quotient of
// its own each time, so no error accumulates, and two borders at the same depth compare equal. Then
// the tie rule of projection.h decides: the eye counts as slightly further east (and far less
// south), so an eastward border comes first and a westward one last.
#pragma once

#include "base/bits.h"
#include "base/coordinate.h"
#include "render/view/projection.h"
#include "world/blueprint.h"

#include <cstdint>
#include <limits>
#include <utility>

namespace slicecast {

// Finite, so that a height of 0 stays at the horizon (infinity times 0 would be NaN).
inline constexpr double kHugeRows = 1e200;

// How far along a ray something is that it does not meet.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

// A line across a tile from corner to corner, that falls or rises eastward as seen on a map: along
// it x - y is constant, or x + y. The distance and speed of its crossing are in these; it is
// crossed as if it ran from west to east, so `nearing` is towards the half in the south.
enum class Cut : std::uint8_t { none, falling, rising };

// A tile border and how a ray crosses it. `along` is in multiples of the ray's direction (see
// Projection::ray): the quotient distance / speed. Rows and points are computed from these two,
// because the quotient is rounded.
struct Crossing {
    double along = 0.0;
    double distance = 0.0;  // units along the border's axis from the eye
    double speed = 1.0;     // size of the ray's direction on that axis, > 0
    double rowsPerRaw =
        kHugeRows;  // rows per 1/65536 unit of height there, rounded; huge if the distance is 0
    bool alongX = false;   // a border of constant x
    bool nearing = false;  // crossed eastward or southward
    bool early =
        false;  // the same in the coordinates of the eye's map: wins ties (see projection.h)
    bool border = true;  // false for an object, where no tile ends
    bool inner = false;  // an edge of a plan inside a tile, where no tile ends, but blocks do
    Cut cut = Cut::none;

    // Blocks may have sides there.
    bool hasSides() const { return border || inner; }
};

// The first row whose ray passes below a height, `rise` 1/65536 units above the eye, where it
// crosses a border; rows above it pass at or above that height.
inline int firstRowBelow(const Projection& projection, std::int32_t rise, const Crossing& border) {
    if (rise == 0) return projection.firstFallingRow;
    if (border.distance <= 0.0) return rise > 0 ? 0 : projection.height;
    const double height = rise / 65536.0;
    return projection.firstRowBelowRow(projection.horizon - height * border.speed / border.distance,
                                       (rise > 0) == border.early);
}

// The face of the next tile through which a crossing leads, and the face of the tile left behind.
constexpr Face enteredFace(const Crossing& c) {
    return c.alongX ? (c.nearing ? Face::west : Face::east)
                    : (c.nearing ? Face::north : Face::south);
}
constexpr Face leftFace(const Crossing& c) {
    return c.alongX ? (c.nearing ? Face::east : Face::west)
                    : (c.nearing ? Face::south : Face::north);
}

struct GridWalk {
    int tileX = 0;
    int tileY = 0;
    int stepX = 0;  // -1, 0 or 1
    int stepY = 0;
    double entered = 0.0;  // `along` at the entry of the current tile, 0 in the eye's own

    GridWalk(Coordinate eyeX, Coordinate eyeY, GroundDirection ray)
        : tileX(eyeX.tile()),
          tileY(eyeY.tile()),
          stepX(stepOf(ray.x)),
          stepY(stepOf(ray.y)),
          x_(eyeX, ray.x),
          y_(eyeY, ray.y),
          earlyX_(stepX > 0),
          earlyY_(stepY > 0),
          tieAlongX_(stepX > 0) {}

    // How the current tile was entered, and how it will be left.
    Crossing enter() const {
        if (way_ == Way::none) {
            Crossing none;
            none.border = false;
            return none;
        }
        const bool alongX = way_ == Way::alongX;
        const Axis& axis = alongX ? x_ : y_;
        return crossing(entered, axis.distance - 1.0, axis, alongX);
    }
    Crossing leave() const {
        const bool alongX = leavesAlongX();
        const Axis& axis = alongX ? x_ : y_;
        return crossing(axis.along, axis.distance, axis, alongX);
    }
    double left() const { return x_.along < y_.along ? x_.along : y_.along; }  // leave().along

    // Where the ray crosses an edge inside the current tile, `distance` units from the eye along
    // the edge's axis.
    Crossing innerCrossing(bool alongX, double distance) const {
        const Axis& axis = alongX ? x_ : y_;
        Crossing edge = crossing(distance / axis.speed, distance, axis, alongX);
        edge.border = false;
        edge.inner = true;
        return edge;
    }
    // Advances to the next tile.
    void advance() {
        if (leavesAlongX()) {
            entered = x_.along;
            way_ = Way::alongX;
            tileX += stepX;
            x_.advance();
        } else {
            entered = y_.along;
            way_ = Way::alongY;
            tileY += stepY;
            y_.advance();
        }
    }

    // Jumps to another tile of its way, which it enters along x or along y, as if it had walked
    // there.
    void comeTo(int x, int y, bool enteredAlongX) {
        x_.goOn(x > tileX ? x - tileX : tileX - x);
        y_.goOn(y > tileY ? y - tileY : tileY - y);
        tileX = x;
        tileY = y;
        way_ = enteredAlongX ? Way::alongX : Way::alongY;
        const Axis& axis = enteredAlongX ? x_ : y_;
        entered = (axis.distance - 1.0) / axis.speed;
    }

    // `along` of the next border on either axis.
    double nextAlongX() const { return x_.along; }
    double nextAlongY() const { return y_.along; }

    bool hasEntered() const { return way_ != Way::none; }  // false in the eye's own tile

    // See Crossing; and which of two borders at one depth comes first.
    bool isEarly(bool alongX) const { return alongX ? earlyX_ : earlyY_; }
    bool tieIsAlongX() const { return tieAlongX_; }

    // The same walk in another tile, turned clockwise by quarter turns: directions change, the
    // depths of borders do not.
    GridWalk turned(int quarterTurns, int toX, int toY) const {
        GridWalk walk = *this;
        for (int i = 0; i < quarterTurns; ++i) {
            std::swap(walk.x_, walk.y_);
            walk.stepX = std::exchange(walk.stepY, walk.stepX);
            walk.stepX = -walk.stepX;
            std::swap(walk.earlyX_, walk.earlyY_);
            walk.tieAlongX_ = !walk.tieAlongX_;
            if (walk.way_ != Way::none)
                walk.way_ = walk.way_ == Way::alongX ? Way::alongY : Way::alongX;
        }
        walk.tileX = toX;
        walk.tileY = toY;
        return walk;
    }

private:
    enum class Way : std::uint8_t { none, alongX, alongY };

    // #region borders
    // The next border of one axis.
    struct Axis {
        double distance;
        double speed;
        double along;

        Axis(Coordinate eye, double direction) : speed(direction < 0.0 ? -direction : direction) {
            if (direction == 0.0) {
                distance = along = kNever;
                speed = 1.0;
            } else {
                distance = direction > 0.0 ? 1.0 - eye.fraction() : eye.fraction();
                along = distance / speed;
            }
        }
        void advance() {
            distance += 1.0;
            along = distance / speed;
        }
        void goOn(int borders) {
            distance += borders;
            along = distance / speed;
        }
    };
    // #endregion

    Crossing crossing(double along, double distance, const Axis& axis, bool alongX) const {
        return {along,
                distance,
                axis.speed,
                distance > 0.0 ? axis.speed / distance * (1.0 / 65536.0) : kHugeRows,
                alongX,
                (alongX ? stepX : stepY) > 0,
                alongX ? earlyX_ : earlyY_,
                true,
                false,
                Cut::none};
    }
    static int stepOf(double direction) { return direction > 0.0 ? 1 : direction < 0.0 ? -1 : 0; }
    // #region ties
    bool leavesAlongX() const {
        return x_.along < y_.along || (x_.along == y_.along && tieAlongX_);
    }
    // #endregion

    Axis x_;
    Axis y_;
    bool earlyX_;  // see Crossing
    bool earlyY_;
    bool tieAlongX_;  // which of two borders at equal depth comes first
    Way way_ = Way::none;
};

}  // namespace slicecast
