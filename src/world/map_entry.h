// Where a player comes into a map that says nothing about it: only one map of a scene has a start.
// It is the middle of the free tile nearest to the map's middle, counted ring by ring and in each
// ring row by row; the feet stand on the floor or on the lowest block of the tile that has room
// above it. Where there is no such tile, the place is in the air above the middle.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

struct World;

struct MapEntry {
    Coordinate x;
    Coordinate y;
    Coordinate feet;
    bool stands = false;  // there is room for a player who stands
};

MapEntry findMapEntry(const World& world, int map);

}  // namespace slicecast
