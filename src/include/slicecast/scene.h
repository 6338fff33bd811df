// A scene: a world of maps, its textures and the place where the player starts. It comes from a
// file, from a text, or from code (scene_builder.h), and goes into a game (game.h).
#pragma once

#include "slicecast/fault.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

struct World;  // of the engine, not for users

// A map's name and size.
struct MapInfo {
    std::string name;
    int width = 0;   // tiles eastward, 1 to 4096
    int depth = 0;   // tiles southward, 1 to 4096
    int levels = 0;  // stacked levels of height 1, 1 to 32
};

// May hold hundreds of megabytes, so it moves; only copy() copies it.
class Scene {
public:
    explicit Scene(World&& world);  // for the engine itself
    ~Scene();
    Scene(Scene&& other) noexcept;
    Scene& operator=(Scene&& other) noexcept;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    // A second scene that shares nothing with this one.
    Scene copy() const;

    // May be empty.
    const std::string& title() const;

    // At least one. A map's index in this list is its number everywhere.
    std::vector<MapInfo> maps() const;

    // The world itself, for the engine. The scene counts as moved from afterwards.
    World takeWorld() &&;

private:
    std::unique_ptr<World> world_;
};

// A scene, or everything that is wrong with it.
struct LoadResult {
    std::optional<Scene> scene;   // empty if and only if there are faults
    std::vector<Fault> faults;    // in the order of the text; at most 1000, then one for the rest
    std::vector<Fault> warnings;  // the scene loads, but something in it is probably a mistake
};

// Told while a scene loads: the share that is done, growing to 1.
using Progress = std::function<void(double share)>;

// Reads a scene file (JSON) and the PNG files that it names; their paths are relative to its
// folder. Opens regular files only, because a pipe could block forever. Limits: 128 MB for the
// text, 64 MB for each image. Shipped pictures that the scene names without declaring them are
// those of the sources from which the library was built; without these, the names are faults.
LoadResult loadSceneFile(const std::filesystem::path& file, const Progress& progress = {});

// The bytes of PNG files, by the names that the scene uses.
using ImageFiles = std::map<std::string, std::vector<std::uint8_t>>;

// The same from a text in memory, UTF-8. `name` stands for the file in faults. Touches no disk: an
// image that `images` lacks is a fault, and so is the name of a shipped picture that the scene does
// not declare.
LoadResult loadSceneText(std::string_view text, const std::string& name,
                         const ImageFiles& images = {}, const Progress& progress = {});

}  // namespace slicecast
