// The halves of a tile that is cut from corner to corner.
#pragma once

#include <cstdint>

namespace slicecast {

// Each is named after its own corner, clockwise from the north-eastern one. `none` is no half: the
// whole tile.
enum class Half : std::uint8_t { none, northEast, southEast, southWest, northWest };

}  // namespace slicecast
