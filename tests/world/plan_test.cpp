// Blocks that fill only a part of their tile: bodies, sight and rays pass beside them.
#include "world/plan.h"

#include "walking.h"
#include "world/collision.h"
#include "world/line_of_sight.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

constexpr Plan kPost = {Coordinate{16384}, Coordinate{32768}, Coordinate{24576}, Coordinate{49152}};

constexpr Plan halfOf(Half half) {
    Plan plan;
    plan.half = half;
    return plan;
}
constexpr Plan kSouthWest = halfOf(Half::southWest);

// Five tiles a side; one block in the middle tile, 1 unit high.
World yardWith(const Plan& plan) {
    World world = emptyWorld(5, 5, 2);
    putBlock(world, 2, 2, 0.0_u, 1.0_u);
    world.blueprints.back().plan = plan;
    return world;
}

TEST(Plan, TurnsWithItsTile) {
    EXPECT_EQ(turned(kPost, 1),
              (Plan{Coordinate{16384}, Coordinate{16384}, Coordinate{32768}, Coordinate{24576}}));
    EXPECT_EQ(turned(turned(kPost, 1), 3), kPost);
    EXPECT_EQ(turned(turned(kPost, 2), 2), kPost);
    EXPECT_TRUE(turned(Plan{}, 1).isWhole());
    EXPECT_FALSE(kPost.isWhole());
    EXPECT_EQ(turned(kSouthWest, 1), halfOf(Half::northWest));
    EXPECT_EQ(turned(kSouthWest, 2), halfOf(Half::northEast));
    EXPECT_EQ(turned(kSouthWest, 3), halfOf(Half::southEast));
    EXPECT_FALSE(kSouthWest.isWhole());
}

TEST(Plan, BodiesTouchItWhereItStands) {
    const World world = yardWith(kPost);
    // The post reaches from 2.25, 2.5 to 2.375, 2.75.
    Box box = {2.0_u, 2.25_u, 2.4_u, 2.8_u, 0.0_u, 0.5_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "west of it";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = kTiny, .y = {}, .z = {}})));
    box = {2.375_u, 3.0_u, 2.4_u, 2.8_u, 0.0_u, 0.5_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "east of it";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {-1}, .y = {}, .z = {}})));
    box = {2.2_u, 2.4_u, 2.0_u, 2.5_u, 0.0_u, 0.5_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "north of it";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {}, .y = kTiny, .z = {}})));
    box = {2.2_u, 2.4_u, 2.75_u, 3.0_u, 0.0_u, 0.5_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "south of it";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {}, .y = {-1}, .z = {}})));
    box = {2.0_u, 3.0_u, 2.0_u, 3.0_u, 1.0_u, 1.5_u};
    EXPECT_TRUE(isSupported(world, 0, box)) << "on top";
    EXPECT_FALSE(isSupported(world, 0, moved(box, {.x = 0.4_u, .y = {}, .z = {}}))) << "beside it";
}

TEST(Plan, ABodySlidesPastWithinTheTile) {
    World world = yardWith({0.5_u, 0.0_u, 0.625_u, 1.0_u});
    Walker walker(std::move(world), 1.5, 2.5, 0.0);
    walker.step({.forward = 1.0}, 2 * kSecond);
    EXPECT_EQ(bodyBox(walker.player).east, 2.5_u);
    // Southward, along the board and round its end
    walker.step({.strafe = 1.0}, kSecond);
    walker.step({.forward = 1.0}, kSecond);
    EXPECT_GT(walker.x(), 3.0);
}

// The corner of a box that is nearest to the cut may lie on it; where it lies beside the half, the
// box may reach past the cut.
TEST(Plan, BodiesTouchTheCutOfAHalf) {
    const Box box = {2.25_u, 2.75_u, 2.5_u, 2.75_u, 0.0_u, 0.5_u};
    const auto isFreeAt = [&](Half half, Coordinate x, Coordinate y) {
        return isFree(yardWith(halfOf(half)), 0, moved(box, {.x = x, .y = y, .z = {}}));
    };
    // South-western corner (2.25, 2.75), and how far it is from each cut
    EXPECT_TRUE(isFreeAt(Half::southWest, 0.5_u, {}));
    EXPECT_FALSE(isFreeAt(Half::southWest, 0.5_u - kTiny, {}));
    EXPECT_TRUE(isFreeAt(Half::southWest, {}, {-32768}));
    EXPECT_FALSE(isFreeAt(Half::southWest, {}, {-32768 + 1}));
    EXPECT_TRUE(isFreeAt(Half::northEast, {-16384}, {}));
    EXPECT_FALSE(isFreeAt(Half::northEast, {-16384 + 1}, {}));
    EXPECT_TRUE(isFreeAt(Half::southEast, {-32768}, {}));
    EXPECT_FALSE(isFreeAt(Half::southEast, {-32768 + 1}, {}));
    EXPECT_TRUE(isFreeAt(Half::northWest, 0.25_u, {}));
    EXPECT_FALSE(isFreeAt(Half::northWest, 0.25_u - kTiny, {}));
    // One stands on a half only where it is
    const World world = yardWith(kSouthWest);
    EXPECT_TRUE(isSupported(world, 0, moved(box, {.x = {}, .y = {}, .z = 1.0_u})));
    EXPECT_FALSE(isSupported(world, 0, moved(box, {.x = 0.5_u, .y = {}, .z = 1.0_u})));
}

// West against a wall from the north-west to the south-east: half of the way along each axis, so at
// 1 / sqrt(2) of the speed. The same the other way, and behind a portal that turns it.
TEST(Plan, ABodySlidesAlongACut) {
    for (const bool throughPortal : {false, true}) {
        World world = emptyWorld(9, 9, 2);
        for (int i = 1; i < 8; ++i) putBlock(world, i, i, 0.0_u, 1.0_u);
        for (int x = 0; x < 8; ++x) {
            for (int y = x + 1; y < 9; ++y) putBlock(world, x, y, 0.0_u, 0.75_u);
        }
        world.blueprints[world.maps[0].cell(1, 1, 0)].plan = kSouthWest;
        if (throughPortal) {
            // Somewhere else: the same code as near a portal
            world.portals.push_back({});
        }
        Walker walker(std::move(world), 6.5, 4.5, 0.0, 180.0);
        walker.step(kAhead, kSecond);
        ASSERT_LT(walker.y(), 4.0);
        const double x = walker.x();
        const double y = walker.y();
        walker.step(kAhead, kSecond / 4);
        EXPECT_NEAR(x - walker.x(), 1.5 / 4, 0.001) << throughPortal;
        EXPECT_NEAR(y - walker.y(), 1.5 / 4, 0.001);
        EXPECT_NEAR(walker.player.velocityX, -1.5, 1e-6);
        EXPECT_NEAR(walker.player.velocityY, -1.5, 1e-6);
        const Box body = bodyBox(walker.player);
        EXPECT_NEAR(body.west.value(), body.south.value(), 0.02) << "its corner is at the cut";
        // Straight against it, once it has come to rest
        walker.player.headingDegrees = 135.0;
        walker.step(kAhead, 2 * kSecond);
        const Player before = walker.player;
        walker.step(kAhead, kSecond / 4);
        EXPECT_NEAR(before.x.value(), walker.x(), 0.001);
        EXPECT_NEAR(before.y.value(), walker.y(), 0.001);
    }
}

// In a pocket between two cuts there is nowhere to slide to.
TEST(Plan, ABodyStopsBetweenTwoCuts) {
    World world = emptyWorld(5, 5, 2);
    putBlock(world, 1, 2, 0.0_u, 1.0_u);
    putBlock(world, 1, 1, 0.0_u, 0.75_u);
    world.blueprints[world.maps[0].cell(1, 2, 0)].plan = kSouthWest;
    world.blueprints[world.maps[0].cell(1, 1, 0)].plan = halfOf(Half::northWest);
    Walker walker(std::move(world), 3.5, 2.0, 0.0, 180.0);
    walker.step(kAhead, 2 * kSecond);
    const Box body = bodyBox(walker.player);
    EXPECT_EQ(body.west, 1.2_u);
    EXPECT_EQ(walker.y(), 2.0);
    EXPECT_EQ(walker.player.velocityX, 0.0);
    EXPECT_EQ(walker.player.velocityY, 0.0);
}

TEST(Plan, SweepsEndExactlyAtItsEdges) {
    Random random(7);
    for (int i = 0; i < 20'000; ++i) {
        const World world = yardWith(randomPlan(random));
        const auto place = [&] { return Coordinate{random.between(65536, 4 * 65536)}; };
        const Coordinate size = {random.between(1, 40000)};
        const Coordinate west = place();
        const Coordinate north = place();
        const Box box = {west, west + size, north, north + size, 0.0_u, 0.5_u};
        if (!isFree(world, 0, box)) continue;
        const Coordinate way = {random.between(-60000, 60000)};
        const Coordinate x = sweepX(world, 0, box, way);
        const Coordinate y = sweepY(world, 0, box, way);
        const Coordinate further = {way.raw > 0 ? 1 : -1};
        EXPECT_TRUE(isFree(world, 0, moved(box, {.x = x, .y = {}, .z = {}})));
        EXPECT_TRUE(isFree(world, 0, moved(box, {.x = {}, .y = y, .z = {}})));
        const Box pastX = moved(box, {.x = x + further, .y = {}, .z = {}});
        const Box pastY = moved(box, {.x = {}, .y = y + further, .z = {}});
        EXPECT_TRUE(x == way || !isFree(world, 0, pastX));
        EXPECT_TRUE(y == way || !isFree(world, 0, pastY));
    }
}

TEST(Plan, HidesOnlyWhatIsBehindIt) {
    const World world = yardWith(kPost);
    const auto sees = [&](const Place& from, const Place& to) {
        return isInSight(world, world.maps[0], from, to);
    };
    EXPECT_FALSE(sees({0.5, 2.6, 0.5}, {4.5, 2.6, 0.5}));
    EXPECT_TRUE(sees({0.5, 2.4, 0.5}, {4.5, 2.4, 0.5})) << "north of it";
    EXPECT_TRUE(sees({0.5, 2.8, 0.5}, {4.5, 2.8, 0.5})) << "south of it";
    EXPECT_FALSE(sees({2.3, 0.5, 0.5}, {2.3, 4.5, 0.5}));
    EXPECT_TRUE(sees({2.1, 0.5, 0.5}, {2.1, 4.5, 0.5}));
    EXPECT_TRUE(sees({0.5, 2.6, 1.5}, {4.5, 2.6, 0.9})) << "over it";
}

TEST(Plan, AHalfHidesOnlyWhatIsBehindIt) {
    const World world = yardWith(kSouthWest);
    const auto sees = [&](const Place& from, const Place& to) {
        return isInSight(world, world.maps[0], from, to);
    };
    EXPECT_TRUE(sees({1.5, 1.375, 0.5}, {3.5, 3.375, 0.5})) << "along the cut, north of it";
    EXPECT_FALSE(sees({1.5, 1.625, 0.5}, {3.5, 3.625, 0.5})) << "and south of it";
    EXPECT_FALSE(sees({1.0, 3.5, 0.5}, {4.0, 1.25, 0.5})) << "across";
    EXPECT_TRUE(sees({2.5, 1.0, 0.5}, {2.5, 2.25, 0.5})) << "up to the cut";
}

TEST(Plan, TheWayOverItIsCutToItsEdges) {
    const auto way = wayOver(kPost, 2, 2, 0.0, 2.625, 1.0, 0.0, {0.0, 10.0});
    ASSERT_TRUE(way.has_value());
    EXPECT_EQ(way->from, 2.25);
    EXPECT_EQ(way->to, 2.375);
    EXPECT_FALSE(wayOver(kPost, 2, 2, 0.0, 2.75, 1.0, 0.0, {0.0, 10.0})) << "its southern edge";
    EXPECT_FALSE(wayOver(kPost, 2, 2, 0.0, 2.625, 1.0, 0.0, {0.0, 2.0})) << "ends before it";
    for (const Half half : {Half::northEast, Half::southEast, Half::southWest, Half::northWest}) {
        // Eastward at 1/4 from the north
        const auto over = wayOver(halfOf(half), 2, 2, 0.0, 2.25, 1.0, 0.0, {0.0, 10.0});
        ASSERT_TRUE(over.has_value());
        EXPECT_EQ(over->from, half == Half::northEast   ? 2.25
                              : half == Half::southEast ? 2.75
                                                        : 2.0);
        EXPECT_EQ(over->to, half == Half::southWest ? 2.25 : half == Half::northWest ? 2.75 : 3.0);
    }
}

}  // namespace
}  // namespace slicecast
