// Finds where a player enters a map that has no start (only one map of a scene has one).
//
// That is the middle of a tile where the player can stand dry. Tiles are tried in rings around the
// map's middle, and in each ring row by row. The feet stand on the floor, or else on the lowest
// block of the tile with room above it. If no tile will do, the place is in the air above the
// middle.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

struct World;

struct MapEntry {
    Coordinate x;
    Coordinate y;
    Coordinate feet;
    bool stands = false;  // there is room for a standing player; false in the air
};

// `map` must be an index in World::maps.
MapEntry findMapEntry(const World& world, int map);

}  // namespace slicecast
