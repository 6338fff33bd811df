// Finds ground to stand on: where a player enters a map that has no start (only one map of a scene
// has one), and where a player lands who has no room.
//
// That is the middle of a tile where the player can stand dry. Tiles are tried in rings around a
// first one, and in each ring row by row. The feet stand on the floor or on a block of the tile
// with room above it, where that is nearest to a wanted height. If no tile will do, the place is in
// the air above the first one.
#pragma once

#include "base/coordinate.h"

#include <optional>

namespace slicecast {

struct Position;
struct World;

struct MapEntry {
    Coordinate x;
    Coordinate y;
    Coordinate feet;
    bool stands = false;  // there is room for a standing player; false in the air
};

// The height nearest to `wanted` at which a player can stand in the middle of a tile.
std::optional<Coordinate> findFooting(const World& world, int map, int tileX, int tileY,
                                      Coordinate wanted);

// `map` must be an index in World::maps. Begins at the map's middle, and takes the lowest ground.
MapEntry findMapEntry(const World& world, int map);

// The same from an eye, which may be outside the grid.
MapEntry findGround(const World& world, int map, const Position& eye);

}  // namespace slicecast
