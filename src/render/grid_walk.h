// The walk over the grid: which tiles a ground ray passes and at which depths it crosses their borders.
//
//     +-----+-----+          Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (1987), on two axes. The depth of the n-th border of an
//     |  .--|-*   |          axis is (distance to the first + n) / |direction|: computed afresh each time, so nothing accumulates.
//     | e   |  \  |
//     +-----+---*-+          Where both axes are crossed at the same depth, the tie rule of projection.h decides: the eye counts as a little further east
//           |     |          (and far less south), so an eastward border comes first and a westward one last.
#pragma once

#include "base/coordinate.h"
#include "render/projection.h"
#include "world/blueprint.h"

#include <limits>

namespace slicecast {

// A tile border and how a ray crosses it.
struct Crossing {
    double depth = 0.0;    // perpendicular depth t
    bool alongX = false;   // a border of constant x
    bool nearing = false;  // crossed eastward or southward
};

// The face of the tile ahead through which a crossing leads, and the face of the tile behind.
constexpr Face enteredFace(const Crossing& c) { return c.alongX ? (c.nearing ? Face::west : Face::east) : (c.nearing ? Face::north : Face::south); }
constexpr Face leftFace(const Crossing& c) { return c.alongX ? (c.nearing ? Face::east : Face::west) : (c.nearing ? Face::south : Face::north); }

struct GridWalk {
    int tileX = 0;
    int tileY = 0;
    int stepX = 0;  // -1, 0 or 1
    int stepY = 0;
    Crossing enter;  // how the current tile was entered; depth 0 in the eye's own
    Crossing leave;  // how it will be left

    GridWalk(Coordinate eyeX, Coordinate eyeY, GroundDirection ray) : tileX(eyeX.tile()), tileY(eyeY.tile()) {
        startAxis(eyeX, ray.x, stepX, distanceX_, depthPerUnitX_);
        startAxis(eyeY, ray.y, stepY, distanceY_, depthPerUnitY_);
        findLeave();
    }

    // On to the next tile.
    void advance() {
        if (leave.alongX) {
            tileX += stepX;
            distanceX_ += 1.0;
        } else {
            tileY += stepY;
            distanceY_ += 1.0;
        }
        enter = leave;
        findLeave();
    }

private:
    static void startAxis(Coordinate eye, double direction, int& step, double& distance, double& depthPerUnit) {
        if (direction > 0.0) {
            step = 1;
            distance = 1.0 - eye.fraction();
            depthPerUnit = 1.0 / direction;
        } else if (direction < 0.0) {
            step = -1;
            distance = eye.fraction();
            depthPerUnit = 1.0 / -direction;
        } else {
            step = 0;
            distance = std::numeric_limits<double>::infinity();
            depthPerUnit = 1.0;
        }
    }

    void findLeave() {
        const double depthX = distanceX_ * depthPerUnitX_;
        const double depthY = distanceY_ * depthPerUnitY_;
        const bool alongX = depthX < depthY || (depthX == depthY && stepX > 0);
        leave.alongX = alongX;
        leave.depth = alongX ? depthX : depthY;
        leave.nearing = (alongX ? stepX : stepY) > 0;
    }

    double distanceX_ = 0.0;  // units along x from the eye to the next border
    double distanceY_ = 0.0;
    double depthPerUnitX_ = 1.0;
    double depthPerUnitY_ = 1.0;
};

}  // namespace slicecast
