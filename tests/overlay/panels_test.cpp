#include "overlay/panels.h"

#include "canvas.h"
#include "overlay/layout.h"
#include "overlay/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr Colour kTextColour = TextStyle{}.colour;

// The brightly written values of a panel's rows, read back by comparing with what the font draws.
std::vector<std::string> valuesOf(const Canvas& canvas, PixelRect panel, int scale, int rows) {
    std::vector<std::string> values;
    const int right = panel.x + panel.width - kPanelPadding * scale;
    for (int row = 0; row < rows; ++row) {
        const int y = panel.y + (kPanelPadding + row * kLineAdvance) * scale;
        std::string value;
        for (int x = right - kGlyphWidth * scale; x > panel.x; x -= kGlyphAdvance * scale) {
            char found = 0;
            for (char c = ' '; c <= '~' && found == 0; ++c) {
                Canvas glyph(kGlyphWidth * scale, kGlyphHeight * scale);
                drawText(glyph.picture, 0, 0, std::string(1, c), {.scale = scale});
                bool same = true;
                for (int dy = 0; dy < kGlyphHeight * scale && same; ++dy) {
                    for (int dx = 0; dx < kGlyphWidth * scale && same; ++dx) {
                        same = (toColour(canvas.at(x + dx, y + dy)) == kTextColour) ==
                               glyph.touched(dx, dy);
                    }
                }
                if (same) found = c;
            }
            if (found == 0) break;
            value.insert(value.begin(), found);
        }
        const std::size_t first = value.find_first_not_of(' ');
        values.push_back(first == std::string::npos ? "" : value.substr(first));
    }
    return values;
}

TEST(Panels, ThePlayersTellsWhereAndHow) {
    for (const auto& [width, height] : {std::pair{640, 400}, {1280, 720}}) {
        Canvas canvas(width, height);
        drawPlayerPanel({.map = "castle yard",
                         .x = 12.345,
                         .y = 3.5,
                         .z = 0.5,
                         .headingDegrees = 88.25,
                         .look = -0.125,
                         .speed = 2.998,
                         .flying = false,
                         .crouched = true},
                        canvas.picture);
        const OverlayLayout layout = layoutOverlays(width, height);
        EXPECT_EQ(valuesOf(canvas, layout.player, layout.scale, kPlayerPanelRows),
                  (std::vector<std::string>{"castle yard", "12.35", "3.50", "0.50", "S  88.2",
                                            "-0.125", "3.00 /s", "crouching"}));
    }
}

TEST(Panels, NumbersKeepTheirPlaces) {
    const OverlayLayout layout = layoutOverlays(640, 400);
    for (const auto& [heading, shown] : {std::pair{0.0, "E   0.0"},
                                         {9.94, "E   9.9"},
                                         {9.95, "E   9.9"},
                                         {9.96, "E  10.0"},
                                         {99.96, "S 100.0"}}) {
        Canvas canvas(640, 400);
        drawPlayerPanel({.map = "m", .headingDegrees = heading, .look = -0.0}, canvas.picture);
        const std::vector<std::string> values =
            valuesOf(canvas, layout.player, layout.scale, kPlayerPanelRows);
        EXPECT_EQ(values[4], shown) << heading;
        EXPECT_EQ(values[5], "+0.000");
    }
}

TEST(Panels, TheWindIsTheNearestOfEight) {
    const OverlayLayout layout = layoutOverlays(640, 400);
    for (const auto& [heading, wind] : {std::pair{0.0, "E"},
                                        {22.4, "E"},
                                        {22.6, "SE"},
                                        {90.0, "S"},
                                        {180.0, "W"},
                                        {270.0, "N"},
                                        {315.0, "NE"},
                                        {359.9, "E"}}) {
        Canvas canvas(640, 400);
        drawPlayerPanel({.map = "m", .headingDegrees = heading}, canvas.picture);
        const std::string value =
            valuesOf(canvas, layout.player, layout.scale, kPlayerPanelRows)[4];
        EXPECT_EQ(value.substr(0, value.find(' ')), wind) << heading;
    }
}

TEST(Panels, TheProcessTellsTimesAndCounts) {
    const ProcessTimes times = {.framesPerSecond = 59.94,
                                .stepMilliseconds = 0.012,
                                .viewMilliseconds = 4.5,
                                .overlayMilliseconds = 0.25};
    const FrameReport report = {.tilesWalked = 12345,
                                .blocksMet = 678,
                                .spansDrawn = 90,
                                .partsBehindPortals = 345,
                                .deepestPortal = 8,
                                .mirroredRows = 4567,
                                .layers = 890,
                                .objectSlices = 21,
                                .rowsFilled = 256001};
    const OverlayLayout layout = layoutOverlays(640, 400);
    Canvas canvas(640, 400);
    drawProcessPanel({.times = &times,
                      .report = &report,
                      .intensity = 1.5,
                      .multiplier = 5.0,
                      .mirrors = 1.5,
                      .slicesPerPicture = -3,
                      .slow = true},
                     canvas.picture);
    EXPECT_EQ(valuesOf(canvas, layout.process, layout.scale, kProcessPanelRows),
              (std::vector<std::string>{"640 x 400", "59.9 /s", "0.01 ms", "4.50 ms", "0.25 ms",
                                        "12345", "678", "90", "256001", "890", "21", "8", "345",
                                        "4567", "1.50 x 5.0", "x 1.50", "1 in 3 frames"}));

    Canvas without(640, 400);
    drawProcessPanel({.intensity = 0.5, .multiplier = 10.0}, without.picture);
    EXPECT_EQ(valuesOf(without, layout.process, layout.scale, kProcessPanelRows),
              (std::vector<std::string>{"640 x 400", "-", "-", "-", "-", "-", "-", "-", "-", "-",
                                        "-", "-", "-", "-", "0.50 x 10.0", "x 1.00", "all"}));
}

TEST(Panels, GreatCountsAreNotCut) {
    constexpr int kGreat = 12345678;
    const FrameReport report = {.tilesWalked = kGreat,
                                .blocksMet = kGreat,
                                .spansDrawn = kGreat,
                                .partsBehindPortals = kGreat,
                                .deepestPortal = kGreat,
                                .mirroredRows = kGreat,
                                .layers = kGreat,
                                .objectSlices = kGreat,
                                .rowsFilled = kGreat};
    const OverlayLayout layout = layoutOverlays(640, 400);
    Canvas canvas(640, 400);
    drawProcessPanel({.report = &report}, canvas.picture);
    const std::vector<std::string> values =
        valuesOf(canvas, layout.process, layout.scale, kProcessPanelRows);
    EXPECT_EQ(std::count(values.begin(), values.end(), std::to_string(kGreat)), 9);
}

TEST(Panels, ALongNameIsCutNotSpilt) {
    Canvas canvas(640, 400);
    drawPlayerPanel({.map = "a name that is much too long for the panel"}, canvas.picture);
    const PixelRect panel = layoutOverlays(640, 400).player;
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 640; ++x) {
            const bool inside = x >= panel.x && y >= panel.y && x < panel.x + panel.width &&
                                y < panel.y + panel.height;
            ASSERT_TRUE(inside || !canvas.touched(x, y)) << x << ", " << y;
        }
    }
}

// Bright text on a panel over white, and dim labels over white, stay readable: the panel is far
// darker than both.
TEST(Panels, AreDarkEnoughOverABrightScene) {
    const Colour panel = toColour(blended(toPixel({255, 255, 255, 255}), kPanelColour));
    EXPECT_LT(panel.r + panel.g + panel.b, 3 * 90);
}

}  // namespace
}  // namespace slicecast
