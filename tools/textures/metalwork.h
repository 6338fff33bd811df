// Iron: riveted plates, bare and rusted, and a grating.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintMetalPlates();
Picture paintMetalRusty();
Picture paintMetalTread();

}  // namespace slicecast::textures
