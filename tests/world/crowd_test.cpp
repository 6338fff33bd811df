// Solid objects keep apart, and nobody is ever trapped among them.
#include "stage.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicecast {
namespace {

// As circles, less the rounding of a step.
bool overlap(const Object& a, const Object& b) {
    const double apart = std::hypot((a.x - b.x).value(), (a.y - b.y).value());
    return apart < (a.width.value() + b.width.value()) / 2.0 - 0.001;
}

TEST(Crowd, TwoWhoMeetPassEachOther) {
    World world = emptyWorld(14, 8, 1);
    addActor(world, 2.0, 4.0, patrolling(world, {point(12.0, 4.0)}));
    addActor(world, 12.0, 4.0, patrolling(world, {point(2.0, 4.0)}));
    Stage stage(std::move(world), 0.5, 0.5);
    for (int i = 0; i < 14 * kStepsPerSecond; ++i) {
        stage.step();
        ASSERT_FALSE(overlap(stage.object(0), stage.object(1))) << i;
    }
    EXPECT_NEAR(stage.x(0), 12.0, 0.1);
    EXPECT_NEAR(stage.x(1), 2.0, 0.1);
}

// In a corridor one tile wide there is no room to pass: after a while they go through.
TEST(Crowd, NobodyIsTrappedInACorridor) {
    World world = emptyWorld(14, 3, 1);
    for (int x = 0; x < 14; ++x)
        for (const int y : {0, 2}) putBlock(world, x, y, {}, 1.0_u);
    ObjectMotion one = patrolling(world, {point(12.0, 1.5)});
    ObjectMotion other = patrolling(world, {point(2.0, 1.5)});
    addActor(world, 2.0, 1.5, one);
    addActor(world, 12.0, 1.5, other);
    for (Object& object : world.maps[0].objects) object.width = 0.4_u;
    Stage stage(std::move(world), 0.5, 1.5);
    stage.stepFor(40.0);
    EXPECT_NEAR(stage.x(0), 12.0, 0.1);
    EXPECT_NEAR(stage.x(1), 2.0, 0.1);
}

TEST(Crowd, ThePlayerPushesThroughSlowly) {
    const auto walked = [](bool solid) {
        World world = emptyWorld(14, 3, 1);
        ObjectMotion motion = standing();
        motion.solid = solid;
        addActor(world, 4.0, 1.5, motion);
        // Walls beside it: it cannot be pushed aside
        for (int x = 0; x < 14; ++x)
            for (const int y : {0, 2}) putBlock(world, x, y, {}, 1.0_u);
        Stage stage(std::move(world), 2.0, 1.5);
        stage.stepFor(1.2, {.forward = 1.0});
        return stage.player.x.value();
    };
    const double free = walked(false);
    const double slow = walked(true);
    EXPECT_LT(slow, free - 0.1);
    EXPECT_GT(slow, 4.0);  // but past it
}

TEST(Crowd, AFlyingPlayerPushesNobody) {
    World world = emptyWorld(14, 14, 2);
    addActor(world, 5.0, 5.0, standing());
    Stage stage(std::move(world), 5.1, 5.0);
    stage.player.flying = true;
    stage.stepFor(1.0);
    EXPECT_EQ(stage.x(), 5.0);
    EXPECT_EQ(stage.player.x, 5.1_u);
}

TEST(Crowd, APushedOneComesBack) {
    World world = emptyWorld(14, 14, 1);
    addActor(world, 5.0, 5.0, standing());
    Stage stage(std::move(world), 4.75, 5.0);
    stage.stepFor(0.1);
    EXPECT_GT(stage.x(), 5.0);
    stage.putPlayer(10.0, 10.0);
    stage.stepFor(2.0);
    EXPECT_NEAR(stage.x(), 5.0, 0.05);
}

// Those without it keep the ways that they always had.
TEST(Crowd, OthersWalkThroughEachOther) {
    World world = emptyWorld(14, 3, 1);
    ObjectMotion motion;
    motion.kind = ObjectMotion::Kind::pace;
    motion.speed = 1.0;
    motion.reach = 6.0_u;
    addActor(world, 2.0, 1.5, motion);
    motion.headingDegrees = 180.0;
    addActor(world, 8.0, 1.5, motion);
    Stage stage(std::move(world), 12.0, 1.5);
    EXPECT_FALSE(stage.world.movingObjects.anySolid);
    stage.stepFor(3.0);
    EXPECT_NEAR(stage.x(0), stage.x(1), 0.05);
}

// As many as a scene may have, in the worst places: each step looks at a bounded number of
// neighbours of each.
TEST(Crowd, AStepOfAVeryLargeCrowdGrowsWithItsNumber) {
    constexpr int kCrowd = 4096;
    const auto looksAmong = [](int width, auto place) {
        World world = emptyWorld(width, 70, 1);
        for (int i = 0; i < kCrowd; ++i) {
            ObjectMotion motion;  // it wanders
            motion.solid = true;
            motion.headingDegrees = 7.0 * i;
            const GroundPoint at = place(i);
            addActor(world, at.x.value(), at.y.value(), motion);
        }
        Stage stage(std::move(world), 0.5, 0.5);
        std::int64_t most = 0;
        for (int i = 0; i < 30; ++i) {
            stage.step({.forward = 1.0});
            most = std::max(most, stage.world.movingObjects.crowdLooks);
        }
        return most;
    };
    // Two ways are tried, and the player looks too
    constexpr std::int64_t kMostLooks = std::int64_t{2} * (kMostNeighbours + 2) * (kCrowd + 1);
    const auto jostled = [](int i, int x) {
        return GroundPoint{tileEdge(x) + Coordinate{65536 / 4 + 512 * (i % 64)},
                           tileEdge(3) + Coordinate{65536 / 4 + 512 * (i / 64 % 64)}};
    };
    const std::int64_t oneTile = looksAmong(70, [&](int i) { return jostled(i, 3); });
    EXPECT_GT(oneTile, kCrowd * 10);
    EXPECT_LE(oneTile, kMostLooks);
    EXPECT_LE(looksAmong(1100, [&](int i) { return jostled(i, i / (kCrowd / 2) * 1024 + 3); }),
              kMostLooks)
        << "far apart";
    EXPECT_LE(
        looksAmong(
            70,
            [](int i) {
                return GroundPoint{tileEdge(3 + i % 64) + 0.5_u, tileEdge(3 + i / 64) + 0.5_u};
            }),
        kMostLooks)
        << "spread";
}

}  // namespace
}  // namespace slicecast
