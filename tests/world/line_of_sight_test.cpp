#include "world/line_of_sight.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicecast {
namespace {

World makeYard() {
    WorldBuilder make;
    make.block('#', {.name = "wall"});
    make.block('-', {.name = "step", .top = 0.5});
    make.block('o', {.name = "glass"}).seeThrough = true;
    make.map("yard", 3, R"(
........
........
....-...
........
....#...
........
....o...
........
)");
    return std::move(make.world);
}

bool sees(const World& world, const Place& from, const Place& to) {
    return isInSight(world, world.maps[0], from, to);
}

TEST(LineOfSight, BlocksHide) {
    const World world = makeYard();
    EXPECT_TRUE(sees(world, {1, 3.5, 0.5}, {7, 3.5, 0.5}));
    EXPECT_FALSE(sees(world, {1, 4.5, 0.5}, {7, 4.5, 0.5}));
    EXPECT_FALSE(sees(world, {7, 4.5, 0.5}, {1, 4.5, 0.5}));
    EXPECT_FALSE(sees(world, {1, 2, 0.5}, {7, 7, 0.5}));
    EXPECT_TRUE(sees(world, {1, 4.5, 1.2}, {7, 4.5, 1.2}));
    EXPECT_TRUE(sees(world, {-3, 4.5, 2}, {11, 4.5, 2}));
    EXPECT_FALSE(sees(world, {-3, 4.5, 0.5}, {11, 4.5, 0.5}));
}

TEST(LineOfSight, HeightsCount) {
    const World world = makeYard();
    EXPECT_TRUE(sees(world, {1, 2.5, 0.6}, {7, 2.5, 0.6}));
    EXPECT_FALSE(sees(world, {1, 2.5, 0.4}, {7, 2.5, 0.4}));
    EXPECT_FALSE(sees(world, {1, 2.5, 0.6}, {7, 2.5, 0.1}));
    // Over the near edge and down behind the wall
    EXPECT_FALSE(sees(world, {1, 4.5, 2.9}, {5.2, 4.5, 0.1}));
    EXPECT_TRUE(sees(world, {4.5, 4.5, 2.9}, {4.5, 4.5, 1.05}));
    EXPECT_FALSE(sees(world, {4.5, 4.5, 2.9}, {4.5, 4.5, 0.5}));
    EXPECT_FALSE(sees(world, {1, 3.5, 0.5}, {7, 3.5, -0.5}));
}

TEST(LineOfSight, APlaceOnAWallIsVisibleFromItsSide) {
    const World world = makeYard();
    EXPECT_TRUE(sees(world, {1, 4.5, 0.5}, {4, 4.5, 0.5}));
    EXPECT_FALSE(sees(world, {1, 4.5, 0.5}, {5, 4.5, 0.5}));
    EXPECT_TRUE(sees(world, {7, 4.5, 0.5}, {5, 4.5, 0.5}));
    EXPECT_TRUE(sees(world, {1, 4.5, 2}, {4.5, 4.5, 1}));
    EXPECT_TRUE(sees(world, {3.99, 4.5, 0.5}, {4, 4.5, 0.5}));
}

TEST(LineOfSight, SeeThroughBlocksAndOpenGatesDoNotHide) {
    World world = makeYard();
    EXPECT_TRUE(sees(world, {1, 6.5, 0.5}, {7, 6.5, 0.5}));
    world.blueprints[1].passable = true;
    EXPECT_TRUE(sees(world, {1, 4.5, 0.5}, {7, 4.5, 0.5}));
}

TEST(LineOfSight, CeilingsAndPortalsHide) {
    World world = makeYard();
    world.textures.resize(1);
    Map& map = world.maps[0];
    map.ceiling.height = toCoordinate(1.5);
    map.ceiling.tiles.assign(64, kNoTexture);
    map.ceiling.tiles[map.tileIndex(2, 0)] = 0;
    EXPECT_FALSE(sees(world, {2.5, 0.5, 0.5}, {2.5, 0.5, 2.5}));
    EXPECT_TRUE(sees(world, {3.5, 0.5, 0.5}, {3.5, 0.5, 2.5}));
    map.tilePortals.assign(64, kNoPortal);
    map.tilePortals[map.tileIndex(4, 0)] = 0;
    EXPECT_FALSE(sees(world, {3.5, 0.5, 0.5}, {6.5, 0.5, 0.5}));
    EXPECT_TRUE(sees(world, {4.5, 0.5, 0.5}, {6.5, 0.5, 0.5})) << "the eye's own tile's acts not";
}

TEST(LineOfSight, EndsForNaN) {
    const World world = makeYard();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(sees(world, {1, 1, 1}, {nan, 1, 1}));
    EXPECT_FALSE(sees(world, {1, 1, 1}, {1e300, 1, 1}));
    EXPECT_TRUE(sees(world, {1, 1, 1}, {1, 1, 1}));
}

}  // namespace
}  // namespace slicecast
