#include "world/player.h"

#include "walking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slicecast {
namespace {

// ---- flying, changing modes

TEST(Player, FliesOverTheTopLevelUpToTheGreatestHeight) {
    Walker walker(emptyWorld(3, 3, 1), 1.5, 1.5, 0.0);
    setFlying(walker.world, walker.player, true);
    walker.step({.fly = 1.0}, 10 * kSecond);
    EXPECT_NEAR(walker.z(), 10.0 * kFlyingPace.rise, 0.4);
    walker.player.z = kMaxBodyHeight - 2.0_u;
    walker.step({.fly = 1.0, .fast = true}, 2 * kSecond);
    EXPECT_EQ(walker.player.z + kCrouchedHeight, kMaxBodyHeight);
    walker.step({.fly = -1.0}, kSecond);
    EXPECT_LT(walker.player.z, kMaxBodyHeight - 1.0_u);
}

TEST(Player, FlyingStaysInTheAirAndComesDownToTheFloor) {
    Walker walker(emptyWorld(3, 3, 3), 1.5, 1.5, 0.0);
    setFlying(walker.world, walker.player, true);
    EXPECT_EQ(eyeHeight(walker.player), kStandingEye) << "the eye stays where it was";
    walker.step(kNothing, kSecond);
    EXPECT_EQ(eyeHeight(walker.player), kStandingEye);
    walker.step({.fly = -1.0}, kSecond);
    EXPECT_EQ(walker.z(), 0.0);
    EXPECT_EQ(eyeHeight(walker.player), kCrouchedEye);
    setFlying(walker.world, walker.player, false);
    EXPECT_EQ(eyeHeight(walker.player), kCrouchedEye);
    walker.step(kNothing, kSecond);
    EXPECT_EQ(eyeHeight(walker.player), kStandingEye) << "and stands up";
}

TEST(Player, AFlyerLandsCrouchedWhereThereIsNoRoomToStand) {
    Walker walker(lowPassage(0.6_u), 0.5, 0.5, 0.0);
    setFlying(walker.world, walker.player, true);
    walker.step({.fly = -1.0}, kSecond);
    walker.step(kAhead, kSecond / 2);
    ASSERT_GT(walker.x(), 2.5);
    setFlying(walker.world, walker.player, false);
    EXPECT_FALSE(walker.player.flying);
    EXPECT_TRUE(walker.player.crouched);
    walker.step(kNothing, kSecond);
    EXPECT_TRUE(walker.player.crouched);
    EXPECT_FALSE(reachesIntoSomething(walker.world, bodyBox(walker.player)));
}

TEST(Player, AnEyeInsideABlockFliesOutOfItAndIsThenStoppedByOthers) {
    World world = emptyWorld(6, 1, 1);
    putBlock(world, 1, 0, 0.0_u, 1.0_u);
    putBlock(world, 4, 0, 0.0_u, 1.0_u);
    Walker walker(std::move(world), 0.5, 0.5, 0.0);
    walker.player = playerWithEye(0, 1.5_u, 0.5_u, 0.5_u, 0.0, 0.0);
    EXPECT_EQ(eyeHeight(walker.player), 0.5_u);
    setFlying(walker.world, walker.player, false);
    EXPECT_TRUE(walker.player.flying) << "there is nowhere to stand";
    walker.step(kAhead, 2 * kSecond);
    EXPECT_EQ(walker.player.x, 4.0_u - kBodyHalfWidth);

    // From outside the grid too
    walker.player = playerWithEye(0, Coordinate{-5 * 65536}, 0.5_u, 1.5_u, 0.0, 0.0);
    walker.step(kAhead, 3 * kSecond);
    EXPECT_EQ(walker.player.x, 6.0_u - kBodyHalfWidth);
}

TEST(Player, LevelLookBringsAFlyerDownToStandingHeight) {
    World world = emptyWorld(3, 1, 5);
    putBlock(world, 1, 0, 1.0_u, 1.5_u);
    Walker walker(std::move(world), 1.5, 0.5, 3.0);
    setFlying(walker.world, walker.player, true);
    walker.player.look = 0.7;
    levelLook(walker.world, walker.player);
    EXPECT_EQ(walker.player.look, 0.0);
    EXPECT_EQ(eyeHeight(walker.player), 1.5_u + kStandingEye);
}

// ---- speeds and inputs

double distanceInSecondSecond(PlayerInput input, bool flying) {
    Walker walker(emptyWorld(200, 200, 1), 100.5, 100.5, 0.0, 33.0);
    setFlying(walker.world, walker.player, flying);
    walker.step(input, kSecond);
    const double x = walker.x();
    const double y = walker.y();
    walker.step(input, kSecond);
    return std::sqrt((walker.x() - x) * (walker.x() - x) + (walker.y() - y) * (walker.y() - y));
}

TEST(Player, MovesAtTheSpeedsOfItsMode) {
    for (const bool flying : {false, true}) {
        const Pace& pace = flying ? kFlyingPace : kWalkingPace;
        EXPECT_NEAR(distanceInSecondSecond({.forward = 1.0}, flying), pace.move, 0.002);
        EXPECT_NEAR(distanceInSecondSecond({.forward = -0.5}, flying), pace.move / 2.0, 0.002);
        EXPECT_NEAR(distanceInSecondSecond({.strafe = 1.0}, flying), pace.move, 0.002);
        EXPECT_NEAR(distanceInSecondSecond({.forward = 1.0, .strafe = -1.0}, flying), pace.move,
                    0.002)
            << "no faster aslant";
        EXPECT_NEAR(distanceInSecondSecond({.forward = 1.0, .fast = true}, flying),
                    pace.move * pace.fast, 0.002);
        EXPECT_NEAR(distanceInSecondSecond({.forward = 1.0, .slow = true}, flying),
                    pace.move * pace.slow, 0.002);
        EXPECT_NEAR(distanceInSecondSecond({.forward = 1.0, .fast = true, .slow = true}, flying),
                    pace.move * pace.slow, 0.002);
        EXPECT_NEAR(distanceInSecondSecond({.forward = 1.0, .speed = 2.0}, flying), pace.move * 2.0,
                    0.002);
    }
}

TEST(Player, StartsAndStopsWithinAFifthOfASecond) {
    for (const bool flying : {false, true}) {
        Walker walker(emptyWorld(50, 1, 1), 10.5, 0.5, 0.0);
        setFlying(walker.world, walker.player, flying);
        walker.step(kAhead, kSecond / 5);
        EXPECT_EQ(walker.player.velocityX, (flying ? kFlyingPace : kWalkingPace).move);
        walker.step(kNothing, kSecond / 5);
        const Coordinate rest = walker.player.x;
        walker.step(kNothing, kSecond);
        EXPECT_EQ(walker.player.x, rest);
    }
}

TEST(Player, TurnsLooksAndFacesHeadings) {
    Walker walker(emptyWorld(3, 3, 1), 1.5, 1.5, 0.0, 350.0);
    walker.step({.turn = 1.0}, kSecond);
    const double first = walker.player.headingDegrees;
    EXPECT_LT(first, 350.0 + kWalkingPace.turn - 360.0)
        << "it takes a moment to turn at full speed";
    walker.step({.turn = 1.0}, kSecond);
    EXPECT_NEAR(walker.player.headingDegrees, first + kWalkingPace.turn, 1e-9);
    walker.step({.turnDegrees = -400.0});
    EXPECT_GE(walker.player.headingDegrees, 0.0);
    EXPECT_LT(walker.player.headingDegrees, 360.0);
    for (const int heading : {0, 45, 90, 135, 180, 225, 270, 315, -90, 720}) {
        setHeading(walker.player, heading);
        EXPECT_EQ(walker.player.headingDegrees, (heading + 720) % 360);
        walker.step(kNothing);
        EXPECT_EQ(walker.player.headingDegrees, (heading + 720) % 360);
    }
    walker.step({.look = 1.0}, 10 * kSecond);
    EXPECT_EQ(walker.player.look, kLookLimit);
    walker.step({.look = -1.0}, kSecond / 2);
    EXPECT_LT(walker.player.look, kLookLimit);
    walker.step({.lookHeights = -100.0});
    EXPECT_EQ(walker.player.look, -kLookLimit);
    levelLook(walker.world, walker.player);
    EXPECT_EQ(walker.player.look, 0.0);
}

TEST(Player, NaNCountsAsZero) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    Walker walker(emptyWorld(9, 9, 1), 4.5, 4.5, 0.0);
    const Player before = walker.player;
    walker.step({.forward = nan,
                 .strafe = nan,
                 .turn = nan,
                 .look = nan,
                 .fly = nan,
                 .turnDegrees = nan,
                 .lookHeights = nan,
                 .speed = nan});
    EXPECT_EQ(walker.player.x, before.x);
    EXPECT_EQ(walker.player.headingDegrees, before.headingDegrees);
    EXPECT_EQ(walker.player.look, before.look);
    walker.step({.forward = infinity,
                 .strafe = -infinity,
                 .turn = infinity,
                 .look = -infinity,
                 .turnDegrees = infinity,
                 .lookHeights = infinity,
                 .speed = infinity},
                kSecond);
    EXPECT_TRUE(isFree(walker.world, 0, bodyBox(walker.player)));
    EXPECT_TRUE(std::isfinite(walker.player.headingDegrees));
    EXPECT_LE(std::abs(walker.player.look), kLookLimit);
    setHeading(walker.player, nan);
    EXPECT_EQ(walker.player.headingDegrees, 0.0);
}

TEST(Player, StartsStandingCrouchedOrFlyingByTheRoom) {
    World world = lowPassage(0.6_u);
    putBlock(world, 7, 0, 0.0_u, 1.0_u);
    EXPECT_FALSE(Walker(world.copy(), 0.5, 0.5, 0.0).player.crouched);
    EXPECT_TRUE(Walker(world.copy(), 0.5, 0.5, 0.0).player.onGround);
    EXPECT_TRUE(Walker(world.copy(), 3.5, 0.5, 0.0).player.crouched);
    EXPECT_TRUE(Walker(world.copy(), 7.5, 0.5, 0.0).player.flying);
    EXPECT_TRUE(fitsStanding(world, 0, 0.5_u, 0.5_u, 0.0_u));
    EXPECT_FALSE(fitsStanding(world, 0, 3.5_u, 0.5_u, 0.0_u));
}

}  // namespace
}  // namespace slicecast
