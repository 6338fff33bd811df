// Drawn without any of the old ways, the classic method's picture is the exact one: of random
// worlds, which hold whatever a scene may hold but portals. Those of random worlds lead into the
// middle of blocks, where the two methods differ; tests/render has portals with free exits.
#include "draw.h"
#include "random_scene.h"
#include "suite.h"

#include "classic/draw_classic.h"
#include "sanitized.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

namespace slicecast::judge {
namespace {

TEST(Classic, DrawsRandomWorldsLikeTheExactMethod) {
    std::int64_t pixels = 0;
    std::int64_t different = 0;
    Renderer renderer;
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 100 : 1000); ++seed) {
        const Size size = kSmallSizes[seed % kSmallSizes.size()];
        const Scene scene = randomScene(seed, size.width, size.height);
        if (!scene.world.portals.empty()) continue;
        const Image exact = draw(renderer, scene.world, scene.view);
        Image old(size.width, size.height);
        ASSERT_TRUE(drawClassic(scene.world, eyeOf(scene.view), optionsOf(scene.view), {},
                                renderer.lit(),
                                {old.pixels.data(), old.width, old.height, old.width}));
        pixels += static_cast<std::int64_t>(exact.pixels.size());
        for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
            const Colour a = toColour(exact.pixels[i]);
            const Colour b = toColour(old.pixels[i]);
            if (std::abs(a.r - b.r) > 1 || std::abs(a.g - b.g) > 1 || std::abs(a.b - b.b) > 1)
                ++different;
        }
    }
    EXPECT_GT(pixels, kSanitized ? 300'000 : 3'000'000);
    // Where an eye stands on a border, or a ray meets an edge, within a rounding
    EXPECT_LE(different, pixels / 1000) << different << " of " << pixels;
}

// Old ways in any mixture draw any world, to the last row.
TEST(Classic, DrawsRandomWorldsByAnyOldWays) {
    Random random(11);
    Renderer renderer;
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 100 : 500); ++seed) {
        const Size size = kSmallSizes[seed % kSmallSizes.size()];
        const Scene scene = randomScene(seed, size.width, size.height);
        const auto isOn = [&] { return random.oneIn(4); };
        const ClassicOptions ways = {
            .projection = static_cast<ClassicProjection>(random.below(3)),
            .march = isOn(),
            .stepSize = 0.15,
            .stretched = isOn(),
            .mirroredTextures = isOn(),
            .roofs = static_cast<ClassicRoofs>(random.below(3)),
            .seams = isOn(),
            .paintersOrder = isOn(),
            .oneLevel = isOn(),
            .firstHits = isOn(),
            .noOwnCell = isOn(),
            .driftingHorizon = isOn(),
            .columnDepth = isOn(),
            .wrongScale = isOn(),
            .flippedMirrors = isOn(),
            .portalsOverdrawn = isOn(),
            .sineSteps = isOn() ? 90 : 0,
            .pixelSize = isOn() ? 5 : 1,
        };
        Image image(size.width, size.height);
        ASSERT_TRUE(drawClassic(scene.world, eyeOf(scene.view), optionsOf(scene.view), ways,
                                renderer.lit(),
                                {image.pixels.data(), image.width, image.height, image.width}));
        for (const Pixel pixel : image.pixels) ASSERT_EQ(toColour(pixel).a, 255) << seed;
    }
}

}  // namespace
}  // namespace slicecast::judge
