// Writes files and finishes the standard output. Every failed write is reported.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace slicecast {

// Writes a file whole or not at all: no reader ever sees half of it, and an existing file keeps its
// permissions. Follows links. Writes pipes, devices and the like in place. Returns an empty text on
// success, else what is wrong.
std::string writeWholeFile(const std::string& path, std::span<const std::uint8_t> bytes);
std::string writeWholeFile(const std::string& path, std::string_view text);

// What writeWholeFile would say if it had to write there now; an empty text if it could. Leaves the
// file as it is. Pipes and devices are not tried, since that could wait for their readers.
std::string whyNotWritable(const std::string& path);

// Call it first in main: a write into a closed pipe then fails like any other write, instead of
// ending the program without a message.
void outliveClosedPipes();

// Call it last in main: returns the exit status. That is 1, after a message on stderr, if the
// standard output has lost something.
int finishOutput(const char* program, int status);

}  // namespace slicecast
