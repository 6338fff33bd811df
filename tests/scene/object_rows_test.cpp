// Objects that are typed as rows of characters.
#include "scene/limits.h"
#include "scene/scene_files.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

std::string sceneWithObjects(const std::string& map, const std::string& size = "[4, 3]") {
    std::string text = smallScene("[[]]", "\"size\": " + size + ", " + map);
    return text.insert(text.find("\"blueprints\""),
                       R"("sprites": { "tree": "broken/images/tile.png" }, )");
}

TEST(ObjectRows, StandInTheMiddleOfTheirTiles) {
    const LoadedScene loaded = loadText(sceneWithObjects(R"(
        "objects": [{ "sprite": "tree", "x": 0.25, "y": 2, "height": 1 }],
        "objectRows": { "legend": {
            "t": { "sprite": "tree", "height": 1.2, "light": 0.5, "heading": 90 },
            "🌳": { "sprite": "tree", "height": 2, "width": 1, "z": 0.5, "glow": true } },
          "rows": ["t...", "  🌳 ", "...t"] })"));
    ASSERT_EQ(inWords(loaded.faults), "");
    const std::vector<Object>& objects = loaded.world->maps[0].objects;
    ASSERT_EQ(objects.size(), 4u);
    EXPECT_EQ(objects[0].x, toCoordinate(0.25)) << "those of the list come first";
    EXPECT_EQ(objects[1].x, toCoordinate(0.5));
    EXPECT_EQ(objects[1].y, toCoordinate(0.5));
    EXPECT_EQ(objects[1].z, Coordinate{});
    EXPECT_EQ(objects[1].height, toCoordinate(1.2));
    EXPECT_EQ(objects[1].light, 0.5);
    EXPECT_EQ(objects[1].facingY, toCoordinate(1.0));
    EXPECT_EQ(objects[2].x, toCoordinate(2.5));
    EXPECT_EQ(objects[2].y, toCoordinate(1.5));
    EXPECT_EQ(objects[2].z, toCoordinate(0.5));
    EXPECT_TRUE(objects[2].glow);
    EXPECT_EQ(objects[3].x, toCoordinate(3.5));
    EXPECT_EQ(objects[3].y, toCoordinate(2.5));
}

TEST(ObjectRows, EachHaveAFindAMessageAndAMotion) {
    const LoadedScene loaded = loadText(sceneWithObjects(R"(
        "objectRows": { "legend": {
            "f": { "sprite": "tree", "height": 0.3, "find": { "kind": "leaf", "message": "A leaf" },
                   "message": { "text": "Here", "near": 2, "needs": "leaf" } },
            "m": { "sprite": "tree", "height": 0.3, "motion": { "kind": "patrol", "speed": 1,
                   "path": [{ "x": 1.5, "y": 1.5 }] } } },
          "rows": ["f..f", "....", "m.m."] })"));
    ASSERT_EQ(inWords(loaded.faults), "");
    const Quest& quest = loaded.world->quest;
    ASSERT_EQ(quest.kinds.size(), 1u);
    EXPECT_EQ(quest.kinds[0].count, 2);
    ASSERT_EQ(quest.finds.size(), 2u);
    EXPECT_EQ(quest.finds[0].object, 0);
    EXPECT_EQ(quest.finds[1].object, 1);
    EXPECT_EQ(quest.finds[1].message, "A leaf");
    ASSERT_EQ(quest.notices.size(), 2u);
    EXPECT_EQ(quest.notices[1].object, 1);
    EXPECT_EQ(quest.notices[0].needs.kinds.size(), 1u);
    EXPECT_EQ(quest.notices[1].needs.kinds.size(), 1u);
    const MovingObjects& moving = loaded.world->movingObjects;
    ASSERT_EQ(moving.motions.size(), 2u);
    EXPECT_EQ(moving.motions[0].object, 2);
    EXPECT_EQ(moving.motions[1].object, 3);
    ASSERT_EQ(moving.paths.size(), 2u);
    EXPECT_EQ(moving.paths[1].size(), 1u);
}

TEST(ObjectRows, AreAtMostSoMany) {
    const auto faults = [](const char* object, int width, int depth) {
        std::string rows;
        for (int y = 0; y < depth; ++y)
            rows +=
                (y > 0 ? ",\"" : "\"") + std::string(static_cast<std::size_t>(width), 't') + "\"";
        return parseScene(sceneWithObjects(
                              std::string(R"("objectRows": { "legend": { "t": )") + object +
                                  R"(}, "rows": [)" + rows + "] }",
                              "[" + std::to_string(width) + "," + std::to_string(depth) + "]"),
                          "test.json")
            .faults;
    };
    const char* const tree = R"({ "sprite": "tree", "height": 1 })";
    EXPECT_EQ(inWords(faults(tree, 256, 256)), "");
    const std::vector<Fault> many = faults(tree, 257, 256);
    ASSERT_EQ(many.size(), 1u);
    EXPECT_EQ(many[0].pointer, "/maps/0/objectRows/rows");
    EXPECT_EQ(many[0].found, "65792 objects, counting those of earlier maps");
    // Once, however many there would be
    const std::vector<Fault> finds =
        faults(R"({ "sprite": "tree", "height": 1, "find": "a" })", 64, 17);
    ASSERT_EQ(finds.size(), 1u);
    EXPECT_EQ(finds[0].pointer, "/maps/0/objectRows/legend/t/find");
}

}  // namespace
}  // namespace slicecast
