#include "overlay/blend.h"

#include "canvas.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Blend, RoundsToTheNearestByte) {
    const Pixel grey = toPixel({100, 100, 100, 255});
    EXPECT_EQ(blended(grey, {200, 0, 50, 0}), grey);
    EXPECT_EQ(blended(grey, {200, 0, 50, 255}), toPixel({200, 0, 50, 255}));
    EXPECT_EQ(blended(grey, {200, 0, 50, 128}), toPixel({150, 50, 75, 255}));
    EXPECT_EQ(blended(toPixel({0, 0, 0, 255}), {255, 255, 255, 1}), toPixel({1, 1, 1, 255}));
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
