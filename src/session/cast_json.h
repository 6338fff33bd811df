// A free ray (render/cast.h) as JSON:
//
//     { "map", "x", "y", "z", "heading",        where it begins; z is null without a height
//       "ray": [x, y],                          its direction, of length 1
//       "tiles": [ { "map", "portals",          how many portals were passed before
//                    "tile": [x, y],
//                    "axis",                    "x" if it was entered through a border of constant
//                                               x, "y"; null where the ray begins
//                    "distance",                where it is entered, units along the ray
//                    "next": [x, y] } ],        distances of the next border on either axis (null:
//                                               never); the smaller one leads to the next tile
//       "hits": [ { "map", "portals", "tile", "level", "blueprint",
//                   "face",                     through which it enters; null where it begins
//                   inside "point": [x, y],            where it enters the tile "distance",
//                   "backDistance", where it enters the tile, and leaves it "bottom", "top" } ],
//                   heights above the map's floor
//       "portals": [ { "portals", "from": { "map", "tile" }, "to": { "map", "tile" }, "turn",
//                      "levels", "distance" } ],
//       "end": { "why",                         "block", "edge", "portal" or "floor"
//                "map", "point": [x, y], "distance" } }
#pragma once

#include "render/cast.h"
#include "session/json_text.h"

namespace slicecast {

// The map exists, the heading is a number; `Json` is JsonText or PackedJson.
template <typename Json>
void writeCast(Json& json, const World& world, const CastFrom& from);

}  // namespace slicecast
