// Small things to find in games, each with a glow around it that comes and goes.
#pragma once

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kKeepsakeFrames = 8;

Picture paintShell();
Picture paintMoonflower();
Picture paintCrystal();
Picture paintLantern();

}  // namespace slicecast::textures
