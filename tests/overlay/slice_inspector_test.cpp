#include "overlay/slice_inspector.h"

#include "canvas.h"
#include "overlay/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace slicecast {
namespace {

using What = FilledRows::What;

constexpr int kWidth = 640;
constexpr int kHeight = 400;
constexpr double kHorizon = 200.0;
constexpr double kDistance = 300.0;  // pixels

Hit wall(double depth, double top, int first, int last) {
    Hit hit;
    hit.entered = true;
    hit.face = Face::west;
    hit.depth = depth;
    hit.backDepth = depth + 1.0;
    hit.top = toCoordinate(top);
    hit.topFrontRow = kHorizon - kDistance * (top - 0.5) / depth;
    hit.bottomFrontRow = kHorizon + kDistance * 0.5 / depth;
    if (last > first) hit.filled = {{What::side, Face::west, first, last}};
    return hit;
}

// Seen from 0.5 above the floor: ever higher walls two, four and eight units away, one behind the other.
SliceTrace stairs() {
    SliceTrace trace;
    trace.column = 200;
    trace.horizonRow = kHorizon;
    trace.projectionDistance = kDistance;
    trace.tiles = {{0, 0, 0, 0.0}, {0, 1, 0, 2.0}};
    const auto rowOf = [](double depth, double z) { return static_cast<int>(200.0 - kDistance * (z - 0.5) / depth); };
    trace.hits = {wall(2.0, 0.75, rowOf(2.0, 0.75), rowOf(2.0, 0.0)), wall(4.0, 2.0, rowOf(4.0, 2.0), rowOf(2.0, 0.75)),
                  wall(8.0, 4.5, rowOf(8.0, 4.5), rowOf(4.0, 2.0))};
    trace.planes = {{What::floor, Face::top, rowOf(2.0, 0.0), kHeight}, {What::sky, Face::top, 0, rowOf(8.0, 4.5)}};
    return trace;
}

World oneMap() {
    World world;
    world.maps.push_back(makeMap("map", 10, 10, 2, kNoTexture));
    return world;
}

const Eye kEye = {.map = 0, .x = toCoordinate(1.5), .y = toCoordinate(1.5), .z = toCoordinate(0.5)};

int apart(Colour a, Colour b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

TEST(SliceInspector, TheLineStandsInItsColumnAndTellsWhatFillsEachRow) {
    Canvas canvas(kWidth, kHeight);
    const SliceTrace trace = stairs();
    drawSliceLine(trace, canvas.picture);
    for (int y = 0; y < kHeight; ++y) {
        ASSERT_LT(apart(toColour(canvas.at(200, y)), {255, 255, 255, 255}), 130) << y;
        ASSERT_FALSE(canvas.touched(198, y));
        ASSERT_FALSE(canvas.touched(204, y));
    }
    // Where one thing ends and the next begins there is a dark row.
    const int floor = trace.planes[0].first;
    for (const int y : {60, 150, 210, floor - 2}) EXPECT_LT(apart(toColour(canvas.at(202, y)), kindColour(What::side)), 40) << y;
    for (const int y : {floor + 2, kHeight - 1}) EXPECT_LT(apart(toColour(canvas.at(202, y)), kindColour(What::floor)), 40) << y;
    EXPECT_LT(toColour(canvas.at(202, floor)).r, 60);
}

TEST(SliceInspector, TheStripeIsOnTheLeftOfTheLastColumns) {
    Canvas canvas(kWidth, kHeight);
    SliceTrace trace = stairs();
    trace.column = kWidth - 1;
    drawSliceLine(trace, canvas.picture);
    EXPECT_TRUE(canvas.borderUntouched());
    EXPECT_LT(apart(toColour(canvas.at(kWidth - 2, 100)), kindColour(What::side)), 160);
}

// The columns of the side view in which a strong upright line of a colour stands.
std::vector<int> uprights(const Canvas& canvas, Colour colour) {
    const PixelRect panel = layoutOverlays(kWidth, kHeight).sideView;
    std::vector<int> found;
    for (int x = panel.x; x < panel.x + panel.width; ++x) {
        int longest = 0;
        int run = 0;
        for (int y = panel.y; y < panel.y + panel.height; ++y) {
            run = apart(toColour(canvas.at(x, y)), colour) < 120 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
        if (longest >= 12 && (found.empty() || x > found.back() + 3)) found.push_back(x);
    }
    return found;
}

TEST(SliceInspector, TheSideViewShowsFacesAtTheirDepths) {
    Canvas canvas(kWidth, kHeight);
    drawSideView(stairs(), oneMap(), kEye, canvas.picture);
    const std::vector<int> walls = uprights(canvas, kindColour(What::side));
    ASSERT_EQ(walls.size(), 3u);
    EXPECT_NEAR(walls[2] - walls[1], 2 * (walls[1] - walls[0]), 3) << "8 - 4 is twice 4 - 2";
}

TEST(SliceInspector, TheSideViewStaysInItsPanel) {
    Canvas canvas(kWidth, kHeight);
    SliceTrace trace = stairs();
    trace.hits[2].backDepth = 1e300;
    trace.planes.push_back({What::sky, Face::top, -4000, 0});
    drawSideView(trace, oneMap(), kEye, canvas.picture);
    const PixelRect panel = layoutOverlays(kWidth, kHeight).sideView;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool inside = x >= panel.x && y >= panel.y && x < panel.x + panel.width && y < panel.y + panel.height;
            ASSERT_TRUE(inside || !canvas.touched(x, y)) << x << ", " << y;
        }
    }
}

TEST(SliceInspector, WhatIsNotSeenIsDimmer) {
    const auto greyAt = [](bool seen) {
        Canvas canvas(kWidth, kHeight);
        SliceTrace trace = stairs();
        trace.hits.insert(trace.hits.begin(), wall(5.5, 1.0, 0, seen ? 1 : 0));
        trace.hits[0].backDepth = 6.5;
        drawSideView(trace, oneMap(), kEye, canvas.picture);
        const std::vector<int> walls = uprights(canvas, kindColour(What::side));
        // Depth 6.3, height 0.2: from the walls at 4 and 8
        const int x = walls[1] + (walls.back() - walls[1]) * 23 / 40;
        const PixelRect panel = layoutOverlays(kWidth, kHeight).sideView;
        const Colour colour = toColour(canvas.at(x, panel.y + panel.height - 20));
        return colour.r + colour.g + colour.b;
    };
    EXPECT_GT(greyAt(true), greyAt(false) + 60);
}

TEST(SliceInspector, NothingIsDrawnWhereThereIsNoRoomOrNoMap) {
    Canvas small(100, 70);
    drawSideView(stairs(), oneMap(), kEye, small.picture);
    EXPECT_EQ(small.touchedPixels(), 0);
    Canvas canvas(kWidth, kHeight);
    Eye elsewhere = kEye;
    elsewhere.map = 1;
    drawSideView(stairs(), oneMap(), elsewhere, canvas.picture);
    EXPECT_EQ(canvas.touchedPixels(), 0);
}

}  // namespace
}  // namespace slicecast
