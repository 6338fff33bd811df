// Sown objects: only where they can stand, as many as asked for, and the same ones everywhere.
#include "walking.h"

#include "base/hash.h"
#include "world/object_sowing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

namespace slicecast {
namespace {

Sowing trees(double density) {
    Sowing sowing;
    sowing.density = density;
    sowing.height = {1.2_u, 2.4_u};
    sowing.object.width = 0.5_u;
    return sowing;
}

std::vector<Object> sown(World& world, const Sowing& sowing) {
    TakenSpots taken(world.maps[0]);
    EXPECT_EQ(sowObjects(world, 0, sowing, taken, 0, world.maps[0].depth), Sown::all);
    return world.maps[0].objects;
}

std::set<std::pair<int, int>> tilesOf(const std::vector<Object>& objects) {
    std::set<std::pair<int, int>> tiles;
    for (const Object& object : objects) tiles.emplace(object.x.tile(), object.y.tile());
    return tiles;
}

TEST(Sowing, AreAsManyAsTheDensitySays) {
    for (const double density : {0.0, 0.04, 0.5, 1.0}) {
        World world = emptyWorld(200, 100, 3);
        world.start.map = -1;
        const std::vector<Object> objects = sown(world, trees(density));
        EXPECT_NEAR(static_cast<double>(objects.size()), 20000.0 * density,
                    4.0 * std::sqrt(20000.0 * density * (1.0 - density)));
        EXPECT_EQ(tilesOf(objects).size(), objects.size());
        if (density < 0.5) continue;
        const auto [low, high] = std::minmax_element(
            objects.begin(), objects.end(),
            [](const Object& a, const Object& b) { return a.height < b.height; });
        EXPECT_NEAR(low->height.value(), 1.2, 0.001);
        EXPECT_NEAR(high->height.value(), 2.4, 0.001);
    }
}

TEST(Sowing, DoesNotMoveObjectsSownElsewhere) {
    World small = emptyWorld(20, 20, 3);
    World large = emptyWorld(30, 25, 5);
    putBlock(large, 3, 3, 0.0_u, 1.0_u);
    const std::vector<Object> few = sown(small, trees(0.3));
    const std::vector<Object> many = sown(large, trees(0.3));
    EXPECT_GT(few.size(), 80u);
    for (const Object& object : few) {
        if (object.x.tile() == 3 && object.y.tile() == 3) continue;
        EXPECT_TRUE(std::any_of(many.begin(), many.end(),
                                [&](const Object& other) {
                                    return other.x == object.x && other.y == object.y &&
                                           other.height == object.height;
                                }))
            << object.x.value() << ", " << object.y.value();
    }
    World other = emptyWorld(20, 20, 3);
    Sowing sowing = trees(0.3);
    sowing.seed = 2;
    EXPECT_NE(tilesOf(sown(other, sowing)), tilesOf(few));
}

TEST(Sowing, NeedsRoomUpToTheTopOfTheObject) {
    World world = emptyWorld(6, 1, 4);
    world.start.map = -1;
    putBlock(world, 1, 0, 0.0_u, 0.25_u);
    putBlock(world, 2, 0, 1.0_u, 2.0_u);
    putBlock(world, 3, 0, 2.5_u, 3.0_u);
    EXPECT_EQ(tilesOf(sown(world, trees(1.0))),
              (std::set<std::pair<int, int>>{{0, 0}, {3, 0}, {4, 0}, {5, 0}}));

    World roofed = emptyWorld(2, 1, 1);
    roofed.start.map = -1;
    putCeiling(roofed, 1.1_u);
    roofed.maps[0].ceiling.tiles[1] = kNoTexture;
    EXPECT_EQ(tilesOf(sown(roofed, trees(1.0))), (std::set<std::pair<int, int>>{{1, 0}}));
}

TEST(Sowing, StaysOnTheWantedGround) {
    World world = emptyWorld(4, 1, 3);
    world.start.map = -1;
    putBlock(world, 0, 0, 0.0_u, 1.0_u);
    putBlock(world, 1, 0, 0.0_u, 0.5_u);
    const BlueprintId half = world.maps[0].cell(1, 0, 0);
    putBlock(world, 2, 0, 1.0_u, 1.5_u);  // a bridge of the same blueprint
    Map& map = world.maps[0];
    map.floor.tiles = {5, 5, 5, 6};
    world.blueprints[half].faces[static_cast<std::size_t>(Face::top)].texture = 6;
    const auto heights = [&](const Sowing& sowing) {
        map.objects.clear();
        std::set<std::pair<int, double>> found;
        for (const Object& object : sown(world, sowing))
            found.emplace(object.x.tile(), object.z.value());
        return found;
    };
    using Found = std::set<std::pair<int, double>>;
    Sowing sowing = trees(1.0);
    sowing.height = {0.5_u, 0.75_u};
    EXPECT_EQ(heights(sowing), (Found{{2, 0.0}, {3, 0.0}}));
    sowing.onFloor = false;
    sowing.on = {half};
    EXPECT_EQ(heights(sowing), (Found{{1, 0.5}, {2, 1.5}}));
    sowing.onFloor = true;
    EXPECT_EQ(heights(sowing), (Found{{1, 0.5}, {2, 0.0}, {2, 1.5}, {3, 0.0}}));
    sowing.textures = {6};
    EXPECT_EQ(heights(sowing), (Found{{1, 0.5}, {2, 1.5}, {3, 0.0}}));

    // On what moves nothing is sown, nor where it goes.
    world.blueprints[half].mover = 0;
    sowing.textures.clear();
    EXPECT_EQ(heights(sowing), (Found{{2, 0.0}, {3, 0.0}}));
    map.setCell(3, 0, 0, half);
    map.occupied[3] = 0;
    EXPECT_EQ(heights(sowing), (Found{{2, 0.0}}));
}

TEST(Sowing, KeepsClearOfTheStartAndOfPortals) {
    World world = emptyWorld(9, 9, 3);
    world.start.x = 4.9_u;
    world.start.y = 4.5_u;
    Sowing sowing = trees(1.0);
    std::set<std::pair<int, int>> tiles = tilesOf(sown(world, sowing));
    EXPECT_EQ(tiles.size(), 79u) << "the start reaches over two tiles";
    EXPECT_FALSE(tiles.contains({4, 4}));
    EXPECT_FALSE(tiles.contains({5, 4}));

    world.maps[0].objects.clear();
    sowing.clear = 2.0_u;
    for (const Object& object : sown(world, sowing)) {
        const double x = (object.x - world.start.x).value();
        const double y = (object.y - world.start.y).value();
        EXPECT_GE(x * x + y * y, 4.0);
    }
    EXPECT_NEAR(static_cast<double>(world.maps[0].objects.size()), 81.0 - 12.6, 4.0);

    world.maps[0].objects.clear();
    world.maps[0].tilePortals.assign(81, kNoPortal);
    world.maps[0].tilePortals[world.maps[0].tileIndex(1, 2)] = 0;
    sowing.clear = {};
    EXPECT_EQ(sown(world, sowing).size(), 78u);
    EXPECT_FALSE(tilesOf(world.maps[0].objects).contains({1, 2}));
}

TEST(Sowing, TakesEachSpotOnce) {
    World world = emptyWorld(10, 10, 3);
    world.start.map = -1;
    Object placed;
    placed.x = 7.3_u;
    placed.y = 2.5_u;
    world.maps[0].objects.push_back(placed);
    TakenSpots taken(world.maps[0]);
    Sowing sowing = trees(0.5);
    EXPECT_EQ(sowObjects(world, 0, sowing, taken, 0, world.maps[0].depth), Sown::all);
    const std::size_t first = world.maps[0].objects.size();
    sowing.seed = 9;
    sowing.density = 1.0;
    EXPECT_EQ(sowObjects(world, 0, sowing, taken, 0, world.maps[0].depth), Sown::all);
    EXPECT_GT(first, 30u);
    EXPECT_LT(first, 70u);
    EXPECT_EQ(world.maps[0].objects.size(), 100u);
    EXPECT_EQ(tilesOf(world.maps[0].objects).size(), 100u);
}

TEST(Sowing, GivesEachItsOwnWay) {
    World world = emptyWorld(20, 20, 3);
    Sowing sowing = trees(0.2);
    sowing.motion = ObjectMotion{};
    sowing.motion->speed = 1.0;
    sown(world, sowing);
    const std::vector<ObjectMotion>& motions = world.movingObjects.motions;
    ASSERT_EQ(motions.size(), world.maps[0].objects.size());
    std::set<double> headings;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        EXPECT_EQ(motions[i].object, static_cast<int>(i));
        headings.insert(motions[i].headingDegrees);
    }
    EXPECT_GT(headings.size(), motions.size() / 2);
    startObjects(world);
    for (int step = 0; step < 600; ++step) stepObjects(world);
    for (const Object& object : world.maps[0].objects)
        EXPECT_TRUE(isFree(world, 0, objectBody(object)));

    // Birds only where there is room for their whole circle.
    World walled = emptyWorld(20, 20, 3);
    for (int x = 0; x < 20; ++x) putBlock(walled, x, 10, 0.0_u, 1.0_u);
    sowing.motion->kind = ObjectMotion::Kind::circle;
    sowing.motion->reach = 2.0_u;
    sowing.density = 1.0;
    sown(walled, sowing);
    EXPECT_GT(walled.maps[0].objects.size(), 100u);
    for (const Object& object : walled.maps[0].objects)
        EXPECT_GT(std::abs(object.y.value() - 10.5), 2.5);
}

TEST(Sowing, StopsAtTheLimitOfObjects) {
    World world = emptyWorld(257, 257, 1);
    Sowing sowing = trees(1.0);
    TakenSpots taken(world.maps[0]);
    EXPECT_EQ(sowObjects(world, 0, sowing, taken, 0, world.maps[0].depth), Sown::tooMany);
    sowing.density = 0.5;
    world.maps[0].objects.clear();
    TakenSpots again(world.maps[0]);
    EXPECT_EQ(sowObjects(world, 0, sowing, again, 0, world.maps[0].depth), Sown::all);

    // What stands in other maps counts.
    world.maps.push_back(world.maps[0]);
    world.maps.push_back(makeMap("third", 257, 257, 1, world.maps[0].floor.texture));
    TakenSpots third(world.maps[2]);
    EXPECT_EQ(sowObjects(world, 2, sowing, third, 0, world.maps[2].depth), Sown::tooMany);
}

TEST(Sowing, MakesFinds) {
    World world = emptyWorld(33, 33, 1);
    world.start.map = -1;
    world.maps[0].objects.emplace_back();
    Sowing sowing = trees(0.3);
    sowing.find = Find{.kind = 2, .message = "An apple."};
    const std::vector<Object> objects = sown(world, sowing);
    const std::vector<Find>& finds = world.quest.finds;
    ASSERT_GT(finds.size(), 200u);
    ASSERT_EQ(finds.size() + 1, objects.size());
    for (std::size_t i = 0; i < finds.size(); ++i) {
        EXPECT_EQ(finds[i].map, 0);
        EXPECT_EQ(finds[i].object, static_cast<int>(i) + 1);
        EXPECT_EQ(finds[i].kind, 2);
        EXPECT_EQ(finds[i].message, "An apple.");
    }

    sowing.density = 1.0;
    TakenSpots taken(world.maps[0]);
    EXPECT_EQ(sowObjects(world, 0, sowing, taken, 0, world.maps[0].depth), Sown::tooManyFinds);
}

TEST(Sowing, IsTheSameOnEveryMachine) {
    Hash hash;
    World world = emptyWorld(10, 10, 2);
    for (int i = 0; i < 10; ++i) putBlock(world, i, i, 0.0_u, 0.5_u);
    Sowing sowing = trees(0.5);
    for (BlueprintId id = 1; id < world.blueprints.size(); ++id) sowing.on.push_back(id);
    for (const Object& object : sown(world, sowing)) {
        for (const Coordinate coordinate : {object.x, object.y, object.z, object.height})
            hash.add(std::int64_t{coordinate.raw});
    }
    EXPECT_GT(world.maps[0].objects.size(), 30u);
    EXPECT_EQ(hash.value(), 13978013692874116546u);
}

}  // namespace
}  // namespace slicecast
