// A recording from a disk.
#pragma once

#include "session/recording_text.h"

#include <filesystem>

namespace slicecast {

// The recording, or all faults; a file that cannot be read, is larger than kMaxRecordingBytes or is
// no regular file is one.
ReadRecording readRecordingFile(const std::filesystem::path& path);

}  // namespace slicecast
