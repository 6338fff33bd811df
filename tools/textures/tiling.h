// Laid floors and vaulted ceilings: marble, terracotta, mosaic, coffers.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintMarbleChecker();
Picture paintTerracotta();
Picture paintMosaic();
Picture paintCeilingCoffers();

}  // namespace slicecast::textures
