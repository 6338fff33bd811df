// Finds the known name nearest to a misspelt one, for messages:
//
//     words("Unknown option 'fvo'.", didYouMean("fvo", {"fov", "fog", "light"}))
//                                                     "Unknown option 'fvo'. Did you mean 'fov'?"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// The name that `wanted` was probably meant to be: at most a third of its characters are wrong,
// missing or swapped with their neighbour. Empty if there is none. Only the first few hundred names
// are looked at.
std::string_view nearestName(std::string_view wanted, const std::vector<std::string_view>& names);

// " Did you mean 'fov'?", or nothing.
std::string didYouMean(std::string_view wanted, const std::vector<std::string_view>& names);

}  // namespace slicecast
