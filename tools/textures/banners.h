// Cloth hung on a wall of stone blocks: the sun over the sea.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintBanner();     // crimson
Picture paintBannerSea();  // blue

}  // namespace slicecast::textures
