// From the world to the screen, by figures worked out by hand.
#include "render/view/projection.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicecast {
namespace {

// At a field of view of 90 degrees the projection plane is half a picture's width away.
Projection projected(int width, int height, double look = 0.0, double heading = 0.0) {
    const Eye eye = {.x = {}, .y = {}, .z = tileEdge(1), .headingDegrees = heading, .look = look};
    return {eye, {.fovDegrees = 90.0}, width, height};
}

TEST(Projection, DistanceAndHorizon) {
    const Projection level = projected(200, 120);
    EXPECT_EQ(level.distance, 100.0);
    EXPECT_EQ(level.horizon, 60.0);
    EXPECT_EQ(level.horizonBelow, 60.5);
    EXPECT_EQ(level.heightBelow, 120.5);
    EXPECT_EQ(projected(201, 120).distance, 100.5);
    EXPECT_EQ(projected(200, 121).horizon, 60.5);
    EXPECT_EQ(projected(200, 120, 0.25).horizon, 90.0) << "up: the horizon lies lower";
    EXPECT_EQ(projected(200, 120, -0.25).horizon, 30.0);
    const Projection wide({.x = {}, .y = {}, .z = tileEdge(1)}, {.fovDegrees = 120.0}, 200, 120);
    EXPECT_NEAR(wide.distance, 100.0 / 1.7320508075688772, 1e-12);
}

TEST(Projection, Slopes) {
    const Projection projection = projected(200, 120);
    EXPECT_EQ(projection.sidewaysSlope(0), -0.995);
    EXPECT_EQ(projection.sidewaysSlope(99), -0.005);
    EXPECT_EQ(projection.sidewaysSlope(100), 0.005);
    EXPECT_EQ(projection.upwardSlope(0), 0.595);
    EXPECT_EQ(projection.upwardSlope(59), 0.005);
    EXPECT_EQ(projection.upwardSlope(60), -0.005);
}

// forward * 100 + right * (column + 0.5 - 100), with right clockwise from forward.
TEST(Projection, RaysOfColumns) {
    const auto ray = [](double heading, int column) {
        return projected(200, 120, 0.0, heading).ray(column);
    };
    const auto expectRay = [&](double heading, double x, double y) {
        EXPECT_EQ(ray(heading, 149).x, x) << heading;
        EXPECT_EQ(ray(heading, 149).y, y) << heading;
    };
    expectRay(0.0, 100.0, 49.5);
    expectRay(90.0, -49.5, 100.0);
    expectRay(180.0, -100.0, -49.5);
    expectRay(270.0, 49.5, -100.0);
    EXPECT_EQ(ray(0.0, 50).y, -49.5) << "left of the middle is north of east";
}

// 60 - 100 * rise / depth.
TEST(Projection, RowsOfHeights) {
    const Projection projection = projected(200, 120);
    EXPECT_EQ(projection.rowOf(0.5, 2.0), 35.0);
    EXPECT_EQ(projection.rowOf(-0.5, 2.0), 85.0);
    EXPECT_EQ(projection.rowOf(-1.0, 8.0), 72.5);
    EXPECT_EQ(projection.rowOf(0.0, 8.0), 60.0);
    EXPECT_EQ(projection.rowOf(1.0, 0.0), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(projection.rowOf(-1.0, 0.0), std::numeric_limits<double>::infinity());
}

// Row r's centre is r + 0.5: the first one below 2.4 is row 2's, the first below 2.6 row 3's, and
// 2.5 is row 2's own.
TEST(Projection, TheFirstRowBelowARow) {
    const Projection projection = projected(200, 120);
    EXPECT_EQ(projection.firstRowBelowRow(2.4, false), 2);
    EXPECT_EQ(projection.firstRowBelowRow(2.4, true), 2);
    EXPECT_EQ(projection.firstRowBelowRow(2.6, true), 3);
    EXPECT_EQ(projection.firstRowBelowRow(2.5, true), 2);
    EXPECT_EQ(projection.firstRowBelowRow(2.5, false), 3);
    EXPECT_EQ(projection.firstRowBelowRow(0.5, true), 0);
    EXPECT_EQ(projection.firstRowBelowRow(0.5, false), 1);
    EXPECT_EQ(projection.firstRowBelowRow(119.5, true), 119);
    EXPECT_EQ(projection.firstRowBelowRow(119.5, false), 120);
}

TEST(Projection, RowsOutsideThePicture) {
    const Projection projection = projected(200, 120);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const bool tie : {false, true}) {
        EXPECT_EQ(projection.firstRowBelowRow(0.0, tie), 0);
        EXPECT_EQ(projection.firstRowBelowRow(-7.5, tie), 0);
        EXPECT_EQ(projection.firstRowBelowRow(-kInfinity, tie), 0);
        EXPECT_EQ(projection.firstRowBelowRow(120.0, tie), 120);
        EXPECT_EQ(projection.firstRowBelowRow(1e300, tie), 120);
        EXPECT_EQ(projection.firstRowBelowRow(kInfinity, tie), 120);
    }
}

// The row of the horizon itself looks level, not down.
TEST(Projection, TheFirstFallingRow) {
    EXPECT_EQ(projected(200, 120).firstFallingRow, 60);
    EXPECT_EQ(projected(200, 121).firstFallingRow, 61) << "row 60 is level";
    EXPECT_EQ(projected(200, 120, 1.0).firstFallingRow, 120) << "none looks down";
    EXPECT_EQ(projected(200, 120, -1.0).firstFallingRow, 0) << "all look down";
}

TEST(Projection, Mirrored) {
    for (const int height : {120, 121}) {
        for (const double look : {0.0, 0.25, -0.25, 0.75, -3.0}) {
            const Projection upright = projected(200, height, look);
            const Projection upsideDown = upright.mirrored();
            EXPECT_EQ(upsideDown.horizon, height - upright.horizon);
            EXPECT_EQ(upsideDown.distance, upright.distance);
            int falling = 0;
            for (int row = 0; row < height; ++row) {
                EXPECT_EQ(upsideDown.upwardSlope(row), -upright.upwardSlope(height - 1 - row));
                falling += upsideDown.upwardSlope(row) < 0.0;
            }
            EXPECT_EQ(upsideDown.firstFallingRow, height - falling);
            EXPECT_EQ(upsideDown.ray(3).x, upright.ray(3).x);
            EXPECT_EQ(upsideDown.mirrored().horizon, upright.horizon);
        }
    }
}

}  // namespace
}  // namespace slicecast
