// What a trace tells of a slice, beside what is painted.
#include "render/ask/slice_trace.h"

#include "scenes.h"
#include "slice_stage.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicecast::known {
namespace {

// The eye stands in water, 0.25 below its surface, under a ceiling 1.5 above it. There is no more
// fog than to the surface.
TEST(SliceTraces, FogEndsAtTheSurfaceOfTheEyesWater) {
    World world = emptyWorld(5, 5, 3, plain("floor", kWhite));
    const BlueprintId water = addBlock(world, kNoTexture, {}, toCoordinate(0.75));
    world.blueprints[water].isWater = true;
    world.blueprints[water].waterColour = kMagenta;
    world.blueprints[water].waterSight = 8.0;
    world.maps[0].setCell(2, 2, 0, water);
    world.maps[0].ceiling.height = tileEdge(2);
    world.maps[0].ceiling.tiles.assign(25, 0);
    markSeeThrough(world);

    SliceStage stage(world, eyeAt(2.5, 2.5, 0.5, 0.0), 200, 200);
    SliceTrace trace;
    traceSlice(stage.frame(), stage.find(100), trace);
    int ceilings = 0;
    for (const FilledRows& rows : trace.filled) {
        if (rows.what != FilledRows::What::ceiling) continue;
        ++ceilings;
        const double slope = (100.0 - (rows.first + 0.5)) / 100.0;
        EXPECT_NEAR(rows.top.depth, 1.5 / slope, 1e-9);
        EXPECT_EQ(rows.top.fog, static_cast<std::uint32_t>(255 * 0.25 / slope / 8.0 + 0.5));
    }
    EXPECT_GT(ceilings, 0);
}

// A ray straight ahead along the middle of a board's tile, and one beside it.
TEST(SliceTraces, HitsBeginAndEndAtPlans) {
    World world = emptyWorld(5, 5, 1, plain("floor", kWhite));
    const BlueprintId board = addBlock(world, 0);
    world.blueprints[board].plan = {toCoordinate(0.25), {}, toCoordinate(0.5), toCoordinate(0.75)};
    world.maps[0].setCell(3, 2, 0, board);
    markPlans(world);
    SliceStage stage(world, eyeAt(1.0, 2.5, 0.5, 0.0), 201, 100);
    SliceTrace trace;
    traceSlice(stage.frame(), stage.find(100), trace);
    ASSERT_EQ(trace.hits.size(), 1u);
    EXPECT_NEAR(trace.hits[0].depth, 2.25, 1e-9);
    EXPECT_NEAR(trace.hits[0].backDepth, 2.5, 1e-9);
    EXPECT_NEAR(trace.hits[0].x, 3.25, 1e-9);
    EXPECT_TRUE(trace.hits[0].entered);
    ASSERT_FALSE(trace.hits[0].filled.empty());
    EXPECT_NEAR(trace.hits[0].filled[0].top.depth, 2.25, 1e-9);

    SliceStage beside(world, eyeAt(1.0, 2.875, 0.5, 0.0), 201, 100);
    SliceTrace passed;
    traceSlice(beside.frame(), beside.find(100), passed);
    EXPECT_TRUE(passed.hits.empty());
}

// Equal blocks in a row, seen from above: their roofs are one plane, whose rows touch.
TEST(SliceTraces, EachTileOfARoofIsToldByItself) {
    World world = emptyWorld(7, 5, 1, plain("floor", kWhite));
    const BlueprintId low = addBlock(world, 0, {}, toCoordinate(0.25));
    for (const int x : {2, 3, 4}) world.maps[0].setCell(x, 2, 0, low);
    SliceStage stage(world, eyeAt(0.5, 2.5, 0.75, 0.0), 201, 200);
    SliceTrace trace;
    traceSlice(stage.frame(), stage.find(100), trace);
    ASSERT_EQ(trace.hits.size(), 3u);
    for (const Hit& hit : trace.hits) {
        EXPECT_TRUE(std::any_of(hit.filled.begin(), hit.filled.end(), [](const FilledRows& rows) {
            return rows.what == FilledRows::What::roof;
        })) << hit.tileX;
    }
}

// A ramp two units ahead that rises to the eye's height and beyond: its roof is seen on both sides
// of the horizon.
TEST(SliceTraces, SlopesAreSeenAcrossTheHorizon) {
    World world = emptyWorld(5, 5, 1, plain("floor", kWhite));
    const BlueprintId ramp = addBlock(world, 0);
    world.blueprints[ramp].slopes = slopesTo(Face::east, {}, {{}, tileEdge(1)});
    world.maps[0].setCell(3, 2, 0, ramp);
    SliceStage stage(world, eyeAt(1.0, 2.5, 0.5, 0.0), 201, 200);
    SliceTrace trace;
    trace.watchedRow = 110;
    traceSlice(stage.frame(), stage.find(100), trace);
    ASSERT_EQ(trace.hits.size(), 1u);
    const Hit& hit = trace.hits[0];
    const double d = trace.projectionDistance;
    EXPECT_NEAR(hit.topSlope, 1.0, 1e-12);
    EXPECT_EQ(hit.bottomSlope, 0.0);
    EXPECT_NEAR(hit.topFrontRow, 100.0 + 0.5 * d / 2.0, 1e-9);
    EXPECT_NEAR(hit.topBackRow, 100.0 - 0.5 * d / 3.0, 1e-9);
    EXPECT_EQ(hit.bottomFrontRow, hit.topFrontRow) << "no side";
    ASSERT_EQ(hit.filled.size(), 1u);
    const FilledRows& roof = hit.filled[0];
    EXPECT_EQ(roof.what, FilledRows::What::roof);
    EXPECT_NEAR(roof.first, hit.topBackRow, 1.0);
    EXPECT_NEAR(roof.last, hit.topFrontRow, 1.0);
    EXPECT_NEAR(roof.top.depth, 3.0, 0.03);
    EXPECT_NEAR(roof.bottom.depth, 2.0, 0.03);
    // 0.5 + slope * t = t - 2
    const double slope = (100.0 - 110.5) / d;
    ASSERT_EQ(trace.seen.size(), 1u);
    EXPECT_NEAR(trace.seen[0].texel.depth, 2.5 / (1.0 - slope), 1e-9);
    EXPECT_NEAR(trace.seen[0].z, trace.seen[0].x - 3.0, 1e-9);
}

}  // namespace
}  // namespace slicecast::known
