#include "world/texture.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Texture, LevelsHalveDownToOneTexel) {
    const Texture texture = makeTexture("t", Image(64, 64));
    ASSERT_EQ(texture.levels.size(), 7u);
    for (int m = 0; m < 7; ++m) {
        EXPECT_EQ(texture.levels[static_cast<std::size_t>(m)].size, 64 >> m);
        EXPECT_EQ(1 << texture.levels[static_cast<std::size_t>(m)].bits, 64 >> m);
    }
}

TEST(Texture, TexelsAreStoredColumnAfterColumn) {
    Image image(8, 8);
    image.at(5, 2) = toPixel({1, 2, 3, 255});
    const Texture texture = makeTexture("t", image);
    EXPECT_EQ(texture.levels[0].texels[5 * 8 + 2], image.at(5, 2));
}

// Four texels become one, by hand: opaque ones are averaged with halves rounded down after the half
// that is added first.
TEST(Texture, OpaqueTexelsAreAveraged) {
    Image image(8, 8);
    for (Pixel& pixel : image.pixels) pixel = toPixel({0, 0, 0, 255});
    image.at(0, 0) = toPixel({10, 255, 1, 255});
    image.at(1, 0) = toPixel({20, 255, 0, 255});
    image.at(0, 1) = toPixel({30, 255, 0, 255});
    image.at(1, 1) = toPixel({41, 255, 1, 255});
    const Colour mean = toColour(makeTexture("t", image).levels[1].texels[0]);
    EXPECT_EQ(mean, (Colour{25, 255, 1,
                            255}));  // (101 * 255 + 510) / 1020 = 25.75; (2 * 255 + 510) / 1020 = 1
}

TEST(Texture, HolesDoNotDarkenTheirNeighbours) {
    Image image(8, 8);
    for (Pixel& pixel : image.pixels) pixel = toPixel({0, 0, 0, 0});
    image.at(0, 0) = toPixel({200, 100, 50, 255});
    const Texture texture = makeTexture("t", image);
    EXPECT_EQ(toColour(texture.levels[1].texels[0]), (Colour{200, 100, 50, 64}));  // (255 + 2) / 4
    EXPECT_EQ(toColour(texture.levels[1].texels[1]), (Colour{0, 0, 0, 0}));
}

TEST(Texture, ASheetsFramesRepeat) {
    Image sheet(24, 8);
    for (int frame = 0; frame < 3; ++frame)
        sheet.at(8 * frame + 2, 5) = toPixel({static_cast<std::uint8_t>(frame + 1), 0, 0, 255});
    const Texture texture = makeTexture("t", sheet, 3, 4.0);
    EXPECT_EQ(texture.size(), 8);
    EXPECT_EQ(texture.frames(), 3);
    for (int frame = 0; frame < 3; ++frame)
        EXPECT_EQ(toColour(texture.levelsOf(frame)[0].texels[2 * 8 + 5]).r, frame + 1);
    EXPECT_EQ(texture.frameAt(0), 0);
    EXPECT_EQ(texture.frameAt(29), 0);
    EXPECT_EQ(texture.frameAt(30), 1);
    EXPECT_EQ(texture.frameAt(90), 0);
    EXPECT_EQ(texture.frameAt(120'000'000'000), 1);  // 4e9 = 3 * 1333333333 + 1
    EXPECT_EQ(texture.frameAt(-120), 0);
}

// In seconds, 613 of the first 14,400 steps would come before their time.
TEST(Texture, AFrameComesWithItsStep) {
    constexpr int kFrames = 64;
    for (int step = 0; step < 14'400; ++step) {
        ASSERT_EQ(frameAt(step, 120.0, kFrames), step % kFrames);
        ASSERT_EQ(frameAt(step, 60.0, kFrames), step / 2 % kFrames);
        ASSERT_EQ(frameAt(step, 7.0, kFrames), step * 7 / 120 % kFrames);
        ASSERT_EQ(frameAt(step, 2.5, kFrames), step * 5 / 240 % kFrames);
        ASSERT_EQ(frameAt(step, 0.3, kFrames), step * 3 / 1200 % kFrames) << step;
    }
}

TEST(Texture, KnowsWhetherItIsSeeThrough) {
    Image image(8, 8);
    for (Pixel& pixel : image.pixels) pixel = toPixel({9, 9, 9, 255});
    EXPECT_FALSE(makeTexture("t", image).seeThrough);
    image.at(7, 7) = toPixel({9, 9, 9, 254});
    EXPECT_TRUE(makeTexture("t", image).seeThrough);
    // Of a sheet all frames count.
    Image sheet(16, 8);
    for (Pixel& pixel : sheet.pixels) pixel = toPixel({0, 0, 0, 255});
    EXPECT_FALSE(makeTexture("t", sheet, 2, 1.0).seeThrough);
    sheet.at(12, 3) = toPixel({0, 0, 0, 254});
    EXPECT_TRUE(makeTexture("t", sheet, 2, 1.0).seeThrough);
}

}  // namespace
}  // namespace slicecast
