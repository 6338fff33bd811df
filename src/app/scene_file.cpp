#include "app/scene_file.h"

#ifndef __EMSCRIPTEN__

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {

namespace {

std::optional<std::vector<std::uint8_t>> readBytes(const std::filesystem::path& path) {
    std::error_code fault;
    if (std::filesystem::is_directory(path, fault)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::vector<std::uint8_t>(std::istreambuf_iterator<char>(file), {});
}

std::string textOf(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

// The list of scenes is [{"file": "NAME.json", ...}, ...], the opening scene first; file names need no escapes. So the first text after the first "file" is
// the one.
std::string firstFile(const std::string& list) {
    std::size_t at = list.find("\"file\"");
    if (at == std::string::npos) return {};
    at = list.find(':', at);
    if (at == std::string::npos) return {};
    const std::size_t begin = list.find('"', at);
    if (begin == std::string::npos) return {};
    const std::size_t end = list.find('"', begin + 1);
    return end == std::string::npos ? std::string() : list.substr(begin + 1, end - begin - 1);
}

}  // namespace

LoadedScene readSceneFile(const std::filesystem::path& scene) {
    const auto text = readBytes(scene);
    if (!text) {
        Fault fault;
        fault.file = scene.string();
        fault.found = "no file that can be read";
        fault.expected = "a scene file";
        return {std::nullopt, {fault}};
    }
    const ParsedScene parsed = parseScene(textOf(*text), scene.string());
    SceneFiles files;
    for (const std::string& name : parsed.files) {
        if (auto bytes = readBytes(scene.parent_path() / name)) files.emplace(name, std::move(*bytes));
    }
    if (!parsed.description) return {std::nullopt, parsed.faults};
    return loadScene(parsed, files);
}

std::filesystem::path findOpeningScene(const std::filesystem::path& programFolder) {
    for (const std::filesystem::path& folder : std::to_array<std::filesystem::path>({"scenes", "../../../assets/scenes"})) {
        const std::filesystem::path scenes = programFolder / folder;
        const auto bytes = readBytes(scenes / "index.json");
        if (!bytes) continue;
        const std::string name = firstFile(textOf(*bytes));
        if (!name.empty()) return (scenes / name).lexically_normal();
    }
    return {};
}

}  // namespace slicecast

#endif
