// A scene from a disk: reads the text, then the images that it names, seen from the scene's folder.
// Every program, tool and test that opens a scene file does it here.
//
//     LoadedScene scene = readSceneFile("assets/scenes/first-walk.json");
//     for (const Fault& fault : scene.faults) print(describe(fault));
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace slicecast {

// No image within the limits of a scene is as large in a file.
inline constexpr std::uintmax_t kMaxImageBytes = 64u << 20;

// The world, or all faults. A file that cannot be read, is larger than kMaxSceneBytes or is no
// regular file is a fault, too; nothing waits for it.
LoadedScene readSceneFile(const std::filesystem::path& scene);

// The images that a scene names, seen from a folder: the bytes of those that can be read, and of
// the others in words why not.
struct ReadImages {
    SceneFiles files;
    std::map<std::string, std::string> unread;
};
ReadImages readImages(const ParsedScene& scene, const std::filesystem::path& folder);

}  // namespace slicecast
