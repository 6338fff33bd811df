// Follows a horizontal ray on the map until a block of one level stops it, or it meets a portal,
// behind which another map begins.
#pragma once

#include "world/world.h"

namespace slicecast {

struct MapRay {
    double x = 0.0;  // its start, units
    double y = 0.0;
    double directionX = 0.0;  // any length but 0; ray lengths are in multiples of it
    double directionY = 0.0;
    int level = 0;
    Coordinate height;  // above the level's base
};

struct MapRayEnd {
    double length = 0.0;  // to where it ends, in multiples of the direction; at most `most`
    bool met = false;     // a block or a portal ends it
    bool portal = false;  // what ends it is a portal
};

// The block and the portal tile in which a ray starts do not stop it.
MapRayEnd followRay(const World& world, const Map& map, const MapRay& ray, double most);

}  // namespace slicecast
