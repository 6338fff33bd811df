// A recording, played in a session of its scene.
#pragma once

#include "session/recording.h"
#include "session/session.h"

#include <string>

namespace slicecast {

// Plays it up to a step, given as a number (0 is the start) or by a mark's name, or whole where
// nothing is given. Empty on success, else what was wrong.
std::string replayUpTo(Session& session, Replay& replay, const std::string& stepOrMark);

}  // namespace slicecast
