// What a Game holds.
#pragma once

#include "session/session.h"
#include "slicecast/game.h"

namespace slicecast {

struct Game::State {
    Session session;

    bool hasMap(int map) const {
        return map >= 0 && static_cast<std::size_t>(map) < session.world().maps.size();
    }
};

}  // namespace slicecast
