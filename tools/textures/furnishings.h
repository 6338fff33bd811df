// What stands in rooms or hangs on walls: books, banners, barrels, a carved frieze.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintBookshelf();
Picture paintBarrel();
Picture paintBanner();     // crimson, on stone-blocks
Picture paintBannerSea();  // blue, on stone-blocks
Picture paintFrieze();

}  // namespace slicecast::textures
