// Every texture and sprite that is drawn is seen somewhere, and no scene names one that it does not
// show.
#include "scenes/shipped.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace slicecast {
namespace {

using Names = std::set<std::string>;

// The test card: its letters show how faces are turned, and belong in no scene.
const Names kNotForScenes = {"lettering"};

// The folders that hold textures for faces, floors and ceilings, and sprites for objects, and about
// how many are in each.
struct Folder {
    const char* name;
    int atLeast;
};
constexpr Folder kFolders[] = {
    {"textures", 17}, {"see-through", 11}, {"sheets", 8}, {"sprites", 14}};

// The files of a folder that a scene names.
Names filesNamed(const std::string& text, const std::string& folder) {
    const std::regex file("\\.\\./" + folder + "/([a-z0-9-]+)\\.png");
    Names names;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), file);
         at != std::sregex_iterator(); ++at)
        names.insert((*at)[1]);
    return names;
}

// The textures of a world, by the names that its scene gives them, that stand on a face, a floor or
// a ceiling of its maps.
Names texturesShown(const World& world) {
    std::set<TextureId> shown;
    for (const Map& map : world.maps) {
        for (const BlueprintId cell : map.cells) {
            if (cell == kEmptyCell) continue;
            for (const FaceBlueprint& face : world.blueprints[cell].faces)
                shown.insert(face.texture);
        }
        shown.insert(map.floor.texture);
        shown.insert(map.floor.tiles.begin(), map.floor.tiles.end());
        shown.insert(map.ceiling.tiles.begin(), map.ceiling.tiles.end());
    }
    shown.erase(kNoTexture);
    Names names;
    for (const TextureId id : shown) names.insert(world.textures[id].name);
    return names;
}

bool isVisible(const Texture& texture) {
    const std::vector<Pixel>& pixels = texture.levels[0].texels;
    return std::any_of(pixels.begin(), pixels.end(),
                       [](Pixel pixel) { return toColour(pixel).a != 0; });
}

TEST(Textures, EveryOneIsNamedByAScene) {
    for (const Folder& folder : kFolders) {
        Names named;
        for (const std::string& scene : shippedScenes())
            named.merge(filesNamed(sceneText(scene), folder.name));
        int count = 0;
        for (const auto& entry :
             std::filesystem::directory_iterator(assetsFolder() / folder.name)) {
            if (entry.path().extension() != ".png") continue;
            const std::string name = entry.path().stem().string();
            EXPECT_EQ(named.count(name), kNotForScenes.count(name) == 0 ? 1u : 0u)
                << folder.name << ": " << name;
            ++count;
        }
        EXPECT_GE(count, folder.atLeast) << folder.name;
    }
}

TEST(Textures, EveryOneOfASceneIsShownInIt) {
    for (const std::string& scene : shippedScenes()) {
        const World world = shippedWorld(scene);
        const Names shown = texturesShown(world);
        for (const Texture& texture : world.textures)
            EXPECT_TRUE(shown.count(texture.name) == 1) << scene << ": " << texture.name;
    }
}

TEST(Sprites, EveryOneOfASceneStandsInIt) {
    for (const std::string& scene : shippedScenes()) {
        const World world = shippedWorld(scene);
        std::set<SpriteId> standing;
        for (const Map& map : world.maps) {
            for (const Object& object : map.objects) standing.insert(object.sprite);
        }
        for (const ObjectMotion& motion : world.movingObjects.motions) {
            if (motion.walking) standing.insert(*motion.walking);
            if (motion.alert) standing.insert(*motion.alert);
        }
        for (std::size_t i = 0; i < world.sprites.size(); ++i) {
            EXPECT_TRUE(standing.count(static_cast<SpriteId>(i)) == 1)
                << scene << ": " << world.sprites[i].name;
        }
    }
}

TEST(Blueprints, EveryOneOfASceneStandsInIt) {
    for (const std::string& scene : shippedScenes()) {
        const World world = shippedWorld(scene);
        // By the name: what moves, opens or leads elsewhere has got instances.
        std::set<std::string> standing;
        for (const Map& map : world.maps) {
            for (const BlueprintId id : std::set<BlueprintId>(map.cells.begin(), map.cells.end()))
                standing.insert(world.blueprints[id].name);
        }
        for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
            EXPECT_TRUE(standing.count(world.blueprints[i].name) == 1)
                << scene << ": " << world.blueprints[i].name;
        }
    }
}

// A block of which nothing is seen would be a wall that one runs into without knowing why. Nobody
// runs into water, and that below the surface has no faces.
TEST(Blueprints, NoneIsInvisible) {
    for (const std::string& scene : shippedScenes()) {
        const World world = shippedWorld(scene);
        for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
            if (world.blueprints[i].isWater) continue;
            const auto& faces = world.blueprints[i].faces;
            EXPECT_TRUE(std::any_of(faces.begin(), faces.end(),
                                    [&](const FaceBlueprint& face) {
                                        return face.texture != kNoTexture &&
                                               isVisible(world.textures[face.texture]);
                                    }))
                << scene << ": " << world.blueprints[i].name;
        }
    }
}

}  // namespace
}  // namespace slicecast
