// Water: blocks that bodies get into, and floors that they wade in.
//
//     ~~~~~~~~~~  surface     Water blocks that touch, one upon another, are one body of water.
//     |  water |              A body wades while its feet are at most kSwimDepth below the surface,
//     |--------|              and swims in deeper water.
//     |  water |
//     +--------+  ground      The ground under a floor of water lies kFloorWade below the floor.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

struct CellBlueprint;
struct Map;
struct Traveller;
struct World;

// How deep a floor of water is. Less than the height of a crouched eye: no eye gets below a floor.
inline constexpr Coordinate kFloorWade = toCoordinate(0.2);

struct WaterAt {
    const CellBlueprint* water = nullptr;  // null for none
    Coordinate surface;                    // its height
};

// The water block that a place is in, which may be outside the grid.
WaterAt waterAt(const World& world, const Map& map, int tileX, int tileY, Coordinate z);

// How far below the surface the feet are, below the eye; 0 out of the water.
Coordinate waterDepth(const World& world, const Traveller& body);

// Puts the objects that float and are in water onto its surface.
void floatObjects(World& world);

}  // namespace slicecast
