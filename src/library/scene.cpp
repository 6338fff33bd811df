#include "slicecast/scene.h"

#include "files/scene_file.h"
#include "library/map_infos.h"
#include "scene/scene.h"
#include "world/world.h"

#include <utility>

namespace slicecast {
namespace {

LoadResult resultOf(LoadedScene loaded) {
    LoadResult result;
    if (loaded.world) result.scene.emplace(std::move(*loaded.world));
    result.faults = std::move(loaded.faults);
    result.warnings = std::move(loaded.warnings);
    return result;
}

}  // namespace

std::vector<MapInfo> mapInfos(const World& world) {
    std::vector<MapInfo> infos;
    infos.reserve(world.maps.size());
    for (const Map& map : world.maps) infos.push_back({map.name, map.width, map.depth, map.levels});
    return infos;
}

Scene::Scene(World&& world) : world_(std::make_unique<World>(std::move(world))) {}
Scene::~Scene() = default;
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(Scene&& other) noexcept = default;

Scene Scene::copy() const {
    return Scene(world_->copy());
}

const std::string& Scene::title() const {
    return world_->title;
}

std::vector<MapInfo> Scene::maps() const {
    return mapInfos(*world_);
}

World Scene::takeWorld() && {
    return std::move(*std::exchange(world_, nullptr));
}

LoadResult loadSceneFile(const std::filesystem::path& file, const Progress& progress) {
    return resultOf(readSceneFile(file, progress));
}

LoadResult loadSceneText(std::string_view text, const std::string& name, const ImageFiles& images,
                         const Progress& progress) {
    return resultOf(loadScene(parseScene(text, name, progress), images, {}, progress));
}

}  // namespace slicecast
