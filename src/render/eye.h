// The viewpoint.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

struct Eye {
    int map = 0;   // index into World::maps
    Coordinate x;  // units; an eye outside the grid or inside a block is legal
    Coordinate y;
    Coordinate z;                 // height, > 0
    double headingDegrees = 0.0;  // 0 = east, 90 = south (clockwise seen from above)
    double look = 0.0;  // screen heights that the horizon lies below the middle, positive looks up

    friend bool operator==(const Eye&, const Eye&) = default;
};

// An eye at or below the floor sees nothing and is refused by the renderer.
constexpr bool isAboveFloor(const Eye& eye) {
    return eye.z.raw > 0;
}

}  // namespace slicecast
