#include "headless/scene_file.h"

#include "scene/limits.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// No image within the limits of a scene is as large in a file.
constexpr std::uintmax_t kMaxImageBytes = 64u << 20;

// The bytes of a file, or nothing if it cannot be read. Of a file that is too long, one byte more
// than the limit is read, so that it is still found too long.
std::optional<std::vector<std::uint8_t>> readBytes(const std::filesystem::path& path,
                                                   std::uintmax_t limit) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::vector<std::uint8_t> bytes;
    constexpr std::size_t kBlock = 1u << 16;
    while (file && bytes.size() <= limit) {
        const std::size_t length = bytes.size();
        bytes.resize(length + kBlock);
        file.read(reinterpret_cast<char*>(bytes.data() + length), kBlock);
        bytes.resize(length + static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) return std::nullopt;
    return bytes;
}

}  // namespace

SceneFromFile readScene(const std::string& path) {
    SceneFromFile scene;
    const auto text = readBytes(path, kMaxSceneBytes);
    if (!text) {
        Fault fault;
        fault.file = path;
        fault.found = "no file that can be read";
        fault.expected = "a scene file";
        scene.faults.push_back(std::move(fault));
        return scene;
    }
    const ParsedScene parsed =
        parseScene({reinterpret_cast<const char*>(text->data()), text->size()}, path);

    SceneFiles files;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    for (const std::string& name : parsed.files) {
        // Names in a scene are UTF-8, whatever the system's own file names are.
        const std::filesystem::path file(reinterpret_cast<const char8_t*>(name.c_str()));
        if (auto bytes = readBytes(folder / file, kMaxImageBytes))
            files.emplace(name, std::move(*bytes));
    }
    return loadScene(parsed, files);
}

}  // namespace slicecast
