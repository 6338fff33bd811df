// A level ray as the classic method sends it, seen from above: for the minimap.
#pragma once

#include "render/classic/classic_options.h"
#include "render/eye.h"
#include "world/world.h"

namespace slicecast {

struct ClassicLevelRay {
    double x = 0.0;  // from the eye to where it ends, units
    double y = 0.0;
    bool met = false;     // a block or a portal ends it
    bool portal = false;  // it is a portal
};

struct ClassicAim {
    double fovDegrees = 60.0;
    double share = 0.5;  // the place on the picture: a share of its width, from the left
    int level = 0;
    Coordinate height;  // above the level's base
    double most = 0.0;  // units: the ray goes no further
};

// To the first block of the level that stands at that height; no further than a march goes.
ClassicLevelRay castClassic(const World& world, const Eye& eye, const ClassicOptions& classic,
                            const ClassicAim& aim);

}  // namespace slicecast
