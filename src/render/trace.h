// What the renderer met on its way, as plain data for inspectors and lessons.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace slicecast {

// The texel that one row shows, and in what light.
struct TracedTexel {
    double depth = 0.0;  // perpendicular depth t, units
    int detail = 0;      // level of detail m
    int u = 0;  // which texel of that level, from the left and from the top as its picture is seen
    int v = 0;
    std::uint32_t light = 0;  // q, 0 to 256
    std::uint32_t fog = 0;    // weight, 0 to 255
};

// A texture of 1024 texels a side has so many levels.
inline constexpr int kMostDetails = 11;

// Rows [first, last) of a slice that one face, plane or object filled.
struct FilledRows {
    enum class What : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze, object };
    What what = What::side;
    Face face = Face::top;  // for side, roof and underside
    int first = 0;
    int last = 0;
    int map = 0;
    int portals = 0;     // that the rays had passed before
    int hit = -1;        // whose block it is: index into SliceTrace::hits; of what is no block, -1
    int object = -1;     // index into SliceTrace::objects
    int begun = 0;       // of the classic method: its place before it was sorted by depth
    bool layer = false;  // laid over what is behind, which is told too
    TextureId texture = kNoTexture;  // or the sprite's number; none for the sky and haze
    TracedTexel top = {};            // of the first row, where there is a texture
    TracedTexel bottom = {};         // of the last row
    std::array<std::uint16_t, kMostDetails> rowsOfDetail =
        {};  // how many rows show each level of detail
};

// A block that a slice's ground line passes, whether or not any of it is seen. Rows are real
// numbers: row r's centre is r + 0.5, and rows grow downwards. "Front" is where the line enters the
// block's tile, "back" where it leaves it. In the eye's own tile the front depth is 0 and the front
// rows are infinite.
struct Hit {
    int map = 0;
    int portals = 0;  // that the line has passed before
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    BlueprintId blueprint = kEmptyCell;
    bool entered = false;     // false in the eye's own tile, where the line starts inside
    Face face = Face::north;  // through which the line enters, if it does
    double x = 0.0;           // world point where the line enters the tile, units
    double y = 0.0;
    double rawDepth = 0.0;   // distance from the eye to that point along the ground
    double depth = 0.0;      // perpendicular depth t of that point
    double backDepth = 0.0;  // perpendicular depth where the line leaves the tile
    Coordinate bottom;       // heights above the map's floor
    Coordinate top;
    double topFrontRow = 0.0;
    double bottomFrontRow = 0.0;
    double topBackRow = 0.0;
    double bottomBackRow = 0.0;
    std::vector<FilledRows> filled;  // what was seen of it, from the top
};

// One tile that the walk entered. The walk counts in `along`, the share of the ray's direction
// (SliceTrace::ray times the distance to the projection plane) that lies behind: along = distance /
// speed, depth = along * projectionDistance. The tile is left by whichever of the two borders ahead
// comes first.
struct WalkedTile {
    int map = 0;
    int x = 0;
    int y = 0;
    double depth = 0.0;    // perpendicular depth on entering
    int portals = 0;       // that the line has passed before
    bool entered = false;  // false in the tile in which a walk begins
    bool alongX = false;   // entered through a border of constant x
    double along = 0.0;
    double distance = 0.0;  // of that border from the eye, along its axis, units
    double speed = 1.0;     // size of the ray's direction on that axis
    double nextX = 0.0;     // `along` of the next border of constant x, infinite if there is none
    double nextY = 0.0;
};

// An object that a slice shows, and the rows [first, last) in which it is seen through its holes or
// not.
struct SeenObject {
    int map = 0;
    int portals = 0;  // that the rays had passed before
    int object = 0;   // index into Map::objects
    double depth = 0.0;
    int first = 0;
    int last = 0;
};

// Rows [first, last) of a slice whose rays went through a portal.
struct PassedPortal {
    PortalId portal = kNoPortal;
    int portals = 0;     // that the rays had passed before
    double depth = 0.0;  // perpendicular depth of the tile's border; of what falls or rises through
                         // a roof or an underside, where the line enters the tile
    int first = 0;
    int last = 0;
};

// Rows [first, last) of a slice that show something in a mirror.
struct MirroredRows {
    int map = 0;
    int strength = 0;   // 1 to 255
    Coordinate height;  // of the mirror
    int first = 0;
    int last = 0;
};

// What the ray of the watched row meets: a run of rows that holds it, and the point of it there.
struct SeenPoint {
    int run = 0;             // index into SliceTrace::filled
    TracedTexel texel = {};  // where there is a texture; else its depth is infinite
    double x = 0.0;          // of the run's map, units; of no meaning where there is no texture
    double y = 0.0;
    double z = 0.0;
};

// Everything that one slice did, in the order in which it happened.
struct SliceTrace {
    int watchedRow = -1;         // asked for: the row of which `seen` tells; -1 for none
    bool asksReflection = true;  // asked for: what mirrors show
    int column = 0;
    double rayX = 0.0;  // the ground direction per unit of perpendicular depth
    double rayY = 0.0;
    double horizonRow = 0.0;
    double projectionDistance = 0.0;  // pixels
    std::vector<WalkedTile> tiles;
    std::vector<Hit> hits;
    std::vector<FilledRows> filled;  // all, in the order in which they were met
    std::vector<FilledRows> planes;  // those of floor, ceiling, sky and haze
    std::vector<SeenObject> objects;
    std::vector<PassedPortal> portals;
    std::vector<MirroredRows> mirrors;
    std::vector<SliceTrace> reflection;  // one, of what is seen in them, if there are any; its rows
                                         // are those of the picture
    std::vector<SeenPoint> seen;         // front to back: layers, then what lies behind them

    // Forgets all that is told; the memory is kept.
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
    std::int64_t spansDrawn = 0;          // runs of rows that were filled
    std::int64_t partsBehindPortals = 0;  // walks that went on behind a portal
    int deepestPortal = 0;                // portals passed by one ray, at most
    std::int64_t mirroredRows = 0;
    std::int64_t layers = 0;        // runs of rows that were seen through, objects among them
    std::int64_t objectSlices = 0;  // columns of objects that were drawn
    // Rows of slices: each once, and again for each layer that is blended over it.
    std::int64_t rowsFilled = 0;
};

// Which column of a picture is traced.
struct ColumnRequest {
    int width = 0;  // of the picture, pixels
    int height = 0;
    int column = 0;
    int watchedRow = -1;  // see SliceTrace
};

// The same for many columns, and how much of them is told.
struct TraceRequest {
    int width = 0;  // of the picture, pixels
    int height = 0;
    std::span<const int> columns = {};
    int watchedRow = -1;      // see SliceTrace
    bool reflections = true;  // without them there is less to find
};

}  // namespace slicecast
