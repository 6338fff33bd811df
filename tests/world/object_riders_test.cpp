// Moving objects among moving blocks: they ride on them, are never inside one, and it all happens
// the same way twice.
#include "moving.h"

#include "base/hash.h"
#include "sanitized.h"
#include "world/object_motion.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicecast {
namespace {

constexpr int kRiderWorlds = kSanitized ? 60 : 600;
constexpr int kRiderSteps = 600;

// Random blocks, platforms that go up and down among them, and a crowd.
World livelyWorld(std::uint64_t seed) {
    World world = randomWorld(seed);
    Random random(seed + 99);
    Map& map = world.maps[0];
    for (int i = 0; i < 4; ++i) {
        Motion motion;
        motion.edges = static_cast<MovingEdges>(random.below(3));
        motion.to = toCoordinate(
            motion.edges == MovingEdges::low ? 0.4 : random.between(0.3, map.levels - 0.5));
        motion.periodSteps = random.between(2, 8) * kSecond * map.levels;
        motion.shape = static_cast<MotionShape>(random.below(3));
        const BlueprintId id = addMoving(world, {}, 0.5_u, motion);
        const int x0 = random.below(map.width);
        const int y0 = random.below(map.depth);
        for (int y = y0; y < std::min(map.depth, y0 + 2); ++y) {
            for (int x = x0; x < std::min(map.width, x0 + 2); ++x) {
                for (int level = 0; level < map.levels; ++level)
                    map.setCell(x, y, level, kEmptyCell);
                map.setCell(x, y, 0, id);
            }
        }
    }
    for (int i = 0; i < 15; ++i) {
        ObjectMotion motion;
        motion.kind = static_cast<ObjectMotion::Kind>(random.below(3));
        motion.object = i;
        motion.speed = random.between(0.1, 2.0);
        motion.headingDegrees = random.below(360);
        motion.reach = toCoordinate(random.between(0.5, 3.0));
        motion.random = Random(random.next());
        Object object;
        object.x = Coordinate{random.below(map.width * 65536)};
        object.y = Coordinate{random.below(map.depth * 65536)};
        object.z = toCoordinate(random.between(0.0, 2.0));
        object.width = 0.3_u;
        object.height = toCoordinate(random.between(0.2, 0.8));
        map.objects.push_back(object);
        world.movingObjects.motions.push_back(motion);
    }
    return world;
}

struct Crowd {
    World world;
    std::vector<Body> bodies = {};
    std::int64_t lifted = 0;

    void step() {
        bodies.clear();
        addBodies(world, bodies);
        stepWorld(world, bodies, {});
        liftObjects(world, bodies);
        for (const Body& body : bodies) lifted += body.shift.z.raw != 0;
        stepObjects(world);
    }
    bool isInside(std::size_t i) const {
        return reachesIntoSolid(world, 0, objectBody(world.maps[0].objects[i]));
    }
    std::uint64_t fingerprint() const {
        Hash hash;
        addTo(hash, world);
        addMovingObjects(hash, world);
        return hash.value();
    }
};

TEST(RandomRiders, AreNeverInsideABlockThatMoves) {
    std::int64_t free = 0;
    std::int64_t lifted = 0;
    int worlds = 0;
    for (int seed = 1; seed <= kRiderWorlds; ++seed) {
        Crowd crowd = {.world = livelyWorld(static_cast<std::uint64_t>(seed))};
        if (!makeMovers(crowd.world).empty()) continue;
        ++worlds;
        startObjects(crowd.world);
        std::vector<bool> wasFree;
        for (const Object& object : crowd.world.maps[0].objects)
            wasFree.push_back(isFree(crowd.world, 0, objectBody(object)));
        const std::uint64_t atStart = crowd.fingerprint();
        for (int step = 0; step < kRiderSteps; ++step) {
            crowd.step();
            for (std::size_t i = 0; i < wasFree.size(); ++i) {
                if (!wasFree[i]) continue;
                ++free;
                ASSERT_FALSE(crowd.isInside(i))
                    << "seed " << seed << ", step " << step << ", object " << i;
            }
        }
        lifted += crowd.lifted;
        const std::uint64_t once = crowd.fingerprint();
        resetWorld(crowd.world);
        resetObjects(crowd.world);
        EXPECT_EQ(crowd.fingerprint(), atStart);
        for (int step = 0; step < kRiderSteps; ++step) crowd.step();
        ASSERT_EQ(crowd.fingerprint(), once) << "seed " << seed;
    }
    EXPECT_GT(worlds, kRiderWorlds / 2);
    EXPECT_GT(free, std::int64_t{worlds} * kRiderSteps);
    EXPECT_GT(lifted, worlds * 100);
}

}  // namespace
}  // namespace slicecast
