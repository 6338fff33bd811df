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
    double look =
        0.0;  // how far the horizon lies below the middle, in screen heights; positive looks up

    friend bool operator==(const Eye&, const Eye&) = default;
};

// The renderer refuses an eye at or below the floor, because it sees nothing.
constexpr bool isAboveFloor(const Eye& eye) {
    return eye.z.raw > 0;
}

}  // namespace slicecast
