// What one column of a picture meets and shows, and what drawing a whole picture took:
// Game::hits(), trace() and traceFrame(). These are the renderer's own numbers.
//
// A column's walk follows its ray over the tiles of the ground. Behind a portal it continues in the
// map that the portal leads to: depths go on from the eye, everything else is of that map. "Front"
// is where the ray enters a tile, "back" where it leaves it. Depths are measured straight ahead,
// units. Rows are real numbers where a point lies: the middle of row r is r + 0.5.
#pragma once

#include "slicecast/face.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slicecast {

// The things that pixels show.
enum class Seen : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze, object };
inline constexpr int kSeenKinds = 8;

// Rows first <= row < last of a picture, 0 at the top.
struct RowRange {
    int first = 0;
    int last = 0;
};

// A block that a column passes, seen or not. In the tile of the eye the front depth is 0 and front
// rows are infinite.
struct ColumnHit {
    int map = 0;      // of the block
    int portals = 0;  // passed by the ray before it
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    std::string block;         // name of its blueprint
    std::optional<Face> face;  // where the ray enters; none in the tile of the eye
    double x = 0.0;            // the point where it enters, in the map's units
    double y = 0.0;
    double distance = 0.0;  // from the eye to that point along the ground, units
    double depth = 0.0;     // the same measured straight ahead; sizes in the picture depend on it
    double backDepth = 0.0;
    double bottom = 0.0;  // heights above the map's floor, units
    double top = 0.0;
    double topFrontRow = 0.0;
    double bottomFrontRow = 0.0;
    double topBackRow = 0.0;
    double bottomBackRow = 0.0;
    std::vector<RowRange> rows;  // where the block is seen, from the top; empty if it is hidden
};

// A tile that a walk enters, and the borders ahead. The walk compares `along`: a distance divided
// by the ray's speed on its axis. The nearer border leads on.
struct ColumnTile {
    int map = 0;
    int portals = 0;  // passed before
    int x = 0;
    int y = 0;
    bool entered = false;   // false where a walk starts
    bool alongX = false;    // entered through a border of constant x
    double distance = 0.0;  // from the eye to that border, along its axis, units
    double speed = 1.0;     // size of the ray's direction on that axis
    double along = 0.0;     // distance / speed
    double depth = 0.0;     // along * ColumnTrace::projectionDistance
    double nextX = 0.0;     // `along` of the next border of constant x; infinite for never
    double nextY = 0.0;
};

// The texel that a row shows.
struct Texel {
    int row = 0;
    double depth = 0.0;
    int detail = 0;  // level of detail, 0 the finest
    int width = 0;   // of that level, texels
    int height = 0;
    int u = 0;  // the texel, from the left and from the top
    int v = 0;
    std::array<int, 3> baked = {256, 256, 256};  // baked light of red, green and blue, 0 to 256
    int light = 256;                             // 0 to 256
    int fog = 0;                                 // weight of the haze, 0 to 255
};

// Rows that were filled together with one face, plane or object.
struct ColumnRun {
    Seen what = Seen::sky;
    int map = 0;
    int portals = 0;           // passed before
    int hit = -1;              // its block: index into ColumnTrace::hits; -1 for none
    int object = -1;           // its object: index into ColumnTrace::objects; -1 for none
    std::optional<Face> face;  // of a block
    std::string texture;       // name of the texture or sprite; empty for sky and haze
    RowRange rows;
    bool isLayer = false;        // see-through, over the finished rows behind; the other runs
                                 // share no row and cover every row
    std::optional<Texel> first;  // of the first row; none without a texture
    std::optional<Texel> last;   // of the last row
};

// An object in a column.
struct ColumnObject {
    int map = 0;
    int portals = 0;     // passed before
    int object = 0;      // its number in the map
    std::string sprite;  // its name
    double x = 0.0;      // its middle, units
    double y = 0.0;
    double bottom = 0.0;  // heights of feet and head, units
    double top = 0.0;
    double width = 0.0;
    double depth = 0.0;
    RowRange rows;  // holes included
};

// A portal that a ray has passed.
struct PortalEnds {
    int portals = 0;  // passed before it
    int fromMap = 0;  // its own tile
    int fromX = 0;
    int fromY = 0;
    int toMap = 0;  // the exit tile
    int toX = 0;
    int toY = 0;
    int turnDegrees = 0;  // clockwise: 0, 90, 180 or 270
    int levels = 0;       // added to heights
};

// A portal in a column.
struct ColumnPortal {
    PortalEnds ends;
    double depth = 0.0;  // of the tile's border
    RowRange rows;       // whose rays went through
};

// A mirror in a column.
struct ColumnMirror {
    int map = 0;
    double height = 0.0;  // units
    int strength = 0;     // 1 to 255
    RowRange rows;
};

// Everything that one column did, in order.
struct ColumnTrace {
    int column = 0;
    double rayX = 0.0;  // direction on the ground per unit of depth
    double rayY = 0.0;
    double horizonRow = 0.0;
    double projectionDistance = 0.0;  // to the plane of projection, pixels
    std::vector<ColumnTile> tiles;
    std::vector<ColumnHit> hits;
    std::vector<ColumnRun> runs;  // front to back
    std::vector<ColumnObject> objects;
    std::vector<ColumnPortal> portals;
    std::vector<ColumnMirror> mirrors;
    std::vector<ColumnTrace> reflection;  // what mirrors show, by rows of the picture: one element
                                          // if there are mirrors, else none
};

// How often a picture shows a texture or a sprite.
struct TextureUse {
    std::string name;
    bool isSprite = false;
    std::vector<std::int64_t> rows;  // that showed it, by level of detail
};

// The numbers of one column, added up.
struct ColumnSums {
    double nearest = 0.0;  // depth of the nearest block or object seen; infinite for none
    int tiles = 0;         // walked
    int hits = 0;          // blocks on the way, seen or not
    int layers = 0;        // rows of see-through runs and objects
    std::array<int, kSeenKinds> rows = {};  // opaque rows, by Seen; they add up to the height
};

// What drawing a picture took. In a comparison with old ways, the totals are the exact part's.
struct FrameTrace {
    double horizonRow = 0.0;
    double projectionDistance = 0.0;  // pixels
    std::int64_t tilesWalked = 0;     // in all columns
    std::int64_t blocksMet = 0;       // whose rows were looked at
    std::int64_t spansDrawn = 0;      // runs of filled rows
    std::int64_t rowsFilled = 0;      // each row of each column, and again for each layer
    std::int64_t layers = 0;          // see-through runs
    std::int64_t objectSlices = 0;    // layers of objects
    std::int64_t walksBehindPortals = 0;
    int deepestPortal = 0;  // most portals that one ray has passed
    std::int64_t mirroredRows = 0;
    std::vector<TextureUse> textures;
    std::vector<ColumnSums> columns;  // one for each, from the left
};

}  // namespace slicecast
