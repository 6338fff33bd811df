// The old ways of drawing such a world, for lessons: what each was, and what is wrong with it.
// Every default is the modern way; drawn with all of them the picture agrees with the fast
// renderer's, up to levels of detail, which nobody had then. Two more old ways are RenderOptions'
// already: no textures, no light.
#pragma once

#include <cstdint>

namespace slicecast {

// How a picture's columns are aimed, and which distance the heights are divided by.
enum class ClassicProjection : std::uint8_t {
    plane,        // evenly on a flat picture plane; the depth perpendicular to it
    equalAngles,  // at equal angles; the distance along the ray. Fish eye: straight walls bulge
    equalAnglesCorrected,  // at equal angles; that distance times the cosine. A wall that is faced
                           // is straight; others bend, and textures are unevenly wide
};

inline constexpr double kLeastMarchStep = 0.001;  // units
inline constexpr double kGreatestMarchStep = 1.0;
inline constexpr double kLeastMarchReach = 1.0;  // units
inline constexpr double kGreatestMarchReach =
    100.0;  // a hundred thousand of the least steps in every column
inline constexpr int kMostSineSteps = 360'000;
inline constexpr int kMostPixelSize = 64;

struct ClassicOptions {
    ClassicProjection projection = ClassicProjection::plane;
    bool march = false;  // the ray looks for blocks every `stepSize` only: thin corners are missed,
                         // walls stand a little too far away and are ragged
    double stepSize = 0.001;  // units, kLeastMarchStep to kGreatestMarchStep
    double reach = 25.0;  // units, kLeastMarchReach to kGreatestMarchReach: where a march gives up
    bool stretched = false;  // one texture over the whole height of a stack of blocks, not one per
                             // unit: bricks grow with the wall
    bool paintersOrder = false;  // all blocks are painted from far to near, by the distances of
                                 // their middles: most work is painted over, and where blocks
                                 // interlock or a ceiling pierces them no such order is right
    bool oneLevel = false;  // the eye's level only, as if it stood on the floor: its blocks one
                            // unit high, so that the first hides all that follow
    int sineSteps = 0;  // steps of a table of sines over the full turn, looked up without rounding:
                        // columns, and turns, come in jumps. 0 for none
    int pixelSize = 1;  // pixels a side that show one colour, 1 to kMostPixelSize
};

}  // namespace slicecast
