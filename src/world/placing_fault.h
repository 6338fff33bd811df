// A fault of a cell that moves or opens.
#pragma once

#include <cstddef>
#include <string>

namespace slicecast {

inline constexpr std::size_t kMaxPlacingFaults = 1000;  // more would help nobody

struct PlacingFault {
    int map = 0;  // index into World::maps
    int x = 0;    // the cell
    int y = 0;
    int level = 0;
    std::string found;
    std::string expected;
};

}  // namespace slicecast
