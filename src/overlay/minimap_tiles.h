// How the minimap shows a tile.
#pragma once

#include "base/coordinate.h"
#include "slicecast/colour.h"
#include "world/world.h"

#include <cstdint>

namespace slicecast {

inline constexpr Colour kMinimapGate = {238, 186, 70, 255};
inline constexpr std::uint8_t kMinimapTileAlpha = 235;  // of all tiles
inline constexpr Colour kMinimapPortal = {64, 224, 208, 255};

// Everything that the minimap shows of a tile.
struct MinimapTile {
    Colour colour = {0, 0, 0, 0};  // transparent outside the grid
    Plan plan;                     // where it has this colour; elsewhere the ground's
    Colour ground = {0, 0, 0, 0};
    Coordinate surface;  // top of the level's block, or of the ground below it
    bool block = false;  // the level has one that is not water or an open gate
    bool over = false;   // a level above has one
    bool openGate = false;
    bool water = false;
    bool moves = false;
    unsigned portals = 0;  // bit n is set if face n is a portal
};

MinimapTile minimapTile(const World& world, const Map& map, int x, int y, int level);

// The colour of ground this many units below the shown level.
Colour minimapGround(double drop);

}  // namespace slicecast
