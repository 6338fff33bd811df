// Known answers: where portals put things, and how somebody walks, jumps and falls through them.
#include "world/portal.h"

#include "portal_worlds.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Portal, TurnsClockwiseAboutTheMiddleOfTheTile) {
    // A quarter to the north of the middle goes to the east, the south, the west.
    const Position north = {3.5_u, 5.25_u, 0.75_u};
    const Position ends[] = {{10.5_u, 20.25_u, 2.75_u},
                             {10.75_u, 20.5_u, 2.75_u},
                             {10.5_u, 20.75_u, 2.75_u},
                             {10.25_u, 20.5_u, 2.75_u}};
    for (int turn = 0; turn < 4; ++turn) {
        const Portal portal = {.fromMap = 0,
                               .fromX = 3,
                               .fromY = 5,
                               .toMap = 1,
                               .toX = 10,
                               .toY = 20,
                               .turn = turn,
                               .levels = 2};
        EXPECT_EQ(carried(portal, north), ends[turn]) << turn;
        EXPECT_EQ(carriedHeading(portal, 10.0), 10.0 + 90.0 * turn);
        EXPECT_EQ(turned(Face::north, turn), static_cast<Face>(turn));
        EXPECT_EQ(turned(Face::top, turn), Face::top);
    }
}

TEST(Portal, ReversedUndoesItExactly) {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const auto tile = [&random] { return random.below(kMaxMapWidth); };
        const Portal portal = {.fromMap = 2,
                               .fromX = tile(),
                               .fromY = tile(),
                               .toMap = 5,
                               .toX = tile(),
                               .toY = tile(),
                               .turn = random.below(4),
                               .levels = random.between(-32, 32)};
        const Position place = {
            {random.below(1 << 28)}, {random.below(1 << 28)}, {random.below(1 << 26)}};
        const Portal back = reversed(portal);
        EXPECT_EQ(carried(back, carried(portal, place)), place);
        EXPECT_EQ(reversed(back), portal);
        const GridTile at = {random.between(-5, 5000), random.between(-5, 5000)};
        EXPECT_EQ(carried(back, carried(portal, at)), at);
        EXPECT_TRUE(leadOnTogether(portal, portalAt(portal, tile(), tile())));
    }
}

TEST(Portal, MovesPlacesOnTheFarEdgeInside) {
    const Portal portal = {.fromMap = 0,
                           .fromX = 0,
                           .fromY = 0,
                           .toMap = 0,
                           .toX = 4,
                           .toY = 4,
                           .turn = 2,
                           .levels = 0};
    EXPECT_EQ(carried(portal, Position{0.0_u, 0.5_u, 0.0_u}), (Position{5.0_u, 4.5_u, 0.0_u}));
    EXPECT_EQ(keptInside({4, 4}, {5.0_u, 4.5_u, 0.0_u}), (Position{5.0_u - kTiny, 4.5_u, 0.0_u}));
    EXPECT_EQ(keptInside({4, 4}, {4.0_u, 5.0_u, 0.0_u}), (Position{4.0_u, 5.0_u - kTiny, 0.0_u}));
    EXPECT_EQ(keptInside({4, 4}, {4.0_u, 4.0_u, 0.0_u}), (Position{4.0_u, 4.0_u, 0.0_u}));
}

// A room of 8 x 3 with a wall in column 6, whose block in row 1 leads south in a second room of 5 x
// 8, from its tile (2, 1) on.
World doorway() {
    World world = emptyWorld(8, 3, 2);
    for (int y = 0; y < 3; ++y) putBlock(world, 6, y, 0.0_u, 1.0_u);
    world.maps.push_back(makeMap("second", 5, 8, 2, kNoTexture));
    putFacePortal(world,
                  {.fromMap = 0,
                   .fromX = 6,
                   .fromY = 1,
                   .toMap = 1,
                   .toX = 2,
                   .toY = 1,
                   .turn = 1,
                   .levels = 0},
                  0, Face::west);
    return world;
}

TEST(Traveller, KeepsItsSpeedAndView) {
    Walker walker(doorway(), 4.5, 1.4, 0.0, 10.0);
    walker.step(kAhead, kSecond / 4);
    EXPECT_EQ(walker.player.map, 0);
    while (walker.player.map == 0 && walker.x() < 7.0) {
        const Player before = walker.player;
        walker.step(kAhead);
        if (walker.player.map == 0) continue;
        EXPECT_EQ(walker.player.leaps, 1);
        EXPECT_EQ(walker.player.headingDegrees, 100.0);
        EXPECT_NEAR(walker.player.velocityY, before.velocityX, 1e-9);
        EXPECT_NEAR(walker.player.velocityX, -before.velocityY, 1e-9);
        // It went 1/40 along its way in this step, as in every other: partly on this side, partly
        // on that.
        const double ahead = (6.0 - before.x.value()) + (walker.y() - 1.0);
        EXPECT_NEAR(ahead, before.velocityX * kStepSeconds, 4.0 / 65536);
        EXPECT_GT(walker.y(), 1.0);
    }
    ASSERT_EQ(walker.player.map, 1);
    walker.step(kAhead, kSecond);
    EXPECT_NEAR(walker.y(), 4.0, 0.1);
}

TEST(Traveller, IsStoppedByTheSameBlockFromElsewhere) {
    for (const double degrees : {90.0, 180.0, 270.0}) {
        World world = doorway();
        Walker walker(world.copy(), degrees == 180.0 ? 7.5 : 6.5,
                      degrees == 90.0    ? 0.5
                      : degrees == 270.0 ? 2.5
                                         : 1.5,
                      1.0, degrees);
        walker.step(kAhead, kSecond);
        EXPECT_EQ(walker.player.leaps, 0) << "over its roof";
    }
    Walker behind(doorway(), 7.5, 1.5, 0.0, 180.0);
    behind.step(kAhead, kSecond);
    EXPECT_EQ(behind.player.leaps, 0);
    EXPECT_EQ(behind.player.x - kBodyHalfWidth, tileEdge(7));
}

TEST(Traveller, DoesNotReturnThroughAOneWayPortal) {
    Walker walker(doorway(), 5.5, 1.5, 0.0);
    walker.step(kAhead, kSecond);
    ASSERT_EQ(walker.player.map, 1);
    setHeading(walker.player, 270.0);
    walker.step(kAhead, 2 * kSecond);
    EXPECT_EQ(walker.player.map, 1);
    EXPECT_EQ(walker.player.y - kBodyHalfWidth, tileEdge(0)) << "on to the edge of the second room";
}

// What stands behind the exit does not hold up who comes out of it.
TEST(Traveller, ComesOutOfASolidWall) {
    World world = doorway();
    for (int x = 0; x < 5; ++x) world.maps[1].setCell(x, 0, 0, world.maps[0].cell(6, 0, 0));
    Walker walker(world.copy(), 5.5, 1.5, 0.0);
    bool straddled = false;
    for (int step = 0; step < kSecond; ++step) {
        walker.step(kAhead);
        straddled = straddled || walker.player.behind.isOn;
        EXPECT_TRUE(isFree(walker.world, travellerOf(walker.player)));
    }
    EXPECT_EQ(walker.player.map, 1);
    EXPECT_GT(walker.y(), 3.0);
    EXPECT_TRUE(straddled);
    EXPECT_FALSE(walker.player.behind.isOn);
    setHeading(walker.player, 270.0);
    walker.step(kAhead, 2 * kSecond);
    EXPECT_EQ(walker.player.y - kBodyHalfWidth, tileEdge(1))
        << "and it is a wall to who comes back";
}

// What stands beyond the portal stops the body before the eye gets there.
TEST(Traveller, BumpsIntoBlocksOnTheOtherSide) {
    World world = doorway();
    world.maps[1].setCell(2, 2, 0, world.maps[0].cell(6, 0, 0));
    Walker near(world.copy(), 5.0, 1.5, 0.0);
    near.step(kAhead, kSecond);
    EXPECT_EQ(near.player.map, 1);
    EXPECT_EQ(near.player.y + kBodyHalfWidth, tileEdge(2));
    world.maps[1].setCell(2, 1, 0, world.maps[0].cell(6, 0, 0));
    Walker shut(world.copy(), 5.0, 1.5, 0.0);
    shut.step(kAhead, kSecond);
    EXPECT_EQ(shut.player.map, 0);
    EXPECT_EQ(shut.player.x + kBodyHalfWidth, tileEdge(6));
}

// A step on the other side is taken before the eye is there.
TEST(Traveller, ClimbsBlocksOnTheOtherSide) {
    World world = doorway();
    CellBlueprint slab;
    slab.top = 0.5_u;
    world.blueprints.push_back(slab);
    for (int y = 1; y < 8; ++y)
        world.maps[1].setCell(2, y, 0, static_cast<BlueprintId>(world.blueprints.size() - 1));
    Walker walker(world.copy(), 5.0, 1.5, 0.0);
    bool wasUpBefore = false;
    for (int step = 0; step < kSecond; ++step) {
        walker.step(kAhead);
        wasUpBefore = wasUpBefore || (walker.player.map == 0 && walker.player.z == 0.5_u);
    }
    EXPECT_EQ(walker.player.map, 1);
    EXPECT_EQ(walker.player.z, 0.5_u);
    EXPECT_TRUE(wasUpBefore);
}

// A roof that leads into another room: who steps onto it falls, and goes on falling there as fast.
TEST(Traveller, FallsThroughATop) {
    World world = emptyWorld(3, 1, 6);
    for (int x = 0; x < 3; ++x) putBlock(world, x, 0, 0.0_u, 1.0_u);
    world.maps.push_back(makeMap("below", 3, 3, 1, kNoTexture));
    putFacePortal(world,
                  {.fromMap = 0,
                   .fromX = 1,
                   .fromY = 0,
                   .toMap = 1,
                   .toX = 1,
                   .toY = 1,
                   .turn = 2,
                   .levels = 4},
                  0, Face::top);
    Walker walker(world.copy(), 1.5, 0.5, 3.0, 30.0);
    double fastest = 0.0;
    while (walker.player.map == 0 && !walker.player.onGround) {
        fastest = walker.player.velocityZ;
        walker.step(kNothing);
    }
    ASSERT_EQ(walker.player.map, 1);
    EXPECT_NEAR(walker.player.velocityZ, fastest - kGravity * kStepSeconds, 1e-9);
    EXPECT_EQ(walker.player.headingDegrees, 210.0);
    EXPECT_NEAR(walker.player.z.value() + 0.5, 5.0, 0.1);
    walker.step(kNothing, 2 * kSecond);
    EXPECT_EQ(walker.player.z, 0.0_u);
    EXPECT_TRUE(walker.player.onGround);
}

TEST(Traveller, TilesActAtAllHeightsButNotOnEyesInside) {
    for (const double height : {0.0, 3.25}) {
        World world = emptyWorld(6, 1, 1);
        world.maps.push_back(makeMap("far", 9, 9, 1, kNoTexture));
        putTilePortal(world, {.fromMap = 0,
                              .fromX = 3,
                              .fromY = 0,
                              .toMap = 1,
                              .toX = 4,
                              .toY = 4,
                              .turn = 3,
                              .levels = 1});
        Walker walker(world.copy(), 1.5, 0.5, height);
        setFlying(walker.world, walker.player, true);
        walker.step(kAhead, kSecond / 2);
        EXPECT_EQ(walker.player.map, 1) << height;
        EXPECT_EQ(walker.player.headingDegrees, 270.0);
        EXPECT_NEAR(walker.z(), height + 1.25, 0.01);

        Walker inside(world.copy(), 3.5, 0.5, height);
        setFlying(inside.world, inside.player, true);
        inside.step(kAhead, kSecond / 4);
        EXPECT_EQ(inside.player.map, 0) << height;
        EXPECT_GT(inside.x(), 4.0);
        setHeading(inside.player, 180.0);
        inside.step(kAhead, kSecond / 2);
        EXPECT_EQ(inside.player.map, 1) << height;
    }
}

// One step may lead through several.
TEST(Traveller, GoesThroughSeveralInOneStep) {
    World world = emptyWorld(4, 1, 1);
    for (int x = 1; x < 4; ++x) {
        world.maps.push_back(makeMap("on", 4, 1, 1, kNoTexture));
        putTilePortal(world, {.fromMap = x - 1,
                              .fromX = x,
                              .fromY = 0,
                              .toMap = x,
                              .toX = x,
                              .toY = 0,
                              .turn = 0,
                              .levels = 0});
    }
    Walker walker(world.copy(), 0.5, 0.5, 0.0);
    Traveller body = travellerOf(walker.player);
    const Travelled way = slide(walker.world, body, 2.75_u, {}, {});
    EXPECT_FALSE(way.stoppedX);
    EXPECT_EQ(body.map, 3);
    EXPECT_EQ(body.leaps, 3);
    EXPECT_EQ(body.eye.x, 3.25_u);
}

}  // namespace
}  // namespace slicecast
