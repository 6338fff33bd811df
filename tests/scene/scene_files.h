// Files for the tests of scenes.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace slicecast {

// tests/scene
std::filesystem::path sceneTestFolder();

std::string readText(const std::filesystem::path& path);

// The existing files among those that a scene names.
SceneFiles readSceneFiles(const std::filesystem::path& folder, const ParsedScene& scene);

// Checks and loads a text; image names are relative to the folder.
LoadedScene loadText(const std::string& text, const std::string& name = "test.json",
                     const std::filesystem::path& folder = sceneTestFolder());

// Checks and loads a file; faults show its name without the folder.
LoadedScene loadFrom(const std::filesystem::path& path);

// A scene of one room whose parts a test replaces.
std::string smallScene(const std::string& levels = R"([["###", "#.#", "###"]])",
                       const std::string& moreOfTheMap = "");

// All faults in words, a line each.
std::string inWords(const std::vector<Fault>& faults);

}  // namespace slicecast
