// Replays a recording in a session of its scene.
#pragma once

#include "session/recording.h"
#include "session/session.h"

#include <string>

namespace slicecast {

// Replays up to a step, given as a number (0 is the start) or as the name of a mark; an empty text
// replays all. Empty on success, else an error message.
std::string replayUpTo(Session& session, Replay& replay, const std::string& stepOrMark);

}  // namespace slicecast
