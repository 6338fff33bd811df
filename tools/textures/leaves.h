// Single leaves, of which hedges, creepers and trees are made.
#pragma once

#include <array>

#include "surface.h"

namespace slicecast::textures {

struct Direction {
    double x;
    double y;
};

// Ways for a leaf to point: mostly down and to the sides, as leaves hang
inline constexpr std::array<Direction, 7> kHanging = {
    {{1.0, 0.2}, {0.83, 0.55}, {0.45, 0.9}, {0.0, 1.0}, {-0.45, 0.9}, {-0.83, 0.55}, {-1.0, 0.2}}};

struct Leaf {
    double x;
    double y;
    Direction direction;
    double length;
    double width;
    double height;
    double tone;
    const Ramp* ramp = &kMossRamp;
    bool cutOff =
        false;  // at the edges of the surface, instead of coming in again on the other side
};

// A pointed oval with a light upper half, a dark lower half and a rib between them.
void drawLeaf(Surface& surface, const Leaf& leaf);

}  // namespace slicecast::textures
