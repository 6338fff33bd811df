// Finds the map that the rays of a slice's row reach through portals. All rays of a run of rows
// pass the same portals.
#pragma once

#include "render/trace.h"
#include "world/limits.h"
#include "world/world.h"

namespace slicecast {

struct Beyond {
    int map = 0;  // in which the rays end
    int levels =
        0;  // added to heights on the way: height h there is at h - levels in the eye's map
};

// Behind the first `most` portals that the rays of this row passed.
Beyond beyondPortals(const SliceTrace& trace, const World& world, int eyeMap, int row,
                     int most = kMaxPortalLimit);

}  // namespace slicecast
