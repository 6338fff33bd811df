#include "scene/scene_files.h"

#include <fstream>
#include <iterator>

namespace slicecast {

std::filesystem::path sceneTestFolder() {
    return std::filesystem::path(SLICECAST_SOURCE_FOLDER) / "tests/scene";
}

std::string readText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

SceneFiles readSceneFiles(const std::filesystem::path& folder, const ParsedScene& scene) {
    SceneFiles files;
    for (const std::string& name : scene.files) {
        if (!std::filesystem::exists(folder / name)) continue;
        const std::string bytes = readText(folder / name);
        files[name] = {bytes.begin(), bytes.end()};
    }
    return files;
}

LoadedScene loadFrom(const std::filesystem::path& path) {
    const ParsedScene parsed = parseScene(readText(path), path.filename().string());
    return loadScene(parsed, readSceneFiles(path.parent_path(), parsed));
}

std::string smallScene(const std::string& levels, const std::string& moreOfTheMap) {
    return R"({
  "title": "Small",
  "textures": { "brick": "broken/images/brick.png" },
  "blueprints": { "wall": { "faces": "brick" } },
  "legend": { "#": "wall" },
  "maps": [{ "name": "room", "floor": "brick", "levels": )" +
           levels + (moreOfTheMap.empty() ? "" : ", " + moreOfTheMap) + R"( }],
  "start": { "x": 1.5, "y": 1.5 }
})";
}

std::string inWords(const std::vector<Fault>& faults) {
    std::string words;
    for (const Fault& fault : faults) words += describe(fault) + "\n";
    return words;
}

}  // namespace slicecast
