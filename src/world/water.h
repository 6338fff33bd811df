// Water: blocks that bodies get into, and floors in which they wade.
//
//     ~~~~~~~~~~  surface     Stacked water blocks that touch are one body of water.
//     |  water |              A body wades in water up to kSwimDepth,
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

// The depth of a floor of water. Less than the height of a crouched eye, so that no eye gets below
// a floor.
inline constexpr Coordinate kFloorWade = toCoordinate(0.2);

struct WaterAt {
    const CellBlueprint* water = nullptr;  // null for none
    Coordinate surface;                    // its height
};

// The water block at a place, which may be outside the grid.
WaterAt waterAt(const World& world, const Map& map, int tileX, int tileY, Coordinate z);

// How far the feet are below the surface; 0 out of the water. Looks at the column below the eye.
Coordinate waterDepth(const World& world, const Traveller& body);

// Moves floating objects that are in water to its surface.
void floatObjects(World& world);

}  // namespace slicecast
