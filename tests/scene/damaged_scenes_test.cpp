// Scenes that were cut short or damaged at random: reading them must give either a sound world or
// faults. Sanitizers check the rest.
#include "base/random.h"
#include "scene/scene.h"
#include "scene/scene_files.h"
#include "world/collision.h"
#include "world/player.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicecast {
namespace {

void expectSound(const World& world) {
    const auto textures = static_cast<TextureId>(world.textures.size());
    const auto blueprints = static_cast<BlueprintId>(world.blueprints.size());
    for (const Texture& texture : world.textures) EXPECT_GE(texture.size(), kMinTextureSize);
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        EXPECT_GE(world.blueprints[i].bottom.raw, 0);
        EXPECT_TRUE(world.blueprints[i].bottom < world.blueprints[i].top ||
                    world.blueprints[i].mover >= 0);
        EXPECT_LE(world.blueprints[i].top.raw, 65536);
        for (const FaceBlueprint& face : world.blueprints[i].faces) {
            const bool isLeftOut = world.blueprints[i].isWater && face.texture == kNoTexture;
            EXPECT_TRUE(isLeftOut || face.texture < textures);
        }
    }
    ASSERT_FALSE(world.maps.empty());
    for (const Map& map : world.maps) {
        const std::size_t tiles = static_cast<std::size_t>(map.width) * map.depth;
        ASSERT_GT(tiles, 0u);
        ASSERT_EQ(map.cells.size(), tiles * map.levels);
        ASSERT_EQ(map.occupied.size(), tiles);
        ASSERT_EQ(map.floor.tiles.size(), tiles);
        ASSERT_TRUE(map.ceiling.tiles.empty() || map.ceiling.tiles.size() == tiles);
        for (const BlueprintId id : map.cells) EXPECT_LT(id, blueprints);
        for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
            const CellBlueprint& block = world.blueprints[map.cells[cell]];
            const bool isBlock = (map.occupied[cell / map.levels] >> (cell % map.levels) & 1u) != 0;
            EXPECT_EQ(isBlock, map.cells[cell] != kEmptyCell && block.bottom < block.top &&
                                   block.plan.west < block.plan.east &&
                                   block.plan.north < block.plan.south);
        }
        for (const TextureId id : map.floor.tiles) EXPECT_LT(id, textures);
        for (const TextureId id : map.ceiling.tiles) EXPECT_TRUE(id < textures || id == kNoTexture);
        EXPECT_LT(map.floor.texture, textures);
        EXPECT_TRUE(map.ceiling.tiles.empty() || map.ceiling.height.raw > 0);
        EXPECT_TRUE(!map.fog.on || map.fog.start < map.fog.end);
        EXPECT_LE(map.light.darkest, map.light.brightest);
        EXPECT_TRUE(map.sky.kind != Sky::Kind::panorama || !map.sky.panorama.empty());
        EXPECT_GT(map.sky.slope, 0.0);
        EXPECT_GT(map.far, 0.0);
    }
    const Start& start = world.start;
    ASSERT_LT(start.map, static_cast<int>(world.maps.size()));
    EXPECT_TRUE(isFree(world, start.map, bodyBox(start.x, start.y, start.z, kCrouchedHeight)));
}

// True if the scene gave a world.
bool expectWorldOrFaults(const std::string& text, const SceneFiles& files) {
    ParsedScene parsed = parseScene(text, "damaged.json");
    EXPECT_TRUE(parsed.description != nullptr || !parsed.faults.empty());
    const LoadedScene loaded = loadScene(std::move(parsed), files);
    EXPECT_EQ(loaded.world.has_value(), loaded.faults.empty());
    const int lines = 1 + static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
                          return c == '\n' || c == '\r';
                      }));
    for (const Fault& fault : loaded.faults) {
        EXPECT_FALSE(fault.found.empty());
        EXPECT_FALSE(fault.expected.empty());
        EXPECT_GE(fault.line, 1);
        EXPECT_LE(fault.line, lines);
        EXPECT_GE(fault.column, 1);
    }
    if (loaded.world) expectSound(*loaded.world);
    return loaded.world.has_value();
}

// One to four changes: a byte changed, left out or put in, or a piece copied to another place.
std::string damaged(std::string text, Random& random) {
    const int changes = random.between(1, 4);
    for (int i = 0; i < changes; ++i) {
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
        constexpr std::string_view kTelling = "{}[]\",:.#0123456789-+eE\\u \n\r\t\xff\xc3\xed\xf0";
        const char telling =
            kTelling[static_cast<std::size_t>(random.below(static_cast<int>(kTelling.size())))];
        switch (random.below(5)) {
            case 0:
                text[at] = static_cast<char>(random.below(256));
                break;
            case 1:
                text[at] = telling;
                break;
            case 2:
                text.insert(at, 1, telling);
                break;
            case 3:
                text.erase(at, static_cast<std::size_t>(random.between(1, 8)));
                break;
            default: {
                const auto from =
                    static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
                text.insert(at, text.substr(from, static_cast<std::size_t>(random.between(1, 40))));
            }
        }
    }
    return text;
}

class DamagedScenes : public testing::Test {
protected:
    DamagedScenes() : text_(readText(sceneTestFolder() / "everything.json")) {
        files_ = readSceneFiles(sceneTestFolder(), parseScene(text_, "everything.json"));
    }
    std::string text_;
    SceneFiles files_;
};

TEST_F(DamagedScenes, CutShortAnywhereGiveFaults) {
    ASSERT_TRUE(expectWorldOrFaults(text_, files_));
    const std::size_t end = text_.find_last_of('}');
    for (std::size_t length = 0; length <= end; ++length) {
        EXPECT_FALSE(expectWorldOrFaults(text_.substr(0, length), files_)) << length;
    }
}

TEST_F(DamagedScenes, GiveAWorldOrFaults) {
    constexpr int kScenes = 2500;
    Random random(20);
    int worlds = 0;
    for (int i = 0; i < kScenes; ++i)
        worlds += expectWorldOrFaults(damaged(text_, random), files_) ? 1 : 0;
    // Some damage does no harm (a comment, a colour); most does.
    EXPECT_GT(worlds, kScenes / 100);
    EXPECT_LT(worlds, kScenes / 2);
}

TEST_F(DamagedScenes, MayNameDamagedImages) {
    constexpr int kScenes = 120;
    Random random(21);
    int worlds = 0;
    for (int i = 0; i < kScenes; ++i) {
        SceneFiles files = files_;
        for (auto& [name, bytes] : files) {
            const std::string broken = damaged(std::string(bytes.begin(), bytes.end()), random);
            if (!random.oneIn(3)) bytes.assign(broken.begin(), broken.end());
        }
        const LoadedScene loaded = loadScene(parseScene(text_, "everything.json"), files);
        EXPECT_EQ(loaded.world.has_value(), loaded.faults.empty());
        if (loaded.world) {
            expectSound(*loaded.world);
            ++worlds;
        }
    }
    EXPECT_GT(worlds, 0);
    EXPECT_LT(worlds, kScenes);
}

}  // namespace
}  // namespace slicecast
