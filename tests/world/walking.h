// Worlds to walk in, and somebody who walks there.
#pragma once

#include "base/random.h"
#include "world/player.h"
#include "world/world.h"

#include <string>
#include <vector>

namespace slicecast {

inline constexpr Coordinate operator""_u(long double units) {
    return toCoordinate(static_cast<double>(units));
}
inline constexpr int kSecond = kStepsPerSecond;
// For random players.
inline constexpr int kPlayersPerWorld = 4;
inline constexpr int kStepsPerPlayer = 500;
inline constexpr Coordinate kTiny = {1};  // the smallest distance there is

// One empty map.
World emptyWorld(int width, int depth, int levels);

// Puts a block between two heights above the map's floor, which lie within one level.
void putBlock(World& world, int x, int y, Coordinate bottom, Coordinate top);

// A ceiling over every tile.
void putCeiling(World& world, Coordinate height);

// A corridor along row 0 whose columns 2 to 5 have blocks overhead, from that height up.
World lowPassage(Coordinate height);

// A plan of any size.
Plan randomPlan(Random& random);

// Gives a block slopes between its bottom and its top.
void incline(Random& random, CellBlueprint& block);

// Blocks of all shapes, bridges, shafts, ceilings with holes. Every seed gives another one.
World randomWorld(std::uint64_t seed);

// The same with water of all depths in it, and a floor of water here and there.
World randomWaterWorld(std::uint64_t seed);

// Whether the box is over the part of tile (x, y) that a plan fills; found anew, like the next.
bool isOverPart(const Plan& plan, int x, int y, const Box& box);

// A player at rest at a random place of map 0 where there is room, standing, crouched or flying.
// False if none was found.
bool placeRandomly(const World& world, Random& random, Player& player);

// True if a box that reaches between the lowest and the highest point of a block, over its plan,
// also reaches between its slopes.
bool reachesBetweenSlopes(const Box& box, const CellBlueprint& block, int x, int y, int level);

// True if the box reaches into a block that is not water, the floor, a ceiling or beyond the grid:
// found anew from the map, cell by cell.
bool reachesIntoSomething(const World& world, const Box& box);

// Somebody on the way.
struct Walker {
    World world;
    Player player;

    // At rest, with the feet there, looking along a heading.
    Walker(World where, double x, double y, double feet, double headingDegrees = 0.0);

    void step(const PlayerInput& input, int steps = 1);
    double x() const { return player.x.value(); }
    double y() const { return player.y.value(); }
    double z() const { return player.z.value(); }
};

inline constexpr PlayerInput kNothing = {};
inline constexpr PlayerInput kAhead = {.forward = 1.0};
inline constexpr PlayerInput kCrouchedAhead = {.forward = 1.0, .fly = -1.0};

}  // namespace slicecast
