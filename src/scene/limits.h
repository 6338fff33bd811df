// Limits on scene files, besides those of worlds. They bound the memory and the time that a hostile
// file can take; no scene that a person makes comes near them.
//
// Loading takes at most the sum of these, each times a constant, and the time of the images, which
// is that of their texels. See tests/scene/costs_test.cpp.
//
//     text        bytes * log2(kMaxSceneValues)          reading it; keys and names are looked up
//     filled      bytes, or kMaxFilledCells              the cells that rows and fills set, and at
//                                                        least those of one level of each map
//     cells       filled * kMaxLevels                    the cells of all maps, of which empty levels
//                                                        take no text
//     blocks      filled                                 what stands in a cell is looked at a few
//                                                        times: movers, gates, room, entries
//     movers      kMaxMoverParts + kMaxMovingCells       parts, and the cells that they reach
//     sowing      filled * kMaxSowings                   each kind looks at all tiles
//     areas       kMaxNotices * kMaxMapWidth             see rooms.h
//     portals     kMaxPortals * kMaxPortalWays
//     legends     kMaxMaps * kMaxLegend
//     colours     kMaxPlainTextures                      each is a texture
//     clouds      kMaxCloudShapes
#pragma once

#include "world/limits.h"

#include <cstddef>
#include <cstdint>

namespace slicecast {

inline constexpr std::size_t kMaxSceneBytes =
    128u << 20;  // room for 64 million cells and their floors; offsets keep within 32 bits
inline constexpr int kMaxNesting = 32;  // arrays and objects within each other; a scene needs 5
inline constexpr std::size_t kMaxSceneValues =
    2'000'000;  // values in the JSON text, up to 56 bytes each; one row of a map is one value
inline constexpr std::size_t kMaxNameLength =
    100;  // characters of the name of a texture, blueprint or map
inline constexpr std::size_t kMaxPathLength = 1000;    // characters of a file's name
inline constexpr std::size_t kMaxTitleLength = 200;    // characters
inline constexpr std::size_t kMaxMessageLength = 300;  // characters
inline constexpr std::size_t kMaxPathPoints = 64;      // of an object that patrols
inline constexpr std::size_t kMaxPlaces = 4096;        // named places of one map
inline constexpr std::size_t kMaxLegend = 4096;        // characters of one legend
inline constexpr int kMaxSowings =
    32;  // kinds of objects sown over one map: each looks at all of its tiles
inline constexpr int kMaxCloudShapes =
    4;  // of clouds, by seed and size: each takes some 10 frames to make, and 256 KB
inline constexpr int kMaxPlainTextures =
    2048;  // textures that are a colour: 15 characters of text make 22 KB of texels
inline constexpr std::size_t kMaxFaults = 1000;            // faults listed; more do not help
inline constexpr std::int64_t kMaxSceneCells = kMaxCells;  // of all maps together
inline constexpr std::int64_t kMaxFilledCells =
    250'000;  // cells that rows and fills set, of all maps together; more if the text has more
              // bytes, so that only what fills and repeats is bound by it
inline constexpr std::int64_t kMaxSceneTexels =
    64 << 20;  // of all images together, a panorama counted for each map that shows it: 600 MB with
               // the levels of detail

// Ranges of a scene's numbers that are no limit of the world itself.
inline constexpr double kMaxHeight = 1000.0;       // units; of a ceiling and of the start
inline constexpr double kMaxObjectSize = 64.0;     // units, either way
inline constexpr double kMaxObjectSpeed = 16.0;    // units per second
inline constexpr double kMaxObjectReach = 1000.0;  // units
inline constexpr double kMaxSkySlope = 1000.0;     // height per distance
inline constexpr double kMaxIntensity = 1000.0;    // of light
inline constexpr double kMaxMultiplier = 1.0e6;    // of light, units
inline constexpr double kMaxStartHeading = 360.0;  // degrees either way

}  // namespace slicecast
