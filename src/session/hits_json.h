// The hits of one column as JSON: what the walk met, where on the screen each block's edges lie, and which rows were filled with it.
//
//     { "scene", "map", "size": [W, H], "column", "eye": {"x", "y", "z", "heading", "look"}, "fov", "horizonRow", "projectionDistance",
//       "ray": [x, y],                               ground direction per unit of perpendicular depth
//       "tiles": [ [x, y, depth] ],                  that the walk entered, in order, with the perpendicular depth on entering
//       "hits": [ { "map", "tile": [x, y], "level", "blueprint",
//                   "face",                          through which the ray enters the tile; null in the eye's own tile
//                   "point": [x, y],                 where it enters, units
//                   "rawDepth", "depth", "backDepth",     along the ground; perpendicular; perpendicular where it leaves the tile (null: never)
//                   "bottom", "top",                 heights above the map's floor, units
//                   "bottomFrontRow", "topFrontRow", "bottomBackRow", "topBackRow",     rows as real numbers; null where infinite
//                   "filled": [ { "what", "face", "first", "last" } ] } ],              rows from first to last, both included
//       "planes": [ { "what", "first", "last" } ] }  floor, ceiling, sky and haze
#pragma once

#include "session/session.h"

#include <string>

namespace slicecast {

// The session's view in a picture of that size; `column` lies within it.
std::string hitsJson(Session& session, const std::string& sceneName, int width, int height, int column);

}  // namespace slicecast
