// Reads a scene and the images that it names from disk.
#pragma once

#ifndef __EMSCRIPTEN__

#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace slicecast {

// The world, or all the faults; a scene that cannot be read is one.
LoadedScene readSceneFile(const std::filesystem::path& scene);

// The scene to open when none is asked for: beside the program, or in the source tree that it was
// built in. Empty if there is none.
std::filesystem::path findOpeningScene(const std::filesystem::path& programFolder);

// The scene of that name: in the folder "scenes" beside the one in which the recording is, or among
// those that come with the program. Empty if it is nowhere.
std::filesystem::path findScene(const std::string& name, const std::filesystem::path& recording,
                                const std::filesystem::path& programFolder);

// Empty if the file cannot be read.
std::optional<std::string> readText(const std::filesystem::path& file);

// Empty on success, else what was wrong.
std::string writeText(const std::filesystem::path& file, const std::string& text);

}  // namespace slicecast

#endif
