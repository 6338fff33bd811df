// Finds the map that the rays of a slice's row reach through portals. All rays of a run of rows
// pass the same portals.
#pragma once

#include "render/trace.h"
#include "world/limits.h"
#include "world/world.h"

namespace slicecast {

struct Beyond {
    int map = 0;     // the one that the rays reach
    int levels = 0;  // height h in it appears at height h - levels of the eye's map
};

// The map behind the first `most` portals that the rays of this row passed; the eye's map if they
// passed none.
Beyond beyondPortals(const SliceTrace& trace, const World& world, int eyeMap, int row,
                     int most = kMaxPortalLimit);

}  // namespace slicecast
