// Textures with variants: each place shows one of them.
#include "world/variants.h"
#include "base/hash.h"
#include "scene/scene.h"
#include "scene/scene_files.h"
#include "session/edit_cells.h"

#include <gtest/gtest.h>

#include <map>

namespace slicecast {
namespace {

constexpr int kWidth = 40;
constexpr int kDepth = 30;

// A field of blocks on a floor below a ceiling. `more` are further keys of the block's blueprint.
World field(const std::string& more = "") {
    const std::string row = "\"" + std::string(kWidth, '#') + "\"";
    std::string rows;
    for (int y = 0; y < kDepth; ++y) rows += (y > 0 ? "," : "") + row;
    LoadedScene loaded = loadText(R"({
        "title": "A field",
        "textures": {
            "plain": { "file": "broken/images/brick.png", "variants": ["plain", "worn", "red"] },
            "worn": "broken/images/tile.png",
            "red": { "file": "broken/images/brick.png", "variants": ["worn"] },
            "pool": { "file": "broken/images/tile.png", "variants": ["worn"] }
        },
        "motions": { "pulse": { "moves": "top", "from": -0.5, "to": 0, "period": 2 } },
        "blueprints": { "block": { "faces": "plain")" +
                                  more + R"( },
                        "two": { "faces": { "all": "plain", "top": "red" } } },
        "legend": { "#": "block", "2": "two" },
        "maps": [{ "name": "field", "levels": [[)" +
                                  rows + R"(], [)" + rows + R"(]],
                   "floor": { "texture": "plain", "water": "pool", "legend": { "w": "pool" } },
                   "ceiling": { "height": 2.5, "texture": "red" } }],
        "start": { "x": 1, "y": 1, "z": 3 }
    })");
    EXPECT_EQ(inWords(loaded.faults), "");
    return loaded.world ? std::move(*loaded.world) : World();
}

std::string textureAt(const World& world, int x, int y, int level, Face face = Face::north) {
    const BlueprintId id = world.maps[0].cell(x, y, level);
    return world.textures[world.blueprints[id].face(face).texture].name;
}

TEST(Variants, ShowAllOfAListEquallyOften) {
    const World world = field();
    std::map<std::string, int> counts;
    for (int y = 0; y < kDepth; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            for (int level = 0; level < 2; ++level) ++counts[textureAt(world, x, y, level)];
        }
    }
    const int cells = kWidth * kDepth * 2;
    EXPECT_EQ(counts.size(), 3u);
    EXPECT_NEAR(counts["plain"], cells / 2, cells / 20);  // it stands in its list once more
    EXPECT_NEAR(counts["worn"], cells / 4, cells / 20);
    EXPECT_NEAR(counts["red"], cells / 4, cells / 20);
}

TEST(Variants, FollowFromThePlace) {
    const World world = field();
    const Map& map = world.maps[0];
    const std::string names[] = {"plain", "plain", "worn", "red"};
    const auto nameOf = [&](TextureId id) { return world.textures[id].name; };
    for (int y = 0; y < kDepth; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            EXPECT_EQ(textureAt(world, x, y, 1), names[variantNumber(x, y, 1) % 4]);
            EXPECT_EQ(nameOf(map.floor.tiles[map.tileIndex(x, y)]),
                      names[variantNumber(x, y, -1) % 4]);
            EXPECT_EQ(nameOf(map.ceiling.tiles[map.tileIndex(x, y)]),
                      variantNumber(x, y, -2) % 2 == 0 ? "red" : "worn");
        }
    }
    // The floor outside is the texture itself.
    EXPECT_EQ(nameOf(map.floor.texture), "plain");
}

TEST(Variants, AreOfOneKind) {
    const World world = field(R"(, "bottom": 0.5)");
    for (int x = 1; x < kWidth; ++x) {
        const CellBlueprint& block = world.blueprints[world.maps[0].cell(x, 0, 0)];
        EXPECT_EQ(block.name, "block");
        EXPECT_EQ(block.bottom, toCoordinate(0.5));
        EXPECT_TRUE(block.variants == 1 || block.origin == kEmptyCell);
    }
    EXPECT_EQ(cellRow(world, 0, 1, 3), std::string(kWidth, '#'));
}

TEST(Variants, AreNotOfBlocksThatMove) {
    const World world = field(R"(, "motion": "pulse")");
    for (int x = 0; x < kWidth; ++x) EXPECT_EQ(textureAt(world, x, 0, 0), "plain");
}

TEST(Variants, AreNotOfWaterTiles) {
    const std::string rows = R"(["www","www"])";
    const LoadedScene loaded = loadText(R"({
        "title": "A pool",
        "textures": { "pool": { "file": "broken/images/tile.png", "variants": ["red"] }, "red": "#ff0000" },
        "maps": [{ "name": "pool", "levels": [["...", "..."]],
                   "floor": { "texture": "red", "water": "pool", "legend": { "w": "pool" },
                              "tiles": )" +
                                        rows + R"( } }],
        "start": { "x": 1, "y": 1 }
    })");
    ASSERT_TRUE(loaded.world.has_value()) << inWords(loaded.faults);
    for (std::size_t tile = 0; tile < 6; ++tile)
        EXPECT_TRUE(loaded.world->maps[0].isWaterFloor(tile));
}

TEST(Variants, ChangeWithTheCellsThatAreSet) {
    World world = field();
    CellEdits edits;
    for (int x = 0; x < kWidth; ++x) {
        const BlueprintId before = world.maps[0].cell(x, 5, 1);
        const std::string two = textureAt(world, x, 5, 1);
        ASSERT_EQ(edits.set(world, {0, 1, x, 5}, "2"), "");
        // Its sides have the same pictures as before, its top one of its own.
        EXPECT_EQ(textureAt(world, x, 5, 1), two);
        EXPECT_EQ(textureAt(world, x, 5, 1, Face::top),
                  variantNumber(x, 5, 1) % 2 == 0 ? "red" : "worn");
        ASSERT_EQ(edits.set(world, {0, 1, x, 5}, "#"), "");
        EXPECT_EQ(world.maps[0].cell(x, 5, 1), before);
    }
}

}  // namespace
}  // namespace slicecast
