// A free ray (render/ask/cast.h) as JSON:
//
//     { "map", "x", "y", "z", "heading",        its start; z is null without a height
//       "ray": [x, y],                          its direction, of length 1
//       "tiles": [ { "map", "portals",          portals passed before it
//                    "tile": [x, y],
//                    "axis",                    "x" if the ray enters it through a border of
//                                               constant x, else "y"; null at the start
//                    "distance",                to its entry, units along the ray
//                    "next": [x, y] } ],        distances of the next border on either axis (null:
//                                               never); the smaller one leads to the next tile
//       "hits": [ { "map", "portals", "tile", "level", "blueprint",
//                   "face",                     through which it enters; null at the start
//                   "point": [x, y],            where it enters the tile
//                   "distance", "backDistance",  where it enters the tile, and leaves it
//                   "bottom", "top" } ],         heights above the map's floor
//       "portals": [ { "portals", "from": { "map", "tile" }, "to": { "map", "tile" }, "turn",
//                      "levels", "distance" } ],
//       "end": { "why",                         "block", "edge", "portal" or "floor"
//                "map", "point": [x, y], "distance" } }
#pragma once

#include "answers/json_text.h"
#include "render/ask/cast.h"

namespace slicecast {

// The map must exist and the heading be finite; `Json` is JsonText or PackedJson.
template <typename Json>
void writeCast(Json& json, const World& world, const CastFrom& from);

}  // namespace slicecast
