#include "overlay/panels.h"

#include "base/words.h"
#include "overlay/layout.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>
#include <span>

namespace slicecast {
namespace {

constexpr Colour kLabelColour = {168, 180, 192, 255};
constexpr Colour kRuleColour = {226, 214, 186, 56};
constexpr int kAsideDots = 6 * kGlyphAdvance;  // from the right edge, "360.0" and a gap

struct Row {
    std::string_view label;
    std::string_view unit;   // after the value, in the label's colour
    std::string_view aside;  // before the value, at a fixed place
    std::array<char, 24> room{};
    int length = 0;  // of the value

    Row(std::string_view name, const Words& value, std::string_view behind = {},
        std::string_view before = {})
        : label(name), unit(behind), aside(before) {
        length = static_cast<int>(write(room, value).size());
    }
    std::string_view value() const { return {room.data(), static_cast<std::size_t>(length)}; }
};

// Names on the left, values against the right edge, so that only changing digits move. Draws a fine
// line above the rows numbered in `rules`, if all rows fit.
void drawRows(const Picture& picture, PixelRect panel, int scale, std::span<const Row> rows,
              int shown, std::span<const int> rules = {}) {
    if (panel.width == 0) return;
    drawPanel(picture, panel, scale);
    const int left = panel.x + kPanelPadding * scale;
    const int right = panel.x + panel.width - kPanelPadding * scale;
    const bool isWhole = shown == static_cast<int>(rows.size());
    int y = panel.y + kPanelPadding * scale;
    for (int i = 0; i < shown; ++i) {
        const Row& each = rows[static_cast<std::size_t>(i)];
        if (isWhole && std::find(rules.begin(), rules.end(), i) != rules.end()) {
            blendRect(picture, {left, y, right - left, (scale + 1) / 2}, kRuleColour);
            y += kRuleAdvance * scale;
        }
        const int gap = 4 * scale;
        const int end = each.unit.empty() ? right : right - textWidth(each.unit, scale) - 3 * scale;
        const int begin = left + textWidth(each.label, scale) + gap;
        std::string_view value = each.value();
        while (!value.empty() && end - textWidth(value, scale) < begin) value.remove_suffix(1);
        drawText(picture, left, y, each.label, {.colour = kLabelColour, .scale = scale});
        drawText(picture, end + 3 * scale, y, each.unit, {.colour = kLabelColour, .scale = scale});
        drawText(picture, right - kAsideDots * scale - textWidth(each.aside, scale), y, each.aside,
                 {.scale = scale});
        drawText(picture, end - textWidth(value, scale), y, value, {.scale = scale});
        y += kLineAdvance * scale;
    }
}

// The eight compass points, clockwise from the east.
const char* compassPoint(double headingDegrees) {
    constexpr std::array<const char*, 8> kPoints = {"E", "SE", "S", "SW", "W", "NW", "N", "NE"};
    return kPoints[static_cast<std::size_t>(std::clamp((headingDegrees + 22.5) / 45.0, 0.0, 8.0)) %
                   kPoints.size()];
}

}  // namespace

int panelHeightDots(int rows) {
    return rows * kLineAdvance - (kLineAdvance - kGlyphHeight) + 2 * kPanelPadding;
}

void drawPlayerPanel(const PlayerFigures& player, const Picture& picture) {
    const OverlayLayout layout = layoutOverlays(picture.width, picture.height);
    const std::array<Row, kPlayerPanelRows> rows = {
        Row("map", player.map),
        Row("x", Fixed{player.x, 2}),
        Row("y", Fixed{player.y, 2}),
        Row("height", Fixed{player.z, 2}),
        Row("heading", Fixed{player.headingDegrees, 1}, {}, compassPoint(player.headingDegrees)),
        Row("look", {player.look < 0.0 ? "" : "+", Fixed{player.look + 0.0, 3}}),
        Row("speed", Fixed{player.speed, 2}, "/s"),
        Row("mode", player.flying     ? "flying"
                    : player.swimming ? "swimming"
                    : player.crouched ? "crouching"
                                      : "walking"),
    };
    drawRows(picture, layout.player, layout.scale, rows, kPlayerPanelRows);
}

void drawProcessPanel(const ProcessFigures& process, const Picture& picture) {
    const OverlayLayout layout = layoutOverlays(picture.width, picture.height);
    const auto milliseconds = [&](const char* label, double ProcessTimes::*value) {
        return process.times != nullptr ? Row(label, Fixed{process.times->*value, 2}, "ms")
                                        : Row(label, "-");
    };
    const auto count = [&](const char* label, auto FrameReport::*value) {
        return process.report != nullptr ? Row(label, process.report->*value) : Row(label, "-");
    };
    const int slices = process.slicesPerPicture;
    const std::array<Row, kProcessPanelRows> rows = {
        Row("picture", {process.width, " x ", process.height}),
        process.times != nullptr ? Row("frames", Fixed{process.times->framesPerSecond, 1}, "/s")
                                 : Row("frames", "-"),
        milliseconds("steps", &ProcessTimes::stepMilliseconds),
        milliseconds("view", &ProcessTimes::viewMilliseconds),
        milliseconds("overlays", &ProcessTimes::overlayMilliseconds),
        count("tiles walked", &FrameReport::tilesWalked),
        count("blocks met", &FrameReport::blocksMet),
        count("spans drawn", &FrameReport::spansDrawn),
        count("rows filled", &FrameReport::rowsFilled),
        count("see-through", &FrameReport::layers),
        count("object slices", &FrameReport::objectSlices),
        count("most portals", &FrameReport::deepestPortal),
        count("portal walks", &FrameReport::partsBehindPortals),
        count("mirrored rows", &FrameReport::mirroredRows),
        Row("light", {Fixed{process.intensity, 2}, " x ", Fixed{process.multiplier, 1}}),
        Row("mirrors", {"x ", Fixed{process.mirrors, 2}}),
        !process.slow ? Row("slices", "all")
        : slices < 0  ? Row("slices", {"1 in ", -slices}, "frames")
                      : Row("slices", slices, "a frame"),
    };
    constexpr std::array<int, kProcessPanelRules> kRules = {2, 5, 14};
    drawRows(picture, layout.process, layout.scale, rows, layout.processRows, kRules);
}

}  // namespace slicecast
