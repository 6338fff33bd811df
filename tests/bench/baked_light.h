// What baked light costs: the first picture of a scene, all later ones, and those in which a gate
// opens.
#pragma once

#include <string>

namespace slicecast {

// Prints a line for each scene with baked light, or for one of that name: milliseconds at 1280x720,
// medians over so many rounds. False if a scene cannot be opened.
bool printBakedLight(const std::string& assets, int rounds, const std::string& only);

}  // namespace slicecast
