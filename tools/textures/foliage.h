// Trees and leaves: bark, a clipped hedge, and ivy on a wall.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintBark();
Picture paintHedge();
Picture paintIvy();
Picture paintLeaves();  // see-through

}  // namespace slicecast::textures
