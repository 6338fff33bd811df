// Looks for a view of a world in which an old way of drawing shows: draws small pictures with it
// and without it. The views are numbered: that of the eye, the world's start, and then places where
// a player can stand or fly, spread over all maps. So whoever searches can stop after any of them.
#pragma once

#include "classic/classic_options.h"
#include "render/eye.h"
#include "render/options.h"
#include "world/world.h"

#include <optional>

namespace slicecast {

struct OldWayView {
    // Of the pixels, that look different; 0 if nobody can be there, and less close to a wall.
    double share = 0.0;
    Eye eye;
    bool flying = false;
};

// Takes some milliseconds. Nothing behind the last view.
std::optional<OldWayView> tryOldWay(const World& world, const Eye& eye, bool flying,
                                    const RenderOptions& options, const ClassicOptions& ways,
                                    int number);

}  // namespace slicecast
