// What one column meets, as JSON: the tiles that the walk entered, the blocks with the rows where
// their edges lie and those that were filled with them, planes, objects, portals and mirrors.
// Behind a portal it goes on in the map that the portal leads to: depths go on from the eye,
// everything else is in that map's coordinates; "portals" is how many were passed before.
//
//     { "scene", "map", "size": [W, H], "eye": {"x", "y", "z", "heading", "look"}, "fov", "column", "horizonRow", "projectionDistance",
//       "ray": [x, y],                               ground direction per unit of perpendicular depth
//       "tiles": [ [x, y, depth, map] ],             in order, with the perpendicular depth on entering
//       "hits": [ { "map", "portals", "tile": [x, y], "level", "blueprint",
//                   "face",                          through which the ray enters the tile; null in the eye's own tile
//                   "point": [x, y],                 where it enters, units
//                   "rawDepth", "depth", "backDepth",     along the ground; perpendicular; perpendicular where it leaves the tile (null: never)
//                   "bottom", "top",                 heights above the map's floor, units
//                   "bottomFrontRow", "topFrontRow", "bottomBackRow", "topBackRow",     rows as real numbers; null where infinite
//                   "filled": [ { "what", "face", "first", "last" } ] } ],              rows from first to last, both included
//       "planes": [ { "what", "map", "first", "last" } ],     floor, ceiling, sky and haze
//       "objects": [ { "map", "portals", "sprite",
//                      "point": [x, y],              of its middle, units
//                      "bottom", "top", "width",     heights of feet and head; units
//                      "depth", "first", "last" } ], the rows in which it is seen, through its holes or not
//       "portals": [ { "portals",
//                      "from": { "map", "tile": [x, y] }, "to": { "map", "tile" },      its own tile and the exit tile
//                      "turn", "levels",             degrees clockwise; added to heights
//                      "depth", "first", "last" } ], of the tile's border; the rows whose rays went through
//       "mirrors": [ { "map", "height",
//                      "strength",                   1 to 255
//                      "first", "last" } ] }         what is seen in them, a trace tells (trace_json.h)
#pragma once

#include "session/json_text.h"
#include "session/session.h"

#include <cstddef>
#include <span>
#include <string>

namespace slicecast {

// The session's view in a picture of that size; `column` lies within it.
std::string hitsJson(Session& session, const std::string& sceneName, int width, int height,
                     int column);

// The same of many columns, packed as an array (json_text.h).
void packHits(Session& session, const std::string& sceneName, int width, int height,
              std::span<const int> columns, PackedValues& packed);

// Parts of it, which traces consist of too (trace_json.h); `Json` is JsonText or PackedJson. From
// "scene" to "fov":
template <typename Json>
void writeView(Json& json, const Session& session, const std::string& sceneName, int width,
               int height);
// The rest, from "column" on:
template <typename Json>
void writeHits(Json& json, const Session& session, const SliceTrace& trace);
template <typename Json>
void writeRows(Json& json, int first, int last);  // [first, last) as both included
template <typename Json>
void writePortalEnds(Json& json, const World& world, PortalId id, int portalsBefore);
const char* nameOf(FilledRows::What what);
const char* nameOf(Face face);
const std::string& mapName(const World& world, int map);

}  // namespace slicecast
