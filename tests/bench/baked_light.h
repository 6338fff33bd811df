// What baked light costs: the first picture of a scene, all later ones, and those in which a gate
// opens.
#pragma once

#include <string>
#include <vector>

namespace slicecast {

// Prints a line for each of these shipped scenes: milliseconds, medians over so many rounds. False
// if a scene cannot be opened.
bool printBakedLight(const std::string& root, int rounds, const std::vector<std::string>& scenes);

}  // namespace slicecast
