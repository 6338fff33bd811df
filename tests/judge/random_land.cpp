#include "base/random.h"
#include "random_scene.h"

#include <algorithm>
#include <utility>

namespace slicecast::judge {
namespace {

bool standsStill(const CellBlueprint& block) {
    return block.mover < 0 && block.gate < 0 && !block.hasPortals;
}

}  // namespace

// Adds a wide, nearly empty map to a random scene and puts the eye there. Its blocks, textures,
// objects and light are those of the scene.
Scene wideLandScene(std::uint64_t seed, int width, int height) {
    Scene scene = randomScene(seed, width, height);
    Random random(seed ^ 0x6c616e64u);
    World& world = scene.world;
    View& view = scene.view;
    const Map& near = world.maps[static_cast<std::size_t>(view.map)];
    Map land = makeMap("land", random.between(4, 160), random.between(4, 160), near.levels,
                       near.floor.texture);
    land.ceiling.height = {random.between(1, near.levels * 65536)};
    land.sky = near.sky;
    land.light = near.light;
    land.fog = near.fog;
    land.haze = near.haze;
    land.far = near.far;
    const auto tiles = land.floor.tiles.size();
    const auto anyTile = [&] {
        return static_cast<std::size_t>(random.below(static_cast<int>(tiles)));
    };
    for (std::size_t n = 0; n < tiles / 400 + 1; ++n) {
        const auto id =
            static_cast<BlueprintId>(random.below(static_cast<int>(world.blueprints.size())));
        if (id != kEmptyCell && standsStill(world.blueprints[id]))
            land.setCell(random.below(land.width), random.below(land.depth),
                         random.below(land.levels), id);
        if (random.oneIn(3)) land.floor.tiles[anyTile()] = near.floor.tiles.front();
    }
    if (random.oneIn(4)) {
        land.ceiling.tiles.assign(tiles, kNoTexture);
        land.ceiling.tiles[anyTile()] = near.floor.texture;
    }
    for (Object object : near.objects) {
        object.x = {random.below(land.width << 16)};
        object.y = {random.below(land.depth << 16)};
        land.objects.push_back(object);
    }
    land.findOpenLand();
    view.map = static_cast<int>(world.maps.size());
    view.x = {random.below(land.width << 16)};
    view.y = {random.below(land.depth << 16)};
    if (random.oneIn(6)) view.x = tileEdge(view.x.tile());
    if (random.oneIn(6)) view.y = tileEdge(view.y.tile());
    if (!random.oneIn(3)) view.look = random.between(-0.1, 0.1);
    world.maps.push_back(std::move(land));
    return scene;
}

}  // namespace slicecast::judge
