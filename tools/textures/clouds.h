// Heaped clouds: many round puffs on a flat base, lit from the upper left.
#pragma once

#include <cstdint>

#include "picture.h"

namespace slicecast::textures {

struct Cloud {
    double across;  // middle of its base, in the units of a panorama
    double base;
    double width;
    double height;
    const Ramp* ramp;  // from the shade under it to its brightest top
    Colour haze;       // what distance mixes in, and how much of 256
    int hazeShare;
    std::uint32_t seed;
};

void drawCloud(Picture& sky, const Cloud& cloud);

}  // namespace slicecast::textures
