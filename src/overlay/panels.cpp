#include "overlay/panels.h"

#include "overlay/layout.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <span>

namespace slicecast {
namespace {

constexpr Colour kLabelColour = {168, 180, 192, 255};
constexpr int kValueSize = kPanelColumns + 1;

struct Row {
    std::string_view label;
    std::array<char, kValueSize> value{};
};

__attribute__((format(printf, 2, 3))) Row row(const char* label, const char* format, ...) {
    Row made{label, {}};
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(made.value.data(), made.value.size(), format, values);
    va_end(values);
    return made;
}

// Names on the left, values against the right edge, so that nothing moves but the digits that change.
void drawRows(const Picture& picture, PixelRect panel, int scale, std::span<const Row> rows) {
    if (panel.width == 0) return;
    drawPanel(picture, panel);
    const int left = panel.x + kPanelPadding * scale;
    const int right = panel.x + panel.width - kPanelPadding * scale;
    int y = panel.y + kPanelPadding * scale;
    for (const Row& each : rows) {
        std::string_view value(each.value.data());
        const std::size_t room = static_cast<std::size_t>(kPanelColumns) - each.label.size() - 1;
        value = value.substr(0, room);
        drawText(picture, left, y, each.label, {.colour = kLabelColour, .scale = scale});
        drawText(picture, right - textWidth(value, scale), y, value, {.scale = scale});
        y += kLineAdvance * scale;
    }
}

// The eight winds, clockwise from the east.
const char* windOf(double headingDegrees) {
    constexpr std::array<const char*, 8> kWinds = {"E", "SE", "S", "SW", "W", "NW", "N", "NE"};
    return kWinds[static_cast<std::size_t>(std::clamp((headingDegrees + 22.5) / 45.0, 0.0, 8.0)) % kWinds.size()];
}

}  // namespace

int panelWidthDots() {
    return kPanelColumns * kGlyphAdvance - 1 + 2 * kPanelPadding;
}

int panelHeightDots(int rows) {
    return rows * kLineAdvance - (kLineAdvance - kGlyphHeight) + 2 * kPanelPadding;
}

void drawPlayerPanel(const PlayerFigures& player, const Picture& picture) {
    const OverlayLayout layout = layoutOverlays(picture.width, picture.height);
    const std::array<Row, kPlayerPanelRows> rows = {
        row("map", "%.*s", static_cast<int>(player.map.size()), player.map.data()),
        row("x", "%.2f", player.x),
        row("y", "%.2f", player.y),
        row("height", "%.2f", player.z),
        row("heading", "%s %5.1f", windOf(player.headingDegrees), player.headingDegrees),
        row("look", "%+.3f", player.look),
        row("speed", "%.2f /s", player.speed),
        row("mode", "%s",
            player.flying     ? "flying"
            : player.crouched ? "crouching"
                              : "walking"),
    };
    drawRows(picture, layout.player, layout.scale, rows);
}

void drawProcessPanel(const ProcessFigures& process, const Picture& picture) {
    const OverlayLayout layout = layoutOverlays(picture.width, picture.height);
    const auto milliseconds = [&](const char* label, double ProcessTimes::*value) {
        return process.times != nullptr ? row(label, "%.2f ms", process.times->*value) : row(label, "-");
    };
    const auto count = [&](const char* label, auto FrameReport::*value) {
        return process.report != nullptr ? row(label, "%lld", static_cast<long long>(process.report->*value)) : row(label, "-");
    };
    const int slices = process.slicesPerPicture;
    const std::array<Row, kProcessPanelRows> rows = {
        row("picture", "%d x %d", picture.width, picture.height),
        process.times != nullptr ? row("frames", "%.1f /s", process.times->framesPerSecond) : row("frames", "-"),
        milliseconds("steps", &ProcessTimes::stepMilliseconds),
        milliseconds("view", &ProcessTimes::viewMilliseconds),
        milliseconds("overlays", &ProcessTimes::overlayMilliseconds),
        count("tiles walked", &FrameReport::tilesWalked),
        count("blocks met", &FrameReport::blocksMet),
        count("spans drawn", &FrameReport::spansDrawn),
        count("rows filled", &FrameReport::rowsFilled),
        count("see-through", &FrameReport::layers),
        count("object slices", &FrameReport::objectSlices),
        count("portals deep", &FrameReport::deepestPortal),
        count("walks beyond", &FrameReport::partsBehindPortals),
        count("mirrored rows", &FrameReport::mirroredRows),
        row("light", "%.2f x %.1f", process.intensity, process.multiplier),
        row("mirrors", "x %.2f", process.mirrors),
        !process.slow ? row("slices", "all")
        : slices < 0  ? row("slices", "1 in %d frames", -slices)
                      : row("slices", "%d a frame", slices),
    };
    drawRows(picture, layout.process, layout.scale, rows);
}

}  // namespace slicecast
