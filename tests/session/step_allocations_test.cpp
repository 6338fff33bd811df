// Steps take no memory once the first has been made, with whatever moves, opens and leads
// elsewhere.
#include "../count_allocations.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace slicecast {
namespace {

TEST(Allocations, NoneAfterTheFirstStep) {
    World world;
    world.textures.push_back(makeTexture("plain", Image(8, 8)));
    CellBlueprint plate;
    plate.name = "plate";
    plate.top = toCoordinate(0.25);
    plate.motion = 0;
    world.blueprints.push_back(plate);
    world.motions.push_back(
        {.name = "lift", .edges = MovingEdges::both, .to = toCoordinate(2.0), .periodSteps = 400});
    CellBlueprint gate;
    gate.name = "gate";
    gate.gate = 0;
    world.blueprints.push_back(gate);
    world.gateKinds.push_back(
        {.steps = 20, .opensOnApproach = true, .approach = toCoordinate(1.0), .holdSteps = 10});
    Map map = makeMap("yard", 12, 12, 3, 0);
    map.setCell(2, 2, 0, 1);
    map.setCell(4, 2, 0, 2);
    world.maps.push_back(std::move(map));
    world.start = {
        .map = 0, .x = toCoordinate(2.5), .y = toCoordinate(2.5), .z = toCoordinate(0.25)};
    ASSERT_TRUE(makeMovers(world).empty());
    ASSERT_TRUE(makeGates(world).empty());
    // Objects of all kinds that walk, fly, ride, and go to and fro between two maps
    world.maps.push_back(makeMap("field", 12, 12, 3, 0));
    for (Map& other : world.maps) other.tilePortals.assign(other.occupied.size(), kNoPortal);
    for (int x = 0; x < 12; ++x) {
        for (const int from : {0, 1}) {
            world.maps[static_cast<std::size_t>(from)]
                .tilePortals[static_cast<std::size_t>(12 * 8 + x)] =
                static_cast<PortalId>(world.portals.size());
            world.portals.push_back({.fromMap = from,
                                     .fromX = x,
                                     .fromY = 8,
                                     .toMap = 1 - from,
                                     .toX = 8,
                                     .toY = x,
                                     .turn = 1 + 2 * from});
        }
    }
    for (int i = 0; i < 30; ++i) {
        Object object;
        object.x = toCoordinate(0.5 + i % 11);
        object.y = toCoordinate(6.5 + i % 2);
        object.width = toCoordinate(0.3);
        object.height = toCoordinate(0.5);
        ObjectMotion motion;
        motion.kind = static_cast<ObjectMotion::Kind>(i % 3);
        motion.object = i;
        motion.speed = 2.0;
        motion.headingDegrees = 90.0;
        motion.reach = toCoordinate(i % 3 == 0 ? 0.0 : 1.5);
        world.maps[0].objects.push_back(object);
        world.movingObjects.motions.push_back(motion);
    }
    startObjects(world);
    Session session(std::move(world));
    EXPECT_FALSE(session.hear().empty()) << "somebody listens, too";
    session.step({});
    const long before = allocations;
    std::size_t mostElsewhere = 0;
    for (int step = 0; step < 1000; ++step) {
        session.step({.forward = step < 500 ? 0.0 : 1.0, .turn = 0.3, .use = step % 40 == 0});
        mostElsewhere = std::max(mostElsewhere, session.world().maps[1].objects.size());
    }
    EXPECT_GT(session.world().gates[0].progress + session.world().movers[0].clock, 0);
    session.reset();
    EXPECT_EQ(allocations, before);
    EXPECT_GT(mostElsewhere, 5u);
    ::operator delete(::operator new(1));
    EXPECT_EQ(allocations, before + 1) << "they are counted";
}

}  // namespace
}  // namespace slicecast
