// Cells of a running world that are changed: what is drawn, what is solid, and how it goes back.
#include "session/edit_cells.h"

#include "answers/cells_json.h"
#include "session/drawn.h"
#include "session/recording_text.h"
#include "session/session.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A walled yard of 7 x 6 tiles and three levels, seen from (1.5, 2.5) to the east; a lift that
// rises from level 0, a gate, a portal face.
World walledYard() {
    WorldBuilder make;
    make.texture("plain", {200, 200, 90, 255});
    make.texture("dark", {60, 60, 90, 255});
    make.block('#', {.name = "wall"});
    make.block('-', {.name = "step", .top = 0.25, .texture = 1});
    make.block('l', {.name = "lift", .top = 0.5, .texture = 1}).motion = 0;
    make.block('g', {.name = "gate", .texture = 1}).gate = 0;
    CellBlueprint& door = make.block('d', {.name = "door", .texture = 1});
    door.faces[static_cast<std::size_t>(Face::north)].portal = 0;
    door.hasPortals = true;
    make.world.motions.push_back(
        {.name = "lift", .edges = MovingEdges::both, .from = {}, .to = toCoordinate(1.25)});
    make.world.gateKinds.emplace_back();
    make.map("yard", 3, R"(
#######
.....g.
.......
.......
...d.l.
#######
)")
        .legend = {{"#", 1}, {"w", 1}, {"ß", 2}, {"l", 3}, {"g", 4}, {"d", 5}};
    make.world.portals.push_back({.fromX = 3, .fromY = 4, .toX = 2, .toY = 1});
    EXPECT_TRUE(makeMovers(make.world).empty());
    EXPECT_TRUE(makeGates(make.world).empty());
    makeGateFrames(make.world);
    markSeeThrough(make.world);
    make.start(1.5, 2.5);
    return std::move(make.world);
}

std::vector<std::string> rows(const Session& session, int level) {
    std::vector<std::string> rows;
    for (int y = 0; y < 6; ++y) rows.push_back(cellRow(session.world(), 0, level, y));
    return rows;
}

TEST(EditCells, RowsEqualTheScenes) {
    Session session(walledYard());
    const std::vector<std::string> ground = {"#######", ".....g.", ".......",
                                             ".......", "...d.l.", "#######"};
    EXPECT_EQ(rows(session, 0), ground);
    EXPECT_EQ(rows(session, 1), std::vector<std::string>(6, "......."))
        << "where the lift can come to";
    for (int i = 0; i < 400; ++i) session.step({});
    EXPECT_EQ(rows(session, 0), ground) << "the lift is elsewhere now";
    EXPECT_EQ(session.setCell({0, 2, 6, 3}, "ß"), "");
    EXPECT_EQ(rows(session, 2)[3], "......ß");
    EXPECT_EQ(cellsJson(session.world(), 0).substr(0, 22), "[[\"#######\",\".....g.\",");
}

TEST(EditCells, DrawsTheChangedWorld) {
    World other = walledYard();
    other.maps[0].setCell(4, 2, 0, 1);
    other.maps[0].setCell(3, 5, 0, kEmptyCell);
    Session written(std::move(other));
    Session edited(walledYard());
    const std::vector<Pixel> before = drawn(edited).pixels;
    EXPECT_EQ(edited.setCell({0, 0, 4, 2}, "#"), "");
    EXPECT_EQ(edited.setCell({0, 0, 3, 5}, " "), "");
    EXPECT_EQ(drawn(edited).pixels, drawn(written).pixels);
    EXPECT_NE(drawn(edited).pixels, before);
    EXPECT_EQ(edited.trace(160, 100, 80).hits.size(), written.trace(160, 100, 80).hits.size());
    // Solid, too: both are stopped at the same place.
    for (int i = 0; i < 240; ++i) {
        edited.step({.forward = 1.0});
        written.step({.forward = 1.0});
    }
    EXPECT_EQ(edited.eye(), written.eye());
    EXPECT_LT(edited.eye().x.value(), 4.0);
    edited.reset();
    EXPECT_EQ(drawn(edited).pixels, before);
}

TEST(EditCells, ChangesManyAtOnceOrNone) {
    Session one(walledYard());
    Session many(walledYard());
    const std::uint64_t before = many.fingerprint();
    std::vector<CellChange> changes = {
        {0, 4, 2, "#"}, {2, 6, 3, "ß"}, {0, 3, 5, "."}, {0, 1, 3, "w"}, {0, 4, 2, "ß"}};
    for (const CellChange& change : changes)
        EXPECT_EQ(one.setCell({0, change.level, change.x, change.y}, change.sign), "");
    EXPECT_EQ(many.setCells(0, changes), "");
    EXPECT_EQ(rows(many, 0), rows(one, 0));
    EXPECT_EQ(many.fingerprint(), one.fingerprint());
    EXPECT_NE(many.fingerprint(), before);
    // Back, in one go and in another order: nothing is left to be undone.
    EXPECT_EQ(many.setCells(0,
                            std::vector<CellChange>{
                                {0, 1, 3, "."}, {0, 3, 5, "#"}, {2, 6, 3, "."}, {0, 4, 2, "."}}),
              "");
    EXPECT_EQ(many.fingerprint(), before);
    changes.push_back({0, 7, 0, "#"});
    EXPECT_EQ(many.setCells(0, changes), "found x 7, expected a whole number from 0 to 6");
    EXPECT_EQ(many.fingerprint(), before);
    EXPECT_EQ(many.setCells(0, {}), "");
    // Undone to what the scene has, not to what stood there in between.
    one.reset();
    EXPECT_EQ(rows(one, 0), rows(many, 0));
}

TEST(EditCells, KeepsTheEyeInsideOfANewBlock) {
    Session session(walledYard());
    for (int i = 0; i < 10; ++i) session.step({.forward = 1.0});
    const Eye eye = session.eye();
    EXPECT_FALSE(session.player().flying);
    EXPECT_EQ(session.setCell({0, 0, 1, 2}, "#"), "");
    EXPECT_EQ(session.eye(), eye);
    EXPECT_TRUE(session.player().flying);
    session.step({});
    EXPECT_EQ(session.eye().z, eye.z);
    for (int i = 0; i < 120; ++i) session.step({.forward = 1.0});
    EXPECT_GT(session.eye().x.value(), 2.2) << "flies out";
    // A block elsewhere changes nothing of the player.
    Session walker(walledYard());
    EXPECT_EQ(walker.setCell({0, 0, 4, 3}, "#"), "");
    EXPECT_FALSE(walker.player().flying);
}

TEST(EditCells, RefusesBlocksThatAreSetUpAtLoading) {
    Session session(walledYard());
    const std::uint64_t before = session.fingerprint();
    const auto refusal = [&](CellAt at, std::string_view sign) {
        return session.setCell(at, sign);
    };
    EXPECT_EQ(refusal({0, 0, 5, 4}, ".").substr(0, 27), "found a block that moves, \"");
    EXPECT_EQ(refusal({0, 1, 5, 4}, "#").substr(0, 27), "found a block that moves, \"")
        << "where it can come to";
    EXPECT_EQ(refusal({0, 0, 5, 1}, "#").substr(0, 14), "found a gate, ");
    EXPECT_EQ(refusal({0, 0, 3, 4}, ".").substr(0, 27), "found a block with a portal");
    EXPECT_EQ(refusal({0, 0, 2, 2}, "l").substr(0, 27), "found a block that moves, \"");
    EXPECT_EQ(refusal({0, 0, 2, 2}, "g").substr(0, 14), "found a gate, ");
    EXPECT_EQ(refusal({0, 0, 2, 2}, "Q"),
              "found \"Q\", expected one of . # w ß l g d, as in the map's legend");
    EXPECT_EQ(refusal({1, 0, 2, 2}, "#"), "found map 1, expected a whole number from 0 to 0");
    EXPECT_EQ(refusal({0, 3, 2, 2}, "#"), "found level 3, expected a whole number from 0 to 2");
    EXPECT_EQ(refusal({0, 0, 7, 2}, "#"), "found x 7, expected a whole number from 0 to 6");
    EXPECT_EQ(refusal({0, 0, 2, -1}, "#"), "found y -1, expected a whole number from 0 to 5");
    EXPECT_EQ(session.fingerprint(), before);
}

TEST(EditCells, UndoRestoresTheScenesCells) {
    Session session(walledYard());
    const std::vector<std::string> ground = rows(session, 0);
    const std::uint64_t before = session.fingerprint();
    EXPECT_EQ(session.setCell({0, 0, 2, 2}, "#"), "");
    EXPECT_EQ(session.setCell({0, 0, 2, 2}, "ß"), "");
    EXPECT_EQ(session.setCell({0, 0, 3, 0}, "."), "");
    EXPECT_NE(session.fingerprint(), before);
    session.reset();
    EXPECT_EQ(rows(session, 0), ground);
    EXPECT_EQ(session.fingerprint(), before);
    // Back by hand is the same as never.
    EXPECT_EQ(session.setCell({0, 0, 2, 2}, "#"), "");
    EXPECT_EQ(session.setCell({0, 0, 2, 2}, "."), "");
    EXPECT_EQ(session.fingerprint(), before);
    // Another session that takes the world over has none of it.
    EXPECT_EQ(session.setCell({0, 0, 2, 2}, "#"), "");
    Session other(session.takeWorld());
    EXPECT_EQ(rows(other, 0), ground);
}

TEST(EditCells, AreRecorded) {
    Session session(walledYard());
    Recorder recorder("yard");
    session.record(&recorder);
    for (int i = 0; i < 30; ++i) session.step({.forward = 1.0});
    EXPECT_EQ(session.setCell({0, 0, 3, 2}, "ß"), "");
    EXPECT_EQ(session.setCell({0, 0, 4, 2}, "#"), "");
    for (int i = 0; i < 200; ++i) session.step({.forward = 1.0});
    const std::string text = writeRecording(recorder.finish(session));
    EXPECT_NE(text.find("\ncell 0 0 3 2 223\n"), std::string::npos) << text;
    ReadRecording read = readRecording(text, "yard.txt");
    ASSERT_TRUE(read.recording.has_value()) << describe(read.faults.at(0));
    Session again(walledYard());
    Replay replay(std::move(*read.recording));
    while (replay.step(again)) {
    }
    EXPECT_TRUE(replay.isSame());
    EXPECT_EQ(again.fingerprint(), session.fingerprint());
    EXPECT_EQ(rows(again, 0), rows(session, 0));
}

TEST(EditCells, BlueprintsEqualTheLegend) {
    const World world = walledYard();
    const std::string text = blueprintsJson(world, 0);
    EXPECT_EQ(text.find("[{\"character\":\"#\",\"name\":\"wall\",\"bottom\":0,\"top\":1,"
                        "\"plan\":[0,0,1,1],\"diagonal\":null,\"seeThrough\":false,\"moves\":false,"
                        "\"gate\":false,\"faces\":{\"north\":{"
                        "\"texture\":\"plain\",\"colour\":\"#c8c85a\",\"light\":1,\"glow\":false,"
                        "\"mirror\":0},"),
              0u)
        << text;
    EXPECT_NE(text.find("\"character\":\"l\",\"name\":\"lift\",\"bottom\":0,\"top\":0.5,"
                        "\"plan\":[0,0,1,1],\"diagonal\":null,\"seeThrough\":false,\"moves\":true,"
                        "\"gate\":false"),
              std::string::npos);
}

TEST(EditCells, AMissingFaceHasNoTexture) {
    World world = walledYard();
    for (CellBlueprint& blueprint : world.blueprints) {
        if (blueprint.name == "wall") blueprint.faces[0].texture = kNoTexture;
    }
    const std::string text = blueprintsJson(world, 0);
    EXPECT_NE(text.find("\"faces\":{\"north\":{\"texture\":null,\"colour\":null,\"light\":1,"),
              std::string::npos)
        << text;
}

}  // namespace
}  // namespace slicecast
