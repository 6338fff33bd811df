// What the renderer met on its way, as plain data for inspectors and lessons.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"

#include <cstdint>
#include <vector>

namespace slicecast {

// Rows [first, last) of a slice that one face or plane filled.
struct FilledRows {
    enum class What : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze };
    What what = What::side;
    Face face = Face::top;  // for side, roof and underside
    int first = 0;
    int last = 0;
};

// A block that a slice's ground line passes, whether or not any of it is seen. Rows are real numbers: row r's centre is r + 0.5, and rows grow downwards.
// "Front" is where the line enters the block's tile, "back" where it leaves it. In the eye's own tile the front depth is 0 and the front rows are infinite.
struct Hit {
    int map = 0;
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    BlueprintId blueprint = kEmptyCell;
    bool entered = false;        // false in the eye's own tile, where the line starts inside
    Face face = Face::north;     // through which the line enters, if it does
    double x = 0.0;              // world point where the line enters the tile, units
    double y = 0.0;
    double rawDepth = 0.0;       // distance from the eye to that point along the ground
    double depth = 0.0;          // perpendicular depth t of that point
    double backDepth = 0.0;      // perpendicular depth where the line leaves the tile
    Coordinate bottom;           // heights above the map's floor
    Coordinate top;
    double topFrontRow = 0.0;
    double bottomFrontRow = 0.0;
    double topBackRow = 0.0;
    double bottomBackRow = 0.0;
    std::vector<FilledRows> filled;  // what was seen of it, from the top
};

// One tile that the walk entered.
struct WalkedTile {
    int x = 0;
    int y = 0;
    double depth = 0.0;  // perpendicular depth on entering
};

// Everything that one slice did, in the order in which it happened.
struct SliceTrace {
    int column = 0;
    double rayX = 0.0;  // the ground direction per unit of perpendicular depth
    double rayY = 0.0;
    double horizonRow = 0.0;
    double projectionDistance = 0.0;  // pixels
    std::vector<WalkedTile> tiles;
    std::vector<Hit> hits;
    std::vector<FilledRows> planes;  // floor, ceiling, sky and haze
};

// Sums over a frame.
struct FrameReport {
    std::int64_t tilesWalked = 0;
    std::int64_t blocksMet = 0;   // blocks whose rows were looked at
    std::int64_t spansDrawn = 0;  // runs of rows that were filled
    std::int64_t rowsFilled = 0;  // rows of slices: each once, and again for each see-through layer over it
};

}  // namespace slicecast
