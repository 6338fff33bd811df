#include "world/map_entry.h"

#include "world/portal.h"
#include "world/world.h"
#include "world_builder.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

// A map of 7 x 7 tiles; blueprint 1 is a whole block, 2 a half one.
World emptyMap() {
    WorldBuilder make;
    make.block('#');
    make.block('-', {.top = 0.5});
    make.map("map", 7, 7, 2, kNoTexture);
    return std::move(make.world);
}

void expectEntry(const World& world, double x, double y, double feet) {
    const MapEntry entry = findMapEntry(world, 0);
    EXPECT_TRUE(entry.stands);
    EXPECT_EQ(entry.x.value(), x);
    EXPECT_EQ(entry.y.value(), y);
    EXPECT_EQ(entry.feet.value(), feet);
}

TEST(MapEntry, IsTheMiddleOfTheMapIfFree) {
    expectEntry(emptyMap(), 3.5, 3.5, 0.0);
}

TEST(MapEntry, IsOnTopOfABlock) {
    World world = emptyMap();
    world.maps[0].setCell(3, 3, 0, 2);
    expectEntry(world, 3.5, 3.5, 0.5);
    world.maps[0].setCell(3, 3, 0, 1);
    expectEntry(world, 3.5, 3.5, 1.0);
    world.maps[0].setCell(3, 3, 1, 2);
    expectEntry(world, 3.5, 3.5, 1.5);
}

TEST(MapEntry, IsTheFirstFreeTileOfTheNearestRing) {
    World world = emptyMap();
    Map& map = world.maps[0];
    // A ceiling leaves no room on top.
    map.ceiling.height = toCoordinate(1.2);
    map.ceiling.tiles.assign(49, 0);
    map.setCell(3, 3, 0, 1);
    expectEntry(world, 2.5, 2.5, 0.0);
    map.setCell(2, 2, 0, 1);
    expectEntry(world, 3.5, 2.5, 0.0);
    for (int x = 2; x <= 4; ++x) map.setCell(x, 2, 0, 1);
    expectEntry(world, 2.5, 3.5, 0.0);
    map.setCell(2, 3, 0, 1);
    expectEntry(world, 4.5, 3.5, 0.0);
    for (int x = 0; x < 7; ++x) {
        for (int y = 0; y < 7; ++y) map.setCell(x, y, 0, 1);
    }
    map.setCell(6, 0, 0, kEmptyCell);
    expectEntry(world, 6.5, 0.5, 0.0);
}

TEST(MapEntry, IsInTheAirIfNobodyCanStand) {
    World world = emptyMap();
    Map& map = world.maps[0];
    map.ceiling.height = toCoordinate(0.5);
    map.ceiling.tiles.assign(49, 0);
    const MapEntry entry = findMapEntry(world, 0);
    EXPECT_FALSE(entry.stands);
    EXPECT_EQ(entry.x.value(), 3.5);
    EXPECT_EQ(entry.feet.value(), 3.0) << "above both levels";
}

void expectGround(const World& world, const Position& eye, double x, double y, double feet) {
    const MapEntry entry = findGround(world, 0, eye);
    EXPECT_TRUE(entry.stands);
    EXPECT_EQ(entry.x.value(), x);
    EXPECT_EQ(entry.y.value(), y);
    EXPECT_EQ(entry.feet.value(), feet);
}

TEST(Ground, IsInTheNearestTile) {
    World world = emptyMap();
    const auto eyeAt = [](double x, double y, double z) {
        return Position{toCoordinate(x), toCoordinate(y), toCoordinate(z)};
    };
    expectGround(world, eyeAt(5.2, 1.9, 0.5), 5.5, 1.5, 0.0);
    expectGround(world, eyeAt(-20.0, 3.1, 0.5), 0.5, 3.5, 0.0);
    expectGround(world, eyeAt(900.0, 900.0, 30.0), 6.5, 6.5, 0.0);
    // On a wall or below a bridge, whichever is nearer
    world.maps[0].setCell(5, 1, 0, 1);
    expectGround(world, eyeAt(5.2, 1.9, 0.5), 5.5, 1.5, 1.0);
    world.maps[0].setCell(5, 1, 0, kEmptyCell);
    world.maps[0].setCell(5, 1, 1, 2);
    expectGround(world, eyeAt(5.2, 1.9, 0.7), 5.5, 1.5, 0.0);
    expectGround(world, eyeAt(5.2, 1.9, 1.8), 5.5, 1.5, 1.5);
}

}  // namespace
}  // namespace slicecast
