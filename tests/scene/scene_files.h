// Files for the tests of scenes.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace slicecast {

// tests/scene
std::filesystem::path sceneTestFolder();

std::string readText(const std::filesystem::path& path);

// The files that a scene names, those of them that exist.
SceneFiles readSceneFiles(const std::filesystem::path& folder, const ParsedScene& scene);

// Checks and loads a text whose images are seen from a folder.
LoadedScene loadText(const std::string& text, const std::string& name = "test.json",
                     const std::filesystem::path& folder = sceneTestFolder());

// Checks and loads a scene of the disk; faults name it by its file name.
LoadedScene loadFrom(const std::filesystem::path& path);

// A scene of one room whose parts a test replaces.
std::string smallScene(const std::string& levels = R"([["###", "#.#", "###"]])",
                       const std::string& moreOfTheMap = "");

// All faults in words, a line each.
std::string inWords(const std::vector<Fault>& faults);

}  // namespace slicecast
