// A level ray seen from above: how far it goes until a block of one level stands in its way, or it
// comes to a portal, behind which another map begins.
#pragma once

#include "world/world.h"

namespace slicecast {

struct MapRay {
    double x = 0.0;  // where it begins, units
    double y = 0.0;
    double directionX = 0.0;  // any length but 0; lengths below are in multiples of it
    double directionY = 0.0;
    int level = 0;
    Coordinate height;  // above the level's base
};

struct MapRayEnd {
    double length = 0.0;  // at most what was asked for
    bool met = false;     // a block or a portal ends it
    bool portal = false;  // it is a portal
};

// The block and the portal tile in which a ray begins do not stop it.
MapRayEnd followRay(const World& world, const Map& map, const MapRay& ray, double most);

}  // namespace slicecast
