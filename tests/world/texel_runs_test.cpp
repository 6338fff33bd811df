// Runs of holes, opaque and blended texels in the columns of a picture.
#include "world/texel_runs.h"

#include "base/random.h"
#include "world/sprite.h"
#include "world/texture.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

std::vector<Pixel> withAlphas(std::initializer_list<int> alphas) {
    std::vector<Pixel> texels;
    for (const int alpha : alphas) texels.push_back(static_cast<Pixel>(alpha) << 24 | 0x123456);
    return texels;
}

void expectRuns(const TexelRun* runs, std::initializer_list<std::pair<int, Coverage>> expected) {
    for (const auto& [end, coverage] : expected) {
        EXPECT_EQ(runs->end, end);
        EXPECT_EQ(runs->coverage, coverage);
        ++runs;
    }
}

TEST(TexelRuns, OfTwoColumns) {
    const TexelRuns runs(withAlphas({0, 0, 255, 255, 1, 254, 254, 128}), 4);
    expectRuns(runs.of(0), {{2, Coverage::hole}, {4, Coverage::opaque}});
    expectRuns(runs.of(1), {{4, Coverage::blended}});
}

// A run ends with its column, whatever the next one begins with.
TEST(TexelRuns, EndWithTheColumn) {
    const TexelRuns runs(withAlphas({0, 0, 0, 0, 0, 255}), 2);
    expectRuns(runs.of(0), {{2, Coverage::hole}});
    expectRuns(runs.of(1), {{2, Coverage::hole}});
    expectRuns(runs.of(2), {{1, Coverage::hole}, {2, Coverage::opaque}});
}

void expectRunsOf(const std::vector<Pixel>& texels, const TexelRuns& runs, int height) {
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const auto length = static_cast<std::size_t>(height);
        const TexelRun* run = runs.of(static_cast<int>(i / length));
        while (run->end <= i % length) ++run;
        const Pixel alpha = texels[i] >> 24;
        EXPECT_EQ(run->coverage, alpha == 0     ? Coverage::hole
                                 : alpha == 255 ? Coverage::opaque
                                                : Coverage::blended);
    }
}

// All levels and frames have theirs; an opaque texture needs none.
TEST(TexelRuns, OfTexturesAndSprites) {
    Random random(1);
    Image sheet(32, 16);
    for (Pixel& pixel : sheet.pixels)
        pixel = static_cast<Pixel>(random.below(3) * 127 + random.below(2)) << 24;
    const Texture texture = makeTexture("sheet", sheet, 2, 1.0);
    for (int frame = 0; frame < 2; ++frame) {
        for (const TextureLevel& level : texture.levelsOf(frame))
            expectRunsOf(level.texels, level.runs, level.size);
    }
    const Sprite sprite = makeSprite("sheet", sheet, 2, 1.0);
    for (const SharedVector<SpriteLevel>& frame : sprite.frames) {
        for (const SpriteLevel& level : frame) expectRunsOf(level.texels, level.runs, level.height);
    }
}

}  // namespace
}  // namespace slicecast
