// Tests whether something hides one place of a map from another, for labels.
//
//     isInSight(world, map, eye, {x, y, z})
//     isInSight(world, map, eye, {x, y, z}, 0.001)      nearly exact
//
// Blocks hide places unless they are see-through or open gates; floor and ceiling hide them too,
// and so do portals, because they lead elsewhere. Objects hide nothing. Ignores the last part of
// the way, kNearPlace if not said otherwise, because a place may lie on a wall.
#pragma once

#include "slicecast/place.h"
#include "world/world.h"

namespace slicecast {

inline constexpr double kNearPlace = 1.0 / 16.0;  // units

bool isInSight(const World& world, const Map& map, const Place& from, const Place& to,
               double ignored = kNearPlace);

}  // namespace slicecast
