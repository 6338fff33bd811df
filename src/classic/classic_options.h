// Old ways of drawing such a world, for lessons: what each was, and its defect. Every default is
// the modern way; with all defaults the picture agrees with the fast renderer's. Three more old
// ways are RenderOptions: no textures, no levels of detail, no light.
#pragma once

#include <cstdint>

namespace slicecast {

// The directions of a picture's columns, and the distance by which heights are divided.
enum class ClassicProjection : std::uint8_t {
    plane,                 // evenly spaced on a flat picture plane; perpendicular depth
    equalAngles,           // equal angles; distance along the ray. Fish eye: straight walls bulge
    equalAnglesCorrected,  // equal angles; that distance times the cosine. A wall straight ahead is
                           // straight; others bend, and texture widths are uneven
};

// How the tops and undersides of blocks are drawn.
enum class ClassicRoofs : std::uint8_t {
    textured,
    flat,     // one colour, the average of the texture
    missing,  // not drawn: you look over the walls at the things behind
};

inline constexpr double kLeastMarchStep = 0.001;  // units
inline constexpr double kGreatestMarchStep = 1.0;
inline constexpr double kLeastMarchReach = 1.0;  // units
// Takes a hundred thousand of the least steps in every column.
inline constexpr double kGreatestMarchReach = 100.0;
inline constexpr int kMostSineSteps = 360'000;
inline constexpr int kMostPixelSize = 64;

struct ClassicOptions {
    ClassicProjection projection = ClassicProjection::plane;
    bool march = false;  // the ray looks for blocks only every `stepSize`: it misses thin corners,
                         // and walls are ragged and slightly too far away
    double stepSize = 0.001;  // units, kLeastMarchStep to kGreatestMarchStep
    double reach = 25.0;      // units, kLeastMarchReach to kGreatestMarchReach: where a march stops
    bool stretched = false;   // one texture over the whole height of a stack of blocks instead of
                              // one per unit: bricks grow with the wall
    bool mirroredTextures = false;  // textures follow the map's x and y on every side: letters are
                                    // mirrored on northern and eastern faces
    ClassicRoofs roofs = ClassicRoofs::textured;
    bool seams = false;  // sides begin a row too low and planes end a row too low: coloured lines
                         // between stacked blocks, and at the picture's edges
    bool paintersOrder = false;  // paints all blocks from far to near, by the distances of their
                                 // middles: most work is painted over, and no such order is right
                                 // where blocks interlock or a ceiling pierces them
    bool oneLevel = false;  // only the eye's level, placed on the floor, with blocks one unit high,
                            // so that the first hides all others
    bool firstHits = false;  // only the first block of each level: everything behind a low or a
                             // floating block on that level is missing
    bool noOwnCell =
        false;  // leaves out the eye's own tile: the roof below and the ceiling above are missing
    bool driftingHorizon = false;  // the horizon sinks by a picture's height for each unit that the
                                   // eye is above its place at the scene's start
    bool columnDepth = false;  // one depth per column for objects: the first block, however low,
                               // hides all objects behind it
    bool wrongScale = false;   // objects are sized by the picture's height instead of the distance
                               // to the projection plane: too small, feet off the floor
    bool flippedMirrors = false;    // floors reflect by flipping the picture about the foot of the
                                    // things behind them; other mirrors do not reflect
    bool portalsOverdrawn = false;  // the view through a portal covers the things in front of it,
                                    // except at its upper and lower end
    int sineSteps = 0;              // entries of a sine table for the full turn, looked up without
                                    // interpolation: columns and turns jump. 0 for no table
    int pixelSize = 1;              // side of the squares of one colour, 1 to kMostPixelSize pixels
};

}  // namespace slicecast
