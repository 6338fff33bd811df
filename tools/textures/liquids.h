// What flows, in frames: lava, water, a waterfall and the spray at its foot.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintLava();
Picture paintWaterSurface();
Picture paintWaterClear();  // the same water, seen through
Picture paintWaterfall();
Picture paintSpray();

}  // namespace slicecast::textures
