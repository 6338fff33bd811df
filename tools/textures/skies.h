// Panoramas, 1024 x 256, that wrap sideways. Row 0 is the steepest line of sight, the last row the
// horizon; rows are even steps of slope (height over distance), and a panorama is meant to be shown
// over slopes 0 to 1.
//
// One texel is then 2 pi / 1024 wide and 1 / 256 tall: 1.57 times as wide as tall. Shapes are drawn
// in units in which they look right: `across` and `up` of equal length.
//
// The lowest row of each has one colour. As the haze colour of a map it lets the far floor melt
// into the hills.
#pragma once

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kSkyWidth = 1024;
inline constexpr int kSkyHeight = 256;

inline constexpr Colour kHazeDay = blend(kSea4, kStone6, 96);    // #d4e0d9
inline constexpr Colour kHazeDusk = blend(kCoral, kSand0, 112);  // #dc976a
inline constexpr Colour kHazeNight = blend(kSea0, kSlate1, 96);  // #2b3e53

Picture paintSkyDay();
Picture paintSkyDusk();
Picture paintSkyNight();

}  // namespace slicecast::textures
