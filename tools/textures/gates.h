// Gates in eight frames, from closed to open.
#pragma once

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kGateFrames = 8;

Picture paintPortcullis();
Picture paintDoubleDoor();

}  // namespace slicecast::textures
