// What one pixel of a session's picture shows, and where a point of the world lies in it: each
// answers what the other asks.
//
//     project(session, session.eye(), {x, y, z}, map, 640, 400)     -> column and row, real numbers: the middle of
//                                                     the pixel (c, r) is at c + 0.5, r + 0.5
//     writePick(json, session, 640, 400, c, r)     -> the numbers of the pixel's ray
//
//     { "column", "row",
//       "what",                      as in hits_json.h: "side" ... "object"
//       "map", "portals",            where it is; how many portals lie before it
//       "tile": [x, y],              of a block, the floor or the ceiling; else null
//       "level", "blueprint", "face",    of a block; else null
//       "object",                    its number in the map; else null
//       "texture",                   name of the texture or sprite; null for sky and haze
//       "point": [x, y, z],          of that map, units; null for sky and haze
//       "depth",                     perpendicular; null for sky and haze
//       "texel": { ... },            as in trace_json.h; null for sky and haze
//       "alpha",                     of that texel, 1 to 255
//       "reflection": { ... } }      what shows in a mirror there, told in the same way; else null
//
// It is the nearest thing whose texel there is no hole.
#pragma once

#include "session/json_text.h"
#include "session/session.h"
#include "world/line_of_sight.h"

#include <optional>

namespace slicecast {

// What the watched row of a slice shows: the nearest run of rows there and its point. Both are
// parts of the trace.
struct SeenThing {
    const FilledRows* rows = nullptr;
    const SeenPoint* point = nullptr;
    int alpha = 255;
    bool isHole = false;  // of a floor: what is below it is haze
};
SeenThing nearestSeen(const World& world, const SliceTrace& trace);

// The height of that point; `z` is that of SeenPoint. Those of level planes are known exactly.
double heightOf(const World& world, const SliceTrace& trace, const FilledRows& rows, double z);

// The column and the row lie within the picture; `Json` is JsonText or PackedJson.
template <typename Json>
void writePick(Json& json, Session& session, int width, int height, int column, int row);

struct PicturePoint {
    double x = 0.0;  // pixels from the left; may be outside the picture
    double y = 0.0;  // from the top
    double depth = 0.0;
};

// Nothing for a point that is not before the eye, or in another map.
std::optional<PicturePoint> project(const Session& session, const Eye& eye, const Place& place,
                                    int map, int width, int height);

}  // namespace slicecast
