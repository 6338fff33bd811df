// Finds where a player enters a map without a start; only one map of a scene has one. The place is
// the middle of the free tile nearest to the map's middle, counted ring by ring and in each ring
// row by row. The feet stand on the floor or on the lowest block of the tile with room above it.
// Without such a tile the place is in the air above the middle.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

struct World;

struct MapEntry {
    Coordinate x;
    Coordinate y;
    Coordinate feet;
    bool stands = false;  // there is room for a standing player
};

MapEntry findMapEntry(const World& world, int map);

}  // namespace slicecast
