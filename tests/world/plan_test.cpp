// Blocks that fill only a part of their tile: bodies, sight and rays pass beside them.
#include "world/plan.h"

#include "walking.h"
#include "world/collision.h"
#include "world/line_of_sight.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

constexpr Plan kPost = {Coordinate{16384}, Coordinate{32768}, Coordinate{24576}, Coordinate{49152}};

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
    const Walker before(world.copy(), 1.5, 2.5, 0.0);
    Walker walker(std::move(world), 1.5, 2.5, 0.0);
    walker.step({.forward = 1.0}, 2 * kSecond);
    EXPECT_EQ(bodyBox(walker.player).east, 2.5_u);
    // Southward, along the board and round its end
    walker.step({.strafe = 1.0}, kSecond);
    walker.step({.forward = 1.0}, kSecond);
    EXPECT_GT(walker.x(), 3.0);
    EXPECT_LT(before.x(), walker.x());
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

TEST(Plan, TheWayOverItIsCutToItsEdges) {
    const auto way = wayOver(kPost, 2, 2, 0.0, 2.625, 1.0, 0.0, {0.0, 10.0});
    ASSERT_TRUE(way.has_value());
    EXPECT_EQ(way->from, 2.25);
    EXPECT_EQ(way->to, 2.375);
    EXPECT_FALSE(wayOver(kPost, 2, 2, 0.0, 2.75, 1.0, 0.0, {0.0, 10.0})) << "its southern edge";
    EXPECT_FALSE(wayOver(kPost, 2, 2, 0.0, 2.625, 1.0, 0.0, {0.0, 2.0})) << "ends before it";
}

}  // namespace
}  // namespace slicecast
