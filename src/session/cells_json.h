// The cells and blocks of a running world as JSON, for figures and editors.
//
//     cells         [ [ROW, ...], ... ]       for each level its rows, the north edge first, in the
//                                             characters of edit_cells.h
//     blueprints    [ { "character", "name",  what the map's legend has, in its order
//                       "bottom", "top",      heights above the level's base
//                       "seeThrough", "moves", "gate",     true or false
//                       "faces": { "north": { "texture",
//                                             "colour",    its average, "#rrggbb"; null where all
//                                                          of it is a hole
//                                             "light", "glow", "mirror" }, ... } } ]
#pragma once

#include "world/world.h"

#include <string>

namespace slicecast {

// The map exists.
std::string cellsJson(const World& world, int map);
std::string blueprintsJson(const World& world, int map);

}  // namespace slicecast
