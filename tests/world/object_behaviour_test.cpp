// Actors: objects that stand, patrol, greet, follow and flee, and how their pictures follow.
#include "portal_worlds.h"
#include "stage.h"

#include "base/hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

using Reaction = ObjectMotion::Reaction;

std::uint64_t hashOfActors(const World& world) {
    Hash hash;
    addMovingObjects(hash, world);
    return hash.value();
}

double distance(const Stage& stage, std::size_t motion = 0) {
    return std::hypot(stage.x(motion) - stage.player.x.value(),
                      stage.y(motion) - stage.player.y.value());
}

TEST(Patrol, WalksFromPointToPointAndRoundAgain) {
    World world = emptyWorld(12, 12, 1);
    addActor(world, 2.0, 2.0,
             patrolling(world, {point(8.0, 2.0), point(8.0, 6.0), point(2.0, 2.0)}, 2.0));
    Stage stage(std::move(world), 11.0, 11.0);
    stage.stepFor(3.0);
    EXPECT_NEAR(stage.x(), 8.0, 0.05);
    EXPECT_NEAR(stage.y(), 2.0, 0.05);
    EXPECT_EQ(stage.object().facingY, 0.0_u);
    stage.stepFor(2.0);
    EXPECT_NEAR(stage.y(), 6.0, 0.1);
    EXPECT_EQ(stage.object().facingX, 0.0_u);
    stage.stepFor(3.7);
    EXPECT_NEAR(stage.x(), 2.0, 0.2);
    EXPECT_EQ(stage.world.movingObjects.motions[0].point, 0);
}

TEST(Patrol, GoesBackAlongAPathWithoutALoop) {
    World world = emptyWorld(12, 4, 1);
    ObjectMotion motion = patrolling(world, {point(2.0, 2.0), point(6.0, 2.0), point(9.0, 2.0)});
    motion.loops = false;
    addActor(world, 2.0, 2.0, motion);
    Stage stage(std::move(world), 11.0, 1.0);
    stage.stepFor(7.5);
    EXPECT_NEAR(stage.x(), 8.5, 0.2);
    EXPECT_TRUE(stage.world.movingObjects.motions[0].back);
    stage.stepFor(6.8);
    EXPECT_LT(stage.x(), 2.4);
}

TEST(Patrol, WaitsAtAPoint) {
    World world = emptyWorld(12, 4, 1);
    ObjectMotion motion = patrolling(world, {point(4.0, 2.0), point(9.0, 2.0)});
    world.movingObjects.paths[0][0].waitSteps = 3 * kStepsPerSecond;
    addActor(world, 2.0, 2.0, motion);
    Stage stage(std::move(world), 11.0, 1.0);
    stage.stepFor(4.8);
    EXPECT_NEAR(stage.x(), 4.0, 0.001);
    stage.stepFor(1.0);
    EXPECT_GT(stage.x(), 4.5);
}

TEST(Patrol, ClimbsStepsAndOpensGatesThatOpenOnApproach) {
    World world = emptyWorld(12, 3, 2);
    for (int x = 0; x < 12; ++x)
        for (const int y : {0, 2}) putBlock(world, x, y, {}, 1.0_u);
    putBlock(world, 4, 1, {}, 0.4_u);
    putBlock(world, 5, 1, {}, 0.8_u);
    putBlock(world, 6, 1, {}, 0.4_u);
    GateKind kind;
    kind.opensOnApproach = true;
    kind.approach = 1.0_u;
    const BlueprintId gate = addGate(world, kind);
    for (const int level : {0, 1}) world.maps[0].setCell(8, 1, level, gate);
    ASSERT_TRUE(makeGates(world).empty());
    addActor(world, 2.0, 1.5, patrolling(world, {point(10.5, 1.5), point(2.0, 1.5)}));
    Stage stage(std::move(world), 0.5, 1.5);
    double highest = 0.0;
    double farthest = 0.0;
    for (int i = 0; i < 14 * kStepsPerSecond; ++i) {
        stage.step();
        highest = std::max(highest, stage.object().z.value());
        farthest = std::max(farthest, stage.x());
    }
    EXPECT_NEAR(highest, 0.8, 0.001);
    EXPECT_NEAR(farthest, 10.5, 0.01);
}

// A wall across the way, with room at its end: it goes round, or gives the point up.
TEST(Patrol, IsNeverStuckForever) {
    World world = emptyWorld(12, 8, 1);
    for (int y = 2; y < 8; ++y) putBlock(world, 6, y, {}, 1.0_u);
    addActor(world, 2.0, 6.5, patrolling(world, {point(10.0, 6.5), point(2.0, 2.0)}));
    Stage stage(std::move(world), 0.5, 0.5);
    int points = 0;
    int before = 0;
    for (int i = 0; i < 120 * kStepsPerSecond; ++i) {
        stage.step();
        const int now = stage.world.movingObjects.motions[0].point;
        points += now != before;
        before = now;
    }
    EXPECT_GE(points, 3);
}

TEST(Patrol, LeadsThroughPortalsToOtherMaps) {
    World world = emptyWorld(8, 3, 1);
    world.maps.push_back(makeMap("other", 8, 3, 1, 0));
    for (const int y : {0, 1, 2}) {
        putTilePortal(world,
                      {.fromMap = 0, .fromX = 7, .fromY = y, .toMap = 1, .toX = 1, .toY = y});
        putTilePortal(world,
                      {.fromMap = 1, .fromX = 0, .fromY = y, .toMap = 0, .toX = 6, .toY = y});
    }
    addActor(world, 2.0, 1.5, patrolling(world, {point(6.0, 1.5, 1), point(2.0, 1.5)}, 2.0));
    Stage stage(std::move(world), 0.5, 0.5);
    bool wasThere = false;
    int leftAfter = 0;
    for (int i = 0; i < 20 * kStepsPerSecond; ++i) {
        stage.step();
        const bool isThere = stage.world.movingObjects.motions[0].map == 1;
        leftAfter += wasThere && !isThere;
        wasThere = isThere;
    }
    EXPECT_GE(leftAfter, 1);
}

TEST(Patrol, WaitsForTheHeightOfAPoint) {
    World world = emptyWorld(8, 3, 2);
    ObjectMotion motion = patrolling(world, {point(4.0, 1.5), point(6.0, 1.5)});
    world.movingObjects.paths[0][0].feet = 1.0_u;
    addActor(world, 2.0, 1.5, motion);
    Stage stage(std::move(world), 0.5, 0.5);
    stage.stepFor(10.0);
    EXPECT_NEAR(stage.x(), 4.0, 0.001);  // no lift has come
    // One lifts it
    stage.world.maps[0].objects[0].z = 1.0_u;
    stage.step();
    EXPECT_EQ(stage.world.movingObjects.motions[0].point, 1);
}

TEST(Alert, BeginsNearAndInSightAndEndsLater) {
    World world = emptyWorld(12, 12, 1);
    putBlock(world, 5, 5, {}, 1.0_u);
    addActor(world, 3.0, 5.5, standing(Reaction::greet));
    Stage stage(std::move(world), 11.0, 5.5);
    const ObjectMotion& motion = stage.world.movingObjects.motions[0];
    stage.stepFor(1.0);
    EXPECT_EQ(motion.alertSteps, 0);  // too far
    stage.putPlayer(6.5, 5.5);
    stage.stepFor(1.0);
    EXPECT_EQ(motion.alertSteps, 0);  // behind a block
    stage.putPlayer(3.0, 8.0);
    stage.stepFor(0.2);
    EXPECT_GT(motion.alertSteps, 0);
    EXPECT_EQ(stage.object().facingY, 1.0_u);
    EXPECT_EQ(stage.object().facingX, 0.0_u);
    stage.putPlayer(11.0, 5.5);
    stage.stepFor(1.7);
    EXPECT_GT(motion.alertSteps, 0);
    stage.stepFor(0.5);
    EXPECT_EQ(motion.alertSteps, 0);
    EXPECT_EQ(stage.object().facingX, 1.0_u);  // as before
}

TEST(Alert, FollowersComeCloseAndStopThere) {
    World world = emptyWorld(14, 14, 1);
    addActor(world, 3.0, 3.0, standing(Reaction::follow));
    Stage stage(std::move(world), 6.0, 3.0);
    stage.stepFor(3.0);
    EXPECT_NEAR(distance(stage), 0.9, 0.05);
    const double x = stage.x();
    stage.stepFor(2.0);
    EXPECT_EQ(stage.x(), x);
    // Back home once the player is gone
    stage.putPlayer(13.0, 13.0);
    stage.stepFor(12.0);
    EXPECT_NEAR(stage.x(), 3.0, 0.05);
    EXPECT_NEAR(stage.y(), 3.0, 0.05);
}

TEST(Alert, FollowersComeThroughPortals) {
    World world = emptyWorld(8, 3, 1);
    world.maps.push_back(makeMap("other", 8, 3, 1, 0));
    for (const int y : {0, 1, 2})
        putTilePortal(world,
                      {.fromMap = 0, .fromX = 7, .fromY = y, .toMap = 1, .toX = 1, .toY = y});
    addActor(world, 3.0, 1.5, standing(Reaction::follow));
    Stage stage(std::move(world), 6.0, 1.5);
    stage.stepFor(0.3);
    stage.putPlayer(5.0, 1.5, 1);
    stage.stepFor(5.0);
    EXPECT_EQ(stage.world.movingObjects.motions[0].map, 1);
    EXPECT_LT(distance(stage), 1.0);
}

TEST(Alert, ThoseWhoFleeGetAwayAlsoFromACorner) {
    World world = emptyWorld(14, 14, 1);
    addActor(world, 7.0, 7.0, standing(Reaction::flee));
    addActor(world, 0.5, 0.5, standing(Reaction::flee));
    Stage stage(std::move(world), 6.0, 7.0);
    stage.stepFor(1.5);
    EXPECT_GT(distance(stage), 3.0);
    stage.putPlayer(1.6, 1.4);
    double farthest = 0.0;
    for (int i = 0; i < 3 * kStepsPerSecond; ++i) {
        stage.step();
        farthest = std::max(farthest, distance(stage, 1));
    }
    EXPECT_GT(farthest, 1.6);
}

TEST(Alert, AWandererWalksAgainAfterIt) {
    World world = emptyWorld(14, 14, 1);
    ObjectMotion motion = standing(Reaction::greet);
    motion.kind = ObjectMotion::Kind::wander;
    addActor(world, 7.0, 7.0, motion);
    Stage stage(std::move(world), 8.5, 7.0);
    stage.stepFor(0.3);
    const double x = stage.x();
    stage.stepFor(1.0);
    EXPECT_EQ(stage.x(), x);
    stage.putPlayer(0.5, 13.5);
    stage.stepFor(4.0);
    EXPECT_NE(stage.x(), x);
}

TEST(Actors, ShowTheSpriteOfTheirState) {
    World world = emptyWorld(14, 14, 1);
    ObjectMotion motion = standing(Reaction::follow);
    motion.walking = SpriteId{7};
    motion.alert = SpriteId{8};
    addActor(world, 3.0, 3.0, motion);
    world.maps[0].objects[0].sprite = 6;
    Stage stage(std::move(world), 12.0, 12.0);
    stage.step();
    EXPECT_EQ(stage.object().sprite, 6);
    stage.putPlayer(6.0, 3.0);
    stage.stepFor(0.5);
    EXPECT_EQ(stage.object().sprite, 7);
    stage.stepFor(3.0);
    EXPECT_EQ(stage.object().sprite, 8);
    resetObjects(stage.world);
    EXPECT_EQ(stage.world.maps[0].objects[0].sprite, 6);
}

TEST(Actors, DoTheSameTwiceAndTheirHashTellsThemApart) {
    const auto play = [](double x) {
        World world = emptyWorld(14, 14, 1);
        addActor(world, 3.0, 3.0, standing(Reaction::follow));
        addActor(world, 9.0, 9.0, patrolling(world, {point(2.0, 9.0), point(9.0, 2.0)}));
        addActor(world, 5.0, 5.0, standing(Reaction::flee));
        Stage stage(std::move(world), x, 4.0);
        stage.stepFor(4.0, {.forward = 0.5, .turn = 0.2});
        return hashOfActors(stage.world);
    };
    EXPECT_EQ(play(5.0), play(5.0));
    EXPECT_NE(play(5.0), play(5.1));
}

// Each side by hand: an object that faces east, seen from all around.
TEST(Actors, TurnASideToTheEye) {
    Object object;
    EXPECT_EQ(sideTowards(object, 10, 0), ObjectSide::front);
    EXPECT_EQ(sideTowards(object, 10, 9), ObjectSide::front);
    EXPECT_EQ(sideTowards(object, 10, 10), ObjectSide::front);   // a tie
    EXPECT_EQ(sideTowards(object, 10, -10), ObjectSide::front);  // a tie
    EXPECT_EQ(sideTowards(object, 9, 10), ObjectSide::right);    // the south is to its right
    EXPECT_EQ(sideTowards(object, 0, 10), ObjectSide::right);
    EXPECT_EQ(sideTowards(object, -9, 10), ObjectSide::right);
    EXPECT_EQ(sideTowards(object, -10, 10), ObjectSide::back);   // a tie
    EXPECT_EQ(sideTowards(object, -10, -10), ObjectSide::back);  // a tie
    EXPECT_EQ(sideTowards(object, 0, -10), ObjectSide::left);
    EXPECT_EQ(sideTowards(object, 0, 0), ObjectSide::front);
    object.facingX = {};
    object.facingY = tileEdge(-1);  // north
    EXPECT_EQ(sideTowards(object, 10, 0), ObjectSide::right);
    EXPECT_EQ(sideTowards(object, 0, -10), ObjectSide::front);
}

// With more pairs of patrols and portals than a step compares, the patrols ask for their portals in
// turn; who has not asked yet waits where it is.
TEST(Patrol, AsksForPortalsInTurnWhereThereAreMany) {
    World world = emptyWorld(30, 30, 1);
    world.maps.push_back(emptyWorld(30, 30, 1).maps[0]);
    constexpr int kSide = 20;
    for (int i = 0; i < kSide * kSide; ++i)
        putTilePortal(world, {.fromMap = 0,
                              .fromX = i % kSide,
                              .fromY = 8 + i / kSide,
                              .toMap = 1,
                              .toX = i % kSide,
                              .toY = i / kSide});
    constexpr int kPatrols = 400;
    static_assert(kPatrols * kSide * kSide > static_cast<int>(kMostPortalLooks));
    for (int i = 0; i < kPatrols; ++i) {
        ObjectMotion motion = patrolling(world, {point(2.0, 2.0, 1)});
        motion.solid = false;
        addActor(world, 5.5, 4.5, motion);
    }
    EXPECT_EQ(turnsOfPatrols(world), 2u);
    Stage stage(std::move(world), 25.5, 25.5);
    const auto walking = [&] {
        return std::count_if(stage.world.movingObjects.motions.begin(),
                             stage.world.movingObjects.motions.end(),
                             [](const ObjectMotion& motion) { return motion.isWalking; });
    };
    stage.step();
    EXPECT_EQ(walking(), kPatrols / 2);
    stage.step();
    EXPECT_EQ(walking(), kPatrols);
    stage.stepFor(8.0);
    for (const ObjectMotion& motion : stage.world.movingObjects.motions) EXPECT_EQ(motion.map, 1);
}

}  // namespace
}  // namespace slicecast
