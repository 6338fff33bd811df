// What the classic method tells of a column is what it drew.
#include "classic_scenes.h"

#include <gtest/gtest.h>

#include <tuple>

namespace slicecast::known {
namespace {

constexpr int kTraceWidth = 64;
constexpr int kTraceHeight = 48;

using What = FilledRows::What;

Eye anyEye(Random& random, const World& world) {
    const Map& map = world.maps[0];
    return {.map = 0,
            .x = {random.between(0, map.width * 65536)},
            .y = {random.between(0, map.depth * 65536)},
            .z = {random.between(1, (map.levels + 1) * 65536)},
            .headingDegrees = random.between(0.0, 360.0),
            .look = random.between(-0.5, 0.5)};
}

// Of each row, what is seen there behind all layers, and in mirrors.
struct RowSeen {
    int runs = 0;
    What what = What::haze;
    Face face = Face::top;
    TextureId texture = kNoTexture;
    int map = 0;
    int portals = 0;

    friend bool operator==(const RowSeen&, const RowSeen&) = default;
};

std::vector<RowSeen> rowsOf(const SliceTrace& trace) {
    std::vector<RowSeen> rows(kTraceHeight);
    for (const FilledRows& run : trace.filled) {
        for (int row = run.first; row < run.last && !run.layer; ++row) {
            RowSeen& seen = rows[static_cast<std::size_t>(row)];
            seen = {seen.runs + 1, run.what, run.hit >= 0 ? run.face : Face::top,
                    run.texture,   run.map,  run.portals};
        }
    }
    return rows;
}

TEST(ClassicTrace, EqualsTheRenderersWithoutSeeThroughBlocks) {
    Random random(3);
    int rows = 0;
    int different = 0;
    int behindPortals = 0;
    int mirrored = 0;
    for (std::uint64_t i = 0; i < 80; i += 2) {
        World world = featureWorld(i);
        for (Map& map : world.maps) map.objects.clear();
        const Eye eye = anyEye(random, world);
        const RenderOptions options;
        Renderer renderer;
        for (int column = 3; column < kTraceWidth; column += 12) {
            const SliceTrace exact =
                renderer.trace(world, eye, options, {kTraceWidth, kTraceHeight, column});
            const SliceTrace old = traceClassic(world, eye, options, {}, renderer.lit(),
                                                {kTraceWidth, kTraceHeight, column});
            EXPECT_EQ(old.column, column);
            EXPECT_DOUBLE_EQ(old.horizonRow, exact.horizonRow);
            EXPECT_DOUBLE_EQ(old.projectionDistance, exact.projectionDistance);
            EXPECT_NEAR(old.rayX * exact.projectionDistance, exact.rayX * exact.projectionDistance,
                        1e-9);

            const std::vector<RowSeen> a = rowsOf(exact);
            const std::vector<RowSeen> b = rowsOf(old);
            for (std::size_t row = 0; row < a.size(); ++row) {
                EXPECT_EQ(b[row].runs, 1) << "each row once";
                ++rows;
                different += a[row] == b[row] ? 0 : 1;
                behindPortals += b[row].portals > 0 ? 1 : 0;
            }
            ASSERT_EQ(exact.reflection.size(), old.reflection.size());
            if (!exact.reflection.empty()) {
                const std::vector<RowSeen> up = rowsOf(exact.reflection[0]);
                const std::vector<RowSeen> oldUp = rowsOf(old.reflection[0]);
                for (std::size_t row = 0; row < up.size(); ++row) {
                    mirrored += oldUp[row].runs;
                    ++rows;
                    different += up[row] == oldUp[row] ? 0 : 1;
                }
            }

            // The renderer stops where no row is open; up to there both met the same blocks.
            ASSERT_GE(old.hits.size(), exact.hits.empty() ? 0u : 1u);
            for (std::size_t k = 0; k < exact.hits.size() && exact.hits[k].portals == 0; ++k) {
                const Hit& p = exact.hits[k];
                const Hit& q = old.hits[k];
                EXPECT_EQ(std::tuple(p.tileX, p.tileY, p.level, p.blueprint, p.entered),
                          std::tuple(q.tileX, q.tileY, q.level, q.blueprint, q.entered));
                EXPECT_TRUE(!p.entered || p.face == q.face);
                EXPECT_NEAR(p.depth, q.depth, 1e-9);
                EXPECT_NEAR(p.backDepth, q.backDepth, 1e-9);
                EXPECT_EQ(p.bottom, q.bottom);
                EXPECT_EQ(p.top, q.top);
            }
        }
    }
    EXPECT_LE(different, rows / 500) << different << " of " << rows;
    EXPECT_GT(behindPortals, 300);
    EXPECT_GT(mirrored, 1000);
}

// With every old way: each row has one run that is no layer, whose texel is the one drawn.
TEST(ClassicTrace, EachRowHasOneRunWhateverTheWay) {
    Random random(4);
    for (std::uint64_t i = 0; i < 60; ++i) {
        const World world = featureWorld(i);
        const ClassicOptions classic = {.march = random.oneIn(3),
                                        .stepSize = 0.2,
                                        .roofs = static_cast<ClassicRoofs>(random.below(3)),
                                        .seams = random.oneIn(3),
                                        .paintersOrder = random.oneIn(3),
                                        .firstHits = random.oneIn(3),
                                        .columnDepth = random.oneIn(3),
                                        .wrongScale = random.oneIn(3),
                                        .flippedMirrors = random.oneIn(3),
                                        .portalsOverdrawn = random.oneIn(3),
                                        .pixelSize = random.oneIn(3) ? 5 : 1};
        const Eye eye = anyEye(random, world);
        LitMaps lit;
        const SliceTrace trace =
            traceClassic(world, eye, {}, classic, lit, {kTraceWidth, kTraceHeight, 30});
        for (const RowSeen& row : rowsOf(trace)) ASSERT_EQ(row.runs, 1) << i;
        int hitRows = 0;
        int filledRows = 0;
        for (const FilledRows& run : trace.filled) {
            if (run.hit < 0) continue;
            ASSERT_LT(run.hit, static_cast<int>(trace.hits.size()));
            hitRows += run.last - run.first;
        }
        for (const Hit& hit : trace.hits) {
            for (const FilledRows& run : hit.filled) filledRows += run.last - run.first;
        }
        EXPECT_EQ(hitRows, filledRows);
        for (const SeenObject& object : trace.objects) EXPECT_LT(object.first, object.last);
        for (const PassedPortal& portal : trace.portals) EXPECT_LT(portal.first, portal.last);
    }
}

TEST(ClassicTrace, IsEmptyWithoutAColumn) {
    const World world = mixedWorld(2);
    const Eye eye = eyeAt(5.2, 4.2, 0.5, 0.0);
    LitMaps lit;
    const auto isEmpty = [&](int column, const ClassicOptions& classic = {}) {
        return traceClassic(world, eye, {}, classic, lit, {kTraceWidth, kTraceHeight, column})
            .filled.empty();
    };
    EXPECT_FALSE(isEmpty(0));
    EXPECT_TRUE(isEmpty(-1));
    EXPECT_TRUE(isEmpty(kTraceWidth));
    EXPECT_TRUE(isEmpty(1, {.pixelSize = 0}));
}

}  // namespace
}  // namespace slicecast::known
