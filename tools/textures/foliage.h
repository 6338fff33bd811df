// Leaves: a clipped hedge, and ivy on a wall.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintHedge();
Picture paintIvy();

}  // namespace slicecast::textures
