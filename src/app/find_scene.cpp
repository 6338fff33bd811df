#include "app/find_scene.h"

#ifndef __EMSCRIPTEN__

#include "files/read_file.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace slicecast {

namespace {

// Relative to the program's folder: where it is installed, and where it is built.
const std::array<std::filesystem::path, 2> kShippedScenes = {"scenes", "../../../assets/scenes"};

// The list has one line for each scene.
constexpr std::uintmax_t kMaxListBytes = 1u << 20;

// The list of scenes is [{"file": "NAME.json", ...}, ...], the opening scene first; file names have
// no escapes. So the first text after the first "file" is the name.
std::string firstFile(std::string_view list) {
    std::size_t at = list.find("\"file\"");
    if (at == std::string_view::npos) return {};
    at = list.find(':', at);
    if (at == std::string_view::npos) return {};
    const std::size_t begin = list.find('"', at);
    if (begin == std::string_view::npos) return {};
    const std::size_t end = list.find('"', begin + 1);
    return std::string(list.substr(begin + 1, end == std::string_view::npos ? 0 : end - begin - 1));
}

}  // namespace

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

std::filesystem::path findOpeningScene(const std::filesystem::path& programFolder) {
    for (const std::filesystem::path& folder : kShippedScenes) {
        const std::filesystem::path scenes = programFolder / folder;
        const ReadFile list = readWholeFile(scenes / "index.json", kMaxListBytes);
        const std::string name = firstFile(list.text());
        if (!name.empty()) return (scenes / name).lexically_normal();
    }
    return {};
}

}  // namespace slicecast

#endif
