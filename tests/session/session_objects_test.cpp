// Moving objects in a game: they are stepped, carried, put back, and known by the fingerprint.
#include "session/session.h"
#include "world/mover.h"
#include "world/object_motion.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A yard in which one walks to and fro, and another stands on a lift, almost still.
World livelyYards() {
    const Image grey = imageOf({120, 110, 100, 255});
    WorldBuilder make;
    make.texture("grey", grey);
    make.world.sprites.push_back(makeSprite("walker", grey));
    make.block('=', {.top = 0.5}).motion = 0;
    make.world.motions.push_back({.name = "lift",
                                  .edges = MovingEdges::high,
                                  .from = {},
                                  .to = toCoordinate(0.5),
                                  .periodSteps = 480});
    make.map("yard", 12, 9, 2);
    make.put('=', 9, 6);
    make.start(2.5, 4.5);
    EXPECT_TRUE(makeMovers(make.world).empty());
    const auto walker = [&](double x, double z, double speed) {
        ObjectMotion motion;
        motion.kind = ObjectMotion::Kind::pace;
        motion.object = static_cast<int>(make.world.maps[0].objects.size());
        motion.speed = speed;
        motion.reach = toCoordinate(2.0);
        make.world.movingObjects.motions.push_back(motion);
        make.object(x, 6.5, z, 0.3, 0.6);
    };
    walker(4.5, 0.0, 1.0);
    walker(9.5, 0.5, 0.001);
    startObjects(make.world);
    return std::move(make.world);
}

TEST(SessionObjects, MoveRideAndRestart) {
    Session session(livelyYards());
    const std::vector<Object>& objects = session.world().maps[0].objects;
    const std::uint64_t before = session.fingerprint();
    Coordinate highest;
    for (int i = 0; i < 480; ++i) {
        session.step({});
        if (i == 59) {
            EXPECT_NEAR(objects[0].x.value(), 5.0, 0.01);
        }
        highest = std::max(highest, objects[1].z);
        const CellBlueprint& lift =
            session.world().blueprints[session.world().maps[0].cell(9, 6, 0)];
        ASSERT_EQ(objects[1].z, lift.top) << "after " << i << " steps";
    }
    EXPECT_EQ(highest, toCoordinate(1.0));
    EXPECT_EQ(objects[0].z, Coordinate{});

    // The fingerprint covers them.
    Session other(livelyYards());
    for (int i = 0; i < 480; ++i) other.step({});
    EXPECT_EQ(other.fingerprint(), session.fingerprint());
    World without = livelyYards();
    without.movingObjects.motions.pop_back();
    startObjects(without);
    Session fewer(std::move(without));
    for (int i = 0; i < 480; ++i) fewer.step({});
    EXPECT_NE(fewer.fingerprint(), session.fingerprint());

    session.reset();
    EXPECT_EQ(objects[0].x, toCoordinate(4.5));
    EXPECT_EQ(objects[1].z, toCoordinate(0.5));
    EXPECT_NE(session.fingerprint(), before) << "but for the steps it is the same";
}

}  // namespace
}  // namespace slicecast
