// What the programs write: files, and the standard output. What is lost on the way is told.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace slicecast {

// A file is written whole or not at all: nobody ever sees half of it, and one that was there keeps
// its permissions. Links are followed. What is no file, such as a pipe or a device, gets the bytes
// as it is. Empty on success, else what was wrong.
std::string writeWholeFile(const std::string& path, std::span<const std::uint8_t> bytes);
std::string writeWholeFile(const std::string& path, std::string_view text);

// Call it first in main: a write into a pipe that nobody reads any more then fails like any other
// lost write, instead of ending the program without a word.
void outliveClosedPipes();

// Call it last in main: the exit status, which is 1 where the standard output has lost something;
// that has been said then.
int finishOutput(const char* program, int status);

}  // namespace slicecast
