// What cannot be drawn, and that all else can.
#include "classic_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
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
    LitMaps lit;
    EXPECT_FALSE(drawClassic(world, eye, {}, {}, lit, {nullptr, 8, 8, 8}));
}

// A ray that runs along a slope never meets it, not even when everything is painted.
TEST(Classic, DrawsASlopeThatGoesThroughTheEye) {
    World world = emptyWorld(12, 12, 1, plain("floor", kBlack));
    const BlueprintId ramp = addBlock(world, addTexture(world, plain("ramp", kRed)));
    world.blueprints[ramp].slopes = slopesTo(Face::east, {}, {{}, toCoordinate(0.5)});
    world.blueprints[ramp].top = toCoordinate(0.5);
    world.maps[0].setCell(5, 5, 0, ramp);
    // Row 16 has a slope of one half
    const Eye eye = eyeAt(5.5, 5.5, 0.25, 0.0, 1.0 / 128.0);
    const RenderOptions options = {.fovDegrees = 90.0};
    const int first = firstRow(draw(world, eye, 64, 64, options), 32, kRed);
    for (const bool paintersOrder : {false, true}) {
        const Drawn old = drawOld(world, eye, 64, 64, {.paintersOrder = paintersOrder}, options);
        ASSERT_FALSE(old.image.empty());
        EXPECT_NEAR(firstRow(old.image, 32, kRed), first, 1);
    }
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

using What = FilledRows::What;

// Finite, in front of the eye, and of its texture.
void checkTexel(const World& world, const FilledRows& run, const TracedTexel& texel) {
    ASSERT_TRUE(texel.depth > 0.0 && texel.depth < 1e9) << texel.depth;
    const bool isObject = run.what == What::object;
    const SpriteLevel* sprite =
        isObject ? &world.sprites[run.texture].frames[0][static_cast<std::size_t>(texel.detail)]
                 : nullptr;
    const TextureLevel* texture =
        isObject ? nullptr
                 : &world.textures[run.texture].levels[static_cast<std::size_t>(texel.detail)];
    ASSERT_TRUE(texel.u >= 0 && texel.u < (isObject ? sprite->width : texture->size));
    ASSERT_TRUE(texel.v >= 0 && texel.v < (isObject ? sprite->height : texture->size));
}

// Coarse pixels in narrow pictures, whose middles lie beyond the picture's edge; tables of a few
// sines; seams beside the horizon, which goes through the middle of a row of each odd picture.
// Whatever is divided by is not zero, and what becomes a whole number is one.
TEST(Classic, DividesByNothingNearZero) {
    Random random(6);
    const World worlds[] = {featureWorld(1), featureWorld(2), featureWorld(4), featureWorld(7)};
    int objects = 0;
    for (int width = 1; width <= 64; ++width) {
        for (int i = 0; i < 18; ++i) {
            const World& world = worlds[random.below(4)];
            constexpr int kPixelSizes[] = {1, 2, 3, 8, 63, 64};
            constexpr int kSineSteps[] = {0, 1, 2, 3, 4, 5, 8, 360};
            const ClassicOptions classic = {.projection = static_cast<ClassicProjection>(i % 3),
                                            .march = random.oneIn(4),
                                            .stepSize = 0.25,
                                            .stretched = random.oneIn(3),
                                            .seams = random.oneIn(2),
                                            .paintersOrder = random.oneIn(4),
                                            .oneLevel = random.oneIn(6),
                                            .noOwnCell = random.oneIn(4),
                                            .driftingHorizon = random.oneIn(6),
                                            .wrongScale = random.oneIn(4),
                                            .flippedMirrors = random.oneIn(4),
                                            .portalsOverdrawn = random.oneIn(4),
                                            .sineSteps = kSineSteps[random.below(8)],
                                            .pixelSize = kPixelSizes[i % 6]};
            const Eye eye = {.map = 0,
                             .x = {random.between(0, 10 * 65536)},
                             .y = {random.between(0, 9 * 65536)},
                             .z = {random.between(1, 5 * 65536)},
                             .headingDegrees = random.oneIn(2) ? 90.0 * random.below(4)
                                                               : random.between(0.0, 360.0),
                             .look = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0)};
            const RenderOptions options = {.fovDegrees =
                                               random.oneIn(2) ? kMaxFovDegrees : kMinFovDegrees};
            const int height = random.between(1, 40);
            ASSERT_FALSE(drawOld(world, eye, width, height, classic, options).image.empty());
            const ColumnRequest request = {width, height, random.below(width),
                                           random.below(height)};
            LitMaps lit;
            const SliceTrace trace = traceClassic(world, eye, options, classic, lit, request);
            std::vector<int> times(static_cast<std::size_t>(height));
            for (const FilledRows& run : trace.filled) {
                for (int row = run.first; row < run.last && !run.layer; ++row)
                    ++times[static_cast<std::size_t>(row)];
                objects += run.what == What::object ? 1 : 0;
                if (run.texture == kNoTexture) continue;
                ASSERT_NO_FATAL_FAILURE(checkTexel(world, run, run.top)) << width << ", " << i;
                ASSERT_NO_FATAL_FAILURE(checkTexel(world, run, run.bottom)) << width << ", " << i;
            }
            ASSERT_EQ(times, std::vector<int>(times.size(), 1));
            ASSERT_TRUE(std::isfinite(trace.rayX) && std::isfinite(trace.rayY));
        }
    }
    EXPECT_GT(objects, 20);
}

}  // namespace
}  // namespace slicecast::known
