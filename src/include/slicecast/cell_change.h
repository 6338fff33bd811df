// What to put into a cell of some map.
#pragma once

#include <string_view>

namespace slicecast {

struct CellChange {
    int level = 0;
    int x = 0;
    int y = 0;
    std::string_view sign;  // of the map's legend, UTF-8; "." empties the cell
};

}  // namespace slicecast
