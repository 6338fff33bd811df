// Turned copies of maps, for showing that a portal to one cannot be told from what it hides.
#pragma once

#include "place.h"
#include "world/world.h"

namespace slicecast::judge {

// Appends a copy of a map, turned clockwise by quarter turns, and returns its index: blocks with
// their faces, planes, sky and objects; no portals. Faces keep their look; the textures of level
// faces and planes are turned with the map. A turned block is of another blueprint than its
// original.
int addTurnedCopy(World& world, int map, int turn);

// Where a tile of the original lies in the copy: a portal on `tile` that leads there with that turn
// shows the copy where the original was.
Tile turnedTile(const Map& original, Tile tile, int turn);

}  // namespace slicecast::judge
