// How long the start of each shipped scene takes to draw, as it is played: lit, and stepped.
#pragma once

#include <string>
#include <vector>

namespace slicecast {

// Prints a line for each of these scenes, or for all in the folder: the least nanoseconds a pixel
// of 1280x720 over so many frames. The scenes take turns. False if a scene cannot be opened.
bool printShipped(const std::string& assets, int frames, std::vector<std::string> scenes);

}  // namespace slicecast
