// Where a player has room: every area of random maps, compared with a look at each of its tiles.
#include "scene/rooms.h"

#include "base/random.h"
#include "world/collision.h"
#include "world/player.h"
#include "world_builder.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

// A map of whole blocks, low ones, and ones that leave room in the upper half of their level.
World randomWorld(int width, int depth, std::uint64_t seed) {
    WorldBuilder make;
    make.texture("grey", {128, 128, 128, 255});
    make.block('#');
    make.block('-', {.name = "slab", .bottom = 0.4, .top = 0.6});
    make.block('_', {.name = "low", .top = 0.3});
    Map map = makeMap("map", width, depth, 3, 0);
    Random random(seed);
    for (int y = 0; y < depth; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int level = 0; level < 3; ++level) {
                const int kind = random.between(0, 30);
                map.setCell(x, y, level, static_cast<BlueprintId>(kind < 28 ? 1 : kind - 27));
            }
        }
    }
    make.world.maps.push_back(std::move(map));
    return std::move(make.world);
}

bool hasRoomInTile(const World& world, int x, int y, int level) {
    const Coordinate half = toCoordinate(0.5);
    for (const Coordinate feet : {tileEdge(level), tileEdge(level) + half}) {
        if (isFree(world, 0,
                   bodyBox(tileEdge(x) + half, tileEdge(y) + half, feet, kCrouchedHeight)))
            return true;
    }
    return false;
}

TEST(Rooms, AreFoundInEveryArea) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Random random(seed);
        const int width = random.between(1, 13);
        const int depth = random.between(1, 13);
        const World world = randomWorld(width, depth, seed);
        Rooms rooms;
        for (int i = 0; i < 100; ++i) {
            const int west = random.between(0, width - 1);
            const int east = random.between(west + 1, width);
            const int north = random.between(0, depth - 1);
            const int south = random.between(north + 1, depth);
            const int lowest = random.between(0, 2);
            const int highest = random.between(lowest, 2);
            bool expected = false;
            for (int y = north; y < south; ++y)
                for (int x = west; x < east; ++x)
                    for (int level = lowest; level <= highest; ++level)
                        expected = expected || hasRoomInTile(world, x, y, level);
            const Box area = {tileEdge(west),  tileEdge(east),   tileEdge(north),
                              tileEdge(south), tileEdge(lowest), tileEdge(highest + 1)};
            ASSERT_EQ(rooms.hasRoomIn(world, 0, area), expected)
                << seed << ": " << west << "-" << east << ", " << north << "-" << south;
            found += expected;
        }
    }
    EXPECT_GT(found, 500);
    EXPECT_LT(found, 3500);
}

TEST(Rooms, AreAboveAllBlocks) {
    const World world = randomWorld(4, 4, 1);
    Rooms rooms;
    EXPECT_TRUE(
        rooms.hasRoomIn(world, 0, {{}, tileEdge(4), {}, tileEdge(4), tileEdge(3), tileEdge(1000)}));
}

}  // namespace
}  // namespace slicecast
