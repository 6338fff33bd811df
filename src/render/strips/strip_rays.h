// How the rays of a strip's columns cross a map. They run mostly along the major axis, u.
#pragma once

#include "render/pixels/lanes.h"
#include "render/view/vista.h"

#include <array>
#include <cstddef>

namespace slicecast {

// One number for each column.
struct LaneDoubles {
    alignas(16) std::array<double, kLanes> at;
    double& operator[](std::size_t i) { return at[i]; }
    double operator[](std::size_t i) const { return at[i]; }
    const double* data() const { return at.data(); }
};

struct StripRays {
    // Finds how the columns [first, first + count) see a vista, 1 to 16 of them; lanes behind the
    // last column are like it. False if their directions differ too much: few and wide columns.
    bool aim(const Vista& vista, int first, int count);

    // How far the borders of tiles are from the eye, units: of those in which rays enter or leave a
    // tile along u, and of those along v that rays cross upward (to a greater v) or downward.
    double entersU(int u) const {
        return stepU > 0 ? u - eyeU - fractionU : fractionU + (eyeU - u - 1);
    }
    double leavesU(int u) const { return entersU(u) + 1.0; }
    double entersV(int v, bool upward) const {
        return upward ? v - eyeV - fractionV : fractionV + (eyeV - v - 1);
    }
    double leavesV(int v, bool upward) const { return entersV(v, upward) + 1.0; }

    bool alongX = false;  // u is x
    int stepU = 1;
    int sizeU = 0;  // of the map, tiles
    int sizeV = 0;
    int eyeU = 0;  // the eye's tile
    int eyeV = 0;
    double fractionU = 0.0;  // the eye's place in its tile, 0 to 1
    double fractionV = 0.0;
    LaneDoubles speedU;  // see Crossing
    LaneDoubles speedV;
    LaneDoubles rayV;   // the rays' direction along v
    LaneDoubles slope;  // v per u, with sign
    std::array<int, kLanes> stepV;
    Lanes stepsV;            // stepV in lanes
    double alongPerU = 0.0;  // least and greatest `along` per unit of u
    double alongPerUMost = 0.0;
};

}  // namespace slicecast
