#include "scenes/shipped.h"

#include "files/scene_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

namespace slicecast {
namespace {

std::filesystem::path sceneFile(const std::string& name) {
    return assetsFolder() / "scenes" / (name + ".json");
}

}  // namespace

std::filesystem::path assetsFolder() {
    return std::filesystem::path(SLICECAST_SOURCE_FOLDER) / "assets";
}

std::vector<std::string> shippedScenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(assetsFolder() / "scenes")) {
        // The index lists the scenes for the page's menu.
        if (entry.path().extension() == ".json" && entry.path().stem() != "index")
            names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string sceneText(const std::string& name) {
    std::ifstream file(sceneFile(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

World shippedWorld(const std::string& name) {
    LoadedScene scene = readSceneFile(sceneFile(name).string());
    for (const Fault& fault : scene.faults) ADD_FAILURE() << describe(fault);
    return scene.world ? std::move(*scene.world) : World{};
}

}  // namespace slicecast
