#include "world/collision.h"

#include "walking.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

// A box of 0.4 x 0.4 x 0.5 with its middle at (x, y).
Box boxAt(Coordinate x, Coordinate y, Coordinate bottom) {
    return {x - 0.2_u, x + 0.2_u, y - 0.2_u, y + 0.2_u, bottom, bottom + 0.5_u};
}

TEST(Collision, TouchingIsNotOverlapping) {
    World world = emptyWorld(3, 3, 2);
    putBlock(world, 1, 1, 0.25_u, 0.75_u);
    Box box = {0.25_u, 1.0_u, 1.0_u, 2.0_u, 0.0_u, 1.0_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "west of the block";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = kTiny, .y = {}, .z = {}})));
    box = {2.0_u, 3.0_u, 1.0_u, 2.0_u, 0.0_u, 1.0_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "east";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {-1}, .y = {}, .z = {}})));
    box = {1.0_u, 2.0_u, 0.0_u, 1.0_u, 0.0_u, 1.0_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "north";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {}, .y = kTiny, .z = {}})));
    box = {1.0_u, 2.0_u, 2.0_u, 3.0_u, 0.0_u, 1.0_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "south";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {}, .y = {-1}, .z = {}})));
    box = {1.0_u, 2.0_u, 1.0_u, 2.0_u, 0.0_u, 0.25_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "under";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {}, .y = {}, .z = kTiny})));
    box = {1.0_u, 2.0_u, 1.0_u, 2.0_u, 0.75_u, 2.0_u};
    EXPECT_TRUE(isFree(world, 0, box)) << "on top";
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = {}, .y = {}, .z = {-1}})));
}

TEST(Collision, TheOutlineTheFloorAndTheGreatestHeightAreSolid) {
    const World world = emptyWorld(2, 3, 1);
    const Box whole = {0.0_u, 2.0_u, 0.0_u, 3.0_u, 0.0_u, kMaxBodyHeight};
    EXPECT_TRUE(isFree(world, 0, whole));
    EXPECT_FALSE(isFree(world, 0, moved(whole, {.x = kTiny, .y = {}, .z = {}})));
    EXPECT_FALSE(isFree(world, 0, moved(whole, {.x = {-1}, .y = {}, .z = {}})));
    EXPECT_FALSE(isFree(world, 0, moved(whole, {.x = {}, .y = kTiny, .z = {}})));
    EXPECT_FALSE(isFree(world, 0, moved(whole, {.x = {}, .y = {-1}, .z = {}})));
    EXPECT_FALSE(isFree(world, 0, moved(whole, {.x = {}, .y = {}, .z = kTiny})));
    EXPECT_FALSE(isFree(world, 0, moved(whole, {.x = {}, .y = {}, .z = {-1}})));
    EXPECT_FALSE(isFree(world, 1, whole)) << "no such map";
    EXPECT_FALSE(isFree(world, -1, whole));
}

TEST(Collision, SweepsEndExactlyAtObstacles) {
    World world = emptyWorld(8, 8, 3);
    putBlock(world, 5, 2, 0.0_u, 1.0_u);
    putBlock(world, 1, 2, 0.0_u, 1.0_u);
    putBlock(world, 3, 4, 0.0_u, 1.0_u);
    putBlock(world, 3, 0, 0.0_u, 1.0_u);
    putBlock(world, 3, 2, 1.3_u, 1.4_u);
    const Box box = boxAt(3.5_u, 2.5_u, 0.0_u);
    EXPECT_EQ(sweepX(world, 0, box, 100.0_u), tileEdge(5) - box.east);
    EXPECT_EQ(sweepX(world, 0, box, tileEdge(-100)), tileEdge(2) - box.west);
    EXPECT_EQ(sweepY(world, 0, box, 100.0_u), tileEdge(4) - box.south);
    EXPECT_EQ(sweepY(world, 0, box, tileEdge(-100)), tileEdge(1) - box.north);
    EXPECT_EQ(sweepZ(world, 0, box, 100.0_u), 1.3_u - box.top);
    EXPECT_EQ(sweepZ(world, 0, box, tileEdge(-100)), Coordinate{0});
    EXPECT_EQ(sweepX(world, 0, box, 1.0_u), 1.0_u) << "nothing in the way";
    const Box above = boxAt(3.5_u, 2.5_u, 2.0_u);
    EXPECT_EQ(sweepZ(world, 0, above, tileEdge(-2)), 1.4_u - 2.0_u);
    EXPECT_EQ(sweepZ(world, 0, above, tileEdge(2000)), kMaxBodyHeight - above.top);
}

TEST(Collision, ATouchedCornerDoesNotStopABody) {
    World world = emptyWorld(4, 4, 1);
    putBlock(world, 2, 2, 0.0_u, 1.0_u);
    // The southern side runs exactly along the block's northern one.
    const Box box = {0.5_u, 1.0_u, 1.5_u, 2.0_u, 0.0_u, 0.5_u};
    EXPECT_EQ(sweepX(world, 0, box, 3.0_u), 3.0_u);
    EXPECT_EQ(sweepX(world, 0, moved(box, {.x = {}, .y = kTiny, .z = {}}), 3.0_u), 1.0_u);
}

TEST(Collision, TheCeilingHasNoThickness) {
    World world = emptyWorld(2, 1, 2);
    putCeiling(world, 0.8_u);
    world.maps[0].ceiling.tiles[1] = kNoTexture;
    const Box under = boxAt(0.5_u, 0.5_u, 0.0_u);
    EXPECT_EQ(sweepZ(world, 0, under, 2.0_u), 0.8_u - 0.5_u);
    const Box above = boxAt(0.5_u, 0.5_u, 1.5_u);
    EXPECT_EQ(sweepZ(world, 0, above, tileEdge(-2)), 0.8_u - 1.5_u);
    EXPECT_FALSE(isFree(world, 0, boxAt(0.5_u, 0.5_u, 0.5_u))) << "right through it";
    EXPECT_TRUE(isFree(world, 0, boxAt(1.5_u, 0.5_u, 0.5_u))) << "through the hole";
    EXPECT_EQ(sweepX(world, 0, boxAt(1.5_u, 0.5_u, 0.5_u), tileEdge(-1)), 1.0_u - 1.5_u + 0.2_u)
        << "against its edge";
    EXPECT_TRUE(isSupported(world, 0, boxAt(0.5_u, 0.5_u, 0.8_u)));
}

TEST(Collision, LeastRiseGoesOntoTheObstacle) {
    World world = emptyWorld(3, 1, 3);
    putBlock(world, 1, 0, 0.0_u, 0.3_u);
    putBlock(world, 2, 0, 0.2_u, 0.4_u);
    putBlock(world, 1, 0, 1.0_u, 1.1_u);
    EXPECT_EQ(leastRise(world, 0, boxAt(0.5_u, 0.5_u, 0.0_u), 0.5_u), Coordinate{0});
    EXPECT_EQ(leastRise(world, 0, boxAt(1.5_u, 0.5_u, 0.0_u), 0.5_u), 0.3_u);
    EXPECT_EQ(leastRise(world, 0, boxAt(2.0_u, 0.5_u, 0.0_u), 0.5_u), 0.4_u) << "the higher of two";
    EXPECT_EQ(leastRise(world, 0, boxAt(2.0_u, 0.5_u, 0.0_u), 0.4_u - kTiny), std::nullopt);
    EXPECT_EQ(leastRise(world, 0, boxAt(1.5_u, 0.5_u, 0.6_u), 0.45_u), std::nullopt)
        << "another block above the gap";
    EXPECT_EQ(leastRise(world, 0, boxAt(1.5_u, 0.5_u, 0.6_u), 0.5_u), 1.1_u - 0.6_u)
        << "and over that one too";
    EXPECT_EQ(leastRise(world, 0, boxAt(0.1_u, 0.5_u, 0.0_u), 0.5_u), std::nullopt)
        << "beyond the grid";
}

TEST(Collision, AFastSlideFollowsItsDiagonal) {
    World world = emptyWorld(12, 12, 1);
    putBlock(world, 4, 4, 0.0_u, 1.0_u);
    // One long diagonal move across the block: the box must meet the block, not jump past it.
    const Slide slid = slide(world, 0, boxAt(2.0_u, 2.0_u, 0.0_u), 8.0_u, 8.0_u, {});
    EXPECT_TRUE(isFree(world, 0, slid.box));
    EXPECT_TRUE(slid.stoppedX || slid.stoppedY);
    const bool beside = slid.box.east == tileEdge(4) || slid.box.south == tileEdge(4);
    EXPECT_TRUE(beside || slid.box.west >= tileEdge(5) || slid.box.north >= tileEdge(5));
    // A wall without a gap holds at any speed.
    for (int y = 0; y < 12; ++y) putBlock(world, 6, y, 0.0_u, 1.0_u);
    EXPECT_EQ(slide(world, 0, boxAt(2.0_u, 8.0_u, 0.0_u), 1000.0_u, 0.0_u, {}).box.east,
              tileEdge(6));
}

TEST(Collision, SlidesOverStepsOnlyWithRoomOnTheWay) {
    World world = emptyWorld(4, 1, 3);
    putBlock(world, 1, 0, 0.0_u, 0.5_u);
    const Box box = boxAt(0.5_u, 0.5_u, 0.0_u);
    Slide slid = slide(world, 0, box, 0.5_u, {}, 0.5_u);
    EXPECT_EQ(slid.box, moved(box, {.x = 0.5_u, .y = {}, .z = 0.5_u}));
    EXPECT_EQ(slid.rise, 0.5_u);
    EXPECT_FALSE(slid.stoppedX);
    slid = slide(world, 0, box, 0.5_u, {}, 0.5_u - kTiny);
    EXPECT_EQ(slid.box.east, 1.0_u);
    EXPECT_TRUE(slid.stoppedX);
    // A block above the start stops the rise
    World low = world.copy();
    putBlock(low, 0, 0, 0.9_u, 1.0_u);
    EXPECT_EQ(slide(low, 0, box, 0.5_u, {}, 0.5_u).box.east, 1.0_u);
    // The rear of the box is still under a block while its front takes the step: no room to rise
    World behind = emptyWorld(4, 1, 3);
    putBlock(behind, 2, 0, 0.0_u, 0.25_u);
    const Box wide = {0.97_u, 1.95_u, 0.2_u, 0.8_u, 0.0_u, 0.5_u};
    EXPECT_EQ(slide(behind, 0, wide, 0.0625_u, {}, 0.5_u).box.bottom, 0.25_u);
    putBlock(behind, 0, 0, 0.6_u, 1.0_u);
    EXPECT_EQ(slide(behind, 0, wide, 0.0625_u, {}, 0.5_u).box.east, 2.0_u);
    // A block above the step: one body fits exactly, the other is a little too high
    low = world.copy();
    putBlock(low, 1, 0, 1.0_u, 1.1_u);
    EXPECT_EQ(slide(low, 0, box, 0.5_u, {}, 0.5_u).box.bottom, 0.5_u);
    Box higher = box;
    higher.top = box.top + kTiny;
    EXPECT_EQ(slide(low, 0, higher, 0.5_u, {}, 0.5_u).box.east, 1.0_u);
}

// Free boxes stay free wherever they are swept. They stop only where 1/65536 unit more would
// overlap.
TEST(Collision, RandomSweepsAreTight) {
    int tried = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const World world = randomWorld(seed);
        Random random(seed * 977);
        for (int i = 0; i < 20; ++i) {
            Player player;
            if (!placeRandomly(world, random, player)) continue;
            const Box box = bodyBox(player);
            ASSERT_TRUE(isFree(world, 0, box)) << "seed " << seed;
            const Coordinate distance = {random.between(-3 * 65536, 3 * 65536)};
            for (const auto axis : {&Offset::x, &Offset::y, &Offset::z}) {
                Offset way;
                way.*axis = axis == &Offset::x   ? sweepX(world, 0, box, distance)
                            : axis == &Offset::y ? sweepY(world, 0, box, distance)
                                                 : sweepZ(world, 0, box, distance);
                EXPECT_FALSE(reachesIntoSomething(world, moved(box, way))) << "seed " << seed;
                ++tried;
                if (way.*axis == distance) continue;
                way.*axis = way.*axis + Coordinate{distance.raw > 0 ? 1 : -1};
                EXPECT_TRUE(reachesIntoSomething(world, moved(box, way))) << "seed " << seed;
            }
        }
    }
    EXPECT_GT(tried, 10'000);
}

}  // namespace
}  // namespace slicecast
