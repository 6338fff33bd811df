// Masses of leaves: the crowns of trees and whole bushes, built of clumps that are lit like balls.
#pragma once

#include <vector>

#include "shapes.h"

namespace slicecast::textures {

struct Clump {
    double x;
    double y;
    double radius;
};

struct Leafage {
    const Ramp* ramp = &kMossRamp;
    double tone = 2.6;      // in half-light
    double contrast = 1.2;  // between the lit and the shaded side of a clump
    double length = 7.0;    // of a leaf, in texels
    double width = 0.32;    // of a leaf, as a share of its length
    double density = 1.0;   // leaves for their room: 1 covers well
    bool filled = true;     // dark inside; otherwise one sees through between the leaves
    bool hanging = false;   // leaves hang straight down
    std::uint32_t seed = 1;
};

// Clumps from back to front.
void drawLeafage(Surface& surface, const std::vector<Clump>& clumps, const Leafage& leafage);

}  // namespace slicecast::textures
