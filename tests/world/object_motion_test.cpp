// Objects that move by themselves: how each kind goes its way, that none is ever inside anything,
// and that it all happens the same way twice.
#include "walking.h"

#include "base/hash.h"
#include "sanitized.h"
#include "world/object_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace slicecast {
namespace {

// Adds an object, 0.3 wide and 0.8 high, and how it moves. The world's map must be complete before
// it is started.
void addMoving(World& world, double x, double y, double z, ObjectMotion motion) {
    std::vector<Object>& objects = world.maps[static_cast<std::size_t>(motion.map)].objects;
    motion.object = static_cast<int>(objects.size());
    Object object;
    object.x = toCoordinate(x);
    object.y = toCoordinate(y);
    object.z = toCoordinate(z);
    object.width = 0.3_u;
    object.height = 0.8_u;
    objects.push_back(object);
    world.movingObjects.motions.push_back(motion);
}

ObjectMotion wanderer(double heading, double speed = 1.0, std::uint64_t seed = 1) {
    ObjectMotion motion;
    motion.kind = ObjectMotion::Kind::wander;
    motion.headingDegrees = heading;
    motion.speed = speed;
    motion.random = Random(seed);
    return motion;
}

ObjectMotion pacer(double heading, double length, double speed = 1.0) {
    ObjectMotion motion;
    motion.kind = ObjectMotion::Kind::pace;
    motion.headingDegrees = heading;
    motion.reach = toCoordinate(length);
    motion.speed = speed;
    return motion;
}

ObjectMotion circler(double heading, double radius, double speed = 1.0) {
    ObjectMotion motion = pacer(heading, radius, speed);
    motion.kind = ObjectMotion::Kind::circle;
    return motion;
}

const Object& objectOf(const World& world, std::size_t motion = 0) {
    const ObjectMotion& moving = world.movingObjects.motions[motion];
    return world.maps[static_cast<std::size_t>(moving.map)]
        .objects[static_cast<std::size_t>(moving.object)];
}

void stepFor(World& world, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * kStepsPerSecond + 0.5); ++i) stepObjects(world);
}

std::uint64_t hashOf(const World& world) {
    Hash hash;
    addMovingObjects(hash, world);
    return hash.value();
}

TEST(ObjectMotion, BodiesAreAsWideAsTheirPicturesWithinLimits) {
    Object object;
    object.x = 2.0_u;
    object.y = 3.0_u;
    object.z = 1.0_u;
    object.height = 0.5_u;
    for (const auto& [width, body] :
         {std::pair{0.3_u, 0.3_u}, {2.0_u, kWidestBody}, {0.01_u, kNarrowestBody}}) {
        object.width = width;
        const Box box = objectBody(object);
        EXPECT_NEAR((box.east - box.west).raw, body.raw, 1);
        EXPECT_EQ(box.south - box.north, box.east - box.west);
        EXPECT_EQ(box.west.raw + box.east.raw, 2 * object.x.raw);
        EXPECT_EQ(box.bottom, object.z);
        EXPECT_EQ(box.top, 1.5_u);
    }
}

TEST(ObjectMotion, PacingGoesToAndFroBetweenTheSamePlaces) {
    World world = emptyWorld(10, 10, 1);
    addMoving(world, 2.0, 5.0, 0.0, pacer(0.0, 3.0));
    startObjects(world);
    stepFor(world, 1.5);
    EXPECT_NEAR(objectOf(world).x.value(), 3.5, 0.01);
    EXPECT_EQ(world.movingObjects.motions[0].headingDegrees, 0.0);
    stepFor(world, 1.5);
    EXPECT_NEAR(objectOf(world).x.value(), 5.0, 0.02);
    stepFor(world, 1.0);
    EXPECT_NEAR(objectOf(world).x.value(), 4.0, 0.03);
    EXPECT_EQ(world.movingObjects.motions[0].headingDegrees, 180.0);

    // For ever: the ends stay where they are, to the last bit.
    Coordinate least = 9.0_u;
    Coordinate most = {};
    for (int i = 0; i < 100 * kStepsPerSecond; ++i) {
        stepObjects(world);
        least = std::min(least, objectOf(world).x);
        most = std::max(most, objectOf(world).x);
    }
    EXPECT_EQ(least, 2.0_u);
    EXPECT_NEAR(most.value(), 5.0, 0.01);
    EXPECT_EQ(objectOf(world).y, 5.0_u);
}

TEST(ObjectMotion, PacingTurnsAtABlockAndKeepsToItsLine) {
    World world = emptyWorld(10, 10, 1);
    putBlock(world, 6, 5, 0.0_u, 1.0_u);
    addMoving(world, 2.0, 4.5, 0.0, pacer(20.0, 6.0));
    startObjects(world);
    double farthest = 0.0;
    const double slope = std::tan(20.0 * 3.14159265358979 / 180.0);
    for (int i = 0; i < 30 * kStepsPerSecond; ++i) {
        stepObjects(world);
        const Object& object = objectOf(world);
        farthest = std::max(farthest, object.x.value());
        ASSERT_NEAR(object.y.value(), 4.5 + (object.x.value() - 2.0) * slope, 0.01)
            << "after " << i << " steps";
        ASSERT_TRUE(isFree(world, 0, objectBody(object)));
    }
    EXPECT_NEAR(farthest, 6.0 - 0.15, 0.01);
}

TEST(ObjectMotion, WalkersTakeStepsAndTurnAtLedges) {
    World world = emptyWorld(12, 3, 2);
    for (int x = 3; x < 12; ++x) putBlock(world, x, 1, 0.0_u, 0.5_u);
    putBlock(world, 6, 1, 0.5_u, 1.0_u);
    for (int x = 7; x < 9; ++x) putBlock(world, x, 1, 1.0_u, 1.25_u);
    addMoving(world, 1.5, 1.5, 0.0, pacer(0.0, 9.0));
    startObjects(world);
    bool wasUp = false;
    double farthest = 0.0;
    for (int i = 0; i < 20 * kStepsPerSecond; ++i) {
        stepObjects(world);
        const Object& object = objectOf(world);
        ASSERT_TRUE(isSupported(world, 0, objectBody(object)))
            << "at " << object.x.value() << ", height " << object.z.value();
        wasUp = wasUp || object.z == 1.25_u;
        farthest = std::max(farthest, object.x.value());
    }
    EXPECT_TRUE(wasUp);
    EXPECT_NEAR(farthest, 9.0 + 0.15, 0.02) << "from 1.25 down to 0.5 is no step: it stays up";
}

TEST(ObjectMotion, WalkersWithoutGroundFallAndThenWalk) {
    World world = emptyWorld(10, 10, 4);
    addMoving(world, 5.0, 5.0, 3.0, pacer(90.0, 2.0));
    startObjects(world);
    stepFor(world, 0.5);
    EXPECT_EQ(objectOf(world).y, 5.0_u);
    EXPECT_NEAR(objectOf(world).z.value(), 3.0 - 0.5 * kGravity * 0.25, 0.05);
    stepFor(world, 0.5);
    EXPECT_EQ(objectOf(world).z, Coordinate{});
    EXPECT_GT(objectOf(world).y, 5.1_u);

    // The ground goes away: it falls again, and goes on from where it lands.
    putBlock(world, 3, 3, 2.0_u, 3.0_u);
    addMoving(world, 3.5, 3.5, 3.0, wanderer(0.0, 0.1));
    startObjects(world);
    stepFor(world, 1.0);
    EXPECT_EQ(objectOf(world, 1).z, 3.0_u);
    world.maps[0].setCell(3, 3, 2, kEmptyCell);
    stepFor(world, 2.0);
    EXPECT_EQ(objectOf(world, 1).z, Coordinate{});
}

TEST(ObjectMotion, WanderersBounceAxisByAxis) {
    World world = emptyWorld(4, 40, 1);
    addMoving(world, 3.5, 20.0, 0.0, wanderer(30.0));
    startObjects(world);
    world.movingObjects.motions[0].steps = 1000;  // no other turn meanwhile
    stepFor(world, 1.0);
    EXPECT_EQ(world.movingObjects.motions[0].headingDegrees, 150.0);
    EXPECT_GT(objectOf(world).y, 20.4_u) << "south as before";
    EXPECT_LT(objectOf(world).x, 3.5_u);
}

TEST(ObjectMotion, WanderersStayWithinTheirReach) {
    World world = emptyWorld(30, 30, 1);
    ObjectMotion motion = wanderer(45.0, 2.0);
    motion.reach = 3.0_u;
    addMoving(world, 15.0, 15.0, 0.0, motion);
    addMoving(world, 15.0, 15.0, 0.0, wanderer(45.0, 2.0, 2));
    startObjects(world);
    int changes = 0;
    double heading = 45.0;
    double farthest = 0.0;
    double farthestOther = 0.0;
    const auto distance = [](const Object& object) {
        return std::max(std::abs(object.x.value() - 15.0), std::abs(object.y.value() - 15.0));
    };
    for (int i = 0; i < 200 * kStepsPerSecond; ++i) {
        stepObjects(world);
        farthest = std::max(farthest, distance(objectOf(world)));
        farthestOther = std::max(farthestOther, distance(objectOf(world, 1)));
        changes += world.movingObjects.motions[0].headingDegrees != heading;
        heading = world.movingObjects.motions[0].headingDegrees;
    }
    EXPECT_GT(farthest, 2.9);
    EXPECT_LT(farthest, 3.05);
    EXPECT_GT(farthestOther, 8.0);
    EXPECT_GT(changes, 50);
}

TEST(ObjectMotion, CirclesAreRoundAtOneHeightAndClosed) {
    World world = emptyWorld(20, 20, 8);
    addMoving(world, 10.0, 10.0, 5.0, circler(0.0, 4.0, 3.0));
    startObjects(world);
    EXPECT_EQ(objectOf(world).x, 10.0_u);
    EXPECT_EQ(objectOf(world).y, 6.0_u) << "to the north of the middle, flying east";
    const double round = 2.0 * 3.14159265358979 * 4.0 / 3.0;
    bool wasEast = false;
    for (int i = 0; i < static_cast<int>(100.0 * round * kStepsPerSecond + 0.5); ++i) {
        stepObjects(world);
        const Object& object = objectOf(world);
        const double x = object.x.value() - 10.0;
        const double y = object.y.value() - 10.0;
        ASSERT_NEAR(std::sqrt(x * x + y * y), 4.0, 0.0001);
        ASSERT_EQ(object.z, 5.0_u);
        if (i == static_cast<int>(round / 4.0 * kStepsPerSecond)) {
            wasEast = x > 3.99;
            EXPECT_NEAR(world.movingObjects.motions[0].headingDegrees, 90.0, 1.0);
        }
    }
    EXPECT_TRUE(wasEast) << "clockwise as seen from above";
    EXPECT_NEAR(objectOf(world).x.value(), 10.0, 0.03);
    EXPECT_LT(objectOf(world).y, 6.01_u);
}

TEST(ObjectMotion, FlyersReverseAtBlocks) {
    World world = emptyWorld(20, 20, 8);
    putBlock(world, 13, 9, 5.0_u, 6.0_u);
    addMoving(world, 10.0, 10.0, 5.0, circler(0.0, 4.0, 3.0));
    startObjects(world);
    int turns = 0;
    bool back = false;
    double farthestSouth = 0.0;
    for (int i = 0; i < 60 * kStepsPerSecond; ++i) {
        stepObjects(world);
        ASSERT_TRUE(isFree(world, 0, objectBody(objectOf(world))));
        turns += world.movingObjects.motions[0].back != back;
        back = world.movingObjects.motions[0].back;
        farthestSouth = std::max(farthestSouth, objectOf(world).y.value());
    }
    EXPECT_GE(turns, 3);
    EXPECT_GT(farthestSouth, 13.99) << "from the other side too";
}

// Random crowds in random worlds.
World crowd(std::uint64_t seed, int size) {
    World world = randomWorld(seed);
    Random random(seed * 2 + 1);
    Map& map = world.maps[0];
    for (int i = 0; i < size; ++i) {
        ObjectMotion motion;
        motion.kind = static_cast<ObjectMotion::Kind>(random.below(3));
        motion.speed = random.between(0.1, 6.0);
        motion.headingDegrees = random.between(0.0, 360.0);
        motion.reach = toCoordinate(motion.kind == ObjectMotion::Kind::wander && random.oneIn(2)
                                        ? 0.0
                                        : random.between(0.3, 4.0));
        motion.random = Random(random.next());
        const double z = random.between(0.0, 3.0);
        const double y = random.between(0.0, static_cast<double>(map.depth));
        addMoving(world, random.between(0.0, static_cast<double>(map.width)), y, z, motion);
        map.objects.back().width = toCoordinate(random.between(0.05, 0.8));
        map.objects.back().height = toCoordinate(random.between(0.1, 1.2));
    }
    startObjects(world);
    return world;
}

constexpr int kObjectWorlds = kSanitized ? 100 : 1000;

TEST(RandomObjects, NoneIsEverInsideABlockAndAllRunsAreEqual) {
    std::int64_t free = 0;
    std::int64_t moved = 0;
    std::int64_t higher = 0;
    std::int64_t lower = 0;
    for (int seed = 1; seed <= kObjectWorlds; ++seed) {
        World world = crowd(static_cast<std::uint64_t>(seed), 12);
        const std::vector<Object>& objects = world.maps[0].objects;
        std::vector<bool> wasFree;
        for (const Object& object : objects)
            wasFree.push_back(!reachesIntoSomething(world, objectBody(object)));
        const std::uint64_t atStart = hashOf(world);
        for (int step = 0; step < 400; ++step) {
            const std::vector<Object> before = objects;
            stepObjects(world);
            for (std::size_t i = 0; i < objects.size(); ++i) {
                if (!wasFree[i]) continue;
                ++free;
                moved += objects[i].x != before[i].x || objects[i].y != before[i].y;
                higher += objects[i].z > before[i].z;
                lower += objects[i].z < before[i].z;
                ASSERT_FALSE(reachesIntoSomething(world, objectBody(objects[i])))
                    << "seed " << seed << ", step " << step << ", object " << i;
            }
        }
        const std::uint64_t once = hashOf(world);
        EXPECT_NE(once, atStart);
        resetObjects(world);
        EXPECT_EQ(hashOf(world), atStart);
        for (int step = 0; step < 400; ++step) stepObjects(world);
        ASSERT_EQ(hashOf(world), once) << "seed " << seed;
    }
    EXPECT_GT(free, std::int64_t{kObjectWorlds} * 1000);
    EXPECT_GT(moved, free / 2);
    EXPECT_GT(higher, kObjectWorlds);
    EXPECT_GT(lower, kObjectWorlds);
}

TEST(RandomObjects, GoTheSameWaysOnEveryMachine) {
    Hash hash;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        World world = crowd(seed, 10);
        stepFor(world, 5.0);
        addMovingObjects(hash, world);
    }
    EXPECT_EQ(hash.value(), 7193501528519876626u);
}

}  // namespace
}  // namespace slicecast
