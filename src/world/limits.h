// Limits that no world may exceed. Each bounds memory or keeps a number within its type.
#pragma once

#include <cstdint>

namespace slicecast {

inline constexpr int kMaxMapWidth =
    4096;  // tiles; 4096 * 65536 fits a Coordinate with room to spare
inline constexpr int kMaxMapDepth = 4096;  // tiles
inline constexpr int kMaxLevels = 32;      // one bit per level in Map::occupied
inline constexpr std::int64_t kMaxCells =
    64'000'000;  // width * depth * levels of one map: 128 MB of cells
inline constexpr int kMaxMaps = 256;
inline constexpr int kMaxBlueprints = 65'535;  // a BlueprintId has 16 bits, 0 means empty
inline constexpr int kMaxTextures = 65'535;    // a TextureId has 16 bits, the last value means none
inline constexpr int kMinTextureSize = 8;      // texels a side of a block texture, a power of two
inline constexpr int kMaxTextureSize = 1024;
inline constexpr int kMaxPanoramaWidth = 8192;
inline constexpr int kMaxPanoramaHeight = 4096;

inline constexpr double kDefaultFar = 10'000.0;  // units; beyond it the floor is plain haze
inline constexpr double kMaxFar =
    100'000.0;  // units; floor positions up to here keep their full precision

inline constexpr int kMaxSpriteSide = 1024;  // texels
inline constexpr int kMaxObjects =
    65'536;  // of all maps: a frame looks at each one of a map, once for each view of that map
inline constexpr int kMaxMovingObjects = 4'096;  // of them: a step looks at what is around each one
inline constexpr int kMaxPortals = 65'535;     // a PortalId has 16 bits, the last value means none
inline constexpr int kDefaultPortalLimit = 8;  // portals that one ray passes
inline constexpr int kMaxPortalLimit = 32;
inline constexpr int kMaxFrames = 64;           // of an animated texture
inline constexpr double kMaxFrameRate = 120.0;  // frames per second; one each step

}  // namespace slicecast
