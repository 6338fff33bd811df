// The walk over the grid: which tiles a ground ray passes and at which depths it crosses their borders.
//
//     +-----+-----+          Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (1987), on two axes. The depth of the n-th border of an
//     |  .--|-*   |          axis is (distance to the first + n) / |direction|: a quotient of its own each time, so nothing accumulates, and two borders that
//     | e   |  \  |          are met at the same depth are found equal.
//     +-----+---*-+          There the tie rule of projection.h decides: the eye counts as a little further east (and far less south), so an eastward border
//           |     |          comes first and a westward one last.
#pragma once

#include "base/coordinate.h"
#include "render/projection.h"
#include "world/blueprint.h"

#include <limits>

namespace slicecast {

// A tile border and how a ray crosses it, `along` of the ray's direction from the eye (see Projection::ray): the quotient distance / speed. Rows and points are
// projected from those two, since the quotient is rounded.
struct Crossing {
    double along = 0.0;
    double distance = 0.0;  // units along the border's axis from the eye
    double speed = 1.0;     // size of the ray's direction on that axis, > 0
    bool alongX = false;    // a border of constant x
    bool nearing = false;   // crossed eastward or southward
};

// The first row whose ray passes below a height `rise` above the eye when it crosses a border; rows above it pass at or above that height.
inline int firstRowBelow(const Projection& projection, double rise, const Crossing& border) {
    if (rise == 0.0) return projection.firstFallingRow;
    if (border.distance == 0.0) return rise > 0.0 ? 0 : projection.height;
    return projection.firstRowBelowRow(projection.horizon - rise * border.speed / border.distance, (rise > 0.0) == border.nearing);
}

// The face of the tile ahead through which a crossing leads, and the face of the tile behind.
constexpr Face enteredFace(const Crossing& c) { return c.alongX ? (c.nearing ? Face::west : Face::east) : (c.nearing ? Face::north : Face::south); }
constexpr Face leftFace(const Crossing& c) { return c.alongX ? (c.nearing ? Face::east : Face::west) : (c.nearing ? Face::south : Face::north); }

struct GridWalk {
    int tileX = 0;
    int tileY = 0;
    int stepX = 0;  // -1, 0 or 1
    int stepY = 0;
    GridWalk(Coordinate eyeX, Coordinate eyeY, GroundDirection ray)
        : tileX(eyeX.tile()), tileY(eyeY.tile()), stepX(stepOf(ray.x)), stepY(stepOf(ray.y)), x_(eyeX, ray.x), y_(eyeY, ray.y) {
        findLeave();
    }

    // How the current tile was entered (at 0 in the eye's own), and how it will be left.
    const Crossing& enter() const { return borders_[entered_]; }
    const Crossing& leave() const { return borders_[1 - entered_]; }

    // On to the next tile.
    void advance() {
        if (leave().alongX) {
            tileX += stepX;
            x_.advance();
        } else {
            tileY += stepY;
            y_.advance();
        }
        entered_ = 1 - entered_;
        findLeave();
    }

private:
    // The next border of one axis.
    struct Axis {
        double distance;
        double speed;
        double along;

        Axis(Coordinate eye, double direction) : speed(direction < 0.0 ? -direction : direction) {
            if (direction == 0.0) {
                distance = along = std::numeric_limits<double>::infinity();
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
    };

    static int stepOf(double direction) { return direction > 0.0 ? 1 : direction < 0.0 ? -1 : 0; }

    void findLeave() {
        const bool alongX = x_.along < y_.along || (x_.along == y_.along && stepX > 0);
        const Axis& axis = alongX ? x_ : y_;
        borders_[1 - entered_] = {axis.along, axis.distance, axis.speed, alongX, (alongX ? stepX : stepY) > 0};
    }

    Axis x_;
    Axis y_;
    Crossing borders_[2];  // the tile's two borders take turns, so that none is copied
    int entered_ = 0;
};

}  // namespace slicecast
