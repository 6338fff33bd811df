// Which bodies each mover and each gate looks at.
#include "moving.h"
#include "portal_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicecast {
namespace {

// A yard with a lift at (2, 1) and another at (8, 6), a gate at (5, 1), and an open portal tile at
// (2, 7) that leads to (7, 6), beside the second lift.
World yard() {
    World world = emptyWorld(12, 12, 4);
    const BlueprintId lift =
        addMoving(world, {}, 0.25_u,
                  {.name = "lift", .edges = MovingEdges::both, .to = 1.0_u, .periodSteps = 240});
    const BlueprintId gate = addGate(world, {});
    world.maps[0].setCell(2, 1, 0, lift);
    world.maps[0].setCell(8, 6, 0, lift);
    world.maps[0].setCell(5, 1, 0, gate);
    EXPECT_TRUE(makeMovers(world).empty());
    EXPECT_TRUE(makeGates(world).empty());
    EXPECT_EQ(world.movers.size(), 2u);
    putTilePortal(
        world, {.fromMap = 0, .fromX = 2, .fromY = 7, .toMap = 0, .toX = 8, .toY = 6, .turn = 0});
    return world;
}

Body bodyAt(double x, double y, double z, bool straddles = false) {
    Body body;
    body.box = {toCoordinate(x - 0.2), toCoordinate(x + 0.2), toCoordinate(y - 0.2),
                toCoordinate(y + 0.2), toCoordinate(z),       toCoordinate(z + 0.5)};
    body.eye = {toCoordinate(x), toCoordinate(y), toCoordinate(z + 0.4)};
    body.straddles = straddles;
    return body;
}

std::vector<int> listOf(const World& world, int first) {
    std::vector<int> bodies;
    eachEncounter(world.encounters, first, [&](int body) { bodies.push_back(body); });
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}

using Bodies = std::vector<int>;

TEST(Encounters, AreThoseThatABodyIsNear) {
    World world = yard();
    const std::vector<Body> bodies = {bodyAt(2.5, 1.5, 0.25), bodyAt(1.9, 1.9, 3.0),
                                      bodyAt(0.5, 1.5, 0.0), bodyAt(5.5, 1.5, 0.0),
                                      bodyAt(5.9, 2.1, 0.0)};
    findEncounters(world, bodies);
    EXPECT_EQ(listOf(world, world.movers[0].firstEncounter), Bodies{0}) << "not from far above";
    EXPECT_EQ(listOf(world, world.movers[1].firstEncounter), Bodies{});
    EXPECT_EQ(listOf(world, world.gates[0].firstEncounter), (Bodies{3, 4}));
}

TEST(Encounters, AreAlsoThoseBehindAPortal) {
    World world = yard();
    const std::vector<Body> bodies = {bodyAt(1.9, 7.5, 0.0, true), bodyAt(1.9, 7.5, 0.0, false),
                                      bodyAt(0.5, 7.5, 0.0, true)};
    findEncounters(world, bodies);
    EXPECT_EQ(listOf(world, world.movers[1].firstEncounter), Bodies{0});
    EXPECT_EQ(listOf(world, world.movers[0].firstEncounter), Bodies{});
}

TEST(Encounters, AreFoundAnewInEachStep) {
    World world = yard();
    const std::vector<Body> on = {bodyAt(2.5, 1.5, 0.25)};
    const std::vector<Body> off = {bodyAt(4.0, 3.5, 0.0)};
    findEncounters(world, on);
    findEncounters(world, off);
    EXPECT_EQ(listOf(world, world.movers[0].firstEncounter), Bodies{});
    EXPECT_TRUE(world.encounters.empty());
}

TEST(Encounters, NameEachBodyOnce) {
    World world = emptyWorld(6, 6, 1);
    const BlueprintId lift =
        addMoving(world, {}, 0.25_u,
                  {.name = "lift", .edges = MovingEdges::both, .to = 0.5_u, .periodSteps = 240});
    for (int y = 1; y < 4; ++y) {
        for (int x = 1; x < 4; ++x) world.maps[0].setCell(x, y, 0, lift);
    }
    ASSERT_TRUE(makeMovers(world).empty());
    ASSERT_EQ(world.movers.size(), 1u);
    const std::vector<Body> bodies = {bodyAt(2.0, 2.0, 0.25), bodyAt(3.0, 3.0, 0.25)};
    findEncounters(world, bodies);
    EXPECT_EQ(listOf(world, world.movers[0].firstEncounter), (Bodies{0, 1}));
}

// Floors that move, one above another, and a body on each: a list for each floor, not for all.
TEST(Encounters, AreFewAmongManyFloors) {
    constexpr int kFloors = 16;
    World world = emptyWorld(6, 6, 2 * kFloors);
    const BlueprintId floor =
        addMoving(world, {}, 0.25_u,
                  {.name = "floor", .edges = MovingEdges::both, .to = 0.5_u, .periodSteps = 240});
    std::vector<Body> bodies;
    for (int i = 0; i < kFloors; ++i) {
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 6; ++x) world.maps[0].setCell(x, y, 2 * i, floor);
        bodies.push_back(bodyAt(2.0, 2.0, 2.0 * i + 0.25));
    }
    ASSERT_TRUE(makeMovers(world).empty());
    ASSERT_EQ(world.movers.size(), static_cast<std::size_t>(kFloors));
    findEncounters(world, bodies);
    for (int i = 0; i < kFloors; ++i) {
        EXPECT_EQ(listOf(world, world.movers[static_cast<std::size_t>(i)].firstEncounter),
                  Bodies{i});
    }
    EXPECT_EQ(world.encounters.size(), static_cast<std::size_t>(kFloors));
}

}  // namespace
}  // namespace slicecast
