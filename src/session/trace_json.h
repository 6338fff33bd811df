// Everything that the renderer did, as JSON: for one column, or for a whole picture. It is the
// renderer's own account, number for number, so a figure that is drawn from it shows what the
// engine really does. Depths are perpendicular, in units; rows grow downwards, and row r's centre
// is at r + 0.5.
//
// A column: what hits_json.h tells, and
//
//     "walk": [ { "map", "portals", "tile": [x, y],    the tiles in order, as the walk over the
//     grid found them
//                 "axis",                              "x" if the tile was entered through a border
//                 of constant x, "y"; null where the walk begins "distance", "speed", of that
//                 border from the eye, along the axis, in units; size of the ray's direction on the
//                 axis "along",                             distance / speed, the one number that
//                 the walk compares "depth",                             along * projectionDistance
//                 "next": [x, y] } ],                  `along` of the next border on either axis
//                 (null: never); the smaller one leads to the next tile
//     "runs":  [ { "what", "map", "portals",           rows that were filled, in the order in which
//     they were met: front to back
//                  "hit", "object",                    whose: index into "hits" or "objects"; null
//                  "face",                             of a block; else null
//                  "texture",                          name of the texture or sprite; null for sky
//                  and haze, which have none "first", "last",                    rows, both
//                  included "layer",                            true: see-through, laid over what
//                  is behind when that is finished. Of the other runs no two share a row,
//                                                      and together they hold every row
//                  "texels": [ { "row",                of the first and of the last row; none
//                  without a texture
//                                "depth",
//                                "detail", "size": [w, h],     level of detail m, 0 the finest, and
//                                the texels that it has "u", "v",             which of them, from
//                                the left and from the top "light", "fog" } ] } ]        q, 0 to
//                                256, and the weight of the haze, 0 to 255
//
//     "reflection": { "column" ... "runs" }            what is seen in "mirrors", told in the same
//     way, in the rows of the picture; null where there are none. A
//                                                      mirrored row shows both, blended by the
//                                                      mirror's strength
//
// "ray" is the direction per unit of depth; the walk's is that times projectionDistance, so "speed"
// is projectionDistance * |ray| on its axis. Through rows between those two, texels go evenly on a
// side and an object; on a level plane u and v follow 1 / (row + 0.5 - horizonRow).
//
// A picture:
//
//     { "scene", "map", "size", "eye", "fov", "horizonRow", "projectionDistance",           as in
//     hits_json.h
//       "totals": { "tilesWalked",
//                   "blocksMet",             blocks whose rows were looked at
//                   "spansDrawn",            runs of rows that were filled
//                   "rowsFilled",            each row of each column once, and again for each layer
//                   over it "layers", "objectSlices",        runs that were laid over others; those
//                   of objects "walksBehindPortals", "deepestPortal",     most portals that one ray
//                   has passed "mirroredRows" },
//       "times": { "framesPerSecond", "stepMilliseconds", "viewMilliseconds", "overlayMilliseconds"
//       },   lately, of the program; null where no clock is set "textures": [ { "name", "kind",
//       "texture" or "sprite"
//                       "texels": [number, ...] } ],         rows that showed it, by level of
//                       detail
//       "columns": { "nearest": [depth, ...],        for each column the depth of the nearest block
//       or object that is seen in it; null for none
//                    "tiles": [number, ...],         walked
//                    "hits": [number, ...],          blocks on the way, seen or not
//                    "rows": { "side": [number, ...], "roof", "underside", "floor", "ceiling",
//                    "sky", "haze" },   of opaque runs; they add up to the height "layers":
//                    [number, ...] } }     rows of see-through runs and objects
//
// Both tell of the method that draws the column (option "method", or "compare"); the totals of a
// comparison are the exact one's. Of the classic method, "tilesWalked" are the places that were
// looked at, "rowsFilled" counts what was painted over again, and there is one level of detail.
#pragma once

#include "session/json_text.h"
#include "session/session.h"

#include <span>
#include <string>

namespace slicecast {

// The session's view in a picture of that size; `column` lies within it.
std::string traceJson(Session& session, const std::string& sceneName, int width, int height,
                      int column);
void packTraces(Session& session, const std::string& sceneName, int width, int height,
                std::span<const int> columns, PackedValues& packed);  // as packHits
std::string frameTraceJson(Session& session, const std::string& sceneName, int width, int height);

// Parts of it, for what tells of one row.
template <typename Json>
void writeTexel(Json& json, const World& world, const FilledRows& rows, const TracedTexel& texel,
                int row);
const std::string& textureName(const World& world, const FilledRows& rows);  // not of sky and haze

}  // namespace slicecast
