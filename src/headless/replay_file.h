// A recording from a disk, played in a session of its scene.
#pragma once

#include "session/recording_text.h"
#include "session/session.h"

#include <string>

namespace slicecast {

// The recording, or all faults; a file that cannot be read is one.
ReadRecording readRecordingFile(const std::string& path);

// Plays it up to a step, given as a number (0 is the start) or by a mark's name, or whole where
// nothing is given. Empty on success, else what was wrong.
std::string replayUpTo(Session& session, Replay& replay, const std::string& stepOrMark);

}  // namespace slicecast
