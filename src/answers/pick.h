// Finds what one pixel of a session's picture shows (pick), and the pixel of a point of the world
// (project).
//
//     project(session, session.eye(), {x, y, z}, map, 640, 400)
//                                  -> column and row as real numbers: the middle of
//                                     pixel (c, r) is at c + 0.5, r + 0.5
//     writePick(json, session, 640, 400, c, r)
//                                  -> this JSON:
//
//     { "column", "row",
//       "what",                      as in hits_json.h: "side" ... "object"
//       "map", "portals",            where it is; portals passed before it
//       "tile": [x, y],              of a block, the floor or the ceiling; else null
//       "level", "blueprint", "face",    of a block; else null
//       "object",                    its number in the map; else null
//       "texture",                   name of the texture or sprite; null for sky and haze
//       "point": [x, y, z],          of that map, units; null for sky and haze
//       "depth",                     perpendicular; null for sky and haze
//       "texel": { ... },            as in trace_json.h; null for sky and haze
//       "alpha",                     of that texel, 1 to 255
//       "reflection": { ... } }      what a mirror shows there, in the same form; else null
//
// A pick is the nearest thing that has no hole at that pixel.
#pragma once

#include "answers/json_text.h"
#include "session/session.h"
#include "world/line_of_sight.h"

#include <optional>

namespace slicecast {

// What the watched row of a slice shows: the nearest run of rows and its point. Both point into the
// trace.
struct SeenThing {
    const FilledRows* rows = nullptr;
    const SeenPoint* point = nullptr;
    int alpha = 255;
    bool isHole = false;  // of a floor: the pixel shows the haze below it
};
SeenThing nearestSeen(const World& world, const SliceTrace& trace);
// Whether it has a texture, unlike sky, haze and holes.
bool isThing(const SeenThing& seen);

// The height of that point; `z` is SeenPoint's. Exact for horizontal planes.
double heightOf(const World& world, const SliceTrace& trace, const FilledRows& rows, double z);

// Where a mirror shows something in the place of what was picked, the slice that it shows; else
// null.
const SliceTrace* reflectionAt(const SliceTrace& trace, const SeenThing& picked);

// Column and row must lie within the picture; `Json` is JsonText or PackedJson.
template <typename Json>
void writePick(Json& json, Session& session, int width, int height, int column, int row);

struct PicturePoint {
    double x = 0.0;  // pixels from the left; may be outside the picture
    double y = 0.0;  // from the top
    double depth = 0.0;
};

// Nothing for a point in another map, or not in front of the eye.
std::optional<PicturePoint> project(const Session& session, const Eye& eye, const Place& place,
                                    int map, int width, int height);

}  // namespace slicecast
