// Drawn without any of the old ways the picture is the renderer's.
#include "classic_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace slicecast::known {
namespace {

// Glass and lattices that touch each other and solid blocks, on a floor with holes.
World glassWorld(std::uint64_t seed) {
    Random random(seed);
    World world = emptyWorld(6, 6, 3, lattice("floor"));
    const TextureId pane = addTexture(world, lattice("pane"));
    const BlueprintId blocks[] = {
        addBlock(world, pane), addBlock(world, pane, {}, toCoordinate(0.5)), addBlock(world, pane),
        addBlock(world, addTexture(world, squares("solid", 60)))};
    world.blueprints[blocks[2]].join = false;
    markSeeThrough(world);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 6; ++x) {
            for (int level = 0; level < 3; ++level) {
                if (random.oneIn(2)) world.maps[0].setCell(x, y, level, blocks[random.below(4)]);
            }
        }
    }
    return world;
}

// How many of a number of views' pixels are not the renderer's.
template <typename MakeWorld>
FrameReport expectTheRenderersPictures(std::uint64_t seed, MakeWorld&& makeWorld) {
    Random random(seed);
    std::int64_t pixels = 0;
    std::int64_t different = 0;
    std::set<Pixel> colours;
    FrameReport shown;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const World world = makeWorld(i);
        const Map& map = world.maps[0];
        const Eye eye = {.map = 0,
                         .x = {random.between(-3 * 65536, (map.width + 3) * 65536)},
                         .y = {random.between(-3 * 65536, (map.depth + 3) * 65536)},
                         .z = {random.between(1, (map.levels + 2) * 65536)},
                         .headingDegrees = random.between(0.0, 360.0),
                         .look = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0)};
        const RenderOptions options = {.fovDegrees = random.between(30.0, 120.0),
                                       .detail = !random.oneIn(4),
                                       .smooth = random.oneIn(2),
                                       .textures = !random.oneIn(8),
                                       .fog = !random.oneIn(4),
                                       .mirrors = random.oneIn(2) ? 1.0 : 1.7};
        const Image exact = draw(world, eye, 97, 61, options);
        const Drawn old = drawOld(world, eye, 97, 61, {}, options);
        EXPECT_FALSE(exact.empty());
        EXPECT_EQ(exact.pixels.size(), old.image.pixels.size());
        if (exact.pixels.size() != old.image.pixels.size()) return shown;
        EXPECT_EQ(old.report.rowsFilled, 97 * 61);
        shown.objectSlices += old.report.objectSlices;
        shown.mirroredRows += old.report.mirroredRows;
        shown.layers += old.report.layers;
        shown.deepestPortal = std::max(shown.deepestPortal, old.report.deepestPortal);
        for (std::size_t p = 0; p < exact.pixels.size(); ++p) {
            const Colour a = toColour(exact.pixels[p]);
            const Colour b = toColour(old.image.pixels[p]);
            ++pixels;
            if (std::abs(a.r - b.r) > 1 || std::abs(a.g - b.g) > 1 || std::abs(a.b - b.b) > 1 ||
                b.a != 255)
                ++different;
            colours.insert(exact.pixels[p]);
        }
    }
    EXPECT_GT(colours.size(), 2000u) << "there was something to see";
    // Where a ray meets an edge within a rounding.
    EXPECT_LE(different, pixels / 10000) << different << " of " << pixels;
    return shown;
}

TEST(Classic, WithoutOldWaysEqualsTheRenderer) {
    expectTheRenderersPictures(7, mixedWorld);
}

TEST(Classic, DrawsGlassLikeTheRenderer) {
    expectTheRenderersPictures(8, glassWorld);
}

TEST(Classic, DrawsObjectsMirrorsAndPortalsLikeTheRenderer) {
    const FrameReport shown = expectTheRenderersPictures(9, featureWorld);
    EXPECT_GT(shown.objectSlices, 1000);
    EXPECT_GT(shown.mirroredRows, 20'000);
    EXPECT_GT(shown.layers, 1000);
    EXPECT_GE(shown.deepestPortal, 3);
}

// Two blocks that touch in a corner: nothing is seen between them, and the eastern one comes first.
TEST(Classic, DrawsThroughACornerLikeTheRenderer) {
    World world = emptyWorld(9, 9, 1, plain("floor", kBlack));
    const BlueprintId east = addBlock(world, addTexture(world, plain("east", kRed)));
    const BlueprintId south = addBlock(world, addTexture(world, plain("south", kGreen)));
    world.maps[0].setCell(5, 4, 0, east);
    world.maps[0].setCell(4, 5, 0, south);
    const Eye eye = eyeAt(2.5, 2.5, 0.5, 45.0);
    EXPECT_EQ(draw(world, eye, 1, 1).at(0, 0), toPixel(kRed));
    EXPECT_EQ(drawOld(world, eye, 1, 1, {}).image.at(0, 0), toPixel(kRed));
}

}  // namespace
}  // namespace slicecast::known
