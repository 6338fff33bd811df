// Walls of cut and of found stone.
#pragma once

#include "surface.h"

namespace slicecast::textures {

// Four courses of dressed blocks, for pictures that put something else on them.
Surface ashlarSurface();
Lighting ashlarLighting();

Picture paintStoneBlocks();
Picture paintStoneBlocksWorn();
Picture paintStoneBlocksDark();
Picture paintStoneRubble();
Picture paintSandstone();
Picture paintRock();

}  // namespace slicecast::textures
