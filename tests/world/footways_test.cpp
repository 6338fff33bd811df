// Where a player gets to on foot: no further than this, and all of it.
#include "moving.h"
#include "portal_worlds.h"
#include "world_builder.h"

#include "sanitized.h"
#include "world/footways.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

Box tileBox(int x, int y) {
    return {tileEdge(x), tileEdge(x + 1), tileEdge(y), tileEdge(y + 1), {}, kMaxBodyHeight};
}

bool getsTo(const World& world, int x, int y, int map = 0) {
    return Footways(world).comesInto(map, tileBox(x, y));
}

// A corridor along row 0, from tile 0 on.
World hallway(int length, int levels = 4) {
    World world = emptyWorld(length, 1, levels);
    world.start.x = 0.5_u;
    world.start.y = 0.5_u;
    return world;
}

TEST(Footways, ClimbAsHighAsAJump) {
    for (const auto& [top, isReached] : {std::pair{0.75_u, true}, {0.81_u, false}}) {
        World world = hallway(3);
        putBlock(world, 1, 0, {}, top);
        EXPECT_EQ(getsTo(world, 1, 0), isReached) << top.value();
        EXPECT_EQ(getsTo(world, 2, 0), isReached);
    }
}

// Both tiles are as near from the side; the step is nearer from below.
TEST(Footways, TellTheNearestPlace) {
    World world = hallway(4);
    putBlock(world, 1, 0, {}, 0.75_u);
    for (const int level : {0, 1, 2, 3})
        putBlock(world, 2, 0, tileEdge(level), tileEdge(level + 1));
    const Footways ways(world);
    const auto place = ways.nearestTo(0, {0.9_u, 1.1_u, {}, 1.0_u, 2.0_u, 3.0_u});
    ASSERT_TRUE(place);
    EXPECT_EQ(place->x, 1);
    EXPECT_EQ(place->y, 0);
    EXPECT_EQ(place->feet, 0.75_u);
    const auto behindWall = ways.nearestTo(0, tileBox(3, 0));
    ASSERT_TRUE(behindWall);
    EXPECT_EQ(behindWall->x, 1);
    EXPECT_FALSE(Footways(world).comesInto(0, tileBox(3, 0)));
}

TEST(Footways, NeedRoomForACrouchedBody) {
    for (const auto& [bottom, isReached] : {std::pair{0.36_u, true}, {0.34_u, false}}) {
        World world = hallway(3, 1);
        putBlock(world, 1, 0, bottom, 1.0_u);
        putCeiling(world, 1.0_u);
        EXPECT_EQ(getsTo(world, 2, 0), isReached) << bottom.value();
    }
}

// A pit of which one does not get out again.
TEST(Footways, JumpOverAGap) {
    for (const auto& [gap, isReached] : {std::pair{4, true}, {6, false}}) {
        World world = hallway(gap + 2);
        world.start.z = 2.0_u;
        for (const int x : {0, gap + 1}) {
            putBlock(world, x, 0, {}, 1.0_u);
            putBlock(world, x, 0, 1.0_u, 2.0_u);
        }
        EXPECT_EQ(getsTo(world, gap + 1, 0), isReached) << gap;
        EXPECT_TRUE(getsTo(world, 2, 0)) << "down there";
    }
}

TEST(Footways, StopAtThinAndDiagonalWalls) {
    World world = hallway(4, 1);
    putCeiling(world, 1.0_u);
    putBlock(world, 2, 0, {}, 1.0_u);
    CellBlueprint& wall = world.blueprints.back();
    world.hasPlans = true;
    EXPECT_FALSE(getsTo(world, 3, 0));
    wall.plan.east = 0.125_u;
    EXPECT_FALSE(getsTo(world, 3, 0));
    wall.plan.east = 1.0_u;
    wall.plan.west = 0.875_u;
    EXPECT_FALSE(getsTo(world, 3, 0));
    wall.plan = kWholeTile;
    wall.plan.half = Half::northEast;
    EXPECT_FALSE(getsTo(world, 3, 0));
    wall.plan = kWholeTile;
    wall.plan.south = 0.125_u;
    EXPECT_TRUE(getsTo(world, 3, 0)) << "beside the way";
    wall.plan = kWholeTile;
    wall.plan.east = 0.125_u;
    wall.bottom = 0.5_u;
    EXPECT_TRUE(getsTo(world, 3, 0)) << "under it";
}

TEST(Footways, WalkUpRampsThatAreNotSteep) {
    for (const auto& [top, isReached] : {std::pair{0.75_u, true}, {0.9_u, false}}) {
        World world = hallway(4);
        putBlock(world, 1, 0, {}, top);
        world.blueprints.back().slopes = slopesTo(Face::east, {}, {0.0_u, top});
        putBlock(world, 2, 0, {}, 1.0_u);
        putBlock(world, 3, 0, {}, 1.0_u);
        putBlock(world, 3, 0, 1.0_u, 1.5_u);
        EXPECT_EQ(getsTo(world, 3, 0), isReached) << top.value();
    }
}

TEST(Footways, SwimAndClimbOut) {
    World world = hallway(4);
    putBlock(world, 2, 0, {}, 1.0_u);
    putBlock(world, 3, 0, {}, 1.0_u);
    EXPECT_FALSE(getsTo(world, 3, 0));
    putBlock(world, 1, 0, {}, 0.75_u);
    world.blueprints.back().isWater = true;
    EXPECT_TRUE(getsTo(world, 3, 0));
}

TEST(Footways, RideOnLifts) {
    for (const auto& [to, isReached] : {std::pair{2.0_u, true}, {0.9_u, false}}) {
        World world = hallway(4);
        for (const int x : {2, 3}) {
            putBlock(world, x, 0, {}, 1.0_u);
            putBlock(world, x, 0, 1.0_u, 2.0_u);
        }
        Motion motion;
        motion.to = to;
        motion.periodSteps = 480;
        world.maps[0].setCell(1, 0, 0, addMoving(world, {}, 0.25_u, motion));
        ASSERT_TRUE(makeMovers(world).empty());
        EXPECT_EQ(getsTo(world, 3, 0), isReached) << to.value();
    }
}

// West to east: the start, a gate, a room, another gate, a room.
World twoGates(const GateKind& first, const GateKind& second) {
    World world = hallway(9, 1);
    putCeiling(world, 1.0_u);
    const BlueprintId one = addGate(world, first);
    const BlueprintId two = addGate(world, second);
    world.maps[0].setCell(3, 0, 0, one);
    world.maps[0].setCell(6, 0, 0, two);
    EXPECT_TRUE(makeGates(world).empty());
    return world;
}

void putFind(World& world, int x) {
    Object& object = world.maps[0].objects.emplace_back();
    object.x = tileEdge(x) + 0.5_u;
    object.y = 0.5_u;
    object.width = 0.2_u;
    object.height = 0.3_u;
    world.quest.kinds.resize(1);
    world.quest.finds.emplace_back().object = static_cast<int>(world.maps[0].objects.size()) - 1;
}

TEST(Footways, GoThroughGatesThatOpen) {
    EXPECT_TRUE(getsTo(twoGates({}, {}), 8, 0));
    EXPECT_FALSE(getsTo(twoGates({.keyed = false}, {}), 4, 0));
    EXPECT_TRUE(getsTo(twoGates({.keyed = false, .everySteps = 9}, {}), 4, 0));
    EXPECT_TRUE(getsTo(twoGates({.keyed = false, .startsOpen = true}, {}), 8, 0));
    EXPECT_TRUE(getsTo(twoGates({.keyed = false, .opensOnApproach = true}, {}), 8, 0));
    EXPECT_FALSE(getsTo(twoGates({.reach = 0.5_u, .keyed = false, .follows = {1}}, {}), 4, 0))
        << "what it follows is behind it";
    EXPECT_TRUE(getsTo(twoGates({.keyed = false, .follows = {1}}, {.reach = 6.0_u}), 8, 0));
}

TEST(Footways, TakeFindsForGates) {
    const GateKind locked = {.needs = {.any = 1}};
    World world = twoGates({}, locked);
    putFind(world, 8);
    EXPECT_FALSE(Footways(world).takes(0)) << "behind the gate that needs it";
    EXPECT_FALSE(getsTo(world, 8, 0));
    EXPECT_TRUE(Footways(world).isMet(world.gates[1]));
    putFind(world, 4);
    EXPECT_TRUE(Footways(world).takes(0));
    EXPECT_TRUE(getsTo(world, 8, 0));
    world.gateKinds[1].needs = {.kinds = {{0, 2}}};
    EXPECT_FALSE(getsTo(world, 8, 0)) << "the second is behind it";
    world.movingObjects.motions.emplace_back().object = 0;
    EXPECT_TRUE(getsTo(world, 8, 0)) << "it comes by itself";
}

TEST(Footways, ReachFindsWithinAJump) {
    for (const auto& [z, isReached] : {std::pair{1.4_u, true}, {1.6_u, false}}) {
        World world = hallway(3);
        putFind(world, 1);
        world.maps[0].objects[0].z = z;
        EXPECT_EQ(Footways(world).takes(0), isReached) << z.value();
    }
}

TEST(Footways, GoThroughPortals) {
    World world = hallway(4);
    world.maps.push_back(makeMap("other", 3, 3, 4, world.maps[0].floor.texture));
    EXPECT_FALSE(getsTo(world, 2, 2, 1));
    World tiled = world.copy();
    putTilePortal(tiled, {.fromX = 2, .fromY = 0, .toMap = 1, .toX = 1, .toY = 1, .levels = 1});
    EXPECT_TRUE(getsTo(tiled, 2, 2, 1));
    EXPECT_FALSE(getsTo(tiled, 3, 0)) << "behind it";

    putBlock(world, 2, 0, {}, 1.0_u);
    World wrong = world.copy();
    const Portal portal = {.fromX = 2, .fromY = 0, .toMap = 1, .toX = 1, .toY = 1};
    putFacePortal(world, portal, 0, Face::west);
    EXPECT_TRUE(getsTo(world, 2, 2, 1));
    putFacePortal(wrong, portal, 0, Face::east);
    EXPECT_FALSE(getsTo(wrong, 2, 2, 1));
}

// Wishes of a player who keeps to the ground.
PlayerInput wishOnFoot(Random& random) {
    PlayerInput input;
    input.forward = random.oneIn(6) ? 0.0 : 1.0;
    input.strafe = random.oneIn(3) ? random.between(-1.0, 1.0) : 0.0;
    input.turnDegrees = random.between(-180.0, 180.0);
    input.fly = random.oneIn(4) ? random.between(-1.0, 1.0) : 0.0;
    input.jump = random.oneIn(2);
    input.fast = random.oneIn(2);
    return input;
}

// Portals of some tiles and of some faces, to anywhere.
void addPortals(World& world, Random& random) {
    const Map& map = world.maps[0];
    for (int i = 0; i < 6; ++i) {
        const int x = random.below(map.width);
        const int y = random.below(map.depth);
        const int level = random.below(map.levels);
        const int face = random.below(kFaces);
        Portal portal = {.fromX = x, .fromY = y};
        portal.toX = random.below(map.width);
        portal.toY = random.below(map.depth);
        portal.turn = random.below(4);
        portal.levels = random.between(-1, 1);
        const bool isOfTile = random.oneIn(2);
        if (isOfTile && map.tilePortal(x, y) == kNoPortal) putTilePortal(world, portal);
        const BlueprintId id = map.cell(x, y, level);
        if (!isOfTile && id != kEmptyCell && world.blueprints[id].isBox() &&
            !world.blueprints[id].isWater)
            putFacePortal(world, portal, level, static_cast<Face>(face));
    }
}

// Whoever walks, jumps and swims at random stays on the ways.
TEST(Footways, MissNothing) {
    constexpr int kWorlds = kSanitized ? 60 : 150;
    int cells = 0;
    int reached = 0;
    int leaps = 0;
    for (int seed = 1; seed <= kWorlds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) << 24);
        const auto number = static_cast<std::uint64_t>(seed);
        World world = seed % 3 == 0 ? randomWaterWorld(number) : randomWorld(number);
        if (seed % 3 == 1) addPortals(world, random);
        markPlans(world);
        markPortals(world);
        Player player;
        if (!placeRandomly(world, random, player)) continue;
        setFlying(world, player, false);
        if (player.flying || !isFree(world, travellerOf(player))) continue;
        world.start = {.x = player.x, .y = player.y, .z = player.z};
        const Footways ways(world);
        const auto isOn = [&](const Player& there) {
            Box eye = tileBox(there.x.tile(), there.y.tile());
            eye.bottom = eye.top = eyeHeight(there);
            return ways.comesInto(there.map, eye);
        };
        PlayerInput input;
        for (int step = 0; step < 1200; ++step) {
            if (step % 40 == 0) input = wishOnFoot(random);
            stepPlayer(world, player, input);
            input.turnDegrees = 0.0;
            ASSERT_TRUE(isOn(player))
                << "seed " << seed << ", step " << step << ": " << player.x.value() << ", "
                << player.y.value() << ", " << player.z.value();
        }
        leaps += player.leaps;
        for (int y = 0; y < world.maps[0].depth; ++y) {
            for (int x = 0; x < world.maps[0].width; ++x) {
                for (int level = 0; level < world.maps[0].levels; ++level) {
                    Box cell = tileBox(x, y);
                    cell.bottom = cell.top = tileEdge(level) + 0.5_u;
                    ++cells;
                    reached += ways.comesInto(0, cell);
                }
            }
        }
    }
    EXPECT_GT(leaps, kWorlds / 4);
    EXPECT_LT(reached, cells / 10 * 9) << "a part of the worlds is out of reach";
}

}  // namespace
}  // namespace slicecast
