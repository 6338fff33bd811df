#include "fuzz/fuzzed_scene.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {

namespace {

std::string readFile(const std::string& name) {
    std::ifstream file(SLICECAST_SOURCE_FOLDER "/" + name, std::ios::binary);
    if (!file) std::abort();
    return {std::istreambuf_iterator<char>(file), {}};
}

// What a scene names is one of the tests' pictures, or stands for one of them.
const std::vector<std::uint8_t>& picture(const std::string& path) {
    static std::map<std::string, std::vector<std::uint8_t>> known;
    constexpr std::array kNames = {"brick.png", "see-through.png", "sheet.png", "sky.png"};
    const std::string name = path.substr(path.rfind('/') + 1);
    const bool isKnown = std::find(kNames.begin(), kNames.end(), name) != kNames.end();
    const std::string file = isKnown ? name : "tile.png";
    const auto [place, isNew] = known.try_emplace(file);
    if (isNew) {
        const std::string bytes = readFile("tests/scene/broken/images/" + file);
        place->second.assign(bytes.begin(), bytes.end());
    }
    return place->second;
}

void checkFaults(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults)
        if (fault.found.empty() || fault.expected.empty() || fault.file.empty()) std::abort();
}

}  // namespace

SceneMaker& sceneMaker() {
    constexpr int kWidest = 24;  // tiles a side
    static SceneMaker maker(readFile("assets/scene.schema.json"),
                            {.wall = "brick.png",
                             .seeThrough = "see-through.png",
                             .sheet = "sheet.png",
                             .sheetFrames = 3,
                             .sprite = "tile.png",
                             .walker = "sheet.png",
                             .walkerFrames = 3,
                             .panorama = "sky.png"},
                            kWidest);
    return maker;
}

LoadedScene loadFuzzed(std::string_view text) {
    ParsedScene parsed = parseScene(text, "fuzz.json");
    checkFaults(parsed.faults);
    checkFaults(parsed.warnings);
    if (!parsed.description) {
        if (parsed.faults.empty()) std::abort();
        LoadedScene refused;
        refused.faults = std::move(parsed.faults);
        return refused;
    }
    SceneFiles files;
    for (const std::string& name : parsed.files) files[name] = picture(name);
    LoadedScene loaded = loadScene(std::move(parsed), files);
    checkFaults(loaded.faults);
    if (loaded.world.has_value() == !loaded.faults.empty()) std::abort();
    return loaded;
}

std::vector<Fault> faultsOf(const std::string& text) {
    return loadFuzzed(text).faults;
}

}  // namespace slicecast
