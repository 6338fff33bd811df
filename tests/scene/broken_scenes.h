// The faulty scenes that tests/scene/broken/cases.txt lists, with the faults expected of each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slicecast {

struct BrokenScene {
    std::string name;
    std::string text;
    std::vector<std::string>
        faults;  // as describe() puts them, without the file name and its colon
};

// tests/scene/broken; image names are relative to it.
std::filesystem::path brokenScenesFolder();

// In the order of the list. A mistake in the list ends the program.
std::vector<BrokenScene> brokenScenes();

}  // namespace slicecast
