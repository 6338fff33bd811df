#include "app/scene_file.h"

#ifndef __EMSCRIPTEN__

#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace slicecast {

namespace {

// Seen from the program's folder: where it is installed, and where it is built.
const std::array<std::filesystem::path, 2> kShippedScenes = {"scenes", "../../../assets/scenes"};

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

// The list of scenes is [{"file": "NAME.json", ...}, ...], the opening scene first; file names need
// no escapes. So the first text after the first "file" is the one.
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
        if (auto bytes = readBytes(scene.parent_path() / name))
            files.emplace(name, std::move(*bytes));
    }
    if (!parsed.description) return {std::nullopt, parsed.faults};
    return loadScene(parsed, files);
}

std::filesystem::path findScene(const std::string& name, const std::filesystem::path& recording,
                                const std::filesystem::path& programFolder) {
    std::error_code fault;
    const std::filesystem::path beside = recording.parent_path() / ".." / "scenes";
    for (const std::filesystem::path& folder :
         {beside, programFolder / kShippedScenes[0], programFolder / kShippedScenes[1]}) {
        const std::filesystem::path scene = folder / (name + ".json");
        if (std::filesystem::is_regular_file(scene, fault)) return scene.lexically_normal();
    }
    return {};
}

std::optional<std::string> readText(const std::filesystem::path& file) {
    const auto bytes = readBytes(file);
    return bytes ? std::optional(textOf(*bytes)) : std::nullopt;
}

std::string writeText(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out << text;
    out.close();
    return out ? std::string()
               : file.string() + " cannot be written: " + std::generic_category().message(errno);
}

std::filesystem::path findOpeningScene(const std::filesystem::path& programFolder) {
    for (const std::filesystem::path& folder : kShippedScenes) {
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
