#include "scene/scene_files.h"

#include "files/read_file.h"
#include "files/scene_file.h"
#include "scene/limits.h"

#include <utility>

namespace slicecast {

std::filesystem::path sceneTestFolder() {
    return std::filesystem::path(SLICECAST_SOURCE_FOLDER) / "tests/scene";
}

std::string readText(const std::filesystem::path& path) {
    return std::string(readWholeFile(path, kMaxSceneBytes).text());
}

SceneFiles readSceneFiles(const std::filesystem::path& folder, const ParsedScene& scene) {
    return readImages(scene, folder).files;
}

LoadedScene loadText(const std::string& text, const std::string& name,
                     const std::filesystem::path& folder) {
    ParsedScene parsed = parseScene(text, name);
    const SceneFiles files = readSceneFiles(folder, parsed);
    return loadScene(std::move(parsed), files);
}

LoadedScene loadFrom(const std::filesystem::path& path) {
    return loadText(readText(path), path.filename().string(), path.parent_path());
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
