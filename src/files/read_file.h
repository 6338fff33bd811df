// Whole files of a disk, up to a size.
//
//     ReadFile file = readWholeFile("castle.json", kMaxSceneBytes);
//     if (!file.fault.empty()) ...          // "is a folder", "has 9000 bytes; at most 100 are read"
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// The bytes, or in words why there are none.
struct ReadFile {
    std::vector<std::uint8_t> bytes;
    std::string fault;  // empty on success

    // Of the bytes; lives as long as they do.
    std::string_view text() const {
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
};

// Only a regular file is opened, or a link to one: a pipe could keep the caller waiting for ever.
// Its size is looked at before it is read, and no more than `maxBytes` are kept in memory.
ReadFile readWholeFile(const std::filesystem::path& path, std::uintmax_t maxBytes);

// A name as scenes and command lines write it: UTF-8, whatever the system's own file names are.
std::filesystem::path pathOf(const std::string& name);

}  // namespace slicecast
