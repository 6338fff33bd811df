// Random scenes keep the rules that the definition sets for scenes. A picture of one that does not
// has no correct colours.
#include "random_portals.h"
#include "suite.h"

#include <gtest/gtest.h>

namespace slicecast::judge {
namespace {

bool isSlopedAnywhere(const CellBlueprint& block) {
    return block.slopes.any() && block.top > block.bottom;
}

TEST(RandomScene, BlocksWithSlopesStandWhereTheyMay) {
    int sloped = 0;
    for (const MakeScene make : {randomScene, tieScene, alongBorderScene}) {
        for (std::uint64_t seed = 1; seed <= 600; ++seed) {
            const World world = make(seed, 8, 8).world;
            for (std::size_t m = 0; m < world.maps.size(); ++m) {
                const Map& map = world.maps[m];
                for (int tile = 0; tile < map.width * map.depth * map.levels; ++tile) {
                    const int x = tile % map.width;
                    const int y = tile / map.width % map.depth;
                    const int level = tile / (map.width * map.depth);
                    const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
                    if (!isSlopedAnywhere(block)) continue;
                    ++sloped;
                    ASSERT_FALSE(isExitFromLevelFace(world, static_cast<int>(m), x, y))
                        << "seed " << seed << ": map " << m << ", cell " << x << ", " << y << ", "
                        << level;
                    ASSERT_FALSE(block.hasPortals || block.isWater) << "seed " << seed;
                    ASSERT_EQ(block.plan.half, Half::none) << "seed " << seed;
                    ASSERT_TRUE(block.slopes.top.isLevel() || block.face(Face::top).mirror == 0)
                        << "seed " << seed;
                    ASSERT_TRUE(map.ceiling.tiles.empty() ||
                                map.ceiling.height <= tileEdge(level) + block.bottom ||
                                map.ceiling.height >= tileEdge(level) + block.top)
                        << "seed " << seed;
                }
            }
        }
    }
    EXPECT_GT(sloped, 10'000);
}

}  // namespace
}  // namespace slicecast::judge
