// Blocks on open land, in maps of any size.
#pragma once

#include "world/world.h"

namespace slicecast {

// A map of size x size tiles and 4 levels, made of the world's first blueprints, with some dozen of
// stones around its middle, where one starts. Farther out there is nothing but the floor.
World stonesOnLand(World world, int size);

}  // namespace slicecast
