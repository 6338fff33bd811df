// Any text as a recording. One that is read and written is the same recording.
#include "session/recording_text.h"

#include <cstdint>
#include <cstdlib>
#include <string>

using namespace slicecast;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ReadRecording read =
        readRecording({reinterpret_cast<const char*>(data), size}, "fuzz.txt");
    if (read.recording.has_value() == !read.faults.empty()) std::abort();
    for (const Fault& fault : read.faults)
        if (fault.found.empty() || fault.expected.empty() || fault.line < 1) std::abort();
    if (!read.recording) return 0;
    const std::string text = writeRecording(*read.recording);
    const ReadRecording again = readRecording(text, "again.txt");
    if (!again.recording || writeRecording(*again.recording) != text) std::abort();
    return 0;
}
