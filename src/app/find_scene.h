// Finds the scenes that the program opens by itself.
#pragma once

#ifndef __EMSCRIPTEN__

#include <filesystem>
#include <string>

namespace slicecast {

// The scene to open by default: beside the program, or in the source tree that built it. Empty if
// there is none.
std::filesystem::path findOpeningScene(const std::filesystem::path& programFolder);

// The scene of that name: in the folder "scenes" next to the recording's folder, or among the
// shipped scenes. Empty if not found.
std::filesystem::path findScene(const std::string& name, const std::filesystem::path& recording,
                                const std::filesystem::path& programFolder);

}  // namespace slicecast

#endif
