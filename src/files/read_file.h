// Reads whole files from disk, up to a size limit.
//
//     ReadFile file = readWholeFile("castle.json", kMaxSceneBytes);
//     if (!file.fault.empty()) ...   // "is a folder", "has 9000 bytes; at most 100 are read"
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// The bytes, or why there are none.
struct ReadFile {
    std::vector<std::uint8_t> bytes;
    std::string fault;  // empty on success

    // Valid as long as `bytes`.
    std::string_view text() const {
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
};

// ReadFile::fault where there is nothing of that name.
inline constexpr const char* kNoSuchFile = "does not exist";

// Opens regular files and links to them only: a pipe could block forever. Checks the size before
// reading and keeps at most `maxBytes` in memory.
ReadFile readWholeFile(const std::filesystem::path& path, std::uintmax_t maxBytes);

// Converts a name of a scene or command line: UTF-8, whatever encoding the system uses.
std::filesystem::path pathOf(const std::string& name);

}  // namespace slicecast
