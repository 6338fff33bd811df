// Blocks that fill only a part of their tile, as single rays pass them.
#include "render/spans/plan_walk.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicecast {
namespace {

constexpr Half kHalves[] = {Half::northEast, Half::southEast, Half::southWest, Half::northWest};

// Rays from a coarse grid through its points meet cuts exactly at the corners of tiles, where the
// rounded quotient may lie on the wrong side of a border.
TEST(PlanWalk, CutsAreCrossedBetweenTheBordersOfTheTile) {
    Random random(1);
    int crossed = 0;
    int outside = 0;  // by the quotient itself
    for (int i = 0; i < 40'000; ++i) {
        Viewpoint eye;
        eye.x = random.between(0, 8 * 64) * 1024;
        eye.y = random.between(0, 8 * 64) * 1024;
        GroundDirection ray;
        ray.x = random.between(-9, 9) / 3.0;
        ray.y = random.between(-9, 9) / 3.0;
        if (ray.x == 0.0 && ray.y == 0.0) continue;
        GridWalk walk({static_cast<std::int32_t>(eye.x)}, {static_cast<std::int32_t>(eye.y)}, ray);
        for (int step = 0; step < 12; ++step, walk.advance()) {
            const PlanWalk plans(walk, eye, ray);
            for (const Half half : kHalves) {
                Plan plan;
                plan.half = half;
                const PlanPassage passage = plans.passage(plan);
                if (passage.enter.inner == passage.leave.inner) continue;
                const Crossing& cut = passage.enter.inner ? passage.enter : passage.leave;
                ++crossed;
                EXPECT_GE(cut.along, walk.enter().along);
                EXPECT_LE(cut.along, walk.leave().along);
                const double x = walk.tileX - static_cast<double>(eye.x) / 65536.0;
                const double y = walk.tileY - static_cast<double>(eye.y) / 65536.0;
                const bool isFalling = isCutFalling(half);
                const double along = std::fabs(isFalling ? x - y : x + y + 1.0) /
                                     std::fabs(isFalling ? ray.x - ray.y : ray.x + ray.y);
                if (!(along >= walk.enter().along && along <= walk.leave().along)) ++outside;
            }
        }
    }
    EXPECT_GT(crossed, 100'000);
    EXPECT_GT(outside, 10);
}

}  // namespace
}  // namespace slicecast
