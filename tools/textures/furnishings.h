// What stands in rooms: books on shelves, casks on racks.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintBookshelf();
Picture paintBarrel();

}  // namespace slicecast::textures
