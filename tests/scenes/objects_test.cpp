// How the objects of the shipped scenes stand: feet on the floor or on a block, and not inside one.
// Birds are in the air.
#include "scenes/shipped.h"

#include "world/collision.h"
#include "world/object_motion.h"
#include "world/player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace slicecast {
namespace {

// Off the ground: birds, and what hangs from a ceiling.
const std::set<std::string> kInTheAir = {"gull", "chandelier"};

struct Footing {
    bool firm = false;    // the feet are on something
    bool buried = false;  // a block is in the way of the middle
};

Footing footingOf(const World& world, const Map& map, const Object& object) {
    Footing footing;
    footing.firm = object.z == Coordinate{};
    const int x = object.x.tile();
    const int y = object.y.tile();
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId cell = map.cell(x, y, level);
        if (cell == kEmptyCell) continue;
        const CellBlueprint& block = world.blueprints[cell];
        const Coordinate bottom = tileEdge(level) + block.bottom;
        const Coordinate top = tileEdge(level) + block.top;
        footing.firm = footing.firm || top == object.z;
        footing.buried = footing.buried || (bottom < object.z + object.height && object.z < top);
    }
    return footing;
}

TEST(Objects, StandOnFirmGround) {
    int standing = 0;
    int flying = 0;
    for (const std::string& scene : shippedScenes()) {
        const World world = shippedWorld(scene);
        for (const Map& map : world.maps) {
            for (const Object& object : map.objects) {
                const std::string& name = world.sprites[object.sprite].name;
                const bool flies = kInTheAir.count(name) == 1;
                const Footing footing = footingOf(world, map, object);
                EXPECT_NE(footing.firm, flies) << scene << ": " << name << " at "
                                               << object.x.value() << ", " << object.y.value();
                EXPECT_FALSE(footing.buried) << scene << ": " << name << " at " << object.x.value()
                                             << ", " << object.y.value();
                ++(flies ? flying : standing);
            }
        }
    }
    EXPECT_GT(standing, 100);
    EXPECT_GT(flying, 3);
}

// Nobody is stuck, nobody falls off anything.
TEST(Objects, ThoseThatMoveGetAbout) {
    int walking = 0;
    int flying = 0;
    for (const std::string& scene : shippedScenes()) {
        World world = shippedWorld(scene);
        const std::vector<ObjectMotion>& motions = world.movingObjects.motions;
        const auto objectOf = [&](const ObjectMotion& motion) -> const Object& {
            return world.maps[static_cast<std::size_t>(motion.map)]
                .objects[static_cast<std::size_t>(motion.object)];
        };
        std::vector<Object> begun;
        for (const ObjectMotion& motion : motions) begun.push_back(objectOf(motion));
        std::vector<std::int32_t> farthest(motions.size());
        for (int step = 0; step < 60 * kStepsPerSecond; ++step) {
            stepObjects(world);
            for (std::size_t i = 0; i < motions.size(); ++i) {
                const Object& object = objectOf(motions[i]);
                farthest[i] = std::max({farthest[i], std::abs((object.x - begun[i].x).raw),
                                        std::abs((object.y - begun[i].y).raw)});
                ASSERT_EQ(motions[i].onGround, motions[i].kind != ObjectMotion::Kind::circle)
                    << scene << ": " << object.x.value() << ", " << object.y.value() << ", "
                    << object.z.value();
            }
        }
        for (std::size_t i = 0; i < motions.size(); ++i) {
            // Nobody is there whom they could follow
            if (motions[i].kind == ObjectMotion::Kind::stand) continue;
            EXPECT_GT(farthest[i], tileEdge(1).raw)
                << scene << ": " << begun[i].x.value() << ", " << begun[i].y.value();
            ++(motions[i].kind == ObjectMotion::Kind::circle ? flying : walking);
        }
    }
    EXPECT_GT(walking, 15);
    EXPECT_GT(flying, 5);
}

}  // namespace
}  // namespace slicecast
