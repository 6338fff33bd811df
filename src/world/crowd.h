// Solid objects keep out of each other's way and out of the player's; softly, so that nobody is
// ever trapped.
//
// A walker does not step into another body. It passes on the right, or waits where there is no
// room; after kCrowdPatience steps it goes through. Who overlaps may always move apart. The player
// pushes through: both are pushed apart, slowly, the object twice as far.
//
//     gatherCrowd(world, &player);                 once for each step
//     way = besideOthers(world, motion, way);
//     noteMoved(world, motion);                    after the object's step
//     pushApart(world, player);                    after the objects' steps
//
// Bodies are listed by the tile that they are in, and each looks at no more than kMostNeighbours,
// so a step takes a time that grows with their number, and not with its square, wherever they are.
#pragma once

#include "world/object_motion.h"

namespace slicecast {

struct Player;

inline constexpr int kCrowdPatience = 240;  // steps
inline constexpr int kMostNeighbours = 16;
// How far a step pushes an object, and half as far the player, who walks up to 3 units a second.
inline constexpr Coordinate kPush = toCoordinate(2.0 / 120);

void gatherCrowd(World& world, const Body* player);

// The others see the object where it is now.
void noteMoved(World& world, const ObjectMotion& motion);

// The way of a step that does not lead into others. Counts the steps in which they are in the way.
GroundPoint besideOthers(World& world, ObjectMotion& motion, GroundPoint way);

// Pushes the player and the objects that the body overlaps. Not while it flies.
void pushApart(World& world, Player& player);

}  // namespace slicecast
