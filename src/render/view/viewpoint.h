// A place that rays come from, in the coordinates of their map: the eye, or where the eye appears
// to be behind portals and in mirrors (see vista.h).
#pragma once

#include "render/view/projection.h"

#include <cstdint>

namespace slicecast {

// Where the eye's rays come from, in the coordinates of a map.
struct Viewpoint {
    int map = 0;         // index into World::maps
    int turn = 0;        // quarter turns clockwise from the eye's map to this one
    std::int64_t x = 0;  // 1/65536 units; behind portals it may exceed a Coordinate
    std::int64_t y = 0;
    std::int32_t z = 0;  // may be below the floor
    bool upsideDown = false;

    int tileX() const { return static_cast<int>(x >> 16); }
    int tileY() const { return static_cast<int>(y >> 16); }
    double fractionX() const { return static_cast<double>(x & 0xffff) / 65536.0; }
    double fractionY() const { return static_cast<double>(y & 0xffff) / 65536.0; }

    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

// A horizontal direction turned clockwise by quarter turns.
inline GroundDirection turned(GroundDirection direction, int quarterTurns) {
    for (int i = 0; i < quarterTurns; ++i) direction = {-direction.y, direction.x};
    return direction;
}

}  // namespace slicecast
