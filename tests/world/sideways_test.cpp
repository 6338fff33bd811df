// Blocks that move along x or y: where they are, whom they take along, push and wait for; and gates
// that move blocks.
#include "moving.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicecast {
namespace {

// 3 units east in 3 seconds at one speed, and back.
constexpr int kFerryPeriod = 6 * kSecond;
Motion ferryOf(Axis axis = Axis::x) {
    return {.name = "ferry",
            .axis = axis,
            .edges = MovingEdges::both,
            .from = {},
            .to = 3.0_u,
            .periodSteps = kFerryPeriod,
            .phaseSteps = 0,
            .shape = MotionShape::even};
}

// A block over two tiles, (1, 2) and (2, 2) or turned, of half a unit's height.
World raft(const Motion& motion) {
    World world = emptyWorld(8, 8, 2);
    const BlueprintId id = addMoving(world, {}, 0.5_u, motion);
    const bool alongX = motion.axis == Axis::x;
    world.maps[0].setCell(alongX ? 1 : 2, alongX ? 2 : 1, 0, id);
    world.maps[0].setCell(2, 2, 0, id);
    EXPECT_TRUE(makeMovers(world).empty());
    return world;
}

void stepAlone(World& world, int steps) {
    for (int i = 0; i < steps; ++i) stepWorld(world, {}, {});
}

Player standing(const World& world, Coordinate x, Coordinate y, Coordinate z) {
    Player player;
    player.x = x;
    player.y = y;
    player.z = z;
    player.onGround = true;
    EXPECT_TRUE(isFree(world, travellerOf(player)));
    return player;
}

void stepBothOften(World& world, Player& player, int steps, const GateAsk& ask = {}) {
    for (int i = 0; i < steps; ++i) {
        stepBoth(world, player, {}, i == 0 ? ask : GateAsk{});
        ASSERT_FALSE(reachesIntoSolid(world, 0, bodyBox(player))) << i;
    }
}

TEST(Sideways, AreAtTheirMotionsPlaceInAllTiles) {
    for (const Axis axis : {Axis::x, Axis::y}) {
        World world = raft(ferryOf(axis));
        const Map& map = world.maps[0];
        for (int step = 0; step <= kFerryPeriod; ++step) {
            const Coordinate offset = offsetAt(ferryOf(axis), step);
            for (int tile = 0; tile < 8; ++tile) {
                const int x = axis == Axis::x ? tile : 2;
                const int y = axis == Axis::x ? 2 : tile;
                const Coordinate low = std::max(tileEdge(tile), tileEdge(1) + offset);
                const Coordinate high = std::min(tileEdge(tile + 1), tileEdge(3) + offset);
                const CellBlueprint& part = world.blueprints[map.cell(x, y, 0)];
                ASSERT_EQ(map.isOccupied(x, y, 0), low < high) << step << " " << tile;
                if (low >= high) continue;
                const Plan& plan = part.plan;
                ASSERT_EQ(tileEdge(tile) + (axis == Axis::x ? plan.west : plan.north), low);
                ASSERT_EQ(tileEdge(tile) + (axis == Axis::x ? plan.east : plan.south), high);
                ASSERT_EQ(axis == Axis::x ? part.textureEast : part.textureSouth,
                          Coordinate{offset.raw & 0xffff});
                ASSERT_EQ(part.top, 0.5_u);
            }
            stepAlone(world, 1);
        }
    }
}

TEST(Sideways, OneEdgeMovesAlone) {
    Motion motion = ferryOf();
    motion.edges = MovingEdges::high;
    World world = raft(motion);
    stepAlone(world, kFerryPeriod / 2);
    const Map& map = world.maps[0];
    for (int x = 0; x < 8; ++x) EXPECT_EQ(map.isOccupied(x, 2, 0), x >= 1 && x < 6) << x;
}

TEST(Sideways, TakeAlongWhoStandsOnThem) {
    for (const Axis axis : {Axis::x, Axis::y}) {
        World world = raft(ferryOf(axis));
        Player player = axis == Axis::x ? standing(world, 2.0_u, 2.5_u, 0.5_u)
                                        : standing(world, 2.5_u, 2.0_u, 0.5_u);
        stepBothOften(world, player, kFerryPeriod / 2);
        EXPECT_EQ(axis == Axis::x ? player.x : player.y, 5.0_u);
        EXPECT_EQ(axis == Axis::x ? player.y : player.x, 2.5_u);
        EXPECT_EQ(player.z, 0.5_u);
        stepBothOften(world, player, kFerryPeriod / 2);
        EXPECT_EQ(axis == Axis::x ? player.x : player.y, 2.0_u);
    }
}

TEST(Sideways, LeaveBehindWhomAWallStops) {
    World world = raft(ferryOf());
    putBlock(world, 5, 2, 1.0_u, 2.0_u);
    Player player = standing(world, 2.0_u, 2.5_u, 0.5_u);
    stepBothOften(world, player, kFerryPeriod / 2 - 2);
    EXPECT_EQ(bodyBox(player).east, 5.0_u);
    EXPECT_EQ(player.z, 0.5_u);
    stepBothOften(world, player, 2);
    EXPECT_EQ(world.movers[0].offset, 3.0_u);
}

TEST(Sideways, PushWhoStandsInTheirWay) {
    World world = raft(ferryOf());
    Player player = standing(world, 4.0_u, 2.5_u, {});
    stepBothOften(world, player, kFerryPeriod / 2);
    EXPECT_EQ(bodyBox(player).west, 6.0_u);
    EXPECT_EQ(world.movers[0].offset, 3.0_u);
}

TEST(Sideways, WaitForWhoHasNoRoom) {
    Motion motion = ferryOf();
    motion.to = 2.0_u;
    World world = emptyWorld(8, 8, 2);
    world.maps[0].setCell(1, 2, 0, addMoving(world, {}, 0.5_u, motion));
    putBlock(world, 4, 2, {}, 1.0_u);
    ASSERT_TRUE(makeMovers(world).empty());
    Player player = standing(world, 3.0_u, 2.5_u, {});
    stepBothOften(world, player, kFerryPeriod / 2);
    EXPECT_LE(bodyBox(player).east, 4.0_u);
    const Coordinate front = tileEdge(2) + world.movers[0].offset;
    EXPECT_LE(front, bodyBox(player).west);
    EXPECT_LT((4.0_u - front).value(),
              (bodyBox(player).east - bodyBox(player).west).value() + 0.05);
    const int clock = world.movers[0].clock;
    stepBothOften(world, player, kSecond);
    EXPECT_EQ(world.movers[0].clock, clock);
    player.y = 4.5_u;
    stepBothOften(world, player, kSecond);
    EXPECT_EQ(world.movers[0].clock, clock + kSecond);
}

TEST(Sideways, RestForEverAtTheirEndIfOnce) {
    Motion motion = ferryOf();
    motion.once = true;
    World world = raft(motion);
    stepAlone(world, kFerryPeriod / 2);
    EXPECT_EQ(world.movers[0].offset, 3.0_u);
    stepAlone(world, kFerryPeriod);
    EXPECT_EQ(world.movers[0].offset, 3.0_u);
    resetWorld(world);
    EXPECT_EQ(world.movers[0].offset, Coordinate{0});
}

TEST(Sideways, FaultsSayWhereTheyGo) {
    Motion motion = ferryOf();
    motion.to = 6.0_u;
    World world = emptyWorld(8, 8, 2);
    world.maps[0].setCell(2, 3, 1, addMoving(world, {}, 1.0_u, motion));
    std::vector<PlacingFault> faults = makeMovers(world);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].found, "the moving block \"moving 0\" that moves from x 2 to 9");
    EXPECT_EQ(faults[0].expected, "a motion that stays in the map, from x 0 to 8");
    EXPECT_EQ(faults[0].level, 1);

    world = emptyWorld(8, 8, 2);
    world.maps[0].setCell(2, 3, 0, addMoving(world, {}, 1.0_u, ferryOf(Axis::y)));
    putBlock(world, 2, 6, {}, 0.9_u);
    faults = makeMovers(world);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].found.find("in tile (2, 6)"), std::string::npos) << faults[0].found;

    world = emptyWorld(8, 8, 2);
    const BlueprintId narrow = addMoving(world, {}, 1.0_u, ferryOf());
    world.blueprints[narrow].plan.west = 0.25_u;
    world.maps[0].setCell(1, 3, 0, narrow);
    world.maps[0].setCell(2, 3, 0, narrow);
    faults = makeMovers(world);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].found.find("a gap between its parts"), std::string::npos);
}

// A door of one tile, thin, whose western edge goes east when it opens.
World slidingDoor(const GateKind& kind) {
    Motion motion = ferryOf();
    motion.edges = MovingEdges::low;
    motion.to = 1.0_u;
    motion.periodSteps = 0;
    World world = emptyWorld(8, 8, 2);
    const BlueprintId door = addMoving(world, {}, 1.0_u, motion);
    world.blueprints[door].plan = {{}, 0.4_u, tileEdge(1), 0.6_u};
    world.blueprints[door].gate = 0;
    world.gateKinds.push_back(kind);
    world.maps[0].setCell(3, 3, 0, door);
    EXPECT_TRUE(makeMovers(world).empty());
    EXPECT_TRUE(makeGates(world).empty());
    return world;
}

TEST(MovingGates, OpenAndCloseByTheKey) {
    World world = slidingDoor({.steps = 120});
    Player player = standing(world, 3.5_u, 4.5_u, {});
    EXPECT_EQ(gateOffer(world, asks(player, GateAsk::Wish::nothing)), GateOffer::open);
    stepBothOften(world, player, 60, asks(player, GateAsk::Wish::change));
    const BlueprintId part = world.maps[0].cells[world.maps[0].cellIndex(3, 3, 0)];
    EXPECT_EQ(world.blueprints[part].plan.west, 0.5_u);
    EXPECT_EQ(world.blueprints[part].textureEast, 0.5_u);
    EXPECT_FALSE(world.blueprints[part].passable);
    stepBothOften(world, player, 60);
    EXPECT_FALSE(world.maps[0].isOccupied(3, 3, 0));
    stepBothOften(world, player, 60, asks(player, GateAsk::Wish::close));
    EXPECT_EQ(world.blueprints[part].plan.west, 0.5_u);
    resetWorld(world);
    EXPECT_EQ(world.blueprints[part].plan.west, Coordinate{0});
    EXPECT_TRUE(world.maps[0].isOccupied(3, 3, 0));
}

TEST(MovingGates, PushOrWaitWhenTheyClose) {
    World world = slidingDoor({.steps = 120, .startsOpen = true});
    EXPECT_FALSE(world.maps[0].isOccupied(3, 3, 0));
    Player player = standing(world, 3.5_u, 3.5_u, {});
    stepBothOften(world, player, 240, asks(player, GateAsk::Wish::close));
    EXPECT_EQ(world.gates[0].progress, 0);
    EXPECT_EQ(bodyBox(player).east, 3.0_u);

    world = slidingDoor({.steps = 120, .startsOpen = true});
    putBlock(world, 2, 3, {}, 1.0_u);
    player = standing(world, 3.5_u, 3.5_u, {});
    stepBothOften(world, player, 240, asks(player, GateAsk::Wish::close));
    EXPECT_GT(world.gates[0].progress, 0);
    EXPECT_LT((bodyBox(player).west - 3.0_u).value(), 0.05);
    player.y = 5.5_u;
    stepBothOften(world, player, 240);
    EXPECT_EQ(world.gates[0].progress, 0);
}

TEST(MovingGates, NeverCloseAgainIfOnce) {
    World world = slidingDoor({.steps = 10, .once = true});
    Player player = standing(world, 3.5_u, 4.5_u, {});
    stepBothOften(world, player, 20, asks(player, GateAsk::Wish::open));
    EXPECT_EQ(gateOffer(world, asks(player, GateAsk::Wish::nothing)), GateOffer::none);
    stepBothOften(world, player, 20, asks(player, GateAsk::Wish::close));
    EXPECT_EQ(world.gates[0].progress, 10);
    EXPECT_TRUE(world.gates[0].wantsOpen);
}

TEST(MovingGates, OpenByThemselvesSoOften) {
    World world = slidingDoor({.steps = 10, .keyed = false, .holdSteps = 20, .everySteps = 100});
    int opened = 0;
    int openSteps = 0;
    for (int step = 1; step <= 1000; ++step) {
        const int before = world.gates[0].progress;
        stepAlone(world, 1);
        opened += before != 10 && world.gates[0].progress == 10;
        openSteps += world.gates[0].progress == 10;
        if (step == 99 || step == 109) {
            EXPECT_EQ(world.gates[0].progress, step == 99 ? 0 : 10);
        }
    }
    EXPECT_EQ(opened, 9);
    EXPECT_NEAR(openSteps / 9, 20, 2);
}

TEST(MovingGates, FollowSwitches) {
    World world = slidingDoor({.steps = 10, .keyed = false});
    world.gateKinds[0].follows = {1, 2};
    for (int i = 0; i < 2; ++i) {
        const BlueprintId lever = addGate(world, {.steps = 5, .reach = 1.0_u});
        world.maps[0].setCell(6, 1 + 5 * i, 0, lever);
    }
    world.gates.clear();
    ASSERT_TRUE(makeGates(world).empty());
    ASSERT_EQ(world.gates.size(), 3u);
    Player first = standing(world, 5.5_u, 1.5_u, {});
    stepBothOften(world, first, 4, asks(first, GateAsk::Wish::change));
    EXPECT_FALSE(world.gates[0].wantsOpen);
    stepBothOften(world, first, 30);
    EXPECT_EQ(world.gates[0].progress, 10);
    Player second = standing(world, 5.5_u, 6.5_u, {});
    stepBothOften(world, second, 10, asks(second, GateAsk::Wish::change));
    stepBothOften(world, first, 30, asks(first, GateAsk::Wish::change));
    EXPECT_EQ(world.gates[0].progress, 10) << "one of two is open";
    stepBothOften(world, second, 30, asks(second, GateAsk::Wish::change));
    EXPECT_EQ(world.gates[0].progress, 0);
}

}  // namespace
}  // namespace slicecast
