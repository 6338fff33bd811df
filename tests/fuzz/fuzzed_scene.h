// Any bytes as a scene, for fuzzers, and scenes with all that the schema knows (see
// tests/worst/scene_maker.h).
#pragma once

#include "scene/scene.h"
#include "scene_maker.h"

#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// Its scenes are small, and name the tests' small pictures.
SceneMaker& sceneMaker();

// Loads it with the tests' small pictures. Aborts if a fault does not say where, what was found and
// what was expected, or if there is neither a world nor a fault.
LoadedScene loadFuzzed(std::string_view text);
std::vector<Fault> faultsOf(const std::string& text);

}  // namespace slicecast
