// The water of a fountain, in frames: a jet that falls back in a ring.
#pragma once

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kFountainFrames = 6;

Picture paintFountain();

}  // namespace slicecast::textures
