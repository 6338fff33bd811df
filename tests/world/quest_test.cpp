// Finds, messages, gates that need finds, and the goal of a game.
#include "stage.h"

#include "base/hash.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

using Kind = QuestNews::Kind;
using Wish = GateAsk::Wish;

std::uint16_t kindOf(World& world, const std::string& name) {
    std::vector<FindKind>& kinds = world.quest.kinds;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i].name == name) return static_cast<std::uint16_t>(i);
    kinds.push_back({.name = name});
    return static_cast<std::uint16_t>(kinds.size() - 1);
}

void addFind(World& world, double x, double y, const std::string& name,
             const std::string& message = "") {
    Object object;
    object.x = toCoordinate(x);
    object.y = toCoordinate(y);
    object.width = 0.3_u;
    object.height = 0.4_u;
    world.quest.finds.push_back({.map = 0,
                                 .object = static_cast<int>(world.maps[0].objects.size()),
                                 .kind = kindOf(world, name),
                                 .message = message});
    world.maps[0].objects.push_back(object);
}

std::uint64_t hashOfQuest(const World& world) {
    Hash hash;
    addTo(hash, world.quest);
    return hash.value();
}

TEST(Finds, AreTakenByTouch) {
    World world = emptyWorld(12, 3, 1);
    addFind(world, 8.5, 1.5, "coin");
    addFind(world, 4.5, 1.5, "key", "A key.");
    Stage stage(std::move(world), 1.5, 1.5);
    // The player's body reaches 0.2 ahead, the key's 0.15 back: contact at 4.15
    while (stage.player.x < 4.1_u) stage.step({.forward = 1.0});
    EXPECT_EQ(stage.world.quest.taken, 0);
    while (stage.player.x < 4.2_u) stage.step({.forward = 1.0});
    ASSERT_EQ(stage.news.size(), 1u);
    EXPECT_EQ(stage.news[0].kind, Kind::find);
    EXPECT_EQ(stage.news[0].text, "A key.");
    EXPECT_EQ(stage.news[0].name, "key");
    EXPECT_EQ(stage.news[0].taken, 1);
    EXPECT_EQ(stage.world.quest.taken, 1);
    // Gone, and the other one is still there
    ASSERT_EQ(stage.world.maps[0].objects.size(), 1u);
    EXPECT_EQ(stage.world.maps[0].objects[0].x, 8.5_u);
    stage.stepFor(3.0, {.forward = 1.0});
    EXPECT_EQ(stage.world.quest.taken, 2);
    EXPECT_TRUE(stage.world.maps[0].objects.empty());
    EXPECT_EQ(stage.news.size(), 2u);
}

TEST(Finds, AreOutOfReachFarAbove) {
    World world = emptyWorld(12, 3, 3);
    addFind(world, 4.5, 1.5, "coin");
    world.maps[0].objects[0].z = 1.0_u;
    Stage stage(std::move(world), 4.5, 1.5);
    stage.stepFor(1.0);
    EXPECT_EQ(stage.world.quest.taken, 0);
    stage.stepFor(0.5, {.jump = true});
    EXPECT_EQ(stage.world.quest.taken, 1);
}

TEST(Finds, MayWalkAndComeBackAfterAReset) {
    World world = emptyWorld(12, 3, 1);
    addActor(world, 9.0, 1.5, standing());
    addFind(world, 4.5, 1.5, "coin");
    world.quest.finds.push_back(
        {.map = 0, .object = 0, .kind = kindOf(world, "cat"), .message = ""});
    world.quest.notices.push_back(
        {.map = 0, .object = 0, .near = 1.0_u, .once = false, .text = "Miaow"});
    Stage stage(std::move(world), 4.5, 1.5);
    const std::uint64_t before = hashOfQuest(stage.world);
    stage.step();
    EXPECT_EQ(stage.world.movingObjects.motions[0].object, 0);
    stage.putPlayer(9.2, 1.5);
    stage.step();
    EXPECT_EQ(stage.world.quest.taken, 2);
    EXPECT_TRUE(stage.world.movingObjects.motions.empty());
    EXPECT_TRUE(stage.world.quest.notices.empty());
    EXPECT_NE(hashOfQuest(stage.world), before);
    resetObjects(stage.world);
    resetQuest(stage.world);
    EXPECT_EQ(hashOfQuest(stage.world), before);
    EXPECT_EQ(stage.world.quest.taken, 0);
    EXPECT_EQ(stage.world.maps[0].objects.size(), 2u);
    EXPECT_EQ(stage.world.movingObjects.motions.size(), 1u);
    EXPECT_EQ(stage.world.quest.notices.size(), 1u);
}

// What stands behind a taken find in the list is still found by its own reference.
TEST(Finds, KeepTheReferencesOfTheOthers) {
    World world = emptyWorld(14, 3, 1);
    addFind(world, 3.5, 1.5, "a");
    addActor(world, 12.0, 1.5, standing());
    addFind(world, 6.5, 1.5, "b");
    Stage stage(std::move(world), 3.5, 1.5);
    stage.step();
    EXPECT_EQ(stage.world.quest.finds[0].object, -1);
    EXPECT_EQ(stage.world.quest.finds[1].object, 1);
    EXPECT_EQ(stage.world.movingObjects.motions[0].object, 0);
    EXPECT_EQ(stage.x(), 12.0);
}

// All of them at once, among others in two maps: what is left keeps its references.
TEST(Finds, MayAllBeTakenInOneStep) {
    World world = emptyWorld(14, 3, 1);
    world.maps.push_back(world.maps[0]);
    for (int i = 0; i < 20; ++i) {
        addFind(world, i % 3 == 0 ? 9.5 : 1.5, 1.5, "coin");
        world.quest.notices.push_back(
            {.map = 0, .object = i, .near = 0.1_u, .text = std::to_string(i)});
        addFind(world, 1.5, 1.5, "shell");
        world.quest.finds.back().map = 1;
        world.maps[1].objects.push_back(world.maps[0].objects.back());
        world.quest.finds.back().object = i;
        world.maps[0].objects.pop_back();
    }
    Stage stage(std::move(world), 1.5, 1.5);
    stage.step();
    const Quest& quest = stage.world.quest;
    EXPECT_EQ(quest.taken, 13);
    EXPECT_EQ(stage.world.maps[0].objects.size(), 7u);
    EXPECT_EQ(stage.world.maps[1].objects.size(), 20u);
    ASSERT_EQ(quest.notices.size(), 7u);
    for (int i = 0; i < 7; ++i) {
        const auto index = static_cast<std::size_t>(i);
        EXPECT_EQ(quest.finds[6 * index].object, i);
        EXPECT_EQ(quest.notices[index].object, i);
        EXPECT_EQ(quest.notices[index].text, std::to_string(3 * i));
    }
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(quest.finds[2 * i + 1].object, static_cast<int>(i));
        EXPECT_EQ(quest.finds[2 * i + 1].map, 1);
        if (i % 3 != 0) {
            EXPECT_EQ(quest.finds[2 * i].object, -1);
        }
    }
    stage.putPlayer(9.5, 1.5);
    stage.step();
    EXPECT_EQ(quest.taken, 20);
    EXPECT_TRUE(stage.world.maps[0].objects.empty());
}

TEST(Notices, AppearOnceForEachVisit) {
    World world = emptyWorld(12, 3, 1);
    Notice notice;
    notice.area = {tileEdge(5), tileEdge(6), tileEdge(0), tileEdge(3), {}, tileEdge(2)};
    notice.text = "Here";
    world.quest.notices.push_back(notice);
    notice.once = true;
    notice.text = "First";
    world.quest.notices.push_back(notice);
    Stage stage(std::move(world), 3.5, 1.5);
    stage.stepFor(0.2);
    EXPECT_TRUE(stage.news.empty());
    stage.putPlayer(5.5, 1.5);
    stage.stepFor(1.0);
    ASSERT_EQ(stage.news.size(), 2u);
    EXPECT_EQ(stage.news[0].text, "Here");
    // A step aside is no new visit
    stage.putPlayer(4.7, 1.5);
    stage.step();
    stage.putPlayer(5.5, 1.5);
    stage.step();
    EXPECT_EQ(stage.news.size(), 2u);
    stage.putPlayer(2.5, 1.5);
    stage.step();
    stage.putPlayer(5.5, 1.5);
    stage.step();
    ASSERT_EQ(stage.news.size(), 3u);
    EXPECT_EQ(stage.news[2].text, "Here");
}

TEST(Notices, MayAskForFinds) {
    World world = emptyWorld(12, 3, 1);
    world.quest.kinds.push_back({.name = "key"});
    Notice notice;
    notice.area = {tileEdge(5), tileEdge(6), tileEdge(0), tileEdge(3), {}, tileEdge(2)};
    notice.text = "Bring the key";
    notice.unless.kinds = {{0, 1}};
    world.quest.notices.push_back(notice);
    notice.text = "Thanks";
    notice.needs.kinds = {{0, 1}};
    notice.unless = {};
    notice.once = true;
    world.quest.notices.push_back(notice);
    Stage stage(std::move(world), 5.5, 1.5);
    stage.stepFor(0.2);
    ASSERT_EQ(stage.news.size(), 1u);
    EXPECT_EQ(stage.news[0].text, "Bring the key");
    // Where the player stands, too
    stage.world.quest.kinds[0].taken = 1;
    stage.stepFor(0.2);
    ASSERT_EQ(stage.news.size(), 2u);
    EXPECT_EQ(stage.news[1].text, "Thanks");
    stage.putPlayer(2.5, 1.5);
    stage.step();
    stage.putPlayer(5.5, 1.5);
    stage.step();
    EXPECT_EQ(stage.news.size(), 2u);
}

TEST(Notices, OfObjectsNeedThemInSight) {
    World world = emptyWorld(12, 3, 1);
    putBlock(world, 5, 1, {}, 1.0_u);
    addActor(world, 6.5, 1.5, standing());
    world.quest.notices.push_back({.map = 0, .object = 0, .near = 2.0_u, .text = "Hello"});
    Stage stage(std::move(world), 4.7, 1.5);
    stage.stepFor(0.5);
    EXPECT_TRUE(stage.news.empty());
    stage.putPlayer(7.7, 1.5);
    stage.step();
    EXPECT_EQ(stage.news.size(), 1u);
}

// A step looks for only so many objects in the player's sight. The others have their turn.
TEST(Notices, OfManyHiddenObjectsTakeTurns) {
    World world = emptyWorld(12, 3, 1);
    putBlock(world, 5, 1, {}, 1.0_u);
    constexpr int kHidden = 3 * kMostNoticeLooks;
    for (int i = 0; i <= kHidden; ++i) {
        addActor(world, i == kHidden ? 3.5 : 6.5, 1.5, standing());
        world.quest.notices.push_back(
            {.map = 0, .object = i, .near = 3.0_u, .text = std::to_string(i)});
    }
    Stage stage(std::move(world), 4.5, 1.5);
    for (int i = 0; i < 3; ++i) stage.step();
    EXPECT_TRUE(stage.news.empty());
    EXPECT_EQ(stage.world.quest.nextNotice, static_cast<std::size_t>(kHidden));
    stage.step();
    ASSERT_EQ(stage.news.size(), 1u);
    EXPECT_EQ(stage.news[0].text, std::to_string(kHidden));
}

TEST(Needs, CountAnyOrNamedFinds) {
    Quest quest;
    quest.kinds = {{"coin", 3, 1}, {"key", 1, 0}};
    quest.taken = 1;
    EXPECT_TRUE(holds(quest, {}));
    EXPECT_TRUE(holds(quest, {.any = 1, .kinds = {}}));
    EXPECT_FALSE(holds(quest, {.any = 2, .kinds = {}}));
    EXPECT_TRUE(holds(quest, {.kinds = {{0, 1}}}));
    EXPECT_FALSE(holds(quest, {.kinds = {{0, 2}}}));
    EXPECT_FALSE(holds(quest, {.kinds = {{0, 1}, {1, 1}}}));
    EXPECT_EQ(missing(quest, {.any = 2, .kinds = {}}), "1 more find");
    EXPECT_EQ(missing(quest, {.any = 4, .kinds = {}}), "3 more finds");
    EXPECT_EQ(missing(quest, {.kinds = {{0, 3}, {1, 1}}}), "2 coin and key");
}

World lockedCorridor(const GateKind& kind) {
    World world = emptyWorld(9, 3, 2);
    for (int x = 0; x < 9; ++x)
        for (const int y : {0, 2}) putBlock(world, x, y, {}, 1.0_u);
    const BlueprintId id = addGate(world, kind);
    for (const int level : {0, 1}) world.maps[0].setCell(6, 1, level, id);
    EXPECT_TRUE(makeGates(world).empty());
    addFind(world, 2.5, 1.5, "key");
    return world;
}

TEST(Needs, KeepAGateShutUntilTheyAreMet) {
    GateKind kind;
    kind.needs.any = 1;
    Stage stage(lockedCorridor(kind), 5.0, 1.5);
    stage.step({}, Wish::change);
    ASSERT_EQ(stage.news.size(), 1u);
    EXPECT_EQ(stage.news[0].kind, Kind::message);
    EXPECT_EQ(stage.news[0].text, "Still missing: 1 more find.");
    EXPECT_EQ(refusal(stage.world, stage.world.gates[0]), stage.news[0].text);
    EXPECT_EQ(gateOffer(stage.world, asks(stage.player, Wish::nothing)), GateOffer::none);
    stage.stepFor(1.0);
    EXPECT_EQ(stage.world.gates[0].progress, 0);
    EXPECT_EQ(stage.news.size(), 1u);
    stage.step({}, Wish::open);
    EXPECT_EQ(stage.news.size(), 2u);  // each try
    stage.putPlayer(2.5, 1.5);
    stage.step();
    stage.putPlayer(5.0, 1.5);
    stage.step({}, Wish::change);
    EXPECT_GT(stage.world.gates[0].progress, 0);
    EXPECT_EQ(stage.news.size(), 3u);  // the find
}

TEST(Needs, AlsoOfAGateThatOpensOnApproach) {
    GateKind kind;
    kind.keyed = false;
    kind.opensOnApproach = true;
    kind.approach = 1.0_u;
    kind.needs.kinds = {{0, 1}};
    kind.locked = "No way.";
    Stage stage(lockedCorridor(kind), 5.3, 1.5);
    stage.stepFor(1.0);
    EXPECT_EQ(stage.world.gates[0].progress, 0);
    ASSERT_EQ(stage.news.size(), 1u);
    EXPECT_EQ(stage.news[0].text, "No way.");
    stage.putPlayer(2.5, 1.5);
    stage.step();
    stage.putPlayer(5.3, 1.5);
    stage.stepFor(0.5);
    EXPECT_GT(stage.world.gates[0].progress, 0);
}

TEST(Goals, NeedTheFindsAndThePlace) {
    World world = emptyWorld(12, 3, 1);
    addFind(world, 4.5, 1.5, "coin");
    world.quest.goal.emplace();
    world.quest.goal->needs.any = 1;
    world.quest.goal->map = 0;
    world.quest.goal->area = {tileEdge(8), tileEdge(9), tileEdge(1), tileEdge(2), {}, tileEdge(2)};
    world.quest.goal->message = "Done.";
    Stage stage(std::move(world), 8.5, 1.5);
    stage.stepFor(1.0);
    EXPECT_FALSE(stage.world.quest.isReached);
    EXPECT_EQ(stage.world.quest.steps, 0);  // no input yet
    stage.putPlayer(3.0, 1.5);
    int steps = 0;
    while (!stage.world.quest.isReached && steps < 10 * kStepsPerSecond) {
        stage.step({.forward = 1.0});
        ++steps;
    }
    EXPECT_TRUE(stage.world.quest.isReached);
    EXPECT_EQ(stage.news.back().kind, Kind::goal);
    EXPECT_EQ(stage.news.back().text, "Done.");
    EXPECT_EQ(stage.world.quest.steps, steps);
    EXPECT_GE(stage.player.x, 8.0_u);
    // The clock stands still then, and nothing is told twice
    stage.stepFor(1.0, {.forward = -1.0});
    EXPECT_EQ(stage.world.quest.steps, steps);
    EXPECT_EQ(stage.news.back().kind, Kind::goal);
}

}  // namespace
}  // namespace slicecast
