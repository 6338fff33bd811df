#include "overlay/map_ray.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <utility>

namespace slicecast {
namespace {

// Ten tiles a side. On level 1 a whole block at (7, 5), the lower half of one at (5, 2), the upper
// half of one at (5, 8).
World rayWorld() {
    WorldBuilder make;
    make.block('#');
    make.block('-', {.top = 0.5});
    make.block('^', {.bottom = 0.5});
    make.map("map", 10, 10, 2, kNoTexture);
    make.put('#', 7, 5, 1);
    make.put('-', 5, 2, 1);
    make.put('^', 5, 8, 1);
    return std::move(make.world);
}

MapRayEnd follow(double directionX, double directionY, double height = 0.25, int level = 1) {
    static const World world = rayWorld();
    return followRay(world, world.maps[0],
                     {.x = 5.25,
                      .y = 5.5,
                      .directionX = directionX,
                      .directionY = directionY,
                      .level = level,
                      .height = toCoordinate(height)},
                     100.0);
}

TEST(MapRay, EndsAtThePlanOfABlock) {
    WorldBuilder make;
    make.block('i').plan = {toCoordinate(0.25), toCoordinate(0.25), toCoordinate(0.5),
                            toCoordinate(0.5)};
    make.map("map", 10, 10, 1, kNoTexture);
    make.put('i', 7, 5);
    const auto follow = [&](double y) {
        return followRay(make.world, make.world.maps[0],
                         {.x = 5.25,
                          .y = y,
                          .directionX = 1.0,
                          .directionY = 0.0,
                          .level = 0,
                          .height = toCoordinate(0.5)},
                         4.0);
    };
    EXPECT_EQ(follow(5.375).length, 2.0);
    EXPECT_FALSE(follow(5.125).met) << "north of it";
    EXPECT_FALSE(follow(5.625).met) << "south of it";
}

TEST(MapRay, EndsWhereASlopeHasItsHeight) {
    WorldBuilder make;
    make.block('/').slopes = slopesTo(Face::east, {}, {{}, tileEdge(1)});
    make.map("map", 10, 10, 1, kNoTexture);
    make.put('/', 7, 5);
    const auto lengthAt = [&](double height) {
        return followRay(make.world, make.world.maps[0],
                         {.x = 5.25,
                          .y = 5.5,
                          .directionX = 1.0,
                          .directionY = 0.0,
                          .level = 0,
                          .height = toCoordinate(height)},
                         4.0)
            .length;
    };
    EXPECT_EQ(lengthAt(0.25), 2.0);
    EXPECT_EQ(lengthAt(0.75), 2.5);
}

TEST(MapRay, EndsAtTheFirstBlockOfItsLevel) {
    EXPECT_EQ(follow(1.0, 0.0).length, 1.75);
    EXPECT_TRUE(follow(1.0, 0.0).met);
    EXPECT_EQ(follow(2.0, 0.0).length, 0.875) << "in multiples of the direction";
    EXPECT_FALSE(follow(1.0, 0.0, 0.25, 0).met) << "nothing on level 0";
    EXPECT_FALSE(follow(-1.0, 0.0).met);
    EXPECT_EQ(follow(-1.0, 0.0).length, 100.0);
}

TEST(MapRay, EndsOnlyAtBlocksAtItsHeight) {
    EXPECT_EQ(follow(0.0, -1.0, 0.25).length, 2.5);
    EXPECT_FALSE(follow(0.0, -1.0, 0.5).met) << "a top is not part of its block";
    EXPECT_FALSE(follow(0.0, 1.0, 0.25).met);
    EXPECT_EQ(follow(0.0, 1.0, 0.5).length, 2.5);
}

TEST(MapRay, GoesDiagonallyFromTileToTile) {
    const MapRayEnd end = follow(1.0, -0.25);
    EXPECT_TRUE(end.met);
    EXPECT_EQ(end.length, 1.75);
    EXPECT_FALSE(follow(1.0, -0.5).met) << "passes north of the block";
}

// A portal tile at (7, 2), and a portal on the western face of the block at (7, 5).
TEST(MapRay, EndsAtPortals) {
    World world = rayWorld();
    Map& map = world.maps[0];
    map.tilePortals.assign(map.occupied.size(), kNoPortal);
    map.tilePortals[map.tileIndex(7, 2)] = 0;
    world.blueprints[1].faces[static_cast<std::size_t>(Face::west)].portal = 1;
    const auto follow = [&](double x, double y, double directionX, double directionY) {
        return followRay(world, map,
                         {.x = x,
                          .y = y,
                          .directionX = directionX,
                          .directionY = directionY,
                          .level = 1,
                          .height = toCoordinate(0.75)},
                         100.0);
    };
    EXPECT_EQ(follow(5.25, 2.5, 1.0, 0.0).length, 1.75);
    EXPECT_TRUE(follow(5.25, 2.5, 1.0, 0.0).portal);
    EXPECT_FALSE(follow(7.25, 2.5, 1.0, 0.0).met) << "begins in it";
    EXPECT_TRUE(follow(5.25, 5.5, 1.0, 0.0).portal);
    EXPECT_EQ(follow(9.25, 5.5, -1.0, 0.0).length, 1.25);
    EXPECT_TRUE(follow(9.25, 5.5, -1.0, 0.0).met);
    EXPECT_FALSE(follow(9.25, 5.5, -1.0, 0.0).portal) << "another face of the same block";
    EXPECT_FALSE(follow(7.5, 3.25, 0.0, 1.0).portal) << "from the north";
    EXPECT_TRUE(follow(7.5, 3.25, 0.0, 1.0).met);
}

}  // namespace
}  // namespace slicecast
