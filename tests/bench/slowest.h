// The slowest moments of tours.
#pragma once

#include <string>
#include <vector>

namespace slicecast {

// Draws every so many steps of the tours through these scenes, and prints JSON: for each scene the
// step that is slowest when its light is made, where that is, and nanoseconds a pixel. False if
// something cannot be opened.
bool printSlowest(const std::string& root, int every, const std::vector<std::string>& scenes);

}  // namespace slicecast
