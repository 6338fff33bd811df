// Named places of maps, and who names them.
#include "scene/limits.h"
#include "scene/scene_files.h"
#include "world/portal.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

// Two maps; each has places, of which "gate" stands in both.
std::string sceneWith(const std::string& start, const std::string& more = "",
                      const std::string& rest = "") {
    return R"({
  "title": "Places",
  "textures": { "brick": "broken/images/brick.png" },
  "sprites": { "guard": "broken/images/tile.png" },
  "blueprints": { "wall": { "faces": "brick" } },
  "legend": { "#": "wall" },
  "maps": [
    { "name": "yard", "floor": "brick", "size": [6, 5], "levels": [[]],
      "places": { "gate": { "x": 3.5, "y": 4.25, "z": 0.5, "heading": 90 },
                  "well": { "x": 1.5, "y": 2.5 } })" +
           (more.empty() ? "" : ", " + more) + R"( },
    { "name": "tower", "floor": "brick", "size": [4, 4], "levels": [[], [], []],
      "places": { "gate": { "x": 2.5, "y": 1.5, "z": 2 } } }],
  "start": { )" +
           start + " }" + rest + "\n}";
}

World worldOf(const std::string& text) {
    LoadedScene loaded = loadText(text);
    EXPECT_EQ(inWords(loaded.faults), "");
    if (!loaded.world) return {};
    return std::move(*loaded.world);
}

TEST(Places, AreWhereThePlayerStarts) {
    const Start there = worldOf(sceneWith(R"("place": "gate", "look": 0.5)")).start;
    EXPECT_EQ(there.map, 0);
    EXPECT_EQ(there.x, toCoordinate(3.5));
    EXPECT_EQ(there.y, toCoordinate(4.25));
    EXPECT_EQ(there.z, toCoordinate(0.5));
    EXPECT_EQ(there.headingDegrees, 90.0);
    EXPECT_EQ(there.look, 0.5);

    const Start plain = worldOf(sceneWith(R"("place": "well", "heading": 45)")).start;
    EXPECT_EQ(plain.x, toCoordinate(1.5));
    EXPECT_EQ(plain.z, Coordinate{});
    EXPECT_EQ(plain.headingDegrees, 45.0);

    const Start other =
        worldOf(sceneWith(R"("map": "tower", "place": "gate", "z": 1, "heading": -90)")).start;
    EXPECT_EQ(other.map, 1);
    EXPECT_EQ(other.x, toCoordinate(2.5));
    EXPECT_EQ(other.z, toCoordinate(1.0)) << "what is given beside it counts";
    EXPECT_EQ(other.headingDegrees, -90.0);
}

TEST(Places, AreWherePortalsLead) {
    const World world = worldOf(sceneWith(R"("place": "well")", R"("portals": [
        { "x": 0, "y": 0, "to": { "map": "tower", "place": "gate" } },
        { "x": 1, "y": 0, "to": { "map": "tower", "place": "gate", "level": 1 } },
        { "x": 2, "y": 0, "to": { "place": "well" } }])"));
    ASSERT_EQ(world.portals.size(), 3u);
    const Portal& high = world.portals[0];
    EXPECT_EQ(high.toMap, 1);
    EXPECT_EQ(high.toX, 2);
    EXPECT_EQ(high.toY, 1);
    EXPECT_EQ(high.levels, 2) << "its z says the level";
    EXPECT_EQ(world.portals[1].levels, 1);
    EXPECT_EQ(world.portals[2].toMap, 0);
    EXPECT_EQ(world.portals[2].toX, 1);
    EXPECT_EQ(world.portals[2].toY, 2);
    EXPECT_EQ(world.portals[2].levels, 0);
}

TEST(Places, AreWhereMessagesAndGoalsAre) {
    const World world = worldOf(sceneWith(
        R"("place": "well")", R"("messages": [{ "text": "A gate.", "place": "gate", "width": 2 }])",
        R"(, "game": { "aim": "Up.", "at": { "map": "tower", "place": "gate" } })"));
    ASSERT_EQ(world.quest.notices.size(), 1u);
    const Box& area = world.quest.notices[0].area;
    EXPECT_EQ(area.west, tileEdge(3));
    EXPECT_EQ(area.east, tileEdge(5));
    EXPECT_EQ(area.north, tileEdge(4));
    EXPECT_EQ(area.south, tileEdge(5));
    ASSERT_TRUE(world.quest.goal);
    EXPECT_EQ(world.quest.goal->map, 1);
    EXPECT_EQ(world.quest.goal->area.west, tileEdge(2));
    EXPECT_EQ(world.quest.goal->area.north, tileEdge(1));
}

TEST(Places, ArePointsOfPaths) {
    const World world = worldOf(sceneWith(R"("place": "well")", R"("objects": [
        { "sprite": "guard", "x": 1.5, "y": 1.5, "height": 0.5, "motion": { "kind": "patrol",
          "speed": 1, "path": ["gate", { "map": "tower", "place": "gate", "wait": 1 },
            { "place": "well", "z": 3 }, "well"] } }])"));
    ASSERT_EQ(world.movingObjects.paths.size(), 1u);
    const std::vector<PathPoint>& path = world.movingObjects.paths[0];
    ASSERT_EQ(path.size(), 4u);
    EXPECT_EQ(path[0].map, 0);
    EXPECT_EQ(path[0].place.x, toCoordinate(3.5));
    EXPECT_EQ(path[0].feet, toCoordinate(0.5));
    EXPECT_EQ(path[1].map, 1);
    EXPECT_EQ(path[1].place.y, toCoordinate(1.5));
    EXPECT_EQ(path[1].waitSteps, 120);
    EXPECT_EQ(path[2].feet, toCoordinate(3.0));
    EXPECT_FALSE(path[3].feet);
}

TEST(Places, AreAtMostSoMany) {
    const auto faults = [](std::size_t count) {
        std::string places;
        for (std::size_t i = 0; i < count; ++i)
            places += (i > 0 ? ",\"" : "\"") + std::to_string(i) + R"(": { "x": 1, "y": 1 })";
        return parseScene(smallScene(R"([["###", "#.#", "###"]])", "\"places\": {" + places + "}"),
                          "test.json")
            .faults;
    };
    EXPECT_EQ(faults(kMaxPlaces).size(), 0u);
    EXPECT_EQ(faults(kMaxPlaces + 1).size(), 1u);
}

}  // namespace
}  // namespace slicecast
