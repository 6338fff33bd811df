#include "app/fit.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

void expectPlace(const SDL_Rect& place, int x, int y, int width, int height) {
    EXPECT_EQ(place.x, x);
    EXPECT_EQ(place.y, y);
    EXPECT_EQ(place.w, width);
    EXPECT_EQ(place.h, height);
}

TEST(FillWindow, ASmallWindowIsDrawnPixelForPixel) {
    const Fit fit = fillWindow({1280, 720});
    EXPECT_EQ(fit.picture, (Size{1280, 720}));
    expectPlace(fit.place, 0, 0, 1280, 720);
}

TEST(FillWindow, ALargeOneGetsWholePixelsAndIsCovered) {
    const Fit fit = fillWindow({2561, 1441});
    EXPECT_EQ(fit.picture, (Size{1281, 721}));
    expectPlace(fit.place, 0, 0, 2562, 1442);
}

TEST(FillWindow, AnyWindowIsCoveredBySquares) {
    for (const Size window : {Size{1, 1}, Size{7, 3}, Size{1366, 768}, Size{1920, 1080},
                              Size{3840, 2160}, Size{5120, 1440}, Size{1, 4000}}) {
        const Fit fit = fillWindow(window);
        EXPECT_LE(fit.picture.width * fit.picture.height, kSoftwarePixels);
        EXPECT_GE(fit.place.w, window.width);
        EXPECT_GE(fit.place.h, window.height);
        EXPECT_EQ(fit.place.w % fit.picture.width, 0);
        EXPECT_EQ(fit.place.w / fit.picture.width, fit.place.h / fit.picture.height);
        EXPECT_LT(fit.place.w - window.width, fit.place.w / fit.picture.width);
    }
}

TEST(Letterbox, EnlargesByAWholeNumberInTheMiddle) {
    expectPlace(letterbox({320, 200}, {1000, 700}).place, 20, 50, 960, 600);
    expectPlace(letterbox({320, 200}, {320, 200}).place, 0, 0, 320, 200);
}

TEST(Letterbox, ShrinksInProportion) {
    expectPlace(letterbox({640, 400}, {320, 300}).place, 0, 50, 320, 200);
    expectPlace(letterbox({640, 400}, {640, 200}).place, 160, 0, 320, 200);
    expectPlace(letterbox({4096, 1}, {100, 100}).place, 0, 49, 100, 1);
}

}  // namespace
}  // namespace slicecast
