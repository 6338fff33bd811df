// Reads a scene and the images that it names from disk.
#pragma once

#ifndef __EMSCRIPTEN__

#include "scene/scene.h"

#include <filesystem>

namespace slicecast {

// The world, or all the faults; a scene that cannot be read is one.
LoadedScene readSceneFile(const std::filesystem::path& scene);

// The scene to open when none is asked for: beside the program, or in the source tree that it was built in. Empty if there is none.
std::filesystem::path findOpeningScene(const std::filesystem::path& programFolder);

}  // namespace slicecast

#endif
