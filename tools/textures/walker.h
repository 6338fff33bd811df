// A wayfarer who walks, in eight frames: two steps and back to the first.
#pragma once

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kWalkFrames = 8;

Picture paintWalker();

}  // namespace slicecast::textures
