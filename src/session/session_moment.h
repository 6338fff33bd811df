// A session between two steps: everything that the next steps, and pictures between the last two,
// depend on, but the viewer's own options. See Session::moment.
#pragma once

#include "session/edit_cells.h"
#include "slicecast/input.h"
#include "world/player.h"
#include "world/world_moment.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

struct SessionMoment {
    WorldMoment world;
    std::vector<EditedCell> edits;
    Player player;
    Player previous;
    Input heldBefore;
    double speed = 1.0;  // the options that affect steps
    bool bob = true;
    std::int64_t steps = 0;
    std::int64_t beganAt = 0;

    std::size_t bytes() const {  // of memory, about
        return sizeof(SessionMoment) + world.bytes() + edits.capacity() * sizeof(EditedCell);
    }
};

}  // namespace slicecast
