// A horizontal ray of the classic method, seen from above: for the minimap.
#pragma once

#include "classic/classic_options.h"
#include "render/eye.h"
#include "world/world.h"

namespace slicecast {

struct ClassicLevelRay {
    double x = 0.0;  // from the eye to its end, units
    double y = 0.0;
    bool met = false;     // a block or a portal ends it
    bool portal = false;  // it is a portal
};

struct ClassicAim {
    double fovDegrees = 60.0;
    double share = 0.5;  // position in the picture: a part of its width, from the left
    int level = 0;
    Coordinate height;  // above the level's base
    double most = 0.0;  // greatest length, units
};

// Ends at the first block of the level at that height, or where a march stops.
ClassicLevelRay castClassic(const World& world, const Eye& eye, const ClassicOptions& classic,
                            const ClassicAim& aim);

}  // namespace slicecast
