#include "overlay/blend.h"

#include "canvas.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace slicecast {
namespace {

TEST(Blend, RoundsToTheNearestByte) {
    const Pixel grey = toPixel({100, 100, 100, 255});
    EXPECT_EQ(blended(grey, {200, 0, 50, 0}), grey);
    EXPECT_EQ(blended(grey, {200, 0, 50, 255}), toPixel({200, 0, 50, 255}));
    EXPECT_EQ(blended(grey, {200, 0, 50, 128}), toPixel({150, 50, 75, 255}));
    EXPECT_EQ(blended(toPixel({0, 0, 0, 255}), {255, 255, 255, 1}), toPixel({1, 1, 1, 255}));
}

// (over * a + under * (255 - a) + 127) / 255 in each channel, whatever the number of pixels.
TEST(Blend, RowsEqualTheirPixels) {
    const auto channel = [](unsigned under, unsigned over, unsigned a) {
        return static_cast<std::uint8_t>((over * a + under * (255 - a) + 127) / 255);
    };
    for (unsigned a = 0; a < 256; ++a) {
        for (unsigned over = 0; over < 256; over += 5) {
            std::vector<Pixel> under;
            std::vector<Pixel> expected;
            const auto byte = static_cast<std::uint8_t>(over);
            const Colour colour = {byte, static_cast<std::uint8_t>(255 - byte), 77,
                                   static_cast<std::uint8_t>(a)};
            for (unsigned i = 0; i < 256; ++i) {
                const auto grey = static_cast<std::uint8_t>(i);
                under.push_back(toPixel({grey, grey, static_cast<std::uint8_t>(255 - i), 255}));
                expected.push_back(toPixel({channel(i, colour.r, a), channel(i, colour.g, a),
                                            channel(255 - i, colour.b, a), 255}));
            }
            std::vector<Pixel> one = under;
            blendRow(one.data(), 255, colour);
            EXPECT_EQ(one.back(), under.back());
            one.back() = blended(one.back(), colour);
            ASSERT_EQ(one, expected) << a << ", " << over;
            const std::vector<Pixel> many(256, toPixel(colour));
            blendRow(under.data(), 2, many.data());
            blendRow(under.data() + 2, 254, many.data());
            ASSERT_EQ(under, expected) << a << ", " << over;
        }
    }
}

TEST(Blend, RectanglesAreClippedToThePicture) {
    Canvas canvas(10, 8);
    blendRect(canvas.picture, {-5, -5, 7, 8}, {255, 255, 255, 255});
    EXPECT_EQ(canvas.touchedPixels(), 2 * 3);
    blendRect(canvas.picture, {8, 6, 100, 100}, {255, 255, 255, 255});
    EXPECT_EQ(canvas.touchedPixels(), 2 * 3 + 2 * 2);
    blendRect(canvas.picture, {3, 3, -2, 5}, {255, 255, 255, 255});
    blendPixel(canvas.picture, -1, 0, {255, 255, 255, 255});
    blendPixel(canvas.picture, 10, 7, {255, 255, 255, 255});
    drawPanel(canvas.picture, {-2, -2, 2, 2});
    EXPECT_EQ(canvas.touchedPixels(), 2 * 3 + 2 * 2);
    drawPanel(canvas.picture, {-2, -2, 40, 40});
    EXPECT_TRUE(canvas.borderUntouched());
}

}  // namespace
}  // namespace slicecast
