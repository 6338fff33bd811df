// Warns of what a scene has that no player can get to on foot: finds, messages, gates, and the
// goal. And of blueprints that stand nowhere, places that nothing names, and baked light that the
// map's light dims.
//
//     for (const Fault& warning : findUnreached(loaded)) ...
//
// It looks at the whole world (see world/footways.h), so it is for tools: a page does not wait for
// it.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace slicecast {

// In the order of the text. None for a scene with faults.
std::vector<Fault> findUnreached(const LoadedScene& scene);

}  // namespace slicecast
