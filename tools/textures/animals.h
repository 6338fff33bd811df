// Animals, in frames.
#pragma once

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kCatFrames = 6;
inline constexpr int kBirdFrames = 6;

Picture paintCat();
Picture paintBird();

}  // namespace slicecast::textures
