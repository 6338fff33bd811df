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

// What the tops and undersides of blocks show.
enum class ClassicRoofs : std::uint8_t {
    textured,
    flat,     // one colour, the average of the texture
    missing,  // nothing: one looks past the walls at what is behind
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
    bool mirroredTextures = false;  // textures follow the map's x and y on every side: on northern
                                    // and eastern faces letters are mirrored
    ClassicRoofs roofs = ClassicRoofs::textured;
    bool seams = false;  // sides begin a row too low and planes end a row too low: lines of another
                         // colour between stacked blocks, and at the picture's edges
    bool paintersOrder = false;  // all blocks are painted from far to near, by the distances of
                                 // their middles: most work is painted over, and where blocks
                                 // interlock or a ceiling pierces them no such order is right
    bool oneLevel = false;   // the eye's level only, as if it stood on the floor: its blocks one
                             // unit high, so that the first hides all that follow
    bool firstHits = false;  // of each level the first block only: what stands behind a low or a
                             // floating block on that level is missing
    bool noOwnCell = false;  // nothing of the eye's own tile: the roof that one stands on and the
                             // ceiling above are missing
    bool driftingHorizon = false;  // the horizon sinks by a picture's height for each unit that the
                                   // eye is above its place at the scene's start
    bool columnDepth = false;  // one depth per column for objects: the first block hides all that
                               // is behind it, however low it is
    bool wrongScale = false;   // objects are sized by the picture's height, not by the distance to
                               // the projection plane: too small, feet off the floor
    bool flippedMirrors = false;    // floors reflect by flipping the picture about the foot of what
                                    // stands behind them; other mirrors do not reflect
    bool portalsOverdrawn = false;  // what is behind a portal is drawn over what is before it, but
                                    // at the upper and the lower end
    int sineSteps = 0;  // steps of a table of sines over the full turn, looked up without rounding:
                        // columns, and turns, come in jumps. 0 for none
    int pixelSize = 1;  // pixels a side that show one colour, 1 to kMostPixelSize
};

}  // namespace slicecast
