// What the renderer did, as JSON: for one column, or for a whole picture. These are the renderer's
// own numbers, so a figure drawn from them shows what the engine really does. Depths are
// perpendicular, in units; rows grow downwards, and row r's centre is at r + 0.5.
//
// A column: the members of hits_json.h, and
//
//     "walk": [ { "map", "portals", "tile": [x, y],    the tiles in the order of the grid walk
//                 "axis",              "x" if the ray enters through a border of constant x, else
//                                      "y"; null at the start of the walk
//                 "distance",          from the eye to that border, along the axis, units
//                 "speed",             size of the ray's direction on that axis
//                 "along",             distance / speed, the number that the walk compares
//                 "depth",             along * projectionDistance
//                 "next": [x, y] } ],  `along` of the next border on either axis (null: never);
//                                      the smaller one leads to the next tile
//     "runs":  [ { "what", "map", "portals",           filled rows, front to back
//                  "hit", "object",    their owner: index into "hits" or "objects"; null for none
//                  "face",             of a block; else null
//                  "texture",          name of the texture or sprite; null for sky and haze
//                  "first", "last",    rows, both included
//                  "layer",            true: see-through, blended over the finished rows behind
//                                      it. The other runs share no row, and cover every row
//                  "texels": [ { "row",           of the first and the last row; empty without a
//                                                 texture
//                                "depth",
//                                "detail",        level of detail, 0 the finest
//                                "size": [w, h],  texels of that level
//                                "u", "v",        the texel, from the left and from the top
//                                "baked": [r, g, b],  baked light, 0 to 256
//                                "light",         0 to 256
//                                "fog" } ] } ]    weight of the haze, 0 to 255
//
//     "reflection": { "column" ... "runs" }       seen in "mirrors", in the same form and in the
//                                                 rows of the picture; null without mirrors. A
//                                                 mirrored row shows both, blended by the mirror's
//                                                 strength
//
// "ray" is the direction per unit of depth. The walk's direction is that times projectionDistance,
// so "speed" is projectionDistance * |ray| on its axis. Between the first and the last row of a
// run, texels of sides and objects advance evenly; on a horizontal plane u and v follow 1 / (row +
// 0.5 - horizonRow).
//
// A picture:
//
//     { "scene", "map", "size", "eye", "fov",
//       "horizonRow", "projectionDistance",       as in hits_json.h
//       "totals": { "tilesWalked",
//                   "blocksMet",             blocks whose rows were looked at
//                   "spansDrawn",            runs of filled rows
//                   "rowsFilled",            each row of each column, and again for each layer
//                   "layers",                runs that were blended over others
//                   "objectSlices",          layers that belong to objects
//                   "walksBehindPortals",
//                   "deepestPortal",         most portals that one ray has passed
//                   "mirroredRows" },
//       "times": { "framesPerSecond", "stepMilliseconds", "viewMilliseconds",
//                  "overlayMilliseconds" },       recent averages; null without a clock
//       "textures": [ { "name",
//                       "kind",                   "texture" or "sprite"
//                       "texels": [number, ...] } ],    rows that showed it, by level of detail
//       "columns": { "nearest": [depth, ...],     nearest visible block or object; null for none
//                    "tiles": [number, ...],      walked
//                    "hits": [number, ...],       blocks on the way, seen or not
//                    "rows": { "side": [number, ...], "roof", "underside", "floor", "ceiling",
//                              "sky", "haze",       opaque rows; they add up to the height
//                              "object" },          none by the exact method, where objects are
//                                                   layers; by the classic one an opaque texel of
//                                                   an object ends its row
//                    "layers": [number, ...] } }  rows of see-through runs and objects
//
// The numbers are of the method that draws the column (option "method" or "compare"); the totals of
// a comparison are the exact method's. For the classic method, "tilesWalked" counts the places
// examined, "rowsFilled" includes overpainted rows, and there is one level of detail.
#pragma once

#include "answers/json_text.h"
#include "session/session.h"

#include <span>
#include <string>

namespace slicecast {

// The session's view in a picture of this size; `column` must lie within it.
std::string traceJson(Session& session, const std::string& sceneName, int width, int height,
                      int column);
void packTraces(Session& session, const std::string& sceneName, int width, int height,
                std::span<const int> columns, PackedValues& packed);  // like packHits
std::string frameTraceJson(Session& session, const std::string& sceneName, int width, int height);

// Parts of it, for answers about one row.
template <typename Json>
void writeTexel(Json& json, const World& world, const FilledRows& rows, const TracedTexel& texel,
                int row);
// Of the texture or the sprite; not for sky and haze.
const std::string& textureName(const World& world, const FilledRows& rows);
struct TexelSize {
    int width = 0;
    int height = 0;
};
TexelSize sizeOfDetail(const World& world, const FilledRows& rows, int detail);

}  // namespace slicecast
