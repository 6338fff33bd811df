// The judge's sky: what a ray sees that meets nothing. Written from web/docs/picture.md.
#pragma once

#include "slicecast/colour.h"
#include "world/sky.h"

#include <cstdint>

namespace slicecast::judge {

// What has been seen of its layers, for asserting coverage.
struct SkyNotes {
    bool star = false;
    bool sun = false;
    bool moon = false;
    bool cloud = false;
};

// The colour towards a heading at an upward slope.
Colour skyColour(const Sky& sky, double headingDegrees, double slope, std::int64_t steps,
                 SkyNotes& notes);

// The density of clouds in a column and a row of their shape.
int cloudDensity(std::uint32_t seed, double size, int column, int row);

}  // namespace slicecast::judge
