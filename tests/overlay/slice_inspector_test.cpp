#include "overlay/slice_inspector.h"

#include "canvas.h"
#include "overlay/beyond_portals.h"
#include "overlay/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace slicecast {
namespace {

using What = FilledRows::What;

constexpr int kInspectedWidth = 640;
constexpr int kInspectedHeight = 400;
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

// Seen from 0.5 above the floor: ever higher walls two, four and eight units away, one behind the
// other.
SliceTrace stairs() {
    SliceTrace trace;
    trace.column = 200;
    trace.horizonRow = kHorizon;
    trace.projectionDistance = kDistance;
    trace.tiles = {{0, 0, 0, 0.0}, {0, 1, 0, 2.0}};
    const auto rowOf = [](double depth, double z) {
        return static_cast<int>(200.0 - kDistance * (z - 0.5) / depth);
    };
    trace.hits = {wall(2.0, 0.75, rowOf(2.0, 0.75), rowOf(2.0, 0.0)),
                  wall(4.0, 2.0, rowOf(4.0, 2.0), rowOf(2.0, 0.75)),
                  wall(8.0, 4.5, rowOf(8.0, 4.5), rowOf(4.0, 2.0))};
    trace.planes = {{What::floor, Face::top, rowOf(2.0, 0.0), kInspectedHeight},
                    {What::sky, Face::top, 0, rowOf(8.0, 4.5)}};
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

TEST(SliceInspector, TheLineIsInItsColumnAndShowsWhatFillsEachRow) {
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    const SliceTrace trace = stairs();
    drawSliceLine(trace, canvas.picture);
    for (int y = 0; y < kInspectedHeight; ++y) {
        ASSERT_LT(apart(toColour(canvas.at(200, y)), {255, 255, 255, 255}), 130) << y;
        ASSERT_FALSE(canvas.touched(198, y));
        ASSERT_FALSE(canvas.touched(204, y));
    }
    // Where one thing ends and the next begins there is a dark row.
    const int floor = trace.planes[0].first;
    for (const int y : {60, 150, 210, floor - 2})
        EXPECT_LT(apart(toColour(canvas.at(202, y)), kindColour(What::side)), 40) << y;
    for (const int y : {floor + 2, kInspectedHeight - 1})
        EXPECT_LT(apart(toColour(canvas.at(202, y)), kindColour(What::floor)), 40) << y;
    EXPECT_LT(toColour(canvas.at(202, floor)).r, 60);
}

TEST(SliceInspector, TheStripeIsOnTheLeftOfTheLastColumns) {
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    SliceTrace trace = stairs();
    trace.column = kInspectedWidth - 1;
    drawSliceLine(trace, canvas.picture);
    EXPECT_TRUE(canvas.borderUntouched());
    EXPECT_LT(apart(toColour(canvas.at(kInspectedWidth - 2, 100)), kindColour(What::side)), 160);
}

// The columns of the side view in which a strong upright line of a colour stands.
std::vector<int> uprights(const Canvas& canvas, Colour colour) {
    const PixelRect panel = layoutOverlays(kInspectedWidth, kInspectedHeight).sideView;
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
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    drawSideView(stairs(), oneMap(), kEye, canvas.picture);
    const std::vector<int> walls = uprights(canvas, kindColour(What::side));
    ASSERT_EQ(walls.size(), 3u);
    EXPECT_NEAR(walls[2] - walls[1], 2 * (walls[1] - walls[0]), 3) << "8 - 4 is twice 4 - 2";
}

TEST(SliceInspector, TheSideViewStaysInItsPanel) {
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    SliceTrace trace = stairs();
    trace.hits[2].backDepth = 1e300;
    trace.planes.push_back({What::sky, Face::top, -4000, 0});
    drawSideView(trace, oneMap(), kEye, canvas.picture);
    const PixelRect panel = layoutOverlays(kInspectedWidth, kInspectedHeight).sideView;
    for (int y = 0; y < kInspectedHeight; ++y) {
        for (int x = 0; x < kInspectedWidth; ++x) {
            const bool inside = x >= panel.x && y >= panel.y && x < panel.x + panel.width &&
                                y < panel.y + panel.height;
            ASSERT_TRUE(inside || !canvas.touched(x, y)) << x << ", " << y;
        }
    }
}

TEST(SliceInspector, HiddenBlocksAreDimmer) {
    const auto greyAt = [](bool seen) {
        Canvas canvas(kInspectedWidth, kInspectedHeight);
        SliceTrace trace = stairs();
        trace.hits.insert(trace.hits.begin(), wall(5.5, 1.0, 0, seen ? 1 : 0));
        trace.hits[0].backDepth = 6.5;
        drawSideView(trace, oneMap(), kEye, canvas.picture);
        const std::vector<int> walls = uprights(canvas, kindColour(What::side));
        // Depth 6.3, height 0.2: from the walls at 4 and 8
        const int x = walls[1] + (walls.back() - walls[1]) * 23 / 40;
        const PixelRect panel = layoutOverlays(kInspectedWidth, kInspectedHeight).sideView;
        const Colour colour = toColour(canvas.at(x, panel.y + panel.height - 20));
        return colour.r + colour.g + colour.b;
    };
    EXPECT_GT(greyAt(true), greyAt(false) + 60);
}

// Two walls that a ray meets behind a portal to another map two levels up, six and eight units
// away.
SliceTrace behindPortal() {
    SliceTrace trace = stairs();
    trace.portals = {{0, 0, 5.0, 0, trace.planes[0].first}};
    for (Hit& hit : trace.hits) {
        if (hit.depth < 6.0) continue;
        hit.map = 1;
        hit.portals = 1;
        hit.top = hit.top + tileEdge(2);
        hit.bottom = hit.bottom + tileEdge(2);
    }
    return trace;
}

World twoMaps() {
    World world = oneMap();
    world.maps.push_back(makeMap("cellar", 10, 10, 6, kNoTexture));
    world.portals.push_back({.fromMap = 0,
                             .fromX = 6,
                             .fromY = 1,
                             .toMap = 1,
                             .toX = 0,
                             .toY = 0,
                             .turn = 1,
                             .levels = 2});
    return world;
}

TEST(SliceInspector, DepthsAndHeightsContinueBehindAPortal) {
    Canvas straight(kInspectedWidth, kInspectedHeight);
    drawSideView(stairs(), oneMap(), kEye, straight.picture);
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    drawSideView(behindPortal(), twoMaps(), kEye, canvas.picture);
    const std::vector<int> portals = uprights(canvas, kPortalColour);
    const std::vector<int> walls = uprights(canvas, kindColour(What::side));
    ASSERT_EQ(walls.size(), 3u);
    // Other colours come near that of the line where rays lie over each other; it stands a quarter
    // of the way from the wall at 4 to that at 8.
    const int expected = walls[1] + (walls[2] - walls[1]) / 4;
    EXPECT_TRUE(std::any_of(portals.begin(), portals.end(),
                            [&](int x) { return std::abs(x - expected) <= 2; }));
    EXPECT_TRUE(uprights(straight, kPortalColour).empty());
    // The rest is as it would be without it, below the name of the map.
    const PixelRect panel = layoutOverlays(kInspectedWidth, kInspectedHeight).sideView;
    for (int y = panel.y + 40; y < panel.y + panel.height; ++y) {
        for (int x = panel.x; x < panel.x + panel.width; ++x) {
            ASSERT_TRUE(canvas.at(x, y) == straight.at(x, y) || std::abs(x - expected) <= 2)
                << x << ", " << y;
        }
    }
}

TEST(SliceInspector, RowsAreBehindThePortalsThatTheyPassed) {
    SliceTrace trace = behindPortal();
    trace.portals = {{0, 0, 5.0, 10, 50}, {1, 1, 9.0, 20, 30}};
    World world = twoMaps();
    world.portals.push_back({.fromMap = 1,
                             .fromX = 3,
                             .fromY = 3,
                             .toMap = 0,
                             .toX = 0,
                             .toY = 0,
                             .turn = 0,
                             .levels = -3});
    const auto beyond = [&](int row) { return beyondPortals(trace, world, 0, row); };
    EXPECT_EQ(beyond(9).map, 0);
    EXPECT_EQ(beyond(9).levels, 0);
    EXPECT_EQ(beyond(10).map, 1);
    EXPECT_EQ(beyond(10).levels, 2);
    EXPECT_EQ(beyond(25).map, 0);
    EXPECT_EQ(beyond(25).levels, -1);
    EXPECT_EQ(beyond(30).map, 1);
    EXPECT_EQ(beyond(50).levels, 0);
}

TEST(SliceInspector, ObjectsAreBarsAndMirrorsDashes) {
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    World world = oneMap();
    world.maps[0].objects.resize(1);
    world.maps[0].objects[0].height = toCoordinate(1.5);
    SliceTrace trace = stairs();
    trace.objects = {{.map = 0, .object = 0, .depth = 1.0, .first = 0, .last = 300}};
    drawSideView(trace, world, kEye, canvas.picture);
    const std::vector<int> bars = uprights(canvas, kObjectColour);
    const std::vector<int> walls = uprights(canvas, kindColour(What::side));
    ASSERT_EQ(bars.size(), 1u);
    EXPECT_NEAR(walls[0] - bars[0], (walls[1] - walls[0]) / 2, 3)
        << "at 1, where the walls are at 2 and 4";

    const auto touchedWith = [&](bool mirrored) {
        Canvas with(kInspectedWidth, kInspectedHeight);
        SliceTrace other = stairs();
        if (mirrored)
            other.mirrors = {{.map = 0,
                              .strength = 128,
                              .height = {},
                              .first = other.planes[0].first,
                              .last = kInspectedHeight}};
        drawSideView(other, oneMap(), kEye, with.picture);
        int count = 0;
        for (int y = 0; y < kInspectedHeight; ++y) {
            for (int x = 0; x < kInspectedWidth; ++x)
                count += apart(toColour(with.at(x, y)), kMirrorColour) < 30;
        }
        return count;
    };
    EXPECT_GT(touchedWith(true), touchedWith(false) + 10);
}

TEST(SliceInspector, ASecondStripeMarksPortalsAndMirrors) {
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    SliceTrace trace = behindPortal();
    trace.portals[0].first = 20;
    trace.portals[0].last = 40;
    trace.mirrors = {{.map = 0, .strength = 128, .height = {}, .first = 350, .last = 370}};
    drawSliceLine(trace, canvas.picture);
    EXPECT_LT(apart(toColour(canvas.at(205, 30)), kPortalColour), 40);
    EXPECT_LT(apart(toColour(canvas.at(205, 360)), kMirrorColour), 60);
    EXPECT_FALSE(canvas.touched(205, 60));
    EXPECT_FALSE(canvas.touched(205, 380));
}

TEST(SliceInspector, DrawsNothingWithoutRoomOrMap) {
    Canvas small(100, 70);
    drawSideView(stairs(), oneMap(), kEye, small.picture);
    EXPECT_EQ(small.touchedPixels(), 0);
    Canvas canvas(kInspectedWidth, kInspectedHeight);
    Eye elsewhere = kEye;
    elsewhere.map = 1;
    drawSideView(stairs(), oneMap(), elsewhere, canvas.picture);
    EXPECT_EQ(canvas.touchedPixels(), 0);
}

}  // namespace
}  // namespace slicecast
