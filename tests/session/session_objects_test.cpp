// Moving objects in a game: they are stepped, carried, put back, and known by the fingerprint.
#include "session/session.h"
#include "world/mover.h"
#include "world/object_motion.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
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

// While a picture is drawn, the clock is asked: it looks at the world that is shown.
struct Shown {
    Coordinate walkerX;
    Coordinate riderZ;
    Coordinate liftTop;
};

Shown shownNow(const World& world) {
    const std::vector<Object>& objects = world.maps[0].objects;
    return {objects[0].x, objects[1].z, world.blueprints[world.maps[0].cell(9, 6, 0)].top};
}

TEST(SessionObjects, AreDrawnBetweenTheStepsLikeTheLiftUnderThem) {
    Session session(livelyYards());
    for (int i = 0; i < 100; ++i) session.step({});
    const Shown before = shownNow(session.world());
    session.step({});
    const Shown now = shownNow(session.world());
    ASSERT_NE(before.walkerX, now.walkerX);
    ASSERT_NE(before.riderZ, now.riderZ);
    Shown shown;
    session.setClock([&] {
        shown = shownNow(session.world());
        return 0.0;
    });
    Image image(4, 4);
    for (const double fraction : {0.0, 0.25, 0.5, 0.9, 1.0}) {
        ASSERT_TRUE(session.draw({image.pixels.data(), 4, 4, 4}, fraction));
        EXPECT_EQ(shown.walkerX, between(before.walkerX, now.walkerX, fraction));
        EXPECT_EQ(shown.riderZ, between(before.riderZ, now.riderZ, fraction));
        EXPECT_EQ(shown.riderZ, shown.liftTop);
        EXPECT_EQ(shownNow(session.world()).walkerX, now.walkerX) << "afterwards";
        EXPECT_EQ(shownNow(session.world()).riderZ, now.riderZ);
        EXPECT_EQ(shownNow(session.world()).liftTop, now.liftTop);
    }
    // Back at the start they come from nowhere
    session.reset();
    const Shown start = shownNow(session.world());
    ASSERT_TRUE(session.draw({image.pixels.data(), 4, 4, 4}, 0.5));
    EXPECT_EQ(shown.walkerX, start.walkerX);
    EXPECT_EQ(shown.liftTop, start.liftTop);
}

TEST(SessionObjects, AreWhereTheyWereIfDrawingFails) {
    Session session(livelyYards());
    for (int i = 0; i < 100; ++i) session.step({});
    const Shown now = shownNow(session.world());
    Shown shown = now;
    int asked = 0;
    session.setClock([&] {
        if (++asked == 2) {
            shown = shownNow(session.world());
            throw std::runtime_error("stopped");
        }
        return 0.0;
    });
    Image image(4, 4);
    EXPECT_THROW(session.draw({image.pixels.data(), 4, 4, 4}, 0.5), std::runtime_error);
    EXPECT_NE(shown.walkerX, now.walkerX);
    EXPECT_NE(shown.liftTop, now.liftTop);
    EXPECT_EQ(shownNow(session.world()).walkerX, now.walkerX);
    EXPECT_EQ(shownNow(session.world()).riderZ, now.riderZ);
    EXPECT_EQ(shownNow(session.world()).liftTop, now.liftTop);
}

}  // namespace
}  // namespace slicecast
