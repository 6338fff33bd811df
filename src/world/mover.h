// Movers: blocks whose bottom, top or both go up and down by a motion.
//
//      |     |  level 2
//      |:::::|                  Each shaft has a blueprint of its own on every level that it can
//      |#####|  level 1         reach. It is cut off at the level's borders, and empty while the
//      |#####|                  shaft is elsewhere.
//      |     |  level 0
//      +-----+
//
// Cells of one moving blueprint that touch, side by side or stacked, are one mover: all of it moves
// by the same offset. A shaft is a vertical run of its cells, shared by all tiles that have the
// same run.
//
// A mover waits, and its clock with it, while it would enter a body that was free. It lifts bodies
// that stand on its top or that it meets from below; bodies that rest on it go down with it too.
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

// All cells of movers, with the cells that they reach.
inline constexpr std::size_t kMaxMovingCells = 1'000'000;

struct Shaft {
    Coordinate low;  // above the map's floor, without the motion's offset
    Coordinate high;
    int firstLevel = 0;  // the levels that it can reach
    int lastLevel = 0;
    BlueprintId firstPart = kEmptyCell;  // on firstLevel; those of the levels above follow it
    std::vector<std::size_t> tiles;      // Map::tileIndex
};

struct Mover {
    int map = 0;  // indices into World::maps and World::motions
    int motion = 0;
    int west = 0;  // its bounding tiles, inclusive
    int east = 0;
    int north = 0;
    int south = 0;
    std::vector<Shaft> shafts;
    int clock = 0;  // steps that it has moved, modulo the period
    Coordinate offset;
    Coordinate previousOffset;  // before the last step
    int firstEncounter = -1;    // see findEncounters
};

// Finds the movers of a world whose cells are complete, and puts them in their initial places.
// Returns faults; with any the world is unusable.
std::vector<PlacingFault> makeMovers(World& world);

// One step of all movers. Moves the bodies along. Call findEncounters before.
void stepMovers(World& world, std::span<Body> bodies);

// Restores the initial places.
void resetMovers(World& world);

// Shows the movers at `fraction` (0 to 1) of the way between the last two steps, for a picture.
// Reset to 1 before the next step.
void showMovers(World& world, double fraction);

}  // namespace slicecast
