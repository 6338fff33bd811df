// Moving objects in a game: they are stepped, carried, put back, and known by the fingerprint.
#include "session/session.h"
#include "world/mover.h"
#include "world/object_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A yard in which one walks to and fro, and another stands on a lift, almost still.
World livelyYards() {
    World world;
    Image image(8, 8);
    std::fill(image.pixels.begin(), image.pixels.end(), toPixel({120, 110, 100, 255}));
    world.textures.push_back(makeTexture("grey", image));
    world.maps.push_back(makeMap("yard", 12, 9, 2, 0));
    world.start = {.map = 0,
                   .x = toCoordinate(2.5),
                   .y = toCoordinate(4.5),
                   .z = {},
                   .headingDegrees = 0.0,
                   .look = 0.0};
    world.motions.push_back({.name = "lift",
                             .edges = MovingEdges::top,
                             .from = {},
                             .to = toCoordinate(0.5),
                             .periodSteps = 480,
                             .phaseSteps = 0});
    CellBlueprint lift;
    lift.top = toCoordinate(0.5);
    for (FaceBlueprint& face : lift.faces) face.texture = 0;
    lift.motion = 0;
    world.blueprints.push_back(lift);
    world.maps[0].setCell(9, 6, 0, 1);
    EXPECT_TRUE(makeMovers(world).empty());
    world.sprites.push_back(makeSprite("walker", image));
    for (const double x : {4.5, 9.5}) {
        Object object;
        object.x = toCoordinate(x);
        object.y = toCoordinate(6.5);
        object.z = toCoordinate(x > 9.0 ? 0.5 : 0.0);
        object.width = toCoordinate(0.3);
        object.height = toCoordinate(0.6);
        ObjectMotion motion;
        motion.kind = ObjectMotion::Kind::pace;
        motion.object = static_cast<int>(world.maps[0].objects.size());
        motion.speed = x > 9.0 ? 0.001 : 1.0;
        motion.reach = toCoordinate(2.0);
        world.maps[0].objects.push_back(object);
        world.movingObjects.motions.push_back(motion);
    }
    startObjects(world);
    return world;
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
