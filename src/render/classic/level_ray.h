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

// Through a place on the picture, as a share of its width from the left, to the first block of a
// level that stands at that height above the level's base; at most `most` units far, and no
// further than a march goes.
ClassicLevelRay castClassic(const World& world, const Eye& eye, double fovDegrees,
                            const ClassicOptions& classic, double share, int level,
                            Coordinate height, double most);

}  // namespace slicecast
