// Whether something stands between two places of a map: for labels that hide when what they name is
// covered.
//
//     isInSight(world, map, eye, {x, y, z})
//
// Blocks cover unless they are see-through or open gates, and so do floor and ceiling. Portals lead
// elsewhere, so what lies behind them is covered too. Objects cover nothing. The last kNearPlace of
// the way does not count: a place may lie on a wall.
#pragma once

#include "world/world.h"

namespace slicecast {

inline constexpr double kNearPlace = 1.0 / 16.0;  // units

struct Place {
    double x = 0.0;  // units; outside the grid too
    double y = 0.0;
    double z = 0.0;
};

bool isInSight(const World& world, const Map& map, const Place& from, const Place& to);

}  // namespace slicecast
