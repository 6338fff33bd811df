// What covers houses. Dark, so that roofs stand apart from walls; each course shades the one below.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintRoofClay();
Picture paintRoofSlate();
Picture paintRoofThatch();

}  // namespace slicecast::textures
