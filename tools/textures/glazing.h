// Glass to look through.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintGlassPane();
Picture paintStainedGlass();
Picture paintShopWindow();

}  // namespace slicecast::textures
