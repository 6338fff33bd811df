// Limits of all worlds. Each bounds memory, keeps a number within its type, or bounds the time of a
// step.
//
// A step takes at most the sum of these, each times a constant. tests/scene/costs_test.cpp has the
// constants, and compares the sum with what is promised. Limits that are not below are in the
// header of the same name as their subject.
//
//     movers      kMaxMovers                             each moves
//                 kMaxMoverParts                         parts of movers, one for each place
//                 kMaxMovingCells                        cells that they get into or leave
//     objects     kMaxMovingLevels                       what is around a body, for each level
//                 kMaxMovingObjects * kMostNeighbours    others in its way
//                 kMaxMovingObjects / kLookSteps         looks for the player
//                 kMaxObjects                            lists that some have left
//                 kKeptPortals * kMaxPortals             ways to follow the player
//                 kMostPortalLooks                       ways of patrols
//     gates       kMaxGateCells                          each opens or shuts
//                 kMaxGateCells^2 / 4                    leaders * followers
//                 kMostApproachLooks                     who is near
//     the quest   kMaxFinds + kMaxNotices                each is compared with the player
//                 kMostNoticeLooks                       looks for the player
#pragma once

#include <cstddef>
#include <cstdint>

namespace slicecast {

inline constexpr int kMaxMapWidth = 4096;  // tiles; 4096 * 65536 fits easily into a Coordinate
inline constexpr int kMaxMapDepth = 4096;  // tiles
inline constexpr int kMaxLevels = 32;      // one bit per level in Map::occupied
inline constexpr std::int64_t kMaxCells = 64'000'000;  // width * depth * levels of a map: 128 MB
inline constexpr int kMaxMaps = 256;
inline constexpr int kMaxBlueprints = 65'535;  // a BlueprintId has 16 bits, 0 means empty
inline constexpr int kMaxTextures = 65'535;    // a TextureId has 16 bits, the last value means none
inline constexpr int kMinTextureSize = 8;      // texels a side of a block texture, a power of two
inline constexpr int kMaxTextureSize = 1024;
inline constexpr int kMaxPanoramaWidth = 8192;
inline constexpr int kMaxPanoramaHeight = 4096;

inline constexpr double kDefaultFar = 10'000.0;  // units; beyond it the floor is only haze
inline constexpr double kMaxFar = 100'000.0;     // units; floor positions are precise up to here

inline constexpr int kMaxSpriteSide = 1024;  // texels
// Of all maps: a frame looks for them where its slices walk.
inline constexpr int kMaxObjects = 65'536;
inline constexpr int kMaxMovingObjects = 4'096;  // a step looks at the surroundings of each
// Levels that the bodies of all moving objects may reach into: a step looks at each. One that is at
// most as high as a level counts as two, because it may be in between; a higher one as two for each
// level of its height, because what is around it is less often in the cache.
inline constexpr int kMaxMovingLevels = 8'192;
inline constexpr int kMaxPortals = 65'535;  // a PortalId has 16 bits, the last value means none
// Places that portals lead to, each seen from a point of its own; portals that lead on alike, as
// the parts of a wide one, count as one.
inline constexpr std::size_t kMaxPortalWays = 256;
inline constexpr int kDefaultPortalLimit = 8;  // portals that one ray passes
inline constexpr int kMaxPortalLimit = 32;
inline constexpr int kMaxFrames = 64;           // of an animated texture
inline constexpr double kMaxFrameRate = 120.0;  // frames per second: one per step

}  // namespace slicecast
