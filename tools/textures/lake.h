// What floats on a lake and grows at its shore, as sprites that begin at the water.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintSailingBoat();
Picture paintSwan();
Picture paintCypress();

}  // namespace slicecast::textures
