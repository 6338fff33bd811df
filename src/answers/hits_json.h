// What one column meets, as JSON: the tiles that the walk entered, the blocks with the rows of
// their edges and the rows filled with them, planes, objects, portals and mirrors. Behind a portal
// the walk continues in the map that it leads to: depths are still measured from the eye,
// everything else is in that map's coordinates; "portals" counts those passed before.
//
//     { "scene", "map", "size": [W, H],
//       "eye": {"x", "y", "z", "heading", "look"}, "fov", "column", "horizonRow",
//       "projectionDistance",
//       "ray": [x, y],                  ground direction per unit of perpendicular depth
//       "tiles": [ [x, y, depth, map] ],     in order, with the perpendicular depth on entering
//       "hits": [ { "map", "portals", "tile": [x, y], "level", "blueprint",
//                   "face",             that the ray enters; null in the eye's own tile
//                   "point": [x, y],    where it enters, units
//                   "rawDepth",         to that point along the ground, units
//                   "depth",            perpendicular
//                   "backDepth",        perpendicular, where it leaves the tile (null: never)
//                   "bottom", "top",    heights above the map's floor, units
//                   "bottomFrontRow", "topFrontRow",     rows as real numbers; null where
//                   "bottomBackRow", "topBackRow",       infinite
//                   "filled": [ { "what", "face",
//                                 "first", "last" } ] } ],      both rows included
//       "planes": [ { "what", "map", "first", "last" } ],       floor, ceiling, sky and haze
//       "objects": [ { "map", "portals", "sprite",
//                      "point": [x, y],                  of its middle, units
//                      "bottom", "top", "width",         heights of feet and head; units
//                      "depth", "first", "last" } ],     the rows that it covers, holes included
//       "portals": [ { "portals",
//                      "from": { "map", "tile": [x, y] },     its own tile
//                      "to": { "map", "tile" },               the exit tile
//                      "turn", "levels",                 degrees clockwise; added to heights
//                      "depth",                          of the tile's border
//                      "first", "last" } ],              the rows whose rays went through
//       "mirrors": [ { "map", "height",
//                      "strength",                       1 to 255
//                      "first", "last" } ] }   a trace tells what is seen in them (trace_json.h)
#pragma once

#include "answers/json_text.h"
#include "session/session.h"
#include "slicecast/picture.h"

#include <cstddef>
#include <span>
#include <string>

namespace slicecast {

// The session's view in a picture of this size; `column` must lie within it.
std::string hitsJson(Session& session, const std::string& sceneName, int width, int height,
                     int column);

// A request has at most as many columns as the widest picture.
inline constexpr int kMostAskedColumns = kMaxPictureSide;

// The same for many columns, at most kMostAskedColumns, packed as an array (json_text.h).
void packHits(Session& session, const std::string& sceneName, int width, int height,
              std::span<const int> columns, PackedValues& packed);

// Parts of it, which traces (trace_json.h) use too; `Json` is JsonText or PackedJson. From "scene"
// to "fov":
template <typename Json>
void writeView(Json& json, const Session& session, const std::string& sceneName, int width,
               int height);
// The rest, from "column" on:
template <typename Json>
void writeHits(Json& json, const Session& session, const SliceTrace& trace);
template <typename Json>
void writeRows(Json& json, int first, int last);  // writes [first, last) with the last row included
template <typename Json>
void writePortalEnds(Json& json, const World& world, PortalId id, int portalsBefore);
const char* nameOf(FilledRows::What what);
const char* nameOf(Face face);
const std::string& mapName(const World& world, int map);

}  // namespace slicecast
