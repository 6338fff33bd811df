// Blocks whose tops and undersides rise: bodies walk them up and down, and slide down steep ones.
#include "world/slope.h"

#include "walking.h"
#include "world/collision.h"
#include "world/line_of_sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace slicecast {
namespace {

constexpr Slant kWhole = {tileEdge(1), tileEdge(1)};

// Gives the block in a cell a slope of its own.
void slope(World& world, int x, int y, Face rise, Slant bottom, Slant top, int level = 0) {
    CellBlueprint block;
    block.slopes = slopesTo(rise, bottom, top);
    block.bottom = bottom.least();
    block.top = top.most();
    world.blueprints.push_back(std::move(block));
    world.maps[0].setCell(x, y, level, static_cast<BlueprintId>(world.blueprints.size() - 1));
}

// Columns 2 and 3 rise by `gradient` each, up to a terrace from column 4 on.
World rampOf(Coordinate gradient) {
    World world = emptyWorld(8, 3, 3);
    const Coordinate twice = gradient + gradient;
    for (int y = 0; y < 3; ++y) {
        slope(world, 2, y, Face::east, {}, {{}, gradient});
        if (twice <= tileEdge(1)) {
            slope(world, 3, y, Face::east, {}, {gradient, twice});
        } else {
            putBlock(world, 3, y, 0.0_u, gradient);
        }
        for (int x = 4; x < 8; ++x) putBlock(world, x, y, 0.0_u, std::min(twice, tileEdge(1)));
    }
    return world;
}

TEST(Slope, RisesTowardsTheNamedSide) {
    const Slant rising = {0.25_u, 0.75_u};
    EXPECT_EQ(slopesTo(Face::east, {}, rising).top, rising);
    EXPECT_EQ(slopesTo(Face::south, {}, rising).top, rising);
    EXPECT_EQ(slopesTo(Face::west, {}, rising).top, (Slant{0.75_u, 0.25_u}));
    EXPECT_EQ(slopesTo(Face::north, {}, rising).top, (Slant{0.75_u, 0.25_u}));
    EXPECT_TRUE(slopesTo(Face::east, {}, rising).alongX);
    EXPECT_FALSE(slopesTo(Face::north, {}, rising).alongX);
    EXPECT_EQ(rising.heightAt(32768), std::int64_t{32768} << 16);
}

TEST(Slope, TurnsWithItsTile) {
    const Slopes east = slopesTo(Face::east, {0.125_u, 0.25_u}, {0.5_u, 1.0_u});
    EXPECT_EQ(turned(east, 1), slopesTo(Face::south, {0.125_u, 0.25_u}, {0.5_u, 1.0_u}));
    EXPECT_EQ(turned(east, 2), slopesTo(Face::west, {0.125_u, 0.25_u}, {0.5_u, 1.0_u}));
    EXPECT_EQ(turned(east, 3), slopesTo(Face::north, {0.125_u, 0.25_u}, {0.5_u, 1.0_u}));
    EXPECT_EQ(turned(turned(east, 3), 1), east);
}

// Under a body is the highest point below its box, rounded up.
TEST(Slope, BodiesTouchItsHighestPoint) {
    World world = emptyWorld(4, 1, 2);
    slope(world, 1, 0, Face::east, {}, {{}, 1.0_u});
    Box box = {1.25_u, 1.5_u, 0.25_u, 0.75_u, 0.5_u, 0.75_u};
    EXPECT_TRUE(isFree(world, 0, box));
    EXPECT_TRUE(isSupported(world, 0, box));
    EXPECT_FALSE(isFree(world, 0, moved(box, {.x = kTiny, .y = {}, .z = {}})));
    EXPECT_EQ(sweepX(world, 0, box, 0.5_u), Coordinate{});
    EXPECT_EQ(sweepX(world, 0, moved(box, {.x = {}, .y = {}, .z = 0.125_u}), 0.5_u), 0.125_u);
    EXPECT_EQ(sweepX(world, 0, moved(box, {.x = 2.0_u, .y = {}, .z = toCoordinate(-0.5)}),
                     toCoordinate(-3.0)),
              toCoordinate(-1.25))
        << "against its high end";
    // One third of the way up, heights are rounded
    world.blueprints.back().slopes.top = {{}, {21845}};
    world.blueprints.back().top = {21845};
    box = {1.0_u, 1.5_u, 0.25_u, 0.75_u, 1.0_u, 1.25_u};
    EXPECT_EQ(sweepZ(world, 0, box, toCoordinate(-1.0)), Coordinate{10923 - 65536});
}

TEST(Slope, BodiesDoNotReachIntoItsUnderside) {
    World world = emptyWorld(4, 1, 2);
    slope(world, 1, 0, Face::east, {{}, 1.0_u}, kWhole);
    const Box box = {2.5_u, 2.75_u, 0.25_u, 0.75_u, 0.0_u, 0.5_u};
    EXPECT_EQ(sweepX(world, 0, box, toCoordinate(-2.0)), toCoordinate(-1.0))
        << "half of the vault is high enough";
    EXPECT_EQ(sweepZ(world, 0, moved(box, {.x = toCoordinate(-1.0), .y = {}, .z = {}}), 1.0_u),
              Coordinate{});
}

TEST(Slope, IsWalkedUpAndDownWithoutLeavingTheGround) {
    for (const Coordinate gradient : {0.25_u, 0.5_u, 0.75_u}) {
        Walker walker(rampOf(gradient), 1.2, 1.5, 0.0);
        double before = walker.z();
        double steepest = 0.0;
        for (int step = 0; step < 3 * kSecond; ++step) {
            walker.step(kAhead);
            ASSERT_TRUE(walker.player.onGround) << "step " << step;
            ASSERT_GE(walker.z(), before) << "step " << step;
            steepest = std::max(steepest, walker.z() - before);
            before = walker.z();
        }
        EXPECT_EQ(walker.z(), std::min(1.0, 2.0 * gradient.value()));
        if (gradient != 0.75_u) {
            EXPECT_LT(steepest, 0.04) << "no steps";
        }
        walker.player.headingDegrees = 180.0;
        for (int step = 0; step < 3 * kSecond; ++step) {
            walker.step(kAhead);
            if (gradient != 0.75_u) {
                ASSERT_TRUE(walker.player.onGround) << "step " << step;
            }
        }
        EXPECT_EQ(walker.z(), 0.0);
    }
}

TEST(Slope, ABodyStandsOnWhatIsNotSteep) {
    Walker walker(rampOf(0.75_u), 2.5, 1.5, 0.53);
    walker.step(kNothing, kSecond);
    EXPECT_EQ(walker.x(), 2.5);
    EXPECT_TRUE(walker.player.onGround);
    walker.step({.forward = 0.0, .jump = true});
    EXPECT_FALSE(walker.player.onGround) << "and jumps from it";
}

TEST(Slope, ABodySlidesDownWhatIsSteepAndDoesNotClimbIt) {
    for (const Face rise : {Face::north, Face::east, Face::south, Face::west}) {
        World world = emptyWorld(5, 5, 3);
        slope(world, 2, 2, rise, {}, {{}, 1.0_u});
        Walker walker(std::move(world), 2.5, 2.5, 0.9);
        walker.step(kNothing, 2 * kSecond);
        EXPECT_EQ(walker.z(), 0.0);
        const double down = rise == Face::east || rise == Face::south ? -1.0 : 1.0;
        const bool alongX = rise == Face::east || rise == Face::west;
        EXPECT_GT(((alongX ? walker.x() : walker.y()) - 2.5) * down, 0.5);
        EXPECT_EQ(alongX ? walker.y() : walker.x(), 2.5);
    }
    Walker climber(rampOf(1.0_u), 1.2, 1.5, 0.0);
    climber.step(kAhead, 2 * kSecond);
    EXPECT_EQ(climber.z(), 0.0);
    EXPECT_NEAR(climber.x(), 1.8, 0.05) << "at its foot";
}

TEST(Slope, HidesWhatLiesBehindIt) {
    World world = emptyWorld(4, 1, 2);
    slope(world, 1, 0, Face::east, {}, {{}, 1.0_u});
    const Map& map = world.maps[0];
    EXPECT_TRUE(isInSight(world, map, {0.5, 0.5, 1.1}, {2.5, 0.5, 1.1}));
    EXPECT_FALSE(isInSight(world, map, {0.5, 0.5, 0.8}, {2.5, 0.5, 0.8}));
    EXPECT_TRUE(isInSight(world, map, {0.5, 0.5, 0.3}, {1.5, 0.5, 0.9})) << "above it, in its tile";
    EXPECT_FALSE(isInSight(world, map, {0.5, 0.5, 0.3}, {1.9, 0.5, 0.5}));
}

}  // namespace
}  // namespace slicecast
