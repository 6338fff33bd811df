// Reads a recording from disk.
#pragma once

#include "session/recording_text.h"

#include <filesystem>

namespace slicecast {

// The recording, or all faults. A file that cannot be read, is larger than kMaxRecordingBytes or is
// not a regular file is a fault.
ReadRecording readRecordingFile(const std::filesystem::path& path);

}  // namespace slicecast
