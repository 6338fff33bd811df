#include "files/recording_file.h"

#include "files/read_file.h"

namespace slicecast {

ReadRecording readRecordingFile(const std::filesystem::path& path) {
    const ReadFile file = readWholeFile(path, kMaxRecordingBytes);
    if (file.fault.empty()) return readRecording(file.text(), path.string());
    Fault fault;
    fault.file = path.string();
    fault.found = "a path that " + file.fault;
    fault.expected = "a recording";
    return {std::nullopt, {fault}};
}

}  // namespace slicecast
