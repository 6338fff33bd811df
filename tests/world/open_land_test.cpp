#include "base/random.h"
#include "world/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace slicecast {
namespace {

constexpr TextureId kGrass = 3;
constexpr TextureId kPath = 4;

bool isOpen(const Map& map, int x, int y) {
    const std::size_t tile = map.tileIndex(x, y);
    for (int level = 0; level < map.levels; ++level)
        if (map.cells[map.cellIndex(x, y, level)] != kEmptyCell) return false;
    return map.floor.tiles[tile] == map.floor.texture &&
           (map.ceiling.tiles.empty() || map.ceiling.tiles[tile] == kNoTexture) &&
           map.tilePortal(x, y) == kNoPortal;
}

// Tile by tile, as the header defines it.
int openAround(const Map& map, int x, int y) {
    int least = 255;
    for (int otherY = 0; otherY < map.depth; ++otherY)
        for (int otherX = 0; otherX < map.width; ++otherX)
            if (!isOpen(map, otherX, otherY))
                least = std::min(least, std::max(std::abs(otherX - x), std::abs(otherY - y)));
    return least;
}

TEST(OpenLand, EndsAtTheNearestTileThatIsNotOpen) {
    Random random(1);
    for (int n = 0; n < 60; ++n) {
        Map map = makeMap("land", random.between(1, 24), random.between(1, 24), 2, kGrass);
        const auto anyTile = [&] {
            return map.tileIndex(random.below(map.width), random.below(map.depth));
        };
        for (int block = random.below(3); block > 0; --block)
            map.setCell(random.below(map.width), random.below(map.depth), random.below(2), 1);
        if (random.oneIn(3)) map.floor.tiles[anyTile()] = kPath;
        if (random.oneIn(3)) {
            map.ceiling.tiles.assign(map.occupied.size(), kNoTexture);
            map.ceiling.tiles[anyTile()] = kPath;
        }
        if (random.oneIn(3)) {
            map.tilePortals.assign(map.occupied.size(), kNoPortal);
            map.tilePortals[anyTile()] = 0;
        }
        map.findOpenLand();
        for (int y = 0; y < map.depth; ++y)
            for (int x = 0; x < map.width; ++x)
                ASSERT_EQ(map.openLand[map.tileIndex(x, y)], openAround(map, x, y))
                    << n << ": " << x << ", " << y;
    }
}

TEST(OpenLand, EndsAtMoversThatAreElsewhere) {
    Map map = makeMap("land", 9, 9, 1, kGrass);
    map.setCell(4, 4, 0, 1);
    map.occupied[map.tileIndex(4, 4)] = 0;
    map.findOpenLand();
    EXPECT_EQ(map.openLand[map.tileIndex(1, 4)], 3);
}

TEST(OpenLand, EndsAt255) {
    Map map = makeMap("land", 600, 3, 1, kGrass);
    map.setCell(0, 1, 0, 1);
    map.findOpenLand();
    EXPECT_EQ(map.openLand[map.tileIndex(254, 1)], 254);
    EXPECT_EQ(map.openLand[map.tileIndex(255, 1)], 255);
    EXPECT_EQ(map.openLand[map.tileIndex(599, 1)], 255);
}

TEST(OpenLand, IsClearedByAChangedCell) {
    Map map = makeMap("land", 9, 9, 1, kGrass);
    map.findOpenLand();
    map.setCell(4, 4, 0, 1);
    EXPECT_TRUE(map.openLand.empty());
}

}  // namespace
}  // namespace slicecast
