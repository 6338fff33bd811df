// Alpha: opaque pictures have no holes, see-through ones have them, and what lies under a hole is
// like what lies beside it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "textures/committed.h"

namespace slicecast::textures {
namespace {

struct Alphas {
    double holes = 0.0;
    double between = 0.0;
    double opaque = 0.0;
    int least = 255;
    int most = 0;
};

Alphas alphasOf(const Image& image) {
    Alphas alphas;
    for (const Pixel pixel : image.pixels) {
        const int alpha = toColour(pixel).a;
        (alpha == 0 ? alphas.holes : (alpha == 255 ? alphas.opaque : alphas.between)) +=
            1.0 / static_cast<double>(image.pixels.size());
        alphas.least = std::min(alphas.least, alpha);
        alphas.most = std::max(alphas.most, alpha);
    }
    return alphas;
}

TEST(Holes, EveryPictureHasTheAlphasThatItsEntrySays) {
    for (const Entry& entry : catalogue()) {
        const Alphas alphas = alphasOf(committed(entry));
        switch (entry.alpha) {
            case Alpha::Opaque:
                EXPECT_EQ(alphas.least, 255) << entry.name;
                break;
            case Alpha::Holes:
                EXPECT_EQ(alphas.between, 0.0) << entry.name;
                EXPECT_GT(alphas.holes, 0.1) << entry.name;
                EXPECT_GT(alphas.opaque, 0.1) << entry.name;
                break;
            case Alpha::Blended:
                EXPECT_GT(alphas.between, 0.02) << entry.name;
                break;
            case Alpha::Nothing:
                EXPECT_EQ(alphas.most, 0) << entry.name;
                break;
        }
    }
}

TEST(Holes, SeeThroughTexturesAndSpritesAreSeeThrough) {
    int seen = 0;
    for (const Entry& entry : catalogue()) {
        if (entry.use == Use::SeeThrough || entry.use == Use::Sprite) {
            EXPECT_NE(entry.alpha, Alpha::Opaque) << entry.name;
            ++seen;
        }
    }
    EXPECT_GE(seen, 25);
}

TEST(Holes, ClearWaterIsHalfSeenThrough) {
    const Alphas alphas = alphasOf(committed(entryNamed("water-clear")));
    EXPECT_GE(alphas.least, 160);
    EXPECT_LE(alphas.most, 200);
}

TEST(Holes, GlassLetsMoreThroughThanItKeeps) {
    const Image image = committed(entryNamed("glass-pane"));
    const auto clear = std::count_if(image.pixels.begin(), image.pixels.end(),
                                     [](Pixel pixel) { return toColour(pixel).a < 128; });
    EXPECT_GT(static_cast<double>(clear) / static_cast<double>(image.pixels.size()), 0.7);
}

// Levels of detail and enlarged pictures blend a hole with what is beside it.
TEST(Holes, TheColourOfAHoleIsAmongThoseBesideIt) {
    int holes = 0;
    for (const Entry& entry : catalogue()) {
        if (entry.alpha == Alpha::Opaque) {
            continue;
        }
        const Image image = frameOf(entry, 0);
        const int rows = image.height / entry.views;
        for (int y = 1; y + 1 < image.height; ++y) {
            if (y % rows == 0 || y % rows == rows - 1) {
                continue;
            }
            for (int x = 1; x + 1 < image.width; ++x) {
                const Colour own = toColour(image.at(x, y));
                std::array<int, 3> low = {255, 255, 255};
                std::array<int, 3> high = {0, 0, 0};
                bool beside = false;
                for (int near = 0; near < 9; ++near) {
                    const Colour colour = toColour(image.at(x + near % 3 - 1, y + near / 3 - 1));
                    if (colour.a == 0) {
                        continue;
                    }
                    beside = true;
                    const std::array<int, 3> channels = {colour.r, colour.g, colour.b};
                    for (std::size_t channel = 0; channel < 3; ++channel) {
                        low[channel] = std::min(low[channel], channels[channel]);
                        high[channel] = std::max(high[channel], channels[channel]);
                    }
                }
                if (own.a != 0 || !beside) {
                    continue;
                }
                ++holes;
                const std::array<int, 3> channels = {own.r, own.g, own.b};
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    ASSERT_GE(channels[channel], low[channel])
                        << entry.name << " at " << x << ", " << y;
                    ASSERT_LE(channels[channel], high[channel])
                        << entry.name << " at " << x << ", " << y;
                }
            }
        }
    }
    EXPECT_GT(holes, 10'000);
}

TEST(Holes, SpritesEndSoftlyAndInsideTheirPicture) {
    int sprites = 0;
    for (const Entry& entry : catalogue()) {
        if (entry.use != Use::Sprite) {
            continue;
        }
        ++sprites;
        for (int frame = 0; frame < entry.frames; ++frame) {
            const Image image = frameOf(entry, frame);
            const auto alphaAt = [&](int x, int y) { return toColour(image.at(x, y)).a; };
            for (int x = 0; x < image.width; ++x) {
                EXPECT_LT(alphaAt(x, 0), 255)
                    << entry.name << " frame " << frame << " is cut off above, column " << x;
            }
            for (int y = 0; y < image.height; ++y) {
                EXPECT_LT(alphaAt(0, y), 255)
                    << entry.name << " frame " << frame << " is cut off at the left, row " << y;
                EXPECT_LT(alphaAt(image.width - 1, y), 255)
                    << entry.name << " frame " << frame << " is cut off at the right, row " << y;
            }
        }
    }
    EXPECT_GE(sprites, 14);
}

TEST(Holes, WhatStandsStandsOnTheLowestRow) {
    for (const Entry& entry : catalogue()) {
        if (entry.use != Use::Sprite || !entry.stands) {
            continue;
        }
        for (int frame = 0; frame < entry.frames; ++frame) {
            const Image image = frameOf(entry, frame);
            int firm = 0;
            for (int x = 0; x < image.width; ++x) {
                firm += toColour(image.at(x, image.height - 1)).a > 128 ? 1 : 0;
            }
            EXPECT_GE(firm, 3) << entry.name << " frame " << frame;
        }
    }
}

}  // namespace
}  // namespace slicecast::textures
