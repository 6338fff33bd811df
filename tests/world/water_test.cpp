// Water: wading, swimming, diving, climbing out; and what stands and floats in it.
#include "world/water.h"

#include "walking.h"
#include "world/collision.h"
#include "world/map_entry.h"
#include "world/object_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicecast {
namespace {

// A block of water between two heights of the map, within one level.
void putWater(World& world, int x, int y, Coordinate bottom, Coordinate top) {
    const int level = bottom.tile();
    CellBlueprint water;
    water.isWater = true;
    water.bottom = bottom - tileEdge(level);
    water.top = top - tileEdge(level);
    const auto isLike = [&](const CellBlueprint& other) {
        return other.isWater && other.bottom == water.bottom && other.top == water.top;
    };
    for (std::size_t i = 0; i < world.blueprints.size(); ++i) {
        if (isLike(world.blueprints[i]))
            return world.maps[0].setCell(x, y, level, static_cast<BlueprintId>(i));
    }
    world.blueprints.push_back(water);
    world.maps[0].setCell(x, y, level, static_cast<BlueprintId>(world.blueprints.size() - 1));
}

// Eight tiles in a row: ground up to `bank` in the first two and the last two, and water up to
// `surface` between them.
World canal(Coordinate bank, Coordinate surface) {
    World world = emptyWorld(8, 1, 4);
    const auto fill = [&](int x, Coordinate top, auto put) {
        for (int level = 0; tileEdge(level) < top; ++level)
            put(world, x, 0, tileEdge(level), std::min(top, tileEdge(level + 1)));
    };
    for (const int x : {0, 1, 6, 7}) fill(x, bank, putBlock);
    for (int x = 2; x < 6; ++x) fill(x, surface, putWater);
    return world;
}

constexpr PlayerInput kStill = {.bob = false};

TEST(Water, IsFoundUpToItsSurfaceThroughAllLevels) {
    const World world = canal(2.0_u, 2.75_u);
    const Map& map = world.maps[0];
    EXPECT_EQ(waterAt(world, map, 3, 0, 0.0_u).surface, 2.75_u);
    EXPECT_EQ(waterAt(world, map, 3, 0, 1.5_u).surface, 2.75_u);
    EXPECT_NE(waterAt(world, map, 3, 0, 2.75_u - kTiny).water, nullptr);
    EXPECT_EQ(waterAt(world, map, 3, 0, 2.75_u).water, nullptr);
    EXPECT_EQ(waterAt(world, map, 1, 0, 1.0_u).water, nullptr);
    EXPECT_EQ(waterAt(world, map, -1, 0, 1.0_u).water, nullptr);
}

TEST(Water, WadingIsSlowerTheDeeperItIs) {
    double before = 1e9;
    for (const Coordinate surface : {0.1_u, 0.25_u, 0.45_u}) {
        World world = emptyWorld(12, 1, 2);
        for (int x = 0; x < 12; ++x) putWater(world, x, 0, 0.0_u, surface);
        Walker walker(std::move(world), 0.5, 0.5, 0.0);
        walker.step(kAhead, kSecond);
        const double from = walker.x();
        walker.step(kAhead, kSecond);
        EXPECT_TRUE(walker.player.onGround);
        EXPECT_FALSE(walker.player.swimming);
        EXPECT_LT(walker.x() - from, before);
        before = walker.x() - from;
    }
    EXPECT_NEAR(before, kWalkingPace.move * kWadingPace, 0.01);
}

TEST(Water, SwimmersKeepTheEyeJustAboveDeepWater) {
    Walker walker(canal(1.0_u, 1.0_u), 1.5, 0.5, 1.0);
    const Coordinate onLand = eyeHeight(walker.player);
    walker.step(kAhead, kSecond);
    walker.step(kStill, 5 * kSecond);
    EXPECT_TRUE(walker.player.swimming);
    EXPECT_FALSE(walker.player.onGround);
    EXPECT_NEAR(eyeHeight(walker.player).value(), 1.0 + kFloatingEye.value(), 0.001);
    EXPECT_LT(eyeHeight(walker.player), onLand);
    // and comes to rest there
    const Player rests = walker.player;
    walker.step(kStill, kSecond);
    EXPECT_EQ(walker.player.z, rests.z);
}

TEST(Water, ASwimmerBobsUnlessMotionIsReduced) {
    for (const bool bob : {false, true}) {
        Walker walker(canal(1.0_u, 1.0_u), 3.5, 0.5, 0.8);
        walker.step({.bob = bob}, 4 * kSecond);
        double least = 1e9;
        double most = -1e9;
        for (int i = 0; i < kBobSteps; ++i) {
            walker.step({.bob = bob});
            least = std::min(least, eyeHeight(walker.player).value());
            most = std::max(most, eyeHeight(walker.player).value());
        }
        EXPECT_EQ(most - least > 0.02, bob) << least << " to " << most;
        EXPECT_LT(most - least, 3.0 * kBobHeight);
        EXPECT_GT(least, 1.0 + kFloatingEye.value() / 2.0);
    }
}

TEST(Water, CrouchingDivesAndJumpingComesUpAgain) {
    Walker walker(canal(3.0_u, 3.0_u), 3.5, 0.5, 2.8);
    walker.step({.fly = -1.0}, 4 * kSecond);
    EXPECT_TRUE(walker.player.swimming);
    EXPECT_EQ(walker.z(), 0.0);
    const double bottom = walker.z();
    walker.step(kStill, kSecond);  // drifts up by itself
    EXPECT_NEAR(walker.z() - bottom, kBuoyancy, 0.05);
    walker.step({.jump = true}, kSecond);
    EXPECT_GT(walker.z(), bottom + 1.3);
    walker.step({.jump = true}, 3 * kSecond);
    EXPECT_NEAR(eyeHeight(walker.player).value(), 3.0 + kFloatingEye.value(), 2.0 * kBobHeight);
}

TEST(Water, AFallIntoItIsBroken) {
    World world = canal(3.0_u, 3.0_u);
    Walker walker(std::move(world), 3.5, 0.5, 30.0);
    double fastest = 0.0;
    double deepest = 1e9;
    for (int i = 0; i < 20 * kSecond; ++i) {
        walker.step(kStill);
        fastest = std::min(fastest, walker.player.velocityZ);
        deepest = std::min(deepest, walker.z());
    }
    EXPECT_LT(fastest, -15.0);
    EXPECT_LT(deepest, 2.0);  // it goes under
    EXPECT_TRUE(walker.player.swimming);
    EXPECT_NEAR(eyeHeight(walker.player).value(), 3.0 + kFloatingEye.value(), 0.01);
}

// ---- out of it

TEST(Water, BanksUpToHalfAUnitAreClimbedAndNoneHigher) {
    for (const double bank : {0.7, 0.9, 1.0, 1.2, 1.45, 1.5, 1.55, 2.0}) {
        for (const bool slow : {false, true}) {
            Walker walker(canal(toCoordinate(bank), 1.0_u), 4.0, 0.5, 0.8);
            walker.step(kStill, kSecond);
            ASSERT_TRUE(walker.player.swimming);
            Coordinate before = eyeHeight(walker.player);
            for (int i = 0; i < 6 * kSecond; ++i) {
                walker.step({.forward = 1.0, .slow = slow, .bob = false});
                EXPECT_NEAR(eyeHeight(walker.player).value(), before.value(), 0.05) << bank;
                before = eyeHeight(walker.player);
            }
            if (bank <= 1.5) {
                EXPECT_EQ(walker.player.z, toCoordinate(bank)) << slow;
                EXPECT_GT(walker.x(), 6.0);
                EXPECT_FALSE(walker.player.swimming);
                EXPECT_FALSE(walker.player.crouched);
                EXPECT_TRUE(walker.player.onGround);
            } else {
                EXPECT_LT(walker.x(), 6.0) << bank;
                EXPECT_TRUE(walker.player.swimming) << bank;
            }
        }
    }
}

TEST(Water, PassingABankAlongsideStaysInTheWater) {
    World world = emptyWorld(12, 3, 2);
    for (int x = 0; x < 12; ++x) {
        putBlock(world, x, 0, 0.0_u, 1.0_u);
        for (int y = 1; y < 3; ++y) putWater(world, x, y, 0.0_u, 0.75_u);
    }
    Walker walker(std::move(world), 1.0, 1.5, 0.5, -20.0);
    walker.step(kAhead, 4 * kSecond);
    EXPECT_EQ(walker.player.y, 1.0_u + kBodyHalfWidth);
    EXPECT_GT(walker.x(), 5.0);
    EXPECT_TRUE(walker.player.swimming);
}

TEST(Water, WalksOutAtAShore) {
    // The ground rises from 0 to 1 through water that stands at 1.5 on the next level.
    World deep = emptyWorld(12, 1, 4);
    for (int x = 0; x < 12; ++x) {
        putBlock(deep, x, 0, 0.0_u, std::min(1.0_u, Coordinate{kTiny.raw + x * 8192}));
        if (x < 8) putWater(deep, x, 0, 1.0_u, 1.5_u);
        if (x >= 6) putBlock(deep, x, 0, 1.0_u, x < 7 ? 1.125_u : x < 8 ? 1.3_u : 1.6_u);
    }
    Walker walker(std::move(deep), 0.5, 0.5, 1.1);
    walker.step(kAhead, 12 * kSecond);
    EXPECT_EQ(walker.player.x, 12.0_u - kBodyHalfWidth);
    EXPECT_EQ(walker.player.z, 1.6_u);
    EXPECT_FALSE(walker.player.swimming);
}

TEST(Water, CrouchesWithoutRoomToStand) {
    World world = canal(1.0_u, 1.0_u);
    for (int x = 0; x < 8; ++x) putBlock(world, x, 0, 1.5_u, 2.0_u);
    Walker walker(std::move(world), 4.0, 0.5, 0.8);
    walker.step(kStill, kSecond);
    ASSERT_TRUE(walker.player.swimming);
    walker.step(kAhead, 4 * kSecond);
    EXPECT_GT(walker.x(), 6.0);
    EXPECT_TRUE(walker.player.crouched);
}

TEST(Water, FlyingIsNotAffected) {
    Walker wet(canal(3.0_u, 3.0_u), 3.0, 0.5, 1.0);
    Walker dry(emptyWorld(8, 1, 4), 3.0, 0.5, 1.0);
    for (Walker* walker : {&wet, &dry}) {
        setFlying(walker->world, walker->player, true);
        walker->step({.forward = 1.0, .fly = 0.5}, kSecond / 4);
        walker->step({.fly = -1.0, .jump = true}, kSecond / 4);
    }
    EXPECT_EQ(wet.player, dry.player);
    EXPECT_FALSE(wet.player.swimming);
}

TEST(Water, TheModeChangesInTheWaterAndTheEyeStays) {
    Walker walker(canal(3.0_u, 3.0_u), 3.5, 0.5, 2.0);
    walker.step({.fly = -1.0}, kSecond / 2);
    ASSERT_TRUE(walker.player.swimming);
    const Coordinate eye = eyeHeight(walker.player);
    setFlying(walker.world, walker.player, true);
    EXPECT_TRUE(walker.player.flying);
    EXPECT_FALSE(walker.player.swimming);
    EXPECT_EQ(eyeHeight(walker.player), eye);
    setFlying(walker.world, walker.player, false);
    EXPECT_EQ(eyeHeight(walker.player), eye);
    walker.step(kStill);
    EXPECT_TRUE(walker.player.swimming);
}

// ---- floors of water

World floorOfWater(int width) {
    World world = emptyWorld(width, 1, 2);
    Map& map = world.maps[0];
    map.floor.water = 1;
    for (int x = 3; x < width - 2; ++x) map.floor.tiles[static_cast<std::size_t>(x)] = 1;
    return world;
}

TEST(WaterFloor, BodiesWadeInItAndTheEyeStaysAboveIt) {
    Walker walker(floorOfWater(9), 0.5, 0.5, 0.0);
    walker.step(kAhead, 2 * kSecond);
    EXPECT_EQ(walker.player.z, Coordinate{-kFloorWade.raw});
    EXPECT_FALSE(walker.player.swimming);
    for (const PlayerInput& input :
         {kCrouchedAhead, PlayerInput{.jump = true}, PlayerInput{.forward = -1.0, .fly = -1.0}}) {
        for (int i = 0; i < kSecond; ++i) {
            walker.step(input);
            ASSERT_GT(eyeHeight(walker.player), 0.0_u);
        }
    }
    setFlying(walker.world, walker.player, true);
    walker.step({.fly = -1.0}, 2 * kSecond);
    EXPECT_GT(eyeHeight(walker.player), 0.0_u);
    setFlying(walker.world, walker.player, false);
    walker.step(kAhead, 6 * kSecond);
    EXPECT_GT(walker.x(), 8.0);  // out at the other side
    EXPECT_EQ(walker.z(), 0.0);
}

TEST(WaterFloor, BeginsAtItsTile) {
    const World world = floorOfWater(9);
    EXPECT_TRUE(isFree(world, 0, bodyBox(4.5_u, 0.5_u, {-kFloorWade.raw}, kStandingHeight)));
    EXPECT_FALSE(isFree(world, 0, bodyBox(3.1_u, 0.5_u, {-kTiny.raw}, kStandingHeight)));
    EXPECT_FALSE(isFree(world, 0, bodyBox(4.5_u, 0.5_u, {-kFloorWade.raw - 1}, kStandingHeight)));
    EXPECT_FALSE(isFree(world, 0, bodyBox(4.5_u, 0.5_u, {-1}, kStandingHeight), true));
}

// ---- objects

int addWalker(World& world, Coordinate x, Coordinate z, bool floats) {
    world.maps[0].objects.push_back(
        {.x = x, .y = 0.5_u, .z = z, .width = 0.4_u, .height = 0.5_u, .floats = floats});
    const int object = static_cast<int>(world.maps[0].objects.size()) - 1;
    ObjectMotion motion;
    motion.kind = ObjectMotion::Kind::pace;
    motion.object = object;
    motion.speed = 1.0;
    motion.reach = 5.5_u;
    world.movingObjects.motions.push_back(motion);
    return object;
}

TEST(WaterObjects, WalkersWadeUpToHalfTheirHeightAndTurnBack) {
    for (const Coordinate surface : {0.2_u, 0.3_u}) {
        World world = emptyWorld(8, 1, 2);
        for (int x = 3; x < 8; ++x) putWater(world, x, 0, 0.0_u, surface);
        addWalker(world, 1.0_u, 0.0_u, false);
        startObjects(world);
        double farthest = 0.0;
        for (int i = 0; i < 8 * kSecond; ++i) {
            stepObjects(world);
            const Object& object = world.maps[0].objects[0];
            farthest = std::max(farthest, object.x.value());
            EXPECT_EQ(object.z, 0.0_u);
        }
        EXPECT_EQ(farthest > 4.0, surface == 0.2_u);
        EXPECT_GT(farthest, 2.5);
    }
}

TEST(WaterObjects, FloatingOnesCrossWaterAndGoOntoTheBank) {
    World world = canal(1.0_u, 0.75_u);
    addWalker(world, 2.5_u, 0.1_u, true);
    startObjects(world);
    EXPECT_EQ(world.maps[0].objects[0].z, 0.75_u);  // put onto the surface
    double highest = 0.0;
    for (int i = 0; i < 8 * kSecond; ++i) {
        stepObjects(world);
        highest = std::max(highest, world.maps[0].objects[0].z.value());
        EXPECT_GE(world.maps[0].objects[0].z, 0.75_u);
    }
    EXPECT_EQ(highest, 1.0);
}

TEST(WaterObjects, StandInAFloorOfWater) {
    World world = floorOfWater(9);
    addWalker(world, 4.5_u, 0.0_u, false);
    addWalker(world, 5.5_u, 0.0_u, true);
    startObjects(world);
    for (int i = 0; i < kSecond / 2; ++i) stepObjects(world);
    EXPECT_EQ(world.maps[0].objects[0].z, Coordinate{-kFloorWade.raw});
    EXPECT_EQ(world.maps[0].objects[1].z, 0.0_u);
}

// ---- ways in

TEST(Water, NobodyEntersAMapUnderWater) {
    World world = canal(1.0_u, 1.0_u);
    const MapEntry entry = findMapEntry(world, 0);
    EXPECT_TRUE(entry.stands);
    EXPECT_EQ(entry.feet, 1.0_u);
    EXPECT_EQ(waterAt(world, world.maps[0], entry.x.tile(), 0, entry.feet).water, nullptr);
}

}  // namespace
}  // namespace slicecast
