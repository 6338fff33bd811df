// Moving objects among portals: they go through like anybody else, from one map's list to the
// other's.
#include "portal_worlds.h"

#include "base/hash.h"
#include "world/object_motion.h"
#include "world/traveller.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

namespace slicecast {
namespace {

// Objects of one map, each with the number of its motion as its sprite, and one that stands still
// between any two.
void addCrowd(World& world, Random& random, int size, bool straight) {
    Map& map = world.maps[0];
    for (int i = 0; i < size; ++i) {
        Object object;
        object.x = toCoordinate(random.between(0.0, static_cast<double>(map.width)));
        object.y = toCoordinate(random.between(0.0, static_cast<double>(map.depth)));
        object.z = toCoordinate(random.between(0.0, 2.0));
        object.width = 0.3_u;
        object.height = toCoordinate(random.between(0.1, 0.9));
        object.sprite = 100;
        map.objects.push_back(object);

        object.sprite = static_cast<SpriteId>(i);
        ObjectMotion motion;
        motion.kind = static_cast<ObjectMotion::Kind>(random.between(straight ? 1 : 0, 2));
        motion.object = static_cast<int>(map.objects.size());
        motion.speed = random.between(0.2, 6.0);
        motion.headingDegrees = random.below(3600) / 10.0;
        motion.reach = toCoordinate(
            motion.kind == ObjectMotion::Kind::wander ? 0.0 : random.between(0.5, 5.0));
        motion.random = Random(random.next());
        map.objects.push_back(object);
        world.movingObjects.motions.push_back(motion);
    }
}

const Object& objectOf(const World& world, const ObjectMotion& motion) {
    return world.maps[static_cast<std::size_t>(motion.map)]
        .objects[static_cast<std::size_t>(motion.object)];
}

bool isFreeNow(const World& world, const ObjectMotion& motion) {
    const Object& object = objectOf(world, motion);
    return isFree(world, Traveller{.map = motion.map,
                                   .box = objectBody(object),
                                   .eye = {object.x, object.y, object.z + motion.eye},
                                   .behind = motion.behind});
}

// The world with portals of tiles that lead to a copy and back.
World withPortals(const World& plain, int turn, int levels, Random& random, Portal& toCopy) {
    World world = plain.copy();
    toCopy = appendCopy(world, 0, turn, levels);
    const int density = random.between(2, 6);
    for (int y = 0; y < world.maps[0].depth; ++y) {
        for (int x = 0; x < world.maps[0].width; ++x) {
            const Portal portal = portalAt(toCopy, x, y);
            if (random.oneIn(density)) putTilePortal(world, portal);
            if (random.oneIn(density)) putTilePortal(world, reversed(portal));
        }
    }
    return world;
}

// Every motion has its own object still, and what stands still stands in the order in which it
// stood.
void checkLists(const World& world) {
    std::set<std::pair<int, int>> moving;
    for (std::size_t i = 0; i < world.movingObjects.motions.size(); ++i) {
        const ObjectMotion& motion = world.movingObjects.motions[i];
        EXPECT_EQ(objectOf(world, motion).sprite, i);
        moving.emplace(motion.map, motion.object);
    }
    EXPECT_EQ(moving.size(), world.movingObjects.motions.size());
    std::vector<Coordinate> still;
    for (const Object& object : world.maps[0].objects) {
        if (object.sprite == 100) still.push_back(object.x);
    }
    std::vector<Coordinate> before;
    for (const Object& object : world.movingObjects.objectsAtStart[0]) {
        if (object.sprite == 100) before.push_back(object.x);
    }
    EXPECT_EQ(still, before);
}

// Steps both worlds; after each, everything is in the same place but for the copy's.
void expectSameWays(World& plain, World& world, const Portal& toCopy, int tolerance, int& leaps,
                    int seed) {
    std::vector<ObjectMotion>& expected = plain.movingObjects.motions;
    std::vector<ObjectMotion>& motions = world.movingObjects.motions;
    // What was not free goes other ways.
    std::vector<bool> counts;
    for (std::size_t i = 0; i < motions.size(); ++i)
        counts.push_back(isFreeNow(world, motions[i]) && isFreeNow(plain, expected[i]));
    for (int step = 0; step < 500; ++step) {
        std::vector<int> before;
        for (const ObjectMotion& motion : motions) before.push_back(motion.map);
        stepObjects(plain);
        stepObjects(world);
        for (std::size_t i = 0; i < motions.size(); ++i) {
            if (!counts[i]) continue;
            leaps += before[i] != motions[i].map;
            const Object& object = objectOf(world, motions[i]);
            const Object& other = objectOf(plain, expected[i]);
            Position place = {object.x, object.y, object.z};
            double heading = motions[i].headingDegrees;
            if (motions[i].map == toCopy.toMap) {
                place = carried(reversed(toCopy), place);
                heading = carriedHeading(reversed(toCopy), heading);
            }
            ASSERT_LE(std::abs(place.x.raw - other.x.raw), tolerance)
                << "seed " << seed << ", step " << step << ", object " << i;
            ASSERT_LE(std::abs(place.y.raw - other.y.raw), tolerance)
                << "seed " << seed << ", step " << step << ", object " << i;
            ASSERT_EQ(place.z, other.z) << "seed " << seed << ", step " << step << ", object " << i;
            ASSERT_NEAR(heading, expected[i].headingDegrees, 0.001)
                << "seed " << seed << ", step " << step << ", object " << i;
        }
    }
    checkLists(world);
}

TEST(ObjectPortals, ToACopyChangeNoWay) {
    int leaps = 0;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        World plain = randomWorld(static_cast<std::uint64_t>(seed));
        addCrowd(plain, random, 10, false);
        Portal toCopy;
        World world =
            withPortals(plain, 0, plain.maps[0].levels < 30 ? random.below(3) : 0, random, toCopy);
        startObjects(plain);
        startObjects(world);
        expectSameWays(plain, world, toCopy, 0, leaps, seed);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(leaps, kPortalSeeds * 5);
}

// On an empty ground: among blocks a turned way meets its axes in another order.
TEST(ObjectPortals, TurnWaysWithThem) {
    int leaps = 0;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        World plain = emptyWorld(16, 12, 3);
        addCrowd(plain, random, 10, true);
        for (Object& object : plain.maps[0].objects) {
            object.x = toCoordinate(random.between(6.0, 10.0));
            object.y = toCoordinate(random.between(5.5, 6.5));
        }
        for (ObjectMotion& motion : plain.movingObjects.motions)
            motion.reach = std::min(motion.reach, 4.5_u);
        Portal toCopy;
        World world = withPortals(plain, 1 + seed % 3, random.below(3), random, toCopy);
        startObjects(plain);
        startObjects(world);
        expectSameWays(plain, world, toCopy, 200, leaps, seed);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(leaps, kPortalSeeds * 5);
}

TEST(ObjectPortals, NobodyIsEverInsideABlockOnEitherSideAndResetRestoresAll) {
    constexpr Coordinate kLongestStep = 0.1_u;
    std::int64_t free = 0;
    std::int64_t leaps = 0;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) * 31);
        World world = randomWorld(static_cast<std::uint64_t>(seed));
        World other = randomWorld(static_cast<std::uint64_t>(seed) + 5000);
        // The other map's blueprints are numbered anew.
        const auto shift = static_cast<BlueprintId>(world.blueprints.size());
        for (BlueprintId& id : other.maps[0].cells)
            id = id == kEmptyCell ? id : static_cast<BlueprintId>(id + shift);
        world.blueprints.insert(world.blueprints.end(), other.blueprints.begin(),
                                other.blueprints.end());
        world.maps.push_back(other.maps[0]);
        for (int i = 0; i < 12; ++i) {
            Portal portal;
            portal.fromMap = random.below(2);
            portal.toMap = random.below(2);
            const Map& from = world.maps[static_cast<std::size_t>(portal.fromMap)];
            const Map& to = world.maps[static_cast<std::size_t>(portal.toMap)];
            portal.fromX = random.below(from.width);
            portal.fromY = random.below(from.depth);
            portal.toX = random.below(to.width);
            portal.toY = random.below(to.depth);
            portal.turn = random.below(4);
            portal.levels = random.between(-1, 1);
            const bool isThere = from.tilePortal(portal.fromX, portal.fromY) != kNoPortal;
            const int level = random.below(from.levels);
            const BlueprintId block = from.cell(portal.fromX, portal.fromY, level);
            if (block != kEmptyCell && !world.blueprints[block].hasPortals) {
                putFacePortal(world, portal, level, static_cast<Face>(random.below(kFaces)));
            } else if (!isThere) {
                putTilePortal(world, portal);
            }
        }
        addCrowd(world, random, 12, false);
        startObjects(world);
        std::vector<bool> wasFree;
        for (const ObjectMotion& motion : world.movingObjects.motions)
            wasFree.push_back(isFreeNow(world, motion));
        Hash atStart;
        addMovingObjects(atStart, world);
        for (int step = 0; step < 400; ++step) {
            std::vector<int> before;
            for (const ObjectMotion& motion : world.movingObjects.motions)
                before.push_back(motion.map);
            noteObjects(world);
            stepObjects(world);
            for (std::size_t i = 0; i < before.size(); ++i) {
                // No picture between two steps shows it between two sides of a portal
                const ObjectMotion& motion = world.movingObjects.motions[i];
                const Object& object = objectOf(world, motion);
                ASSERT_LE(std::abs(object.x.raw - motion.before.x.raw), kLongestStep.raw);
                ASSERT_LE(std::abs(object.y.raw - motion.before.y.raw), kLongestStep.raw);
                if (!wasFree[i]) continue;
                ++free;
                leaps += world.movingObjects.motions[i].map != before[i];
                ASSERT_TRUE(isFreeNow(world, world.movingObjects.motions[i]))
                    << "seed " << seed << ", step " << step << ", object " << i;
            }
        }
        checkLists(world);
        resetObjects(world);
        Hash again;
        addMovingObjects(again, world);
        EXPECT_EQ(again.value(), atStart.value());
        EXPECT_EQ(world.maps[0].objects.size(), 24u);
        EXPECT_EQ(world.maps[1].objects.size(), 0u);
    }
    EXPECT_GT(free, std::int64_t{kPortalSeeds} * 400);
    EXPECT_GT(leaps, kPortalSeeds / 2);
}

}  // namespace
}  // namespace slicecast
