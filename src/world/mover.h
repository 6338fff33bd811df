// Movers: blocks whose bottom, top or both go up and down by a motion.
//
//      |     |  level 2        Cells of one moving blueprint that touch, side by side or stacked, are one mover: all of it moves by the same offset. A
//      |:::::|                 shaft is what of it stands in tiles of the same levels. On each level that a shaft can reach its cells have a blueprint of
//      |#####|  level 1        their own, which is cut off at the level's borders, and empty while the shaft is elsewhere.
//      |#####|
//      |     |  level 0        A mover waits, and its clock with it, as long as it would enter a body that was free. What stands on its top, or is met by
//      +-----+                 it from below, goes up with it; what stands there with its weight goes down with it too.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"
#include "world/placing_fault.h"

#include <cstddef>
#include <span>
#include <vector>

namespace slicecast {

struct Body;
struct World;

inline constexpr std::size_t kMaxMovingCells =
    1'000'000;  // of all movers, with what they reach, and all gates

struct Shaft {
    Coordinate low;  // without the motion's offset, above the map's floor
    Coordinate high;
    int firstLevel = 0;  // that it can reach
    int lastLevel = 0;
    BlueprintId firstPart =
        kEmptyCell;  // its blueprint on firstLevel; those of the levels above follow
    std::vector<std::size_t> tiles;  // Map::tileIndex
};

struct Mover {
    int map = 0;  // indices into World::maps and World::motions
    int motion = 0;
    int west = 0;  // the tiles around it, all included
    int east = 0;
    int north = 0;
    int south = 0;
    std::vector<Shaft> shafts;
    int clock = 0;  // steps that it has moved, within the period
    Coordinate offset;
    Coordinate previousOffset;  // before the last step
};

// Finds the movers of a world whose cells are complete, and puts them in their first places. What
// it gives is wrong with the world, which is of no use then.
std::vector<PlacingFault> makeMovers(World& world);

// One step of all of them. The bodies are moved along.
void stepMovers(World& world, std::span<Body> bodies);

// Back to the beginning.
void resetMovers(World& world);

// Puts the blocks where they are at `fraction` (0 to 1) of the way from the last step but one to
// the last, for a picture. Steps are made from 1.
void showMovers(World& world, double fraction);

}  // namespace slicecast
