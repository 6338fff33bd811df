// Which portals the rays of a slice's rows went through. All rays of a run of rows that one thing
// fills went through the same ones.
#pragma once

#include "render/trace.h"
#include "world/limits.h"
#include "world/world.h"

namespace slicecast {

struct Beyond {
    int map = 0;     // in which the rays are in the end
    int levels = 0;  // added to heights on the way: what is at height h there is met at h - levels
                     // in the eye's map
};

// Behind the first `most` portals that the rays of that row went through.
Beyond beyondPortals(const SliceTrace& trace, const World& world, int eyeMap, int row,
                     int most = kMaxPortalLimit);

}  // namespace slicecast
