// A statue on its pedestal, as a sprite.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintStatue();

}  // namespace slicecast::textures
