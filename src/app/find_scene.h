// Where the scenes are that the program opens without being given a file.
#pragma once

#ifndef __EMSCRIPTEN__

#include <filesystem>
#include <string>

namespace slicecast {

// The scene to open when none is asked for: beside the program, or in the source tree that it was
// built in. Empty if there is none.
std::filesystem::path findOpeningScene(const std::filesystem::path& programFolder);

// The scene of that name: in the folder "scenes" beside the one in which the recording is, or among
// those that come with the program. Empty if it is nowhere.
std::filesystem::path findScene(const std::string& name, const std::filesystem::path& recording,
                                const std::filesystem::path& programFolder);

}  // namespace slicecast

#endif
