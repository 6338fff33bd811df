#include "overlay/panels.h"

#include "canvas.h"
#include "overlay/layout.h"
#include "overlay/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr Colour kTextColour = TextStyle{}.colour;

struct Value {
    std::string text;
    std::string unit = "";
};

// Whether a text, and nothing more, is written brightly so that it ends there.
bool endsAt(const Canvas& canvas, int right, int y, int scale, const std::string& text) {
    const int width = textWidth(text, scale);
    const int gap = 4 * scale;
    Canvas written(width + gap, kGlyphHeight * scale);
    drawText(written.picture, gap, 0, text, {.scale = scale});
    for (int dy = 0; dy < written.picture.height; ++dy) {
        for (int dx = 0; dx < written.picture.width; ++dx) {
            const bool bright =
                toColour(canvas.at(right - width - gap + dx, y + dy)) == kTextColour;
            if (bright != written.touched(dx, dy)) return false;
        }
    }
    return true;
}

// The rows below a rule are further down.
void expectValues(const Canvas& canvas, PixelRect panel, int scale,
                  const std::vector<Value>& values, const std::vector<int>& rules = {}) {
    int y = panel.y + kPanelPadding * scale;
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (std::count(rules.begin(), rules.end(), static_cast<int>(row)) > 0)
            y += kRuleAdvance * scale;
        const Value& value = values[row];
        int right = panel.x + panel.width - kPanelPadding * scale;
        if (!value.unit.empty()) right -= textWidth(value.unit, scale) + 3 * scale;
        EXPECT_TRUE(endsAt(canvas, right, y, scale, value.text)) << row << ": " << value.text;
        y += kLineAdvance * scale;
    }
}

const std::vector<int> kProcessRules = {2, 5, 14};

TEST(Panels, ThePlayerPanelShowsPositionAndMode) {
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
        expectValues(canvas, layout.player, layout.scale,
                     {{"castle yard"},
                      {"12.35"},
                      {"3.50"},
                      {"0.50"},
                      {"88.2"},
                      {"-0.125"},
                      {"3.00", "/s"},
                      {"crouching"}});
    }
}

// The end of the name of the wind stays where it is, however many digits the number has.
TEST(Panels, NumbersKeepTheirPlaces) {
    const OverlayLayout layout = layoutOverlays(640, 400);
    const int right = layout.player.x + layout.player.width - kPanelPadding;
    const int y = layout.player.y + kPanelPadding + 4 * kLineAdvance;
    for (const auto& [heading, number, wind] : {std::tuple{0.0, "0.0", "E"},
                                                {9.94, "9.9", "E"},
                                                {9.96, "10.0", "E"},
                                                {22.4, "22.4", "E"},
                                                {22.6, "22.6", "SE"},
                                                {90.0, "90.0", "S"},
                                                {99.96, "100.0", "S"},
                                                {180.0, "180.0", "W"},
                                                {270.0, "270.0", "N"},
                                                {315.0, "315.0", "NE"},
                                                {359.9, "359.9", "E"}}) {
        Canvas canvas(640, 400);
        drawPlayerPanel({.map = "m", .headingDegrees = heading, .look = -0.0}, canvas.picture);
        EXPECT_TRUE(endsAt(canvas, right, y, 1, number)) << heading;
        EXPECT_TRUE(endsAt(canvas, right - 6 * kGlyphAdvance, y, 1, wind)) << heading;
        EXPECT_TRUE(endsAt(canvas, right, y + kLineAdvance, 1, "+0.000"));
    }
}

TEST(Panels, TheProcessPanelShowsTimesAndCounts) {
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
    drawProcessPanel({.width = 640,
                      .height = 400,
                      .times = &times,
                      .report = &report,
                      .intensity = 1.5,
                      .multiplier = 5.0,
                      .mirrors = 1.5,
                      .slicesPerPicture = -3,
                      .slow = true},
                     canvas.picture);
    const auto expectProcess = [&](const Canvas& drawn, const std::vector<Value>& values) {
        expectValues(drawn, layout.process, layout.scale, values, kProcessRules);
    };
    expectProcess(canvas, {{"640 x 400"},
                           {"59.9", "/s"},
                           {"0.01", "ms"},
                           {"4.50", "ms"},
                           {"0.25", "ms"},
                           {"12345"},
                           {"678"},
                           {"90"},
                           {"256001"},
                           {"890"},
                           {"21"},
                           {"8"},
                           {"345"},
                           {"4567"},
                           {"1.50 x 5.0"},
                           {"x 1.50"},
                           {"1 in 3", "frames"}});

    Canvas without(640, 400);
    drawProcessPanel({.width = 640, .height = 400, .intensity = 0.5, .multiplier = 10.0},
                     without.picture);
    std::vector<Value> values(kProcessPanelRows, Value{"-"});
    values[0] = {"640 x 400"};
    values[14] = {"0.50 x 10.0"};
    values[15] = {"x 1.00"};
    values[16] = {"all"};
    expectProcess(without, values);
}

TEST(Panels, LargeCountsAreNotCut) {
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
    drawProcessPanel({.width = 640, .height = 400, .report = &report}, canvas.picture);
    std::vector<Value> values(kProcessPanelRows, Value{std::to_string(kGreat)});
    for (int i = 0; i < 5; ++i) values[static_cast<std::size_t>(i)] = {"-"};
    values[0] = {"640 x 400"};
    values[14] = {"0.00 x 0.0"};
    values[15] = {"x 1.00"};
    values[16] = {"all"};
    expectValues(canvas, layout.process, layout.scale, values, kProcessRules);
}

// A small picture shows the first rows, one with room for all of them all.
TEST(Panels, TheProcessPanelShowsTheRowsThatFit) {
    const OverlayLayout layout = layoutOverlays(320, 200);
    EXPECT_GE(layout.processRows, 6);
    EXPECT_LT(layout.processRows, kProcessPanelRows);
    Canvas canvas(320, 200);
    drawProcessPanel({.width = 320, .height = 200, .mirrors = 2.0}, canvas.picture);
    std::vector<Value> values(static_cast<std::size_t>(layout.processRows), Value{"-"});
    values[0] = {"320 x 200"};
    expectValues(canvas, layout.process, 1, values);
    EXPECT_EQ(layoutOverlays(640, 400).processRows, kProcessPanelRows);
}

TEST(Panels, ALongNameIsCut) {
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
TEST(Panels, AreReadableOverABrightScene) {
    const Colour panel = toColour(blended(toPixel({255, 255, 255, 255}), kPanelColour));
    EXPECT_LT(panel.r + panel.g + panel.b, 3 * 90);
}

}  // namespace
}  // namespace slicecast
