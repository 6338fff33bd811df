// Converts the engine's maps for the library.
#pragma once

#include "slicecast/scene.h"
#include "world/world.h"

#include <vector>

namespace slicecast {

std::vector<MapInfo> mapInfos(const World& world);

}  // namespace slicecast
