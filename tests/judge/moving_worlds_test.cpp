// Worlds that are stepped, before the definition: where movers and gates are after so many steps
// and between them, which frames gates show, where objects are shown; and their pictures before the
// judge.
#include "draw.h"
#include "sanitized.h"
#include "verdict.h"
#include "works.h"

#include "world/object_motion.h"
#include "world/world_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace slicecast::judge {
namespace {

// Where the picture shows the place between two.
Coordinate shownAt(Coordinate before, Coordinate now, double part) {
    const int way = now.raw - before.raw;
    return {before.raw + static_cast<int>(std::floor(way * part + 0.5))};
}

// What cells hold, and the frames of gates.
void expectSame(const World& world, const World& defined, const std::string& when) {
    ASSERT_EQ(world.maps[0].occupied, defined.maps[0].occupied) << when;
    for (std::size_t i = 0; i < world.blueprints.size(); ++i) {
        const CellBlueprint& block = world.blueprints[i];
        const CellBlueprint& other = defined.blueprints[i];
        ASSERT_EQ(block.plan.west, other.plan.west) << when;
        ASSERT_EQ(block.plan.east, other.plan.east) << when;
        ASSERT_EQ(block.plan.north, other.plan.north) << when;
        ASSERT_EQ(block.plan.south, other.plan.south) << when;
        ASSERT_EQ(block.bottom, other.bottom) << when;
        ASSERT_EQ(block.top, other.top) << when;
        const bool isEmpty = block.bottom >= block.top || block.plan.west >= block.plan.east ||
                             block.plan.north >= block.plan.south;
        if (!isEmpty) {
            ASSERT_EQ(block.textureEast, other.textureEast) << when;
            ASSERT_EQ(block.textureSouth, other.textureSouth) << when;
            ASSERT_EQ(block.textureRise, other.textureRise) << when;
        }
        for (std::size_t face = 0; face < block.faces.size(); ++face)
            ASSERT_EQ(block.faces[face].texture, other.faces[face].texture) << when;
    }
}

void expectState(const Works& works, const std::string& when) {
    for (std::size_t i = 0; i < works.world.gates.size(); ++i)
        ASSERT_EQ(works.world.gates[i].progress, works.model.progressOf(i))
            << when << ", gate " << i;
    for (std::size_t i = 0; i < works.world.movers.size(); ++i)
        ASSERT_EQ(works.world.movers[i].offset, works.model.offsetOf(i)) << when << ", mover " << i;
    for (std::size_t i = 0; i < works.bodies.size(); ++i)
        ASSERT_EQ(works.bodies[i].box, works.defined[i].box) << when << ", body " << i;
}

TEST(MovingWorlds, AreWhereTheDefinitionSays) {
    constexpr int kWorlds = kSanitized ? 6 : 40;
    Renderer renderer;
    Verdict sum;
    WorksModel::Seen seen;
    for (int seed = 1; seed <= kWorlds; ++seed) {
        Works works(static_cast<std::uint64_t>(seed));
        World& world = works.world;
        World defined = world.copy();
        for (int step = 1; step <= 500; ++step) {
            const std::string when =
                "seed " + std::to_string(seed) + ", step " + std::to_string(step);
            const std::vector<Object> objects = world.maps[0].objects;
            works.step();
            expectState(works, when);
            if (::testing::Test::HasFatalFailure()) return;
            if (step % 7 != 0 && step >= 3) continue;
            works.model.show(defined, 1.0);
            expectSame(world, defined, when);
            const double part = works.random.oneIn(4) ? 0.5 : works.random.unit();
            const std::vector<Object> now = world.maps[0].objects;
            const ShownBetween shown(world, part);
            works.model.show(defined, part);
            expectSame(world, defined, when + ", between");
            if (::testing::Test::HasFatalFailure()) return;
            for (std::size_t i = 0; i < now.size(); ++i) {
                const Object& object = world.maps[0].objects[i];
                ASSERT_EQ(object.x, shownAt(objects[i].x, now[i].x, part)) << when;
                ASSERT_EQ(object.y, shownAt(objects[i].y, now[i].y, part)) << when;
                ASSERT_EQ(object.z, shownAt(objects[i].z, now[i].z, part)) << when;
                ASSERT_EQ(object.facingX, now[i].facingX) << when;
            }
            if (step % 63 != 0) continue;
            const View view = works.anyView(64, 40);
            const Image image = draw(renderer, world, view);
            World judged = world.copy();
            works.model.show(judged, part);
            sum.add(judge(judged, view, image.pixels.data(), image.width, when));
        }
        const WorksModel::Seen& now = works.model.seen();
        seen.moving += now.moving;
        seen.opening += now.opening;
        seen.heard += now.heard;
        seen.led += now.led;
        seen.waiting += now.waiting;
        seen.gatesHeld += now.gatesHeld;
        seen.doorsHeld += now.doorsHeld;
        seen.ended += now.ended;
    }
    for (const std::string& complaint : sum.complaints) ADD_FAILURE() << complaint;
    EXPECT_EQ(sum.unexcused, 0);
    EXPECT_GT(sum.coverage["object"], 0);
    EXPECT_GT(seen.moving, kWorlds * 50);
    EXPECT_GT(seen.opening, kWorlds * 50);
    EXPECT_GT(seen.heard, kWorlds * 5);
    EXPECT_GT(seen.led, kWorlds * 2);
    EXPECT_GT(seen.waiting, kWorlds * 5);
    EXPECT_GT(seen.gatesHeld, kWorlds);
    EXPECT_GT(seen.doorsHeld, kWorlds * 2);
    EXPECT_GT(seen.ended * 2, kWorlds);
}

}  // namespace
}  // namespace slicecast::judge
