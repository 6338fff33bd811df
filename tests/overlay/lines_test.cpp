#include "overlay/lines.h"

#include "canvas.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

constexpr Colour kWhite = {255, 255, 255, 255};
constexpr PixelRect kAll = {0, 0, 40, 30};

TEST(Lines, HorizontalAndVerticalOnesFillWholePixels) {
    Canvas canvas(40, 30);
    drawLine(canvas.picture, kAll, {5.0, 10.5}, {15.0, 10.5}, kWhite);
    for (int x = 5; x < 15; ++x) EXPECT_EQ(toColour(canvas.at(x, 10)), kWhite) << x;
    EXPECT_FALSE(canvas.touched(4, 10));
    EXPECT_FALSE(canvas.touched(7, 9));
    EXPECT_FALSE(canvas.touched(7, 11));
    drawLine(canvas.picture, kAll, {30.5, 20.0}, {30.5, 3.0}, kWhite);
    for (int y = 3; y < 20; ++y) EXPECT_EQ(toColour(canvas.at(30, y)), kWhite) << y;
    EXPECT_FALSE(canvas.touched(29, 10));
}

TEST(Lines, SlantedOnesShareTheirColourBetweenTwoPixels) {
    Canvas canvas(40, 30);
    for (Pixel& pixel : canvas.image.pixels) pixel = toPixel({0, 0, 0, 255});
    drawLine(canvas.picture, kAll, {2.0, 4.0}, {34.0, 20.0}, kWhite);
    for (int x = 2; x < 34; ++x) {
        int sum = 0;
        double middle = 0.0;
        for (int y = 0; y < 30; ++y) {
            sum += toColour(canvas.at(x, y)).r;
            middle += toColour(canvas.at(x, y)).r * (y + 0.5);
        }
        EXPECT_NEAR(sum, 255, 1);
        EXPECT_NEAR(middle / sum, 4.0 + (x + 0.5 - 2.0) / 2.0, 0.01);
    }
}

TEST(Lines, HaveTheGivenWidth) {
    for (int width = 1; width <= 4; ++width) {
        Canvas canvas(40, 30);
        for (Pixel& pixel : canvas.image.pixels) pixel = toPixel({0, 0, 0, 255});
        drawLine(canvas.picture, kAll, {2.0, 4.0}, {34.0, 20.0}, kWhite, width);
        drawRing(canvas.picture, kAll, {8.5, 22.5}, 5.0, kWhite, width);
        for (int x = 18; x < 34; ++x) {
            int sum = 0;
            double middle = 0.0;
            for (int y = 0; y < 30; ++y) {
                sum += toColour(canvas.at(x, y)).r;
                middle += toColour(canvas.at(x, y)).r * (y + 0.5);
            }
            EXPECT_NEAR(sum, 255 * width, 1);
            EXPECT_NEAR(middle / sum, 4.0 + (x + 0.5 - 2.0) / 2.0, 0.01);
        }
        int ring = 0;
        for (int y = 23; y < 30; ++y) ring += toColour(canvas.at(8, y)).r;
        EXPECT_NEAR(ring, 255 * width, 1);
    }
}

TEST(Lines, AreClipped) {
    Canvas canvas(40, 30);
    const PixelRect inside = {10, 8, 20, 12};
    for (double end = -1e9; end <= 1e9; end += 1.7e8) {
        drawLine(canvas.picture, inside, {20.0, 15.0}, {end, 15.0 - 0.3 * end}, kWhite);
        drawLine(canvas.picture, inside, {end, 3.0}, {20.0, 1e7}, kWhite);
    }
    drawDot(canvas.picture, inside, {10.0, 8.0}, 9.0, kWhite);
    drawRing(canvas.picture, inside, {30.0, 20.0}, 300.0, kWhite);
    EXPECT_GT(canvas.touchedPixels(), 30);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            ASSERT_TRUE((x >= 10 && x < 30 && y >= 8 && y < 20) || !canvas.touched(x, y))
                << x << ", " << y;
        }
    }
}

TEST(Lines, DotsAndRingsAreRound) {
    Canvas dot(40, 30);
    Canvas ring(40, 30);
    drawDot(dot.picture, kAll, {20.5, 15.5}, 6.0, kWhite);
    drawRing(ring.picture, kAll, {20.5, 15.5}, 6.0, kWhite);
    EXPECT_NEAR(dot.touchedPixels(), 3.14 * 6.5 * 6.5, 12);
    EXPECT_TRUE(dot.touched(20, 15));
    EXPECT_FALSE(ring.touched(20, 15));
    for (const Canvas* canvas : {&dot, &ring}) {
        EXPECT_TRUE(canvas->touched(26, 15));
        EXPECT_TRUE(canvas->touched(20, 9));
        EXPECT_FALSE(canvas->touched(28, 15));
        EXPECT_FALSE(canvas->touched(26, 21));
    }
}

}  // namespace
}  // namespace slicecast
