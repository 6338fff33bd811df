// Plastered walls.
#pragma once

#include "surface.h"

namespace slicecast::textures {

// Whitewash, for pictures that put something else on it.
Surface whitewashSurface();
Lighting plasterLighting();

Picture paintPlasterWhite();
Picture paintPlasterWarm();
Picture paintPlasterBroken();

}  // namespace slicecast::textures
