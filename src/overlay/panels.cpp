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

struct Row {
    std::string_view label;
    std::array<char, kPanelColumns> room{};
    int length = 0;  // of the value

    Row(std::string_view name, const Words& value) : label(name) {
        length = static_cast<int>(write(room, value).size());
    }
    std::string_view value() const { return {room.data(), static_cast<std::size_t>(length)}; }
};

// Names on the left, values against the right edge, so that nothing moves but the digits that
// change.
void drawRows(const Picture& picture, PixelRect panel, int scale, std::span<const Row> rows) {
    if (panel.width == 0) return;
    drawPanel(picture, panel);
    const int left = panel.x + kPanelPadding * scale;
    const int right = panel.x + panel.width - kPanelPadding * scale;
    int y = panel.y + kPanelPadding * scale;
    for (const Row& each : rows) {
        const std::string_view value =
            each.value().substr(0, static_cast<std::size_t>(kPanelColumns) - each.label.size() - 1);
        drawText(picture, left, y, each.label, {.colour = kLabelColour, .scale = scale});
        drawText(picture, right - textWidth(value, scale), y, value, {.scale = scale});
        y += kLineAdvance * scale;
    }
}

// The eight winds, clockwise from the east.
const char* windOf(double headingDegrees) {
    constexpr std::array<const char*, 8> kWinds = {"E", "SE", "S", "SW", "W", "NW", "N", "NE"};
    return kWinds[static_cast<std::size_t>(std::clamp((headingDegrees + 22.5) / 45.0, 0.0, 8.0)) %
                  kWinds.size()];
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
    const NumberText heading = fixedText(player.headingDegrees, 1);  // up to "360.0", right-aligned
    const std::array<Row, kPlayerPanelRows> rows = {
        Row("map", player.map),
        Row("x", Fixed{player.x, 2}),
        Row("y", Fixed{player.y, 2}),
        Row("height", Fixed{player.z, 2}),
        Row("heading",
            {windOf(player.headingDegrees),
             std::string_view("      ").substr(std::string_view(heading).size()), heading}),
        Row("look", {player.look < 0.0 ? "" : "+", Fixed{player.look + 0.0, 3}}),
        Row("speed", {Fixed{player.speed, 2}, " /s"}),
        Row("mode", player.flying     ? "flying"
                    : player.swimming ? "swimming"
                    : player.crouched ? "crouching"
                                      : "walking"),
    };
    drawRows(picture, layout.player, layout.scale, rows);
}

void drawProcessPanel(const ProcessFigures& process, const Picture& picture) {
    const OverlayLayout layout = layoutOverlays(picture.width, picture.height);
    const auto milliseconds = [&](const char* label, double ProcessTimes::*value) {
        return process.times != nullptr ? Row(label, {Fixed{process.times->*value, 2}, " ms"})
                                        : Row(label, "-");
    };
    const auto count = [&](const char* label, auto FrameReport::*value) {
        return process.report != nullptr ? Row(label, process.report->*value) : Row(label, "-");
    };
    const int slices = process.slicesPerPicture;
    const std::array<Row, kProcessPanelRows> rows = {
        Row("picture", {picture.width, " x ", picture.height}),
        process.times != nullptr ? Row("frames", {Fixed{process.times->framesPerSecond, 1}, " /s"})
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
        count("portals deep", &FrameReport::deepestPortal),
        count("walks beyond", &FrameReport::partsBehindPortals),
        count("mirrored rows", &FrameReport::mirroredRows),
        Row("light", {Fixed{process.intensity, 2}, " x ", Fixed{process.multiplier, 1}}),
        Row("mirrors", {"x ", Fixed{process.mirrors, 2}}),
        !process.slow ? Row("slices", "all")
        : slices < 0  ? Row("slices", {"1 in ", -slices, " frames"})
                      : Row("slices", {slices, " a frame"}),
    };
    drawRows(picture, layout.process, layout.scale, rows);
}

}  // namespace slicecast
