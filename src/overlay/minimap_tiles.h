// What the minimap shows of a tile.
#pragma once

#include "base/coordinate.h"
#include "slicecast/colour.h"
#include "world/world.h"

#include <cstdint>

namespace slicecast {

inline constexpr Colour kMinimapGate = {238, 186, 70, 255};
inline constexpr std::uint8_t kMinimapTileAlpha = 235;  // of all tiles
inline constexpr Colour kMinimapPortal = {64, 224, 208, 255};

// A tile as it is drawn.
struct MinimapTile {
    Colour colour = {0, 0, 0, 0};  // see-through outside the grid
    Coordinate surface;            // of the block of the level, or of the ground below it
    bool block = false;            // the level has one
    bool over = false;             // a level above has one
    bool openGate = false;
    bool water = false;
    bool moves = false;
    unsigned portals = 0;  // bit n is the face of that number
};

MinimapTile minimapTile(const World& world, const Map& map, int x, int y, int level);

// Ground whose surface lies so many units below the level that is shown.
Colour minimapGround(double drop);

}  // namespace slicecast
