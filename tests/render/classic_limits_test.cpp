// What cannot be drawn, and that all else can.
#include "classic_scenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicecast::known {
namespace {

TEST(Classic, RefusesInvalidViews) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(8.0, 20.5, 0.5, 0.0);
    EXPECT_FALSE(drawOld(world, eye, 8, 8, {}).image.empty());
    for (const ClassicOptions& wrong :
         std::vector<ClassicOptions>{{.stepSize = 0.0},
                                     {.stepSize = -0.1},
                                     {.stepSize = 1.1},
                                     {.reach = 0.5},
                                     {.reach = 101.0},
                                     {.sineSteps = -1},
                                     {.sineSteps = kMostSineSteps + 1},
                                     {.pixelSize = 0},
                                     {.pixelSize = kMostPixelSize + 1}}) {
        EXPECT_TRUE(drawOld(world, eye, 8, 8, wrong).image.empty());
    }
    EXPECT_TRUE(drawOld(world, eyeAt(8.0, 20.5, 0.0, 0.0), 8, 8, {}).image.empty());
    EXPECT_TRUE(drawOld(world, eyeAt(8.0, 20.5, 0.5, 0.0, 4.1), 8, 8, {}).image.empty());
    EXPECT_TRUE(drawOld(world, eye, 8, 8, {}, {.fovDegrees = 151.0}).image.empty());
    Eye nowhere = eye;
    nowhere.map = 1;
    EXPECT_TRUE(drawOld(world, nowhere, 8, 8, {}).image.empty());
    EXPECT_FALSE(drawClassic(world, eye, {}, {}, {nullptr, 8, 8, 8}));
}

// All at once, at the least of steps and the widest of views: nothing is divided by zero, nothing
// looked up beside a texture.
TEST(Classic, AnyMixtureCanBeDrawn) {
    Random random(5);
    for (std::uint64_t i = 0; i < 60; ++i) {
        const World world = featureWorld(i);
        const ClassicOptions classic = {
            .projection = static_cast<ClassicProjection>(random.below(3)),
            .march = random.oneIn(2),
            .stepSize = random.oneIn(2) ? 0.01 : random.between(0.02, 1.0),
            .reach = random.between(1.0, 100.0),
            .stretched = random.oneIn(2),
            .mirroredTextures = random.oneIn(2),
            .roofs = static_cast<ClassicRoofs>(random.below(3)),
            .seams = random.oneIn(2),
            .paintersOrder = random.oneIn(2),
            .oneLevel = random.oneIn(3),
            .firstHits = random.oneIn(2),
            .noOwnCell = random.oneIn(2),
            .driftingHorizon = random.oneIn(2),
            .columnDepth = random.oneIn(2),
            .wrongScale = random.oneIn(2),
            .flippedMirrors = random.oneIn(2),
            .portalsOverdrawn = random.oneIn(2),
            .sineSteps = random.oneIn(2) ? 0 : random.between(1, 400),
            .pixelSize = random.between(1, 9)};
        const Eye eye = {
            .map = 0,
            .x = {random.oneIn(4) ? 5 * 65536 : random.between(-3 * 65536, 13 * 65536)},
            .y = {random.oneIn(4) ? 4 * 65536 : random.between(-3 * 65536, 12 * 65536)},
            .z = {random.oneIn(4) ? 65536 : random.between(1, 6 * 65536)},
            .headingDegrees =
                random.oneIn(3) ? 90.0 * random.between(-4, 4) : random.between(-400.0, 400.0),
            .look = random.between(-4.0, 4.0)};
        const Image image =
            drawOld(world, eye, 64, 48, classic,
                    {.fovDegrees = random.oneIn(2) ? 150.0 : random.between(10.0, 150.0)})
                .image;
        ASSERT_FALSE(image.empty());
        for (const Pixel pixel : image.pixels) ASSERT_EQ(toColour(pixel).a, 255);
    }
}

}  // namespace
}  // namespace slicecast::known
