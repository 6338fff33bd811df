// Figures that are seen from four sides: people and animals of games. Each picture has a row for
// the front, the right side, the back and the left side.
#pragma once

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kFigureFrames = 6;  // of a step; standing figures have one

Picture paintKeeper();
Picture paintKeeperWalking();
Picture paintGuard();
Picture paintGuardWalking();
Picture paintGuardAlert();
Picture paintLamb();
Picture paintLambWalking();
Picture paintFox();
Picture paintFoxRunning();

}  // namespace slicecast::textures
