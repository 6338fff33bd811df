#include "world/player.h"

#include "walking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicecast {
namespace {

World room(int width, int depth, int levels) {
    World world = emptyWorld(width, depth, levels);
    for (int x = 0; x < width; ++x) {
        putBlock(world, x, 0, 0.0_u, 1.0_u);
        putBlock(world, x, depth - 1, 0.0_u, 1.0_u);
    }
    for (int y = 0; y < depth; ++y) {
        putBlock(world, 0, y, 0.0_u, 1.0_u);
        putBlock(world, width - 1, y, 0.0_u, 1.0_u);
    }
    return world;
}

// ---- walls

TEST(Player, StopsExactlyItsHalfWidthFromAWall) {
    for (const bool flying : {false, true}) {
        for (const bool fast : {false, true}) {
            Walker walker(room(7, 7, 2), 3.5, 3.5, 0.0);
            setFlying(walker.world, walker.player, flying);
            for (const int heading : {0, 90, 180, 270}) {
                setHeading(walker.player, heading);
                walker.step({.forward = 1.0, .fast = fast}, 3 * kSecond);
                const Coordinate place = heading % 180 == 0 ? walker.player.x : walker.player.y;
                EXPECT_EQ(place, heading < 180 ? 6.0_u - kBodyHalfWidth : 1.0_u + kBodyHalfWidth)
                    << heading << (flying ? " flying" : " walking");
            }
        }
    }
}

TEST(Player, SlidesAlongAWallWithoutCatchingAtItsSeams) {
    World world = room(40, 5, 2);
    for (int x = 0; x < 40; x += 3)
        putBlock(world, x, 3, 0.0_u,
                 1.0_u - kTiny);  // every third block of the wall is another one
    for (int x = 1; x < 40; x += 3) putBlock(world, x, 3, 0.0_u, 0.75_u);
    for (int x = 2; x < 40; x += 3) putBlock(world, x, 3, 0.51_u, 0.75_u);
    for (int x = 0; x < 40; ++x) putBlock(world, x, 3, 1.0_u, 2.0_u);
    Walker walker(std::move(world), 1.5, 2.5, 0.0, 30.0);
    walker.step(kAhead, kSecond);
    ASSERT_EQ(walker.player.y, 3.0_u - kBodyHalfWidth);
    const double wanted = kWalkingPace.move * std::sqrt(0.75) * kStepSeconds;
    for (int i = 0; i < 10 * kSecond; ++i) {
        const double before = walker.x();
        walker.step(kAhead);
        ASSERT_NEAR(walker.x() - before, wanted, 2.0 / 65536.0) << "at x = " << before;
    }
    EXPECT_EQ(walker.player.y, 3.0_u - kBodyHalfWidth);
}

TEST(Player, DoesNotSlipBetweenBlocksThatTouchAtACorner) {
    World world = emptyWorld(4, 4, 1);
    putBlock(world, 1, 2, 0.0_u, 1.0_u);
    putBlock(world, 2, 1, 0.0_u, 1.0_u);
    for (const double offset : {0.0, -0.05, 0.05, -0.3, 0.3}) {
        Walker walker(world.copy(), 1.5 + offset, 1.5 - offset, 0.0, 45.0);
        walker.step(kAhead, 3 * kSecond);
        EXPECT_LE(walker.player.x + kBodyHalfWidth, 2.0_u);
        EXPECT_LE(walker.player.y + kBodyHalfWidth, 2.0_u);
    }
}

TEST(Player, WalksThroughACorridorOfOneTileAndRoundItsCorners) {
    // A corridor east along row 1, then south down column 6, then back west along row 5.
    World world = emptyWorld(8, 7, 1);
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 8; ++x) {
            const bool open = (y == 1 && x >= 1 && x <= 6) || (x == 6 && y >= 1 && y <= 5) ||
                              (y == 5 && x >= 1 && x <= 6);
            if (!open) putBlock(world, x, y, 0.0_u, 1.0_u);
        }
    }
    Walker walker(std::move(world), 1.5, 1.5, 0.0, 12.0);  // a little askew: it scrapes along
    walker.step(kAhead, 3 * kSecond);
    EXPECT_GT(walker.x(), 6.5);
    setHeading(walker.player, 100.0);
    walker.step(kAhead, 3 * kSecond);
    EXPECT_EQ(walker.player.y, 6.0_u - kBodyHalfWidth);
    setHeading(walker.player, 175.0);
    walker.step(kAhead, 3 * kSecond);
    EXPECT_EQ(walker.player.x, 1.0_u + kBodyHalfWidth);
}

TEST(Player, TheEdgeOfTheGridIsAWallAtAnyHeight) {
    for (const double height : {0.0, 0.5, 3.0, 40.0}) {
        Walker walker(emptyWorld(3, 4, 2), 1.5, 2.0, height);
        setFlying(walker.world, walker.player, true);
        walker.step(kAhead, 2 * kSecond);
        EXPECT_EQ(walker.player.x, 3.0_u - kBodyHalfWidth);
        walker.step({.forward = -1.0, .fast = true}, 2 * kSecond);
        EXPECT_EQ(walker.player.x, kBodyHalfWidth);
        walker.step({.strafe = 1.0}, 2 * kSecond);
        EXPECT_EQ(walker.player.y, 4.0_u - kBodyHalfWidth);
        walker.step({.strafe = -1.0}, 2 * kSecond);
        EXPECT_EQ(walker.player.y, kBodyHalfWidth);
    }
}

// ---- steps

double heightAfterWalkingAt(Coordinate step) {
    World world = emptyWorld(6, 1, 2);
    for (int x = 3; x < 6; ++x) putBlock(world, x, 0, 0.0_u, step);
    Walker walker(std::move(world), 1.5, 0.5, 0.0);
    walker.step(kAhead, 2 * kSecond);
    EXPECT_EQ(walker.x() > 3.0, walker.z() > 0.0);
    return walker.z();
}

TEST(Player, StepsUpToHalfAUnitAndNoMore) {
    EXPECT_EQ(heightAfterWalkingAt(0.25_u), 0.25);
    EXPECT_EQ(heightAfterWalkingAt(kTiny), kTiny.value());
    EXPECT_EQ(heightAfterWalkingAt(0.5_u), 0.5);
    EXPECT_EQ(heightAfterWalkingAt(0.5_u + kTiny), 0.0);
    EXPECT_EQ(heightAfterWalkingAt(0.51_u), 0.0);
}

TEST(Player, TheEyeFollowsAStepSmoothly) {
    World world = emptyWorld(6, 1, 2);
    for (int x = 3; x < 6; ++x) putBlock(world, x, 0, 0.0_u, 0.5_u);
    Walker walker(std::move(world), 1.5, 0.5, 0.0);
    for (const PlayerInput& input : {kAhead, PlayerInput{.forward = -1.0}}) {  // up, and down again
        Coordinate before = eyeHeight(walker.player);
        for (int i = 0; i < 2 * kSecond; ++i) {
            walker.step(input);
            EXPECT_NEAR(eyeHeight(walker.player).value(), before.value(), 0.03);
            before = eyeHeight(walker.player);
        }
        EXPECT_EQ(eyeHeight(walker.player), walker.player.z + kStandingEye);
    }
    EXPECT_EQ(walker.z(), 0.0);
}

TEST(Player, ClimbsStairsToTheNextLevelsAndComesBackDownOnThem) {
    World world = emptyWorld(14, 1, 3);
    for (int x = 2; x < 10; ++x) {
        for (int level = 0; level < 2; ++level) {
            const int quarters = std::min(std::max(x - 1 - 4 * level, 0), 4);
            if (quarters > 0)
                putBlock(world, x, 0, tileEdge(level),
                         tileEdge(level) + Coordinate{quarters * 16384});
        }
    }
    for (int x = 10; x < 14; ++x) {
        putBlock(world, x, 0, 0.0_u, 1.0_u);
        putBlock(world, x, 0, 1.0_u, 2.0_u);
    }
    Walker walker(std::move(world), 0.5, 0.5, 0.0);
    walker.step(kAhead, 6 * kSecond);
    EXPECT_EQ(walker.z(), 2.0);
    setHeading(walker.player, 180.0);
    for (int i = 0; i < 6 * kSecond; ++i) {
        walker.step(kAhead);
        EXPECT_TRUE(walker.player.onGround) << "stairs are walked down, not fallen down";
    }
    EXPECT_EQ(walker.z(), 0.0);
}

TEST(Player, AStepNeedsRoomAboveIt) {
    World world = emptyWorld(4, 1, 2);
    putBlock(world, 2, 0, 0.0_u, 0.5_u);
    putBlock(world, 2, 0, 1.0_u, 1.5_u);
    Walker walker(std::move(world), 0.5, 0.5, 0.0);
    walker.step(kAhead, kSecond);
    EXPECT_EQ(walker.player.x, 2.0_u - kBodyHalfWidth);
    walker.step(kCrouchedAhead, kSecond / 2);
    EXPECT_GT(walker.x(), 2.0) << "a crouched one fits in";
    EXPECT_EQ(walker.z(), 0.5);
}

// ---- low places, jumping

TEST(Player, WalksUnderALowPlaceOnlyCrouchedAndStandsUpBehindIt) {
    Walker walker(lowPassage(0.7_u), 0.5, 0.5, 0.0);
    walker.step(kAhead, kSecond);
    EXPECT_EQ(walker.player.x, 2.0_u - kBodyHalfWidth);
    walker.step(kCrouchedAhead, kSecond);
    EXPECT_TRUE(walker.player.crouched);
    EXPECT_GT(walker.x(), 2.5);
    walker.step(kAhead, kSecond / 2);
    EXPECT_TRUE(walker.player.crouched) << "no room to stand up";
    EXPECT_LT(walker.x(), 5.0);
    EXPECT_NEAR(std::abs(walker.player.velocityX), kWalkingPace.move * kCrouchedPace, 1e-9);
    walker.step(kAhead, 3 * kSecond);
    EXPECT_FALSE(walker.player.crouched);
    EXPECT_GT(walker.x(), 6.2);
    EXPECT_EQ(eyeHeight(walker.player), kStandingEye);
}

TEST(Player, ALowPlaceLetsExactlyItsOwnHeightPass) {
    for (const bool crouched : {false, true}) {
        const Coordinate height = crouched ? kCrouchedHeight : kStandingHeight;
        for (const bool fits : {false, true}) {
            Walker walker(lowPassage(fits ? height : height - kTiny), 0.5, 0.5, 0.0);
            walker.step(crouched ? kCrouchedAhead : kAhead, 2 * kSecond);
            EXPECT_EQ(walker.x() > 2.0, fits);
        }
    }
}

double heightAfterJumpingAt(Coordinate top) {
    World world = emptyWorld(6, 1, 3);
    for (int x = 3; x < 6; ++x) putBlock(world, x, 0, 0.0_u, top);
    Walker walker(std::move(world), 1.5, 0.5, 0.0);
    walker.step(kAhead, kSecond);
    EXPECT_EQ(walker.player.x, 3.0_u - kBodyHalfWidth);
    walker.step({.forward = 1.0, .jump = true}, 2 * kSecond);
    return walker.z();
}

TEST(Player, JumpsOntoThreeQuartersOfAUnitButNotOntoMoreThanItsReach) {
    EXPECT_EQ(heightAfterJumpingAt(0.75_u), 0.75);
    EXPECT_EQ(heightAfterJumpingAt(0.79_u), (0.79_u).value());
    EXPECT_EQ(heightAfterJumpingAt(0.81_u), 0.0);
    EXPECT_EQ(heightAfterJumpingAt(1.0_u), 0.0);
}

TEST(Player, OnePressIsOneJump) {
    Walker walker(emptyWorld(3, 3, 2), 1.5, 1.5, 0.0);
    double highest = 0.0;
    int takeOffs = 0;
    for (int i = 0; i < 4 * kSecond; ++i) {
        const bool before = walker.player.onGround;
        walker.step({.jump = true});
        takeOffs += before && !walker.player.onGround;
        highest = std::max(highest, walker.z());
    }
    EXPECT_EQ(takeOffs, 1) << "holding the key does not hop on";
    EXPECT_NEAR(highest, 0.8, 0.001);
    EXPECT_EQ(walker.z(), 0.0);

    // In the air, pressing again does nothing.
    walker.step(kNothing);
    walker.step({.jump = true}, kSecond / 4);
    walker.step(kNothing, 2);
    const double rising = walker.player.velocityZ;
    walker.step({.jump = true});
    EXPECT_LT(walker.player.velocityZ, rising);
}

TEST(Player, APressJustBeforeLandingIsRemembered) {
    for (const int early : {kEarlyJumpSteps - 3, kEarlyJumpSteps + 3}) {
        Walker walker(emptyWorld(3, 3, 2), 1.5, 1.5, 0.0);
        const double airSteps = 2.0 * kJumpSpeed / kGravity * kStepsPerSecond;
        walker.step({.jump = true});
        walker.step(kNothing, static_cast<int>(airSteps) - early - 1);
        walker.step({.jump = true}, 3);
        walker.step(kNothing, kSecond / 3);
        EXPECT_EQ(!walker.player.onGround, early < kEarlyJumpSteps);
    }
}

TEST(Player, AJumpStillWorksJustAfterTheEdge) {
    for (const int late : {kLateJumpSteps - 2, kLateJumpSteps + 2}) {
        World world = emptyWorld(8, 1, 3);
        putBlock(world, 0, 0, 0.0_u, 1.0_u);
        putBlock(world, 1, 0, 0.0_u, 1.0_u);
        Walker walker(std::move(world), 0.5, 0.5, 1.0);
        int steps = 0;
        while (walker.player.onGround && ++steps < 1000) walker.step(kAhead);
        ASSERT_FALSE(walker.player.onGround);
        walker.step(kAhead, late - 1);
        walker.step({.forward = 1.0, .jump = true});
        EXPECT_EQ(walker.player.velocityZ > 0.0, late < kLateJumpSteps);
    }
}

TEST(Player, TheHeadStopsAtBlocksAbove) {
    World world = emptyWorld(3, 3, 2);
    putBlock(world, 1, 1, 1.0_u, 1.5_u);
    Walker walker(std::move(world), 1.5, 1.5, 0.0);
    double highest = 0.0;
    for (int i = 0; i < kSecond; ++i) {
        walker.step({.jump = true});
        highest = std::max(highest, walker.z());
    }
    EXPECT_EQ(highest, (1.0_u - kStandingHeight).value());
    EXPECT_EQ(walker.z(), 0.0);
}

// ---- heights, bridges, falls

TEST(Player, FallsExactlyOntoTops) {
    for (const Coordinate top : {0.25_u, 0.5_u, 0.3_u, kTiny, 1.0_u, 1.0_u - kTiny}) {
        World world = emptyWorld(1, 1, 3);
        putBlock(world, 0, 0, 0.0_u, top);
        Walker walker(std::move(world), 0.5, 0.5, 2.7);
        EXPECT_FALSE(walker.player.onGround);
        walker.step(kNothing, 2 * kSecond);
        EXPECT_EQ(walker.player.z, top);
        EXPECT_TRUE(walker.player.onGround);
        EXPECT_EQ(walker.player.velocityZ, 0.0);
    }
}

TEST(Player, FallsOffALedgeAtTheRateOfGravity) {
    World world = emptyWorld(8, 1, 20);
    for (int level = 0; level < 18; ++level)
        putBlock(world, 0, 0, tileEdge(level), tileEdge(level + 1));
    Walker walker(std::move(world), 0.5, 0.5, 18.0);
    while (walker.player.onGround && walker.x() < 4.0) walker.step(kAhead);
    EXPECT_GE(walker.player.x, 1.0_u + kBodyHalfWidth)
        << "no part of the body is left above the edge";
    const int fallen = kSecond - 1;
    walker.step(kNothing, fallen);
    EXPECT_NEAR(18.0 - walker.z(),
                0.5 * kGravity * (1.0 + fallen) * (1.0 + fallen) * kStepSeconds * kStepSeconds,
                0.01);
    walker.step(kNothing, 5 * kSecond);
    EXPECT_EQ(walker.z(), 0.0);
}

TEST(Player, ABridgeIsWalkedOverAndUnder) {
    // A wall of two levels with a gap below: row 1 is a bridge at 1.0 to 1.25 across the tunnel in
    // column 3.
    World world = emptyWorld(7, 3, 3);
    for (int x = 0; x < 7; ++x) {
        if (x != 3) putBlock(world, x, 1, 0.0_u, 1.0_u);
        putBlock(world, x, 1, 1.0_u, 1.25_u);
    }
    Walker over(world.copy(), 0.5, 1.5, 1.25);
    over.step(kAhead, 3 * kSecond);
    EXPECT_EQ(over.player.x, 7.0_u - kBodyHalfWidth);
    EXPECT_EQ(over.z(), 1.25);
    Walker under(world.copy(), 3.5, 0.5, 0.0, 90.0);
    under.step(kAhead, 3 * kSecond);
    EXPECT_EQ(under.player.y, 3.0_u - kBodyHalfWidth);
    EXPECT_EQ(under.z(), 0.0);
}

TEST(Player, TheCeilingIsAFloorFromAbove) {
    World world = emptyWorld(4, 1, 1);
    putCeiling(world, 1.2_u);
    world.maps[0].ceiling.tiles[3] = kNoTexture;
    Walker above(world.copy(), 0.5, 0.5, 2.0);
    above.step(kNothing, kSecond);
    EXPECT_EQ(above.player.z, 1.2_u);
    above.step(kAhead, 2 * kSecond);
    EXPECT_EQ(above.z(), 0.0) << "down through the hole at the end";
    Walker below(world.copy(), 0.5, 0.5, 0.0);
    setFlying(below.world, below.player, true);
    below.step({.fly = 1.0}, 3 * kSecond);
    EXPECT_EQ(below.player.z + kCrouchedHeight, 1.2_u);
}

}  // namespace
}  // namespace slicecast
