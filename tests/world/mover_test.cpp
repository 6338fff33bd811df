// Moving blocks: where they are at each step, whom they carry, and whom they wait for.
#include "moving.h"

#include "base/random.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

// Up 2 units in 4 seconds and down again.
constexpr int kPeriod = 8 * kSecond;
Motion lift(MotionShape shape = MotionShape::smooth) {
    return {.name = "lift",
            .edges = MovingEdges::both,
            .from = {},
            .to = 2.0_u,
            .periodSteps = kPeriod,
            .phaseSteps = 0,
            .shape = shape};
}

// A platform of half a block's height in the middle of a room, which moves in this way.
World platform(const Motion& motion, Coordinate bottom = {}, Coordinate top = 0.5_u,
               int levels = 4) {
    World world = emptyWorld(5, 5, levels);
    world.maps[0].setCell(2, 2, 0, addMoving(world, bottom, top, motion));
    EXPECT_TRUE(makeMovers(world).empty());
    return world;
}

void stepWorldAlone(World& world, int steps = 1) {
    for (int i = 0; i < steps; ++i) stepWorld(world, {}, {});
}

// Of the blocks of a column, which touch each other: lowest and highest point. Both 0 where there
// is none.
std::pair<Coordinate, Coordinate> extentAt(const World& world, int x, int y) {
    const Map& map = world.maps[0];
    Coordinate low;
    Coordinate high;
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId id = map.cell(x, y, level);
        if (id == kEmptyCell) continue;
        const CellBlueprint& block = world.blueprints[id];
        EXPECT_LT(block.bottom, block.top);
        EXPECT_GE(block.bottom.raw, 0);
        EXPECT_LE(block.top, tileEdge(1));
        if (high > Coordinate{0}) {
            EXPECT_EQ(high, tileEdge(level) + block.bottom);
        } else {
            low = tileEdge(level) + block.bottom;
        }
        high = tileEdge(level) + block.top;
    }
    return {low, high};
}

TEST(Motion, GoesToAndFroWithinItsPeriod) {
    for (const MotionShape shape :
         {MotionShape::smooth, MotionShape::even, MotionShape::stopAndGo}) {
        Motion motion = lift(shape);
        motion.from = toCoordinate(-0.25);
        EXPECT_EQ(offsetAt(motion, 0), motion.from);
        EXPECT_EQ(offsetAt(motion, kPeriod / 2), motion.to);
        EXPECT_EQ(offsetAt(motion, kPeriod), motion.from);
        const double limit = fastestSpeed(shape, 2.25, 8.0) / kSecond;
        double fastest = 0.0;
        for (int step = 0; step < kPeriod / 2; ++step) {
            const double way = (offsetAt(motion, step + 1) - offsetAt(motion, step)).value();
            EXPECT_GE(way, 0.0);
            fastest = std::max(fastest, way);
            EXPECT_EQ(offsetAt(motion, step), offsetAt(motion, kPeriod - step));
        }
        EXPECT_LE(fastest, limit + 0.0001);
        EXPECT_GE(fastest, limit * 0.99);
        motion.phaseSteps = kPeriod / 2;
        EXPECT_EQ(offsetAt(motion, 0), motion.to);
        EXPECT_EQ(offsetAt(motion, 7 * kPeriod), motion.to);
    }
}

TEST(Motion, HasItsShape) {
    EXPECT_EQ(offsetAt(lift(MotionShape::even), kPeriod / 8), 0.5_u);
    EXPECT_EQ(offsetAt(lift(MotionShape::smooth), kPeriod / 4), 1.0_u);
    EXPECT_EQ(offsetAt(lift(MotionShape::smooth), kPeriod / 8),
              toCoordinate(2.0 * (3.0 / 16.0 - 2.0 / 64.0)));
    for (const int rest : {0, kPeriod / 8, kPeriod * 7 / 8})
        EXPECT_EQ(offsetAt(lift(MotionShape::stopAndGo), rest), Coordinate{0}) << rest;
    for (const int rest : {kPeriod * 3 / 8, kPeriod / 2, kPeriod * 5 / 8})
        EXPECT_EQ(offsetAt(lift(MotionShape::stopAndGo), rest), 2.0_u) << rest;
    EXPECT_EQ(offsetAt(lift(MotionShape::stopAndGo), kPeriod / 4), 1.0_u);
}

// By whole numbers: the offset is the raw number nearest to from + (to - from) * 2 * at / period,
// halves going up.
TEST(Motion, IsRoundedOnce) {
    Random random(77);
    for (int i = 0; i < 20000; ++i) {
        Motion motion = lift(MotionShape::even);
        motion.from = {random.between(-100000, 100000)};
        motion.to = {random.between(-100000, 100000)};
        motion.periodSteps = random.between(2, 5000);
        motion.phaseSteps = random.below(motion.periodSteps);
        const int steps = random.below(motion.periodSteps);
        const std::int64_t period = motion.periodSteps;
        const std::int64_t at = (steps + motion.phaseSteps) % period;
        const std::int64_t way =
            2 * std::min(at, period - at) * (std::int64_t{motion.to.raw} - motion.from.raw);
        const std::int64_t off =
            std::int64_t{offsetAt(motion, steps).raw - motion.from.raw} * period - way;
        ASSERT_GT(2 * off, -period) << i;
        ASSERT_LE(2 * off, period) << i;
    }
}

// `part` is a third here: 3 / 9 - 2 / 27 = 7 / 27, and what stops and goes is at q = 1 / 6.
TEST(Motion, IsRoundedOnceInEveryShape) {
    Motion motion = lift(MotionShape::smooth);
    motion.periodSteps = 6;
    EXPECT_EQ(offsetAt(motion, 1), toCoordinate(2.0 * 7.0 / 27.0));
    motion.shape = MotionShape::stopAndGo;
    EXPECT_EQ(offsetAt(motion, 1), toCoordinate(2.0 * (3.0 / 36.0 - 2.0 / 216.0)));
    motion.shape = MotionShape::even;
    EXPECT_EQ(offsetAt(motion, 1), toCoordinate(2.0 / 3.0));
}

TEST(Movers, AreAtTheirMotionsPlaceOnAllLevels) {
    for (const MovingEdges edges : {MovingEdges::both, MovingEdges::high, MovingEdges::low}) {
        Motion motion = lift();
        motion.edges = edges;
        if (edges == MovingEdges::low) motion.to = 0.75_u;  // past its top: gone for a while
        if (edges == MovingEdges::high) motion.from = toCoordinate(-0.6);
        World world = platform(motion);
        for (int step = 0; step <= 2 * kPeriod; ++step) {
            const Coordinate offset = offsetAt(motion, step);
            const Coordinate low = edges == MovingEdges::high ? Coordinate{0} : offset;
            const Coordinate high = edges == MovingEdges::low ? 0.5_u : 0.5_u + offset;
            const auto [seenLow, seenHigh] = extentAt(world, 2, 2);
            if (low < high) {
                ASSERT_EQ(seenLow, low) << step;
                ASSERT_EQ(seenHigh, high) << step;
                const int level = high.raw > 65536 ? 1 : 0;
                const CellBlueprint& part = world.blueprints[world.maps[0].cell(2, 2, level)];
                ASSERT_EQ(part.textureRise, Coordinate{offset.raw & 0xffff}) << step;
            } else {
                ASSERT_EQ(seenHigh, Coordinate{0}) << step;
                ASSERT_EQ(world.maps[0].occupied[world.maps[0].tileIndex(2, 2)], 0u);
            }
            stepWorldAlone(world);
        }
    }
}

TEST(Movers, OfTouchingCellsAreOne) {
    World world = emptyWorld(8, 3, 5);
    Map& map = world.maps[0];
    const BlueprintId id = addMoving(world, {}, 1.0_u, lift());
    for (const int x : {1, 2}) map.setCell(x, 1, 0, id);  // two side by side
    map.setCell(2, 1, 1, id);                             // one of them two high
    map.setCell(5, 1, 1, id);                             // another, alone
    EXPECT_TRUE(makeMovers(world).empty());
    ASSERT_EQ(world.movers.size(), 2u);
    EXPECT_EQ(world.movers[0].shafts.size(), 2u);
    EXPECT_EQ(world.movers[1].shafts.size(), 1u);
    stepWorldAlone(world, kPeriod / 4);
    EXPECT_EQ(extentAt(world, 1, 1), std::pair(1.0_u, 2.0_u));
    EXPECT_EQ(extentAt(world, 2, 1), std::pair(1.0_u, 3.0_u));
    EXPECT_EQ(extentAt(world, 5, 1), std::pair(2.0_u, 3.0_u));
    const int mover = world.blueprints[map.cell(1, 1, 1)].mover;
    EXPECT_GE(mover, 0);
    EXPECT_EQ(world.blueprints[map.cell(2, 1, 1)].mover, mover);
    EXPECT_EQ(world.blueprints[map.cell(2, 1, 2)].mover, mover);
    EXPECT_NE(world.blueprints[map.cell(5, 1, 2)].mover, mover);
    // Tiles of one shaft share their blueprints.
    World wide = emptyWorld(8, 3, 5);
    const BlueprintId plate = addMoving(wide, {}, 1.0_u, lift());
    for (int x = 1; x < 7; ++x) wide.maps[0].setCell(x, 1, 0, plate);
    EXPECT_TRUE(makeMovers(wide).empty());
    EXPECT_EQ(wide.blueprints.size(), 2u + 3u);
}

TEST(Movers, MoveInEveryMap) {
    World world = emptyWorld(3, 3, 4);
    world.maps.push_back(world.maps[0]);
    const BlueprintId id = addMoving(world, {}, 0.5_u, lift());
    for (Map& map : world.maps) map.setCell(1, 1, 0, id);
    EXPECT_TRUE(makeMovers(world).empty());
    Body body = {.map = 0, .box = bodyBox(0.5_u, 0.5_u, {}, kStandingHeight), .rides = true};
    for (int i = 0; i < kPeriod / 2; ++i) stepWorld(world, {&body, 1}, {});
    for (const Map& map : world.maps) {
        EXPECT_EQ(map.cell(1, 1, 0), kEmptyCell);
        EXPECT_NE(map.cell(1, 1, 2), kEmptyCell);
    }
}

TEST(Movers, AreRefusedIfTheyCannotMove) {
    const auto faultOf = [](World world) {
        const std::vector<PlacingFault> faults = makeMovers(world);
        return faults.size() == 1 ? faults[0].found + " at " + std::to_string(faults[0].x) + " " +
                                        std::to_string(faults[0].y) + " " +
                                        std::to_string(faults[0].level) + ": " + faults[0].expected
                                  : std::to_string(faults.size()) + " faults";
    };
    World low = emptyWorld(5, 5, 2);
    low.maps[0].setCell(2, 3, 0, addMoving(low, {}, 0.5_u, lift()));
    EXPECT_EQ(faultOf(low.copy()),
              "the moving block \"moving 0\" that moves from height 0 to 2.5 at 2 3 0: a motion "
              "that stays between 0 and the map's 2 levels");
    World deep = emptyWorld(5, 5, 4);
    Motion down = lift();
    down.from = toCoordinate(-0.25);
    deep.maps[0].setCell(2, 3, 0, addMoving(deep, {}, 0.5_u, down));
    EXPECT_EQ(faultOf(deep.copy()),
              "the moving block \"moving 0\" that moves from height -0.25 to 2.5 at 2 3 0: a "
              "motion that stays between 0 and the map's 4 levels");
    World into = emptyWorld(5, 5, 4);
    into.maps[0].setCell(2, 3, 0, addMoving(into, {}, 0.5_u, lift()));
    into.blueprints.push_back({});
    into.blueprints.back().name = "wall";
    into.maps[0].setCell(2, 3, 2, 2);
    EXPECT_EQ(faultOf(into.copy()),
              "the moving block \"moving 0\" that runs into \"wall\" on level 2 at 2 3 0: empty "
              "cells wherever it moves");
    World two = emptyWorld(5, 5, 5);
    const BlueprintId id = addMoving(two, {}, 0.5_u, lift());
    two.maps[0].setCell(2, 3, 0, id);
    two.maps[0].setCell(2, 3, 2, id);
    EXPECT_EQ(faultOf(two.copy()),
              "the moving block \"moving 0\" that runs into \"moving 0\" on level 2 at 2 3 0: "
              "empty cells wherever it moves");
    two.maps[0].setCell(2, 3, 2, kEmptyCell);
    Motion upside = lift();
    upside.from = toCoordinate(-2.0);
    upside.to = {};
    two.maps[0].setCell(2, 3, 4, addMoving(two, {}, 0.5_u, upside));
    EXPECT_EQ(faultOf(two.copy()),
              "the moving block \"moving 1\" that runs into \"moving 0\" on level 2 at 2 3 4: "
              "moving blocks that do not reach each other");
    World gap = emptyWorld(5, 5, 5);
    const BlueprintId half = addMoving(gap, {}, 0.5_u, lift());
    gap.maps[0].setCell(2, 3, 0, half);
    gap.maps[0].setCell(2, 3, 1, half);
    EXPECT_EQ(faultOf(gap.copy()),
              "the moving block \"moving 0\" stacked with a gap between its parts at 2 3 0: a "
              "bottom of 0 and a top of 1 where moving blocks are stacked");
    World never = emptyWorld(5, 5, 5);
    Motion hidden = lift();
    hidden.edges = MovingEdges::high;
    hidden.from = toCoordinate(-1.0);
    hidden.to = toCoordinate(-0.5);
    never.maps[0].setCell(2, 3, 0, addMoving(never, {}, 0.5_u, hidden));
    EXPECT_EQ(faultOf(never.copy()),
              "the moving block \"moving 0\" whose top never gets above its bottom at 2 3 0: a "
              "motion during which the block is visible");
}

// On every other tile, as on a chess board, so that none touches another.
World manyLifts(double reach) {
    World world = emptyWorld(150, 150, 12);
    Motion motion = lift();
    motion.to = toCoordinate(reach);
    const BlueprintId id = addMoving(world, {}, 0.5_u, motion);
    for (int x = 0; x < 150; ++x) {
        for (int y = x % 2; y < 150; y += 2) world.maps[0].setCell(x, y, 0, id);
    }
    return world;
}

TEST(Movers, AreLimitedByTheirParts) {
    World world = manyLifts(9.0);
    const std::size_t before = world.blueprints.size();
    std::vector<PlacingFault> faults = makeMovers(world);
    ASSERT_EQ(faults.size(), kMaxPlacingFaults);
    EXPECT_EQ(faults[0].found, "more than 32768 parts of moving blocks");
    EXPECT_EQ(faults[0].expected, "fewer moving blocks and gates, or fewer levels that they reach");
    EXPECT_LE(world.blueprints.size(), before + kMaxMoverParts);

    // With many blueprints of their own
    world = manyLifts(3.0);
    world.blueprints.resize(kMaxBlueprints - 1000, world.blueprints[0]);
    faults = makeMovers(world);
    ASSERT_FALSE(faults.empty());
    EXPECT_NE(faults[0].found.find("whose parts make more than 65535 blueprints"),
              std::string::npos);
    EXPECT_LE(world.blueprints.size(), static_cast<std::size_t>(kMaxBlueprints));
}

TEST(Movers, AreLimitedByTheirNumber) {
    World world = manyLifts(0.25);
    const std::vector<PlacingFault> faults = makeMovers(world);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].expected, "at most 8192 in a scene");
    EXPECT_EQ(world.movers.size(), kMaxMovers);
}

// ---- riders

TEST(Riders, FollowTheirMoverExactly) {
    for (const MotionShape shape :
         {MotionShape::smooth, MotionShape::even, MotionShape::stopAndGo}) {
        for (const MovingEdges edges : {MovingEdges::both, MovingEdges::high}) {
            Motion motion = lift(shape);
            motion.edges = edges;
            Walker rider(platform(motion), 2.5, 2.5, 0.5);
            for (int step = 1; step <= 2 * kPeriod; ++step) {
                stepBoth(rider.world, rider.player);
                ASSERT_EQ(rider.player.z, 0.5_u + offsetAt(motion, step)) << step;
                ASSERT_EQ(eyeHeight(rider.player), rider.player.z + kStandingEye) << step;
                ASSERT_TRUE(rider.player.onGround);
            }
        }
    }
}

TEST(Riders, WalkOnAndOffAMover) {
    World world = emptyWorld(7, 3, 4);
    const BlueprintId id = addMoving(world, {}, 0.5_u, lift());
    for (const int x : {2, 3, 4}) world.maps[0].setCell(x, 1, 0, id);
    EXPECT_TRUE(makeMovers(world).empty());
    Walker rider(std::move(world), 2.3, 1.5, 0.5);
    for (int step = 1; step <= kPeriod / 4; ++step) {
        stepBoth(rider.world, rider.player, {.forward = 1.0, .slow = true});
        const bool isOnIt = rider.x() < 5.2;
        ASSERT_TRUE(!isOnIt || rider.player.z == 0.5_u + offsetAt(lift(), step)) << step;
    }
    EXPECT_GT(rider.x(), 4.0);
    for (int step = 0; step < kPeriod / 4; ++step) stepBoth(rider.world, rider.player, kAhead);
    EXPECT_EQ(rider.z(), 0.0);
    EXPECT_GT(rider.x(), 6.0);
}

TEST(Riders, JumpFromAMoverAndLandOnIt) {
    Walker rider(platform(lift(MotionShape::even)), 2.5, 2.5, 0.5);
    bool flew = false;
    for (int step = 1; step <= kSecond * 3; ++step) {
        stepBoth(rider.world, rider.player, {.jump = step == 60});
        flew = flew || rider.player.z > 0.5_u + offsetAt(lift(MotionShape::even), step) + 0.3_u;
    }
    EXPECT_TRUE(flew);
    EXPECT_EQ(rider.player.z, 0.5_u + offsetAt(lift(MotionShape::even), kSecond * 3));
    EXPECT_TRUE(rider.player.onGround);
}

TEST(Riders, FlyersArePushedUpButNotTakenDown) {
    Walker flyer(platform(lift()), 2.5, 2.5, 0.5);
    setFlying(flyer.world, flyer.player, true);
    flyer.player.z = 0.75_u;
    flyer.player.eyeLag = {};
    for (int step = 0; step < kPeriod; ++step) stepBoth(flyer.world, flyer.player);
    EXPECT_EQ(flyer.player.z, 2.5_u);
}

TEST(Riders, StayOnStillGroundBesideAMover) {
    // Half on the platform, half on a block of its height.
    World world = emptyWorld(5, 5, 4);
    putBlock(world, 3, 2, {}, 0.5_u);
    Motion motion = lift();
    motion.to = toCoordinate(-0.5);
    world.maps[0].setCell(2, 2, 0, addMoving(world, 0.5_u, 0.5_u + kTiny, motion));
    EXPECT_TRUE(makeMovers(world).empty());
    Walker rider(std::move(world), 3.0, 2.5, 0.5 + kTiny.value());
    for (int step = 0; step < kPeriod / 2; ++step) stepBoth(rider.world, rider.player);
    EXPECT_EQ(rider.z(), 0.5);
}

// A block that grows out of the floor and fills only a half of its tile, or a strip, lifts nobody
// beside it.
TEST(Riders, StayOnTheGroundBesideAPartOfATile) {
    Plan half;
    half.half = Half::southWest;
    Plan strip;
    strip.south = 0.5_u;
    Motion motion = lift();
    motion.edges = MovingEdges::high;
    motion.from = toCoordinate(-0.5);
    for (const Plan& plan : {half, strip}) {
        World world = emptyWorld(5, 5, 4);
        const BlueprintId id = addMoving(world, {}, 0.5_u, motion);
        world.blueprints[id].plan = plan;
        world.maps[0].setCell(2, 2, 0, id);
        EXPECT_TRUE(makeMovers(world).empty());
        const bool isHalf = plan.half != Half::none;
        Walker beside(world.copy(), 2.75, isHalf ? 2.25 : 2.75, 0.0);
        Walker rider(std::move(world), 2.25, isHalf ? 2.75 : 2.25, 0.0);
        const auto liftOfAStep = [](Walker& walker) {
            Body body = bodyOf(travellerOf(walker.player), true);
            stepWorld(walker.world, {&body, 1}, {});
            return body.shift.z;
        };
        EXPECT_EQ(liftOfAStep(beside), Coordinate{});
        EXPECT_GT(liftOfAStep(rider), Coordinate{});
    }
}

// ---- waiting

// Steps until the mover has waited for a second; gives the offset that it waits at.
Coordinate offsetWhereItWaits(World& world, Player& player) {
    int waited = 0;
    for (int step = 0; step < 2 * kPeriod && waited < kSecond; ++step) {
        const Coordinate before = world.movers[0].offset;
        const int clock = world.movers[0].clock;
        stepBoth(world, player);
        waited =
            world.movers[0].offset == before && world.movers[0].clock == clock ? waited + 1 : 0;
        EXPECT_FALSE(reachesIntoSolid(world, 0, bodyBox(player)));
    }
    EXPECT_EQ(waited, kSecond);
    return world.movers[0].offset;
}

TEST(Movers, WaitForBodiesUnderACeiling) {
    World world = emptyWorld(5, 5, 4);
    world.maps[0].setCell(2, 2, 0, addMoving(world, {}, 0.5_u, lift()));
    putBlock(world, 3, 2, 2.0_u, 2.25_u);
    EXPECT_TRUE(makeMovers(world).empty());
    Walker rider(std::move(world), 2.9, 2.5, 0.5);
    const double room = 2.0 - 0.5 - kStandingHeight.value();
    const double offset = offsetWhereItWaits(rider.world, rider.player).value();
    EXPECT_LE(offset, room);
    EXPECT_GT(offset, room - 0.01);
    // It goes on where it stood when the rider has stepped aside.
    const int clock = rider.world.movers[0].clock;
    stepBoth(rider.world, rider.player, {.strafe = 1.0, .fly = -1.0});
    EXPECT_EQ(rider.world.movers[0].clock, clock);
    stepBoth(rider.world, rider.player, {.fly = -1.0});
    EXPECT_EQ(rider.world.movers[0].clock, clock + 1);
}

TEST(Movers, WaitForBodiesBelow) {
    Motion press = lift();
    press.from = 1.5_u;
    press.to = {};
    Walker victim(platform(press), 2.1, 2.5, 0.0);
    const Coordinate offset = offsetWhereItWaits(victim.world, victim.player);
    EXPECT_GE(offset, kStandingHeight);
    EXPECT_LT(offset, kStandingHeight + 0.01_u);
    EXPECT_EQ(victim.z(), 0.0);
}

TEST(Movers, WaitForBodiesBesideAGrowingBlock) {
    // Grows out of a wall's side at the height of the hips: from nothing at 0.5 to 0.9.
    Motion grow = lift();
    grow.edges = MovingEdges::high;
    grow.from = toCoordinate(-0.125);
    grow.to = 0.25_u;
    World world = platform(grow, 0.5_u, 0.5_u + 0.125_u);
    Walker victim(std::move(world), 2.5, 2.5, 0.0);
    EXPECT_EQ(offsetWhereItWaits(victim.world, victim.player), grow.from);
    // The same from the ground lifts whoever stands there.
    Motion pulse = grow;
    pulse.to = 0.5_u;
    Walker lifted(platform(pulse, {}, 0.125_u), 2.9, 2.5, 0.0);
    for (int step = 0; step < kPeriod / 2; ++step) stepBoth(lifted.world, lifted.player);
    EXPECT_EQ(lifted.z(), 0.625);
}

TEST(Movers, DoNotWaitForBodiesInsideThem) {
    World world = platform(lift());
    Player player = playerWithEye(0, 2.5_u, 2.5_u, 0.25_u, 0.0, 0.0);
    ASSERT_FALSE(isFree(world, 0, bodyBox(player)));
    for (int step = 0; step < kPeriod / 2; ++step) stepBoth(world, player);
    EXPECT_EQ(world.movers[0].offset, 2.0_u);
    EXPECT_EQ(player.z, 0.0_u);
}

// ---- both

TEST(Movers, RestartWithTheWorld) {
    World world = platform(lift());
    const auto before = extentAt(world, 2, 2);
    const std::vector<std::uint32_t> occupied = world.maps[0].occupied;
    stepWorldAlone(world, 333);
    EXPECT_NE(extentAt(world, 2, 2), before);
    resetWorld(world);
    EXPECT_EQ(extentAt(world, 2, 2), before);
    EXPECT_EQ(world.maps[0].occupied, occupied);
    EXPECT_EQ(world.movers[0].clock, 0);
}

TEST(Movers, AreShownBetweenSteps) {
    World world = platform(lift(MotionShape::even));
    stepWorldAlone(world, kPeriod / 8);
    const Coordinate now = world.movers[0].offset;
    const Coordinate before = world.movers[0].previousOffset;
    ASSERT_LT(before, now);
    showMovers(world, 0.0);
    EXPECT_EQ(extentAt(world, 2, 2).first, before);
    showMovers(world, 0.5);
    EXPECT_NEAR(extentAt(world, 2, 2).first.value(), (before.value() + now.value()) / 2.0,
                1.0 / 65536.0);
    showMovers(world, 1.0);
    EXPECT_EQ(extentAt(world, 2, 2).first, now);
}

}  // namespace
}  // namespace slicecast
