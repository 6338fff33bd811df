// How rays were aimed, and how they looked for walls: what each old way shows wrongly.
#include "classic_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace slicecast::known {
namespace {

// With the notes' step, a thousandth, the defect is hard to see; coarse steps spoil the picture.
TEST(Classic, MarchingIsAsGoodAsItsStep) {
    const auto different = [](double step) {
        int pixels = 0;
        for (std::uint64_t i = 0; i < 8; ++i) {
            const World world = mixedWorld(i);
            const Eye eye = eyeAt(-2.0, 4.3, 2.6, -10.0);
            const Image exact = drawOld(world, eye, 160, 100, {}).image;
            const Image marched =
                drawOld(world, eye, 160, 100, {.march = true, .stepSize = step}).image;
            for (std::size_t p = 0; p < exact.pixels.size(); ++p)
                pixels += exact.pixels[p] != marched.pixels[p] ? 1 : 0;
        }
        return pixels / (8 * 160.0 * 100.0);
    };
    EXPECT_LT(different(0.001), 0.03);
    EXPECT_GT(different(0.2), 0.2);
}

TEST(Classic, MarchingFindsWallsTooLateAndRagged) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(8.1, 20.5, 0.5, 0.0);
    const RenderOptions options = {.fovDegrees = 90.0};
    const Image exact = drawOld(world, eye, 200, 200, {}, options).image;
    const Image fine =
        drawOld(world, eye, 200, 200, {.march = true, .stepSize = 0.001}, options).image;
    const Image coarse =
        drawOld(world, eye, 200, 200, {.march = true, .stepSize = 0.4}, options).image;
    int turns = 0;  // of the coarse wall's upper edge
    int way = 0;
    for (int x = 0; x < 200; ++x) {
        ASSERT_EQ(firstRow(exact, x, kWhite), firstRow(exact, 0, kWhite));
        EXPECT_LE(firstRow(fine, x, kWhite) - firstRow(exact, x, kWhite), 1);
        EXPECT_GE(firstRow(coarse, x, kWhite), firstRow(exact, x, kWhite))
            << "never nearer than it is";
        const int step = x > 0 ? firstRow(coarse, x, kWhite) - firstRow(coarse, x - 1, kWhite) : 0;
        if (step != 0 && (step > 0) != (way > 0)) ++turns;
        if (step != 0) way = step;
    }
    EXPECT_GT(turns, 4) << "a saw's edge";
    EXPECT_LT(count(coarse, kWhite), count(exact, kWhite) * 95 / 100);
}

TEST(Classic, MarchingMissesThinCornersAndEnds) {
    // A lone block whose corner is all that some columns meet.
    World world = emptyWorld(60, 9, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, plain("wall", kWhite)));
    world.maps[0].setCell(5, 4, 0, block);
    const Eye eye = eyeAt(1.3, 1.2, 0.5, 40.0);
    const auto columnsWithWall = [&](const ClassicOptions& classic) {
        const Image image = drawOld(world, eye, 400, 20, classic).image;
        int columns = 0;
        for (int x = 0; x < 400; ++x) columns += firstRow(image, x, kWhite) < 20 ? 1 : 0;
        return columns;
    };
    const int exact = columnsWithWall({});
    EXPECT_GT(exact, 50);
    EXPECT_LE(std::abs(columnsWithWall({.march = true, .stepSize = 0.001}) - exact), 1);
    EXPECT_LT(columnsWithWall({.march = true, .stepSize = 0.5}), exact - 3);
    EXPECT_EQ(columnsWithWall({.march = true, .stepSize = 0.001, .reach = 3.0}), 0)
        << "it gives up before the block";

    // The walk looks at as many places as there are tiles, the march at one every step.
    EXPECT_LT(drawOld(world, eye, 10, 10, {}).report.tilesWalked, 10 * 70);
    EXPECT_GT(drawOld(world, eye, 10, 10, {.march = true}).report.tilesWalked, 10 * 1000);
}

// A wall that is faced: its upper edge is a straight line, but at the distance along the ray it
// sinks to both sides.
TEST(Classic, EqualAnglesAloneAreAFishEye) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(8.0, 20.5, 0.5, 0.0);
    const RenderOptions options = {.fovDegrees = 90.0};
    const auto edge = [&](ClassicProjection projection, int column) {
        return firstRow(drawOld(world, eye, 200, 200, {.projection = projection}, options).image,
                        column, kWhite);
    };
    for (const int column : {0, 50, 100, 150, 199}) {
        EXPECT_EQ(edge(ClassicProjection::plane, column), 75) << column;  // 100 - 0.5 * 100 / 2
        EXPECT_EQ(edge(ClassicProjection::equalAnglesCorrected, column), 75) << column;
    }
    // At 45 degrees the way to the wall is longer by the square root of two: 100 - 25 / 1.414
    // = 82.3; at 22.5 degrees 100 - 25 * 0.924 = 76.9.
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 100), 75);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 50), 77);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 150), 77);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 0), 82);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 199), 82);
}

TEST(Classic, EqualAnglesBendSlantingWallsEvenWithTheCosine) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(9.0, 20.5, 0.5, 35.0);
    const RenderOptions options = {.fovDegrees = 90.0};
    const auto bend = [&](ClassicProjection projection) {
        const Image image =
            drawOld(world, eye, 800, 800, {.projection = projection}, options).image;
        // How far the upper edge lies off the straight line between its ends.
        const int left = firstRow(image, 40, kWhite);
        const int right = firstRow(image, 760, kWhite);
        int furthest = 0;
        for (int x = 40; x <= 760; ++x) {
            furthest = std::max(furthest, std::abs(firstRow(image, x, kWhite) * 720 -
                                                   (left * (760 - x) + right * (x - 40))) /
                                              720);
        }
        return furthest;
    };
    EXPECT_LE(bend(ClassicProjection::plane), 1);
    EXPECT_GE(bend(ClassicProjection::equalAnglesCorrected), 6);
}

TEST(Classic, EqualAnglesMakeTexturesUnevenlyWide) {
    const World world = wallWorld(sides("wall", kWhite, kGreen));
    const Eye eye = eyeAt(8.0, 20.5, 0.5, 0.0);
    const auto widths = [&](ClassicProjection projection) {
        const Image image =
            drawOld(world, eye, 400, 20, {.projection = projection}, {.fovDegrees = 90.0}).image;
        std::vector<int> runs = {1};
        for (int x = 1; x < 400; ++x) {
            if (image.at(x, 10) == image.at(x - 1, 10))
                ++runs.back();
            else
                runs.push_back(1);
        }
        return runs;
    };
    // Half a unit at depth 2 with d = 200: 50 pixels everywhere. At equal angles it is 400 / 90 *
    // atan(1 / 4) = 62.4 in the middle, 400 / 90 * (45 - atan(3 / 4)) = 36.1 at the border.
    EXPECT_EQ(widths(ClassicProjection::plane), std::vector<int>(8, 50));
    const std::vector<int> uneven = widths(ClassicProjection::equalAnglesCorrected);
    ASSERT_EQ(uneven.size(), 8u);
    EXPECT_NEAR(uneven[3], 62, 1);
    EXPECT_NEAR(uneven[4], 62, 1);
    EXPECT_NEAR(uneven[0], 36, 1);
    EXPECT_NEAR(uneven[7], 36, 1);
}

TEST(Classic, CoarseSineTablesMakeColumnsAndTurnsJump) {
    const World world = wallWorld(squares("wall", 40));
    const RenderOptions options = {.fovDegrees = 60.0};
    const auto differentColumns = [&](int steps) {
        const Image image =
            drawOld(world, eyeAt(7.3, 20.4, 0.5, 20.0), 480, 60,
                    {.projection = ClassicProjection::equalAnglesCorrected, .sineSteps = steps},
                    options)
                .image;
        int different = 1;
        for (int x = 1; x < 480; ++x) different += columnsAreEqual(image, x - 1, x) ? 0 : 1;
        return different;
    };
    // A step of a degree is 8 columns; all that lies within one looks the same way.
    EXPECT_LE(differentColumns(360), 61);
    EXPECT_GT(differentColumns(360), 20);
    EXPECT_GT(differentColumns(360'000), differentColumns(360));
    EXPECT_EQ(differentColumns(360'000), differentColumns(0))
        << "the notes' finer table was fine enough for this";

    const auto turned = [&](double heading, int steps) {
        return drawOld(world, eyeAt(7.3, 20.4, 0.5, heading), 120, 60, {.sineSteps = steps},
                       options)
            .image.pixels;
    };
    EXPECT_EQ(turned(20.0, 360), turned(20.9, 360));
    EXPECT_NE(turned(20.0, 360), turned(21.0, 360));
    EXPECT_NE(turned(20.0, 0), turned(20.9, 0));
}

}  // namespace
}  // namespace slicecast::known
