// Finds, messages, games and behaviours in scene files.
#include "scene/scene.h"
#include "scene/scene_files.h"
#include "world/player.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

std::string hunt(const std::string& gate, const std::string& game, const std::string& map) {
    return R"({
  "title": "A hunt",
  "textures": { "brick": "broken/images/brick.png", "tile": "broken/images/tile.png",
    "door": { "file": "broken/images/sheet.png", "frames": 3 } },
  "sprites": { "coin": "broken/images/tile.png" },
  "blueprints": { "wall": { "faces": "brick" },
    "door": { "faces": { "all": "door" }, "gate": { )" +
           gate + R"( } } },
  "legend": { "#": "wall", "g": "door" },
  "maps": [{ "name": "room", "levels": [["######", "#...g#", "#....#", "######"]],
    "floor": "tile", )" +
           map + R"( }],
  )" + game +
           R"(
  "start": { "x": 1.5, "y": 1.5 }
})";
}

constexpr const char* kCoins = R"("objects": [
  { "sprite": "coin", "x": 2.5, "y": 1.5, "height": 0.3,
    "find": { "kind": "coin", "message": "A coin." } },
  { "sprite": "coin", "x": 3.5, "y": 1.5, "height": 0.3, "find": "coin" },
  { "sprite": "coin", "x": 3.5, "y": 2.5, "height": 0.3, "find": "key",
    "message": { "text": "Look", "near": 2, "once": true } }])";

// "COUNT of KIND, ..."
std::string inWords(const Needs& needs) {
    std::string text;
    for (const auto& [kind, count] : needs.kinds)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " of " + std::to_string(kind);
    return text;
}

TEST(QuestScenes, AreReadWhole) {
    const LoadedScene loaded = loadText(
        hunt(R"("needs": ["coin", "coin"], "locked": "No.")",
             R"("game": { "aim": "Go.", "needs": "key", "message": "Done.",
             "at": { "x": 2, "y": 2, "width": 2, "top": 1 } },)",
             std::string(kCoins) +
                 R"(, "messages": [{ "text": "Here", "x": 1, "y": 1, "depth": 2, "near": 0.5 }])"));
    ASSERT_EQ(inWords(loaded.faults), "");
    EXPECT_EQ(inWords(loaded.warnings), "");
    const Quest& quest = loaded.world->quest;
    ASSERT_EQ(quest.kinds.size(), 2u);
    EXPECT_EQ(quest.kinds[0].name, "coin");
    EXPECT_EQ(quest.kinds[0].count, 2);
    ASSERT_EQ(quest.finds.size(), 3u);
    EXPECT_EQ(quest.finds[0].message, "A coin.");
    EXPECT_EQ(quest.finds[2].kind, 1);
    EXPECT_EQ(quest.finds[2].object, 2);
    ASSERT_EQ(quest.notices.size(), 2u);
    EXPECT_EQ(quest.notices[0].object, 2);
    EXPECT_TRUE(quest.notices[0].once);
    EXPECT_EQ(quest.notices[1].object, -1);
    EXPECT_EQ(quest.notices[1].area.south, tileEdge(3));
    EXPECT_EQ(quest.notices[1].near, toCoordinate(0.5));
    EXPECT_EQ(quest.aim, "Go.");
    ASSERT_TRUE(quest.goal.has_value());
    EXPECT_EQ(inWords(quest.goal->needs), "1 of 1");
    EXPECT_EQ(quest.goal->area.east, tileEdge(4));
    EXPECT_EQ(quest.goal->area.top, tileEdge(1));
    EXPECT_EQ(inWords(loaded.world->gateKinds[0].needs), "2 of 0");
    EXPECT_EQ(loaded.world->gateKinds[0].locked, "No.");
}

TEST(QuestScenes, MessagesMayAskForFinds) {
    std::string coins = kCoins;
    coins.insert(coins.find(R"("once": true)"), R"("needs": "coin", "unless": 3, )");
    const LoadedScene loaded = loadText(hunt(
        "", "",
        coins +
            R"(, "messages": [{ "text": "Here", "x": 1, "y": 1, "unless": ["key", "coin", "coin"] },
                   { "text": "There", "x": 1, "y": 1, "needs": 9 }])"));
    ASSERT_EQ(inWords(loaded.faults), "");
    const std::vector<Notice>& notices = loaded.world->quest.notices;
    ASSERT_EQ(notices.size(), 3u);
    EXPECT_EQ(inWords(notices[0].needs), "1 of 0");
    EXPECT_EQ(notices[0].unless.any, 3);
    EXPECT_TRUE(notices[1].needs.none());
    EXPECT_EQ(inWords(notices[1].unless), "1 of 1, 2 of 0");
    EXPECT_EQ(notices[2].needs.any, 9);
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_EQ(loaded.warnings[0].pointer, "/maps/0/messages/1/needs");
}

TEST(QuestScenes, AGameNeedsAllFindsByItself) {
    const LoadedScene loaded = loadText(hunt("", R"("game": { "aim": "Take all." },)", kCoins));
    ASSERT_EQ(inWords(loaded.faults), "");
    ASSERT_TRUE(loaded.world->quest.goal.has_value());
    EXPECT_EQ(loaded.world->quest.goal->needs.any, 3);
}

TEST(QuestScenes, WarnOfWhatNobodyCanDo) {
    const auto warnings = [](const std::string& gate, const std::string& game,
                             const std::string& map) {
        const LoadedScene loaded = loadText(hunt(gate, game, map));
        EXPECT_EQ(inWords(loaded.faults), "");
        return inWords(loaded.warnings);
    };
    EXPECT_EQ(warnings(R"("needs": 3)", "", kCoins), "");
    EXPECT_NE(warnings(R"("needs": 4)", "", kCoins).find("a need of 4 finds"), std::string::npos);
    EXPECT_NE(warnings(R"("needs": ["key", "key"])", "", kCoins).find("a need of 2 finds named"),
              std::string::npos);
    EXPECT_NE(warnings("", R"("game": { "aim": "Go.", "needs": 9 },)", kCoins).find("9 finds"),
              std::string::npos);
    EXPECT_EQ(warnings("", R"("game": { "aim": "Go." },)", kCoins), "");
    EXPECT_NE(warnings("", R"("game": { "aim": "Go." },)", R"("messages": [])")
                  .find("a game that never ends"),
              std::string::npos);
    const std::string walled = R"("messages": [{ "text": "Boo", "x": 5, "y": 0, "depth": 3 }])";
    EXPECT_NE(warnings("", "", walled).find("a message where the player has no room"),
              std::string::npos);
    EXPECT_EQ(warnings("", "", R"("messages": [{ "text": "Boo", "x": 2, "y": 1 }])"), "");
}

TEST(QuestScenes, FindsMayBeSown) {
    const std::string game = R"("game": { "aim": "Take all.", "needs": ["apple", "key"] },)";
    const auto sown = [&](const std::string& density) {
        return loadText(hunt(R"("needs": "apple")", game,
                             std::string(kCoins) +
                                 R"(, "sow": [{ "sprite": "coin", "height": 0.3, "clear": 0,
            "find": { "kind": "apple", "message": "Sweet." }, "density": )" +
                                 density + " }]"));
    };
    const LoadedScene loaded = sown("1");
    ASSERT_EQ(inWords(loaded.faults), "");
    EXPECT_EQ(inWords(loaded.warnings), "");
    const Quest& quest = loaded.world->quest;
    ASSERT_EQ(quest.finds.size(), 6u);
    ASSERT_EQ(quest.kinds.size(), 3u);
    EXPECT_EQ(quest.kinds[2].name, "apple");
    EXPECT_EQ(quest.kinds[2].count, 3) << "not at the start, nor where others stand";
    EXPECT_EQ(quest.finds[3].message, "Sweet.");
    EXPECT_EQ(quest.finds[3].object, 3);
    EXPECT_EQ(inWords(quest.goal->needs), "1 of 2, 1 of 1");

    const LoadedScene none = sown("0");
    ASSERT_EQ(inWords(none.faults), "");
    EXPECT_NE(inWords(none.warnings).find("a find that is sown nowhere"), std::string::npos);
    EXPECT_NE(inWords(none.warnings).find("a need of 1 find named \"apple\""), std::string::npos);
}

TEST(QuestScenes, BehavioursAreReadWhole) {
    const LoadedScene loaded = loadText(hunt("", "", R"("objects": [
      { "sprite": "coin", "x": 2.5, "y": 1.5, "height": 0.3, "motion": { "kind": "patrol",
        "speed": 2, "loop": false, "path": [{ "x": 1.5, "y": 2.5, "wait": 2 },
        { "map": "room", "x": 3.5, "y": 2.5, "z": 1 }] } },
      { "sprite": "coin", "x": 3.5, "y": 2.5, "height": 0.3, "motion": { "kind": "stand",
        "solid": false, "sprites": { "alert": "coin" },
        "alert": { "do": "follow", "near": 3, "keep": 1.5, "speed": 2.5, "seconds": 4 } } },
      { "sprite": "coin", "x": 1.5, "y": 2.5, "height": 0.3, "heading": 90 }])"));
    ASSERT_EQ(inWords(loaded.faults), "");
    const MovingObjects& moving = loaded.world->movingObjects;
    ASSERT_EQ(moving.motions.size(), 2u);
    const ObjectMotion& guard = moving.motions[0];
    EXPECT_EQ(guard.kind, ObjectMotion::Kind::patrol);
    EXPECT_FALSE(guard.loops);
    EXPECT_TRUE(guard.solid);
    ASSERT_EQ(moving.paths.size(), 1u);
    ASSERT_EQ(moving.paths[0].size(), 2u);
    EXPECT_EQ(moving.paths[0][0].waitSteps, 2 * kStepsPerSecond);
    EXPECT_FALSE(moving.paths[0][0].feet.has_value());
    EXPECT_EQ(moving.paths[0][1].feet, tileEdge(1));
    const ObjectMotion& follower = moving.motions[1];
    EXPECT_EQ(follower.reaction, ObjectMotion::Reaction::follow);
    EXPECT_EQ(follower.near, tileEdge(3));
    EXPECT_EQ(follower.keep, toCoordinate(1.5));
    EXPECT_EQ(follower.alertSpeed, 2.5);
    EXPECT_EQ(follower.calmSteps, 4 * kStepsPerSecond);
    EXPECT_FALSE(follower.solid);
    EXPECT_EQ(follower.alert, SpriteId{0});
    EXPECT_FALSE(follower.walking.has_value());
    EXPECT_EQ(loaded.world->maps[0].objects[2].facingY, tileEdge(1));
    EXPECT_EQ(loaded.world->maps[0].objects[2].facingX, tileEdge(0));
}

}  // namespace
}  // namespace slicecast
