// Brick walls: eight courses of four bricks, running bond. All variants lay the same bricks, so
// that they can stand side by side and on top of each other without a break.
#pragma once

#include "surface.h"

namespace slicecast::textures {

inline constexpr int kBrickWidth = 32;
inline constexpr int kBrickHeight = 16;

// The bare wall, for pictures that put something else on it.
Surface brickSurface();
Lighting brickLighting();

Picture paintBrick();
Picture paintBrickWeathered();
Picture paintBrickMossy();

}  // namespace slicecast::textures
