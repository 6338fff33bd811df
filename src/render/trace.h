// What the renderer met, as plain data for inspectors and lessons.
#pragma once

#include "base/coordinate.h"
#include "render/options.h"
#include "world/blueprint.h"
#include "world/object.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slicecast {

// The texel that one row shows, and its light.
struct TracedTexel {
    double depth = 0.0;  // perpendicular depth t, units
    int detail = 0;      // level of detail m
    int u = 0;           // in that level, from the left and from the top of its picture
    int v = 0;
    std::uint32_t light = 0;                              // q, 0 to 256
    std::uint32_t fog = 0;                                // weight, 0 to 255
    std::array<std::int32_t, 3> baked = {256, 256, 256};  // L of red, green and blue, 0 to 256
};

// The levels of a texture with 1024 texels a side.
inline constexpr int kMostDetails = 11;

// Rows [first, last) of a slice that one face, plane or object filled.
struct FilledRows {
    enum class What : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze, object };
    // The number of kinds, for tables of all of them.
    static constexpr std::size_t kWhats = static_cast<std::size_t>(What::object) + 1;
    What what = What::side;
    Face face = Face::top;  // for side, roof and underside
    int first = 0;
    int last = 0;
    int map = 0;
    int portals = 0;  // passed by the rays before it
    int hit = -1;     // index of its block in SliceTrace::hits; -1 if it is not of a block
    int object = -1;  // index into SliceTrace::objects
    ObjectSide side = ObjectSide::front;  // of an object: the row of its sprite's sheet
    int begun = 0;                        // classic method: its position before sorting by depth
    bool layer = false;                   // blended over the background, which is listed too
    TextureId texture = kNoTexture;       // or the sprite's number; none for sky and haze
    TracedTexel top = {};                 // of the first row, if there is a texture
    TracedTexel bottom = {};              // of the last row
    std::array<std::uint16_t, kMostDetails> rowsOfDetail = {};  // number of rows by level of detail
};

// A block that a slice's ground line passes, seen or not. Rows are real numbers: row r's centre is
// r + 0.5, and rows grow downwards. "Front" is where the line enters the block, "back" where it
// leaves it. If the line starts inside, the front depth is 0 and the front rows are infinite.
struct Hit {
    int map = 0;
    int portals = 0;  // passed by the line before it
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    BlueprintId blueprint = kEmptyCell;
    bool entered = false;     // false if the line starts inside
    Face face = Face::north;  // that the line enters, if `entered`
    double x = 0.0;           // world point at the entry, units
    double y = 0.0;
    double rawDepth = 0.0;   // distance from the eye to that point along the ground
    double depth = 0.0;      // perpendicular depth t of that point
    double backDepth = 0.0;  // perpendicular depth where the line leaves the block
    Coordinate bottom;       // heights above the map's floor: its lowest and its highest point
    Coordinate top;
    double bottomSlope = 0.0;  // how far its underside and its top rise per unit of depth
    double topSlope = 0.0;
    double topFrontRow = 0.0;
    double bottomFrontRow = 0.0;
    double topBackRow = 0.0;
    double bottomBackRow = 0.0;
    std::vector<FilledRows> filled;  // its visible rows, from the top
};

// One tile that the walk entered. The walk measures distance by `along`, in multiples of the ray's
// direction (SliceTrace::ray times the distance to the projection plane): along = distance / speed,
// depth = along * projectionDistance. The nearer of the two borders ahead leads on.
struct WalkedTile {
    int map = 0;
    int x = 0;
    int y = 0;
    double depth = 0.0;    // perpendicular, at the entry
    int portals = 0;       // passed by the line before it
    bool entered = false;  // false in the tile where a walk starts
    bool alongX = false;   // entered through a border of constant x
    double along = 0.0;
    double distance = 0.0;  // from the eye to the border, along its axis, units
    double speed = 1.0;     // size of the ray's direction on that axis
    double nextX = 0.0;     // `along` of the next border of constant x, infinite for none
    double nextY = 0.0;
};

// An object that a slice shows, and the rows [first, last) that it covers, holes included.
struct SeenObject {
    int map = 0;
    int portals = 0;  // passed by the rays before it
    int object = 0;   // index into Map::objects
    double depth = 0.0;
    int first = 0;
    int last = 0;
};

// Rows [first, last) of a slice whose rays went through a portal.
struct PassedPortal {
    PortalId portal = kNoPortal;
    int portals = 0;     // passed by the rays before it
    double depth = 0.0;  // perpendicular depth of the tile's border; for a roof or an underside,
                         // where the line enters the tile
    int first = 0;
    int last = 0;
};

// Rows [first, last) of a slice that reflect something.
struct MirroredRows {
    int map = 0;
    int strength = 0;   // 1 to 255
    Coordinate height;  // of the mirror
    int first = 0;
    int last = 0;
};

// What the ray of the watched row meets: a run of rows, and the point seen.
struct SeenPoint {
    int run = 0;             // index into SliceTrace::filled
    TracedTexel texel = {};  // depth is infinite if there is no texture
    double x = 0.0;          // in the run's map, units; undefined without a texture
    double y = 0.0;
    double z = 0.0;
};

// Everything that one slice did, in order.
struct SliceTrace {
    int watchedRow = -1;         // input: the row for `seen`; -1 for none
    bool asksReflection = true;  // input: whether to trace what mirrors show
    int column = 0;
    double rayX = 0.0;  // the ground direction per unit of perpendicular depth
    double rayY = 0.0;
    double horizonRow = 0.0;
    double projectionDistance = 0.0;  // pixels
    std::vector<WalkedTile> tiles;
    std::vector<Hit> hits;
    std::vector<FilledRows> filled;  // all, front to back
    std::vector<FilledRows> planes;  // those of floor, ceiling, sky and haze
    std::vector<SeenObject> objects;
    std::vector<PassedPortal> portals;
    std::vector<MirroredRows> mirrors;
    std::vector<SliceTrace>
        reflection;  // one element if there are mirrors: what they show, in rows of the picture
    std::vector<SeenPoint> seen;  // front to back: layers, then the opaque rows behind

    // Empties the results; keeps the memory.
    void clear() {
        tiles.clear();
        hits.clear();
        filled.clear();
        planes.clear();
        objects.clear();
        portals.clear();
        mirrors.clear();
        reflection.clear();
        seen.clear();
    }
};

// Sums over a frame.
struct FrameReport {
    std::int64_t tilesWalked = 0;
    std::int64_t blocksMet = 0;           // blocks whose rows were looked at
    std::int64_t spansDrawn = 0;          // runs of filled rows
    std::int64_t partsBehindPortals = 0;  // walks that continued behind a portal
    int deepestPortal = 0;                // most portals passed by one ray
    std::int64_t mirroredRows = 0;
    std::int64_t layers = 0;        // runs of see-through rows, including objects
    std::int64_t objectSlices = 0;  // columns of objects drawn
    // Rows of slices: each once, and again for each layer over it.
    std::int64_t rowsFilled = 0;
    LightWork lightWork = 0;  // done for baked light
    // How often light was asked for that RenderOptions::lightWork left no room for; and how often
    // there was none from before either.
    std::int64_t lateLight = 0;
    std::int64_t unlit = 0;
};

// The column of a picture to trace.
struct ColumnRequest {
    int width = 0;  // of the picture, pixels
    int height = 0;
    int column = 0;
    int watchedRow = -1;  // see SliceTrace
};

// The same for many columns.
struct TraceRequest {
    int width = 0;  // of the picture, pixels
    int height = 0;
    std::span<const int> columns = {};
    int watchedRow = -1;      // see SliceTrace
    bool reflections = true;  // false saves the work of tracing them
};

}  // namespace slicecast
