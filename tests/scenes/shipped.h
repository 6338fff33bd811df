// The scenes that are shipped, for tests.
#pragma once

#include "world/world.h"

#include <filesystem>
#include <string>
#include <vector>

namespace slicecast {

std::filesystem::path assetsFolder();

// The names of the scene files, without their ending, in alphabetical order.
std::vector<std::string> shippedScenes();

std::string sceneText(const std::string& name);

// A faulty scene fails the test and gives an empty world.
World shippedWorld(const std::string& name);

}  // namespace slicecast
