// How the objects of the shipped scenes stand: feet on the floor or on a block, and not inside one. Birds are in the air.
#include "scenes/shipped.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

const char* const kFlying = "gull";

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
                const bool flies = name == kFlying;
                const Footing footing = footingOf(world, map, object);
                EXPECT_NE(footing.firm, flies) << scene << ": " << name << " at " << object.x.value() << ", " << object.y.value();
                EXPECT_FALSE(footing.buried) << scene << ": " << name << " at " << object.x.value() << ", " << object.y.value();
                ++(flies ? flying : standing);
            }
        }
    }
    EXPECT_GT(standing, 100);
    EXPECT_GT(flying, 3);
}

}  // namespace
}  // namespace slicecast
