// Scenes that load, but probably hold a mistake.
#include "scene/scene.h"
#include "scene/scene_files.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

LoadedScene loadSound(const std::string& text) {
    LoadedScene loaded = loadText(text);
    EXPECT_EQ(inWords(loaded.faults), "");
    EXPECT_TRUE(loaded.world.has_value());
    EXPECT_EQ(loaded.warnings, parseScene(text, "test.json").warnings);
    return loaded;
}

std::size_t warningsOf(const std::string& levels, const std::string& moreOfTheMap = "") {
    return loadSound(smallScene(levels, moreOfTheMap)).warnings.size();
}

TEST(Warnings, HavePlacesAndFollowTheText) {
    const LoadedScene loaded = loadFrom(sceneTestFolder() / "warnings.json");
    ASSERT_TRUE(loaded.world.has_value());
    EXPECT_EQ(inWords(loaded.faults), "");
    ASSERT_EQ(loaded.warnings.size(), 2u) << inWords(loaded.warnings);
    EXPECT_EQ(loaded.warnings[0].file, "warnings.json");
    EXPECT_EQ(loaded.warnings[0].pointer, "/maps/0/portals/0/to");
    EXPECT_EQ(loaded.warnings[0].line, 18);
    EXPECT_EQ(loaded.warnings[0].column, 33);
    EXPECT_EQ(loaded.warnings[0].found, "an exit where the player does not fit");
    EXPECT_EQ(loaded.warnings[1].pointer, "/start");
    EXPECT_EQ(loaded.warnings[1].found, "a start from which the player can walk to no other tile");
}

TEST(Warnings, NameGatesThatFollowNothing) {
    std::string text = smallScene(R"([["#####", "#..d#", "#...#", "#####"]])", "");
    const auto replace = [&text](const std::string& what, const std::string& by) {
        text.replace(text.find(what), what.size(), by);
    };
    replace("\"legend\": { \"#\": \"wall\" }",
            R"("motions": { "up": { "moves": "bottom", "to": 1 } },
               "legend": { "#": "wall", "d": "door", "b": "bell" })");
    replace("\"wall\": { \"faces\": \"brick\" }",
            R"("wall": { "faces": "brick" },
               "bell": { "faces": "brick", "motion": "up", "gate": {} },
               "door": { "faces": "brick", "motion": "up", "gate": { "follows": "bell" } })");
    const std::vector<Fault> warnings = loadSound(text).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].pointer, "/blueprints/door/gate/follows");
    EXPECT_EQ(warnings[0].found, "the gate \"bell\", which stands in no map");
    replace("#...#", "#..b#");
    EXPECT_TRUE(loadSound(text).warnings.empty());
}

TEST(Warnings, AreNotGivenBesideFaults) {
    const std::string text = readText(sceneTestFolder() / "warnings.json");
    const std::size_t at = text.find("\"floor\": \"tile\"");
    ASSERT_NE(at, std::string::npos);
    const ParsedScene parsed =
        parseScene(text.substr(0, at) + "\"floor\": \"till\"" + text.substr(at + 15), "test.json");
    EXPECT_EQ(parsed.faults.size(), 1u);
    EXPECT_TRUE(parsed.warnings.empty());
}

// The player starts in the middle of 3 x 3 tiles.
TEST(Warnings, TellOfStartsWithoutAWayOut) {
    const std::string closed = R"(["###", "#.#", "###"])";
    const std::string open = R"(["###", "#..", "###"])";
    EXPECT_EQ(warningsOf("[" + closed + ", " + closed + "]"), 1u);
    EXPECT_EQ(warningsOf("[" + open + ", " + closed + "]"), 0u);
    EXPECT_EQ(warningsOf("[" + closed + ", " + open + "]"), 1u) << "too high to jump";
}

TEST(Warnings, TellOfLampsInOpaqueBlocks) {
    const std::string levels = R"([["###", "#..", "###"]])";
    const auto lamp = [&](const std::string& place) {
        // Only a block whose images are known is known to be opaque
        return loadText(smallScene(levels, R"("baked": { "lamps": [{)" + place + "}] }"));
    };
    const LoadedScene hidden = lamp(R"("x": 0.5, "y": 1.5, "z": 0.5)");
    ASSERT_EQ(hidden.warnings.size(), 1u);
    EXPECT_EQ(hidden.warnings[0].pointer, "/maps/0/baked/lamps/0");
    EXPECT_EQ(hidden.warnings[0].found, "a lamp inside the block \"wall\"");
    EXPECT_EQ(lamp(R"("x": 1.5, "y": 1.5, "z": 0.5)").warnings.size(), 0u);
    EXPECT_EQ(lamp(R"("x": 0.5, "y": 1.5, "z": 1)").warnings.size(), 0u) << "on top of it";
}

LoadedScene loadWithSprite(const std::string& levels, const std::string& object) {
    std::string text = smallScene(
        levels, "\"baked\": {}, \"objects\": [{ \"sprite\": \"tile\", " + object + " }]");
    return loadText(text.insert(text.find("\"blueprints\""),
                                "\"sprites\": { \"tile\": \"broken/images/tile.png\" }, "));
}

TEST(Warnings, TellOfObjectsInOpaqueBlocks) {
    const auto object = [](const std::string& place) {
        return loadWithSprite(R"([["###", "#..", "###"]])", place);
    };
    const LoadedScene hidden = object(R"("x": 0.5, "y": 1.5, "height": 0.5)");
    ASSERT_EQ(hidden.warnings.size(), 1u) << inWords(hidden.faults);
    EXPECT_EQ(hidden.warnings[0].pointer, "/maps/0/objects/0");
    EXPECT_EQ(hidden.warnings[0].found, "an object inside the block \"wall\"");
    EXPECT_EQ(object(R"("x": 0.5, "y": 1.5, "z": 1, "height": 0.5)").warnings.size(), 0u);
    EXPECT_EQ(object(R"("x": 0.5, "y": 1.5, "height": 3)").warnings.size(), 0u)
        << "most of it is in sight";
    const LoadedScene lamp = object(R"("x": 0.5, "y": 1.5, "height": 1.2, "lamp": {})");
    ASSERT_EQ(lamp.warnings.size(), 2u) << inWords(lamp.faults);
    EXPECT_EQ(lamp.warnings[1].pointer, "/maps/0/objects/0/lamp");
    EXPECT_EQ(object(R"("x": 0.5, "y": 1.5, "height": 1.3, "lamp": {})").warnings.size(), 1u)
        << "the lamp hangs above the wall";
}

TEST(Warnings, TellOfLampsWithoutBakedLight) {
    std::string text = smallScene(R"([["###", "#..", "###"]])", "\"baked\": {}");
    const std::string face = R"({ "all": { "texture": "brick", "lamp": {} } })";
    text.replace(text.find("\"faces\": \"brick\"") + 9, 7, face);
    EXPECT_EQ(loadSound(text).warnings.size(), 0u);
    text.erase(text.find(", \"baked\": {}"), 13);
    const std::vector<Fault> warnings = loadSound(text).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].pointer, "/blueprints/wall/faces/all/lamp");
    EXPECT_EQ(warnings[0].found, "a lamp, but no map with \"baked\": it does not shine");
}

TEST(Warnings, TellOfWaterThatNoTileHas) {
    const auto floor = [](const std::string& more) {
        std::string text = smallScene(R"([["###", "#..", "###"]])", "");
        const std::string plain = "\"floor\": \"brick\"";
        text.replace(text.find(plain), plain.size(),
                     R"("floor": { "texture": "brick", "water": "wet")" + more + " }");
        const std::string brick = "\"brick\": \"broken/images/brick.png\"";
        return loadSound(
                   text.replace(text.find(brick), brick.size(), brick + ", \"wet\": \"#2040a0\""))
            .warnings;
    };
    const std::vector<Fault> warnings = floor("");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].pointer, "/maps/0/floor/water");
    EXPECT_EQ(warnings[0].found, "a water that no tile of the floor has");
    EXPECT_EQ(floor(R"(, "legend": { "~": "wet" }, "tiles": ["   ", " ~ ", "   "])").size(), 0u);
}

TEST(Warnings, TellOfPathsThroughOpaqueBlocks) {
    const auto path = [](const std::string& point) {
        return loadWithSprite(R"([["####", "#..#", "####"]])",
                              R"("x": 1.5, "y": 1.5, "height": 0.5, "motion": {
            "kind": "patrol", "speed": 1, "path": [{ "x": 2.5, "y": 1.5 }, )" +
                                  point + "] }");
    };
    const LoadedScene hidden = path(R"({ "x": 3.5, "y": 1.5, "z": 0 })");
    ASSERT_EQ(hidden.warnings.size(), 1u) << inWords(hidden.faults);
    EXPECT_EQ(hidden.warnings[0].pointer, "/maps/0/objects/0/motion/path/1");
    EXPECT_EQ(hidden.warnings[0].found, "a point of a path inside the block \"wall\"");
    EXPECT_EQ(path(R"({ "x": 3.5, "y": 1.5, "z": 1 })").warnings.size(), 0u);
}

TEST(Warnings, CountAJumpAsAWayOut) {
    const auto pit = [](const std::string& top) {
        std::string text = smallScene(R"([["###", "#.#", "###"]])");
        const std::string faces = R"("wall": { )";
        const std::size_t at = text.find(faces);
        EXPECT_NE(at, std::string::npos) << text;
        return text.insert(at + faces.size(), "\"top\": " + top + ", ");
    };
    EXPECT_EQ(loadSound(pit("0.75")).warnings.size(), 0u);
    EXPECT_EQ(loadSound(pit("0.8")).warnings.size(), 1u);
}

TEST(Warnings, CountPortalsAsAWayOut) {
    const std::string closed = R"([["###", "#.#", "###"], ["###", "#.#", "###"]])";
    const std::string face =
        R"({ "x": 0, "y": 1, "face": "east", "to": { "x": 0, "y": 0, "level": 2 }, "turn": 90 })";
    const std::string back =
        R"({ "x": 0, "y": 1, "face": "west", "to": { "x": 0, "y": 0, "level": 2 }, "turn": 90 })";
    EXPECT_EQ(warningsOf(closed, R"("portals": [ )" + face + " ]"), 0u);
    EXPECT_EQ(warningsOf(closed, R"("portals": [ )" + back + " ]"), 1u)
        << "on the far side of the wall";
}

TEST(Warnings, TellOfMapsThatTrapThePlayer) {
    const auto second = [](const std::string& levels) {
        std::string text = smallScene(R"([["###", "#..", "###"]])");
        const std::string other =
            R"(, { "name": "second", "floor": "brick", "levels": )" + levels + " }";
        return loadSound(text.insert(text.find(" }],") + 2, other)).warnings;
    };
    const std::vector<Fault> shut =
        second(R"([["####", "#..#", "##.#", "####"], ["####", "####", "##.#", "####"]])");
    ASSERT_EQ(shut.size(), 0u) << "its middle is (2, 2), from where (2, 1) can be walked to";
    const std::vector<Fault> hole = second(R"([["###", "#.#", "###"], ["###", "#.#", "###"]])");
    ASSERT_EQ(hole.size(), 1u);
    EXPECT_EQ(hole[0].pointer, "/maps/1");
    EXPECT_EQ(second(R"([["."]])").size(), 0u) << "there is no other tile";
    EXPECT_EQ(second(
                  R"([["###", "###", "###"], ["###", "###", "###"],
                ["###", "#.#", "###"], ["###", "#.#", "###"]])")
                  .size(),
              1u)
        << "on the blocks";
}

TEST(Warnings, AreNotGivenWhereTheWayOutMayOpen) {
    const std::string text = readText(sceneTestFolder() / "warnings.json");
    const auto replaced = [&](const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return std::string(text).replace(at, from.size(), to);
    };
    const std::string moving =
        R"("motions": { "lift": { "moves": "top", "from": -0.75, "to": 0, "period": 8 } },
           "blueprints": {)";
    std::string withLift = replaced(R"("blueprints": {)",
                                    moving + R"( "lift": { "motion": "lift", "faces": "brick" },)");
    const auto put = [&](const std::string& from, const std::string& to) {
        withLift.replace(withLift.find(from), from.size(), to);
    };
    put(R"("legend": {)", R"("legend": { "l": "lift",)");
    put(R"("#.#^#")", R"("l.#^#")");
    EXPECT_EQ(loadSound(withLift).warnings.size(), 1u) << "only the exit";
}

}  // namespace
}  // namespace slicecast
