// Files that are either written whole or not at all.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace slicecast {

// Writes beside the file first and puts that in its place when all is written, so that nobody ever
// sees half a file. Empty on success, else what was wrong.
std::string writeWholeFile(const std::string& path, std::span<const std::uint8_t> bytes);
std::string writeWholeFile(const std::string& path, std::string_view text);

}  // namespace slicecast
