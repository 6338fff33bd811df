// What flows, in frames: lava, water, a waterfall.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintLava();
Picture paintWaterSurface();
Picture paintWaterClear();  // the same water, seen through
Picture paintWaterfall();

}  // namespace slicecast::textures
