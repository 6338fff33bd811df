// Stone cut in relief.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintFrieze();

}  // namespace slicecast::textures
