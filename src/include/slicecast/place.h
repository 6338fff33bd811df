// A point of a map.
#pragma once

namespace slicecast {

struct Place {
    double x = 0.0;  // units; may lie outside the grid
    double y = 0.0;
    double z = 0.0;
};

}  // namespace slicecast
