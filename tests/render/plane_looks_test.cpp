// How planes look, row by row: against the formulas, for planes above and below the eye.
#include "render/view/plane_looks.h"

#include "render/view/frame.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slicecast {
namespace {

constexpr int kRows = 120;

// Lights and fogs that begin anywhere, a horizon anywhere within the picture.
struct AnyLight {
    explicit AnyLight(Random& random) {
        rays.lighting.lit = !random.oneIn(4);
        rays.lighting.foggy = random.oneIn(2);
        rays.lighting.strength = random.between(0.2, 8.0);
        rays.lighting.brightest = random.between(0.3, 1.0);
        rays.lighting.fogStart = random.between(0.0, 6.0);
        rays.lighting.fogLength = random.between(0.5, 20.0);
        if (random.oneIn(4)) rays.lighting.surface = random.between(1, 65536);
        rays.projectionDistance = random.between(40.0, 200.0);
        const double horizon = random.between(1, 2 * kRows - 1) / 2.0;
        for (int row = 0; row < kRows; ++row) {
            const double offset = std::fabs(horizon - (row + 0.5));
            inverseOffsets.push_back(offset > 0.0 ? 1.0 / offset
                                                  : std::numeric_limits<double>::infinity());
        }
        rays.inverseOffsets = inverseOffsets.data();
        rays.firstFallingRow = static_cast<int>(std::ceil(horizon - 0.5));
        rays.height = kRows;
    }

    PlaneRays rays;
    std::vector<double> inverseOffsets;
};

Plane anyPlane(Random& random) {
    Plane plane;
    plane.rise = random.between(1, 200000);
    if (random.oneIn(2)) plane.rise = -plane.rise;
    plane.texture = static_cast<TextureId>(random.below(3));
    plane.light = random.oneIn(2) ? 1.0 : random.unit();
    plane.glow = random.oneIn(5);
    return plane;
}

TEST(PlaneLooks, EachRowByTheFormulas) {
    Random random(1);
    PlaneLooks looks;
    for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i) {
        const AnyLight any(random);
        looks.beginFrame(any.rays);
        const Plane plane = anyPlane(random);
        const FrameTexture texture = {nullptr, 64, 6, false};
        const Detail detail({}, any.rays.projectionDistance);
        PlaneLook& look = looks.find(plane, texture, detail);
        const double units = std::fabs(plane.rise / 65536.0);
        EXPECT_EQ(look.depthPerInverse, units * any.rays.projectionDistance);
        const int first = plane.rise < 0 ? any.rays.firstFallingRow : 0;
        const int last = plane.rise < 0 ? kRows : any.rays.firstFallingRow;
        // Some of the rows, then all.
        if (last - first > 20) look.rows(first + 5, last - 7);
        const PlaneRows rows = look.rows(first, last);
        std::size_t stretch = 0;
        for (int row = first; row < last; ++row) {
            const double inverse = any.inverseOffsets[static_cast<std::size_t>(row)];
            const double depth = look.depthPerInverse * inverse;
            const double under = std::min(units, any.rays.lighting.surface / 65536.0);
            const double inFog =
                plane.rise < 0 ? depth : under * any.rays.projectionDistance * inverse;
            const std::uint32_t factor = any.rays.lighting.factorAt(depth, plane.light, plane.glow);
            const std::uint32_t fog = any.rays.lighting.fogAt(inFog);
            EXPECT_EQ(rows.factors[row], inBothHalves(factor));
            if (any.rays.lighting.foggy) {
                EXPECT_EQ(rows.fogs[row], inBothHalves(fog));
            }
            ASSERT_LT(stretch, look.stretches().size());
            if (look.stretches()[stretch].last == row) ++stretch;
            const PlaneLook::Stretch& here = look.stretches()[stretch];
            EXPECT_EQ(here.detail, detail.levelAt(depth, 64, 6)) << row;
            EXPECT_EQ(here.shade, fog != 0        ? PlaneShade::foggy
                                  : factor != 256 ? PlaneShade::dimmed
                                                  : PlaneShade::full)
                << row;
        }
        EXPECT_EQ(look.stretches().back().last, kRows);
        EXPECT_EQ(rows.fogs != nullptr, any.rays.lighting.foggy);
    }
}

// As many as there are, each is found again, until the next frame.
TEST(PlaneLooks, EachPlaneHasOne) {
    Random random(2);
    const AnyLight any(random);
    PlaneLooks looks;
    const FrameTexture texture = {nullptr, 64, 6, false};
    for (int frame = 0; frame < 3; ++frame) {
        looks.beginFrame(any.rays);
        std::vector<PlaneLook*> found;
        const auto planeOf = [&](int i) {
            Plane plane;
            plane.rise = i % 7 - 9;
            plane.texture = static_cast<TextureId>(i / 7 % 5);
            plane.light = 1.0 / (1 + i / 35 % 5);
            plane.glow = i / 175 % 2 == 1;
            plane.southReversed = i / 350 % 2 == 1;
            plane.mirror = i / 700 % 2 == 1;
            return plane;
        };
        for (int i = 0; i < 1400; ++i) {
            found.push_back(&looks.find(planeOf(i), texture, {}));
            ASSERT_EQ(found.back()->plane, planeOf(i));
        }
        for (int i = 0; i < 1400; ++i)
            ASSERT_EQ(&looks.find(planeOf(i), texture, {}), found[static_cast<std::size_t>(i)]);
    }
}

}  // namespace
}  // namespace slicecast
