#include "overlay/pixel_grid.h"

#include "canvas.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(PixelGrid, HasFineLinesEveryTenPixelsAndClearOnesEveryHundred) {
    Canvas canvas(640, 400);
    for (Pixel& pixel : canvas.image.pixels) pixel = toPixel({100, 100, 100, 255});
    drawPixelGrid(canvas.picture);
    const int row = 57;  // beside the numbers
    for (int x = 1; x < 640; ++x) {
        const int red = toColour(canvas.at(x, row)).r;
        if (x % 100 == 0) {
            EXPECT_GT(red, 180) << x;
        } else if (x % 10 == 0) {
            EXPECT_TRUE(red > 104 && red < 130) << x;
        } else {
            EXPECT_LE(red, 100) << x;
        }
    }
    for (int y = 1; y < 400; ++y) {
        const int red = toColour(canvas.at(57, y)).r;
        EXPECT_EQ(red > 180, y % 100 == 0) << y;
        EXPECT_EQ(red > 104, y % 10 == 0) << y;
    }
}

TEST(PixelGrid, StaysInThePicture) {
    for (int side = 1; side < 230; side += 7) {
        Canvas canvas(side, 230 - side);
        drawPixelGrid(canvas.picture);
        EXPECT_TRUE(canvas.borderUntouched());
    }
}

}  // namespace
}  // namespace slicecast
