#include "overlay/pixel_grid.h"

#include "canvas.h"
#include "overlay/layout.h"

#include <gtest/gtest.h>

#include <utility>

namespace slicecast {
namespace {

TEST(PixelGrid, HasFineLinesEveryTenPixelsAndStrongOnesEveryHundred) {
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

// In large pictures, too, the numbers do not cover each other: after each there is something of the
// picture before the next.
TEST(PixelGrid, NumbersFitAndStrongLinesAreVisible) {
    for (const auto& [width, height] : {std::pair{1280, 720}, {2560, 1440}, {3840, 2160}}) {
        Canvas canvas(width, height);
        for (Pixel& pixel : canvas.image.pixels) pixel = toPixel({100, 100, 100, 255});
        drawPixelGrid(canvas.picture);
        const int scale = readableScale(width, height);
        const int row =
            height / 2 / 100 * 100 + 2 + 10 * scale;  // below the digits on their plates
        int plates = 0;
        int free = 0;
        for (int x = 1; x < width; ++x) {
            const bool isPlate = toColour(canvas.at(x, row)).r < 60;
            const bool wasPlate = toColour(canvas.at(x - 1, row)).r < 60;
            plates += isPlate && !wasPlate;
            free += !isPlate;
        }
        EXPECT_GE(plates, 12) << width;
        EXPECT_GT(free, width / 6) << width;
        int clear = 0;
        for (int x = 95; x < 106; ++x) clear += toColour(canvas.at(x, 57)).r > 180;
        EXPECT_EQ(clear, width / 1280) << "pixels of a clear line";
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
