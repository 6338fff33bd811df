// The cells and blocks of a running world as JSON, for figures and editors.
//
//     cells         [ [ROW, ...], ... ]       for each level its rows from north to south, in the
//                                             characters of edit_cells.h
//     blueprints    [ { "character", "name",  the map's legend, in its order
//                       "bottom", "top",      its lowest and its highest point above the level's
//                                             base
//                       "slopes": { "along", "bottom", "top" },     only if there are some: "x" or
//                                             "y", heights at the lesser and the greater coordinate
//                       "seeThrough", "moves", "gate",     true or false
//                       "faces": { "north": { "texture",
//                                             "colour",    its average, "#rrggbb"; null if it has
//                                                          no visible texel
//                                             "light", "glow", "mirror" }, ... } } ]
#pragma once

#include "world/world.h"

#include <string>

namespace slicecast {

// The map must exist.
std::string cellsJson(const World& world, int map);
std::string blueprintsJson(const World& world, int map);

}  // namespace slicecast
