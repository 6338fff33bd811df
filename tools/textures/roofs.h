// Roofs of houses. Dark, so that they stand out from walls; each course shades the one below.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintRoofClay();
Picture paintRoofSlate();
Picture paintRoofThatch();

}  // namespace slicecast::textures
