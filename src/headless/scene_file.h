// A scene from a disk: reads the text, then the images that it names, seen from the scene's folder.
//
//     SceneFromFile scene = readScene("assets/scenes/first-walk.json");
//     for (const Fault& fault : scene.faults) print(describe(fault));
#pragma once

#include "scene/scene.h"

#include <string>

namespace slicecast {

// Like LoadedScene: a world, or faults. Files that cannot be read are faults too.
using SceneFromFile = LoadedScene;

SceneFromFile readScene(const std::string& path);

}  // namespace slicecast
