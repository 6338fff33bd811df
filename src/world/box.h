// A box in a map, for collisions and distances.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

// The space of a body, without its surface: west < x < east, north < y < south, bottom < z < top.
struct Box {
    Coordinate west;
    Coordinate east;
    Coordinate north;
    Coordinate south;
    Coordinate bottom;
    Coordinate top;

    friend constexpr bool operator==(const Box&, const Box&) = default;
};

}  // namespace slicecast
