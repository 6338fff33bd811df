#include "base/image.h"
#include "base/random.h"
#include "random_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

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

// The blocks are those of a random scene; some of its textures have become see-through.
Scene crowdedScene(std::uint64_t seed, int width, int height) {
    Scene scene = randomScene(seed, width, height);
    Random random(seed ^ 0x63726f77u);
    World& world = scene.world;
    View& view = scene.view;
    std::vector<TextureId> clear;
    for (std::size_t i = 0; i < world.textures.size(); ++i) {
        if (i > 0 && random.oneIn(2)) continue;
        clear.push_back(static_cast<TextureId>(i));
        Image image(8, 8);
        for (int texel = 0; texel < 64; ++texel) {
            // Mostly holes, so that the farthest show
            const bool isBar = texel % 8 == 3 && i % 10 == 0;
            const int alpha = isBar ? 255 : random.oneIn(50) ? random.between(60, 254) : 0;
            image.pixels[static_cast<std::size_t>(texel)] = toPixel(
                {static_cast<std::uint8_t>(random.below(256)),
                 static_cast<std::uint8_t>(30 * (texel % 8)),
                 static_cast<std::uint8_t>(30 * (texel / 8)), static_cast<std::uint8_t>(alpha)});
        }
        world.textures[i] = makeTexture("pane", image);
    }
    const auto anyOf = [&](const auto& all) {
        return all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
    };
    markSeeThrough(world);
    std::vector<BlueprintId> panes = {kEmptyCell};
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        CellBlueprint& block = world.blueprints[i];
        if (!block.seeThrough || !standsStill(block) || block.isWater) continue;
        block.join = random.oneIn(6);
        for (FaceBlueprint& face : block.faces) face.texture = anyOf(clear);
        if (random.oneIn(6) && !block.slopes.any())
            block.faces[static_cast<std::size_t>(Face::top)].mirror =
                static_cast<std::uint8_t>(random.between(1, 255));
        panes.push_back(static_cast<BlueprintId>(i));
    }
    const Map& near = world.maps[static_cast<std::size_t>(view.map)];
    Map hall = makeMap("hall", random.between(40, 140), random.between(1, 6), random.between(1, 3),
                       near.floor.texture);
    hall.sky = near.sky;
    hall.haze = near.haze;
    hall.light = near.light;
    hall.floor.mirror = random.oneIn(3) ? near.floor.mirror : std::uint8_t{0};
    hall.far = 200.0;
    for (int y = 0; y < hall.depth; ++y) {
        for (int x = 3; x < hall.width; ++x) {
            for (int level = 0; level < hall.levels; ++level)
                hall.setCell(x, y, level, anyOf(panes));
        }
    }
    for (int i = random.oneIn(2) ? 0 : random.between(1, 20); i > 0 && !near.objects.empty(); --i) {
        Object object = anyOf(near.objects);
        object.x = {random.below(hall.width << 16)};
        object.y = {random.below(hall.depth << 16)};
        hall.objects.push_back(object);
    }
    view.map = static_cast<int>(world.maps.size());
    view.x = {random.between(65536, 3 * 65536)};
    view.y = {random.below(hall.depth << 16)};
    view.z = {random.between(1, hall.levels << 16)};
    view.headingDegrees = random.between(-8.0, 8.0);
    view.look = random.between(-0.2, 0.2);
    view.fovDegrees = random.between(20.0, 60.0);
    world.maps.push_back(std::move(hall));
    return scene;
}

}  // namespace slicecast::judge
