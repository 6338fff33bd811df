#include "overlay/slice_inspector.h"

#include "overlay/layout.h"
#include "overlay/lines.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

namespace slicecast {
namespace {

constexpr Colour kLine = {255, 255, 255, 220};
constexpr Colour kBesideLine = {0, 0, 0, 150};
constexpr Colour kAxis = {168, 180, 192, 255};
constexpr Colour kAxisLine = {168, 180, 192, 120};
constexpr Colour kUnseenBlock = {104, 120, 140, 70};
constexpr Colour kSeenBlock = {120, 148, 184, 170};
constexpr Colour kBlockEdge = {226, 232, 240, 110};
constexpr Colour kEye = {255, 214, 74, 255};
constexpr Colour kEyeLevel = {255, 214, 74, 70};
constexpr int kRayAlpha = 110;
constexpr int kRowsPerRay = 24;  // between the rays to one run of rows
constexpr double kLeastDepth = 4.0;
constexpr double kGreatestDepth = 200.0;
constexpr double kLeastHeight = 2.0;

struct Kind {
    FilledRows::What what;
    const char* name;
    Colour colour;
};
constexpr auto kKinds = std::to_array<Kind>({
    {FilledRows::What::side, "side", {255, 196, 92, 255}},
    {FilledRows::What::roof, "roof", {242, 112, 92, 255}},
    {FilledRows::What::underside, "under", {206, 140, 240, 255}},
    {FilledRows::What::floor, "floor", {132, 214, 112, 255}},
    {FilledRows::What::ceiling, "ceiling", {96, 222, 212, 255}},
    {FilledRows::What::sky, "sky", {112, 178, 255, 255}},
    {FilledRows::What::haze, "haze", {186, 192, 200, 255}},
});

// Depths and heights on the panel.
struct Plot {
    PixelRect area;
    int scale;                     // of text and strong lines
    double depth = kLeastDepth;    // units, at the right edge
    double height = kLeastHeight;  // units, at the upper edge

    double x(double units) const { return area.x + std::min(units / depth, 1.0) * area.width; }
    double y(double units) const { return area.y + area.height - units / height * area.height; }
};

// The scale holds everything that is seen of blocks, and the eye.
Plot makePlot(const SliceTrace& trace, double eyeZ, PixelRect area, int scale) {
    double depth = 0.0;
    double height = eyeZ;
    for (const Hit& hit : trace.hits) {
        if (hit.filled.empty()) continue;
        depth = std::max(depth, std::min(hit.backDepth, hit.depth + 4.0));
        height = std::max(height, hit.top.value());
    }
    if (depth == 0.0 && !trace.tiles.empty()) depth = trace.tiles.back().depth;
    return {area, scale, std::clamp(depth * 1.08, kLeastDepth, kGreatestDepth), std::max(height + 0.4, kLeastHeight)};
}

// 1, 2, 5, 10 ... units from mark to mark, so that marks are at least so many pixels apart.
double markStep(double units, int pixels, int least) {
    double step = 1.0;
    for (int i = 0; step * pixels < least * units; ++i) step *= i % 3 == 1 ? 2.5 : 2.0;
    return step;
}

// Where a ray through a row's edge is at a depth, kept within what the plot shows.
struct SideRay {
    const Plot& plot;
    double eyeZ;
    double slope;

    Point at(double depth) const {
        double t = std::clamp(depth, 0.0, plot.depth);
        if (slope < 0.0) t = std::min(t, eyeZ / -slope);
        if (slope > 0.0) t = std::min(t, std::max(0.0, plot.height - eyeZ) / slope);
        return {plot.x(t), plot.y(eyeZ + slope * t)};
    }
};

// The depth at which the ray of that slope meets what fills its row.
double depthOf(const Hit& hit, const FilledRows& rows, double eyeZ, double slope) {
    if (rows.what == FilledRows::What::side) return hit.entered && rows.face == hit.face ? hit.depth : hit.backDepth;
    const double level = (rows.what == FilledRows::What::roof ? hit.top : hit.bottom).value();
    return slope != 0.0 ? std::clamp((level - eyeZ) / slope, hit.depth, hit.backDepth) : hit.backDepth;
}

void drawAxes(const Plot& plot, double eyeZ, int scale, const Picture& picture) {
    std::array<char, 16> text;
    const int bottom = plot.area.y + plot.area.height;
    blendRect(picture, {plot.area.x, bottom, plot.area.width, 1}, kAxisLine);
    blendRect(picture, {plot.area.x - 1, plot.area.y, 1, plot.area.height + 1}, kAxisLine);

    // Depths below, heights on the left
    const double across = markStep(plot.depth, plot.area.width, 30 * scale);
    for (double depth = across; depth < plot.depth * 0.97; depth += across) {
        std::snprintf(text.data(), text.size(), "%.0f", depth);
        const std::string_view label(text.data());
        const int x = static_cast<int>(plot.x(depth));
        blendRect(picture, {x, bottom, 1, 3 * scale}, kAxis);
        drawText(picture, x - textWidth(label, scale) / 2, bottom + 4 * scale, label, {.colour = kAxis, .scale = scale});
    }
    const double up = markStep(plot.height, plot.area.height, 14 * scale);
    for (double height = 0.0; height < plot.height; height += up) {
        std::snprintf(text.data(), text.size(), "%.0f", height);
        const std::string_view label(text.data());
        const int y = static_cast<int>(plot.y(height));
        if (y - 4 * scale < plot.area.y) break;
        blendRect(picture, {plot.area.x - 3 * scale, y, 3 * scale, 1}, kAxis);
        drawText(picture, plot.area.x - 5 * scale - textWidth(label, scale), y - 3 * scale, label, {.colour = kAxis, .scale = scale});
    }
    const int eyeRow = static_cast<int>(plot.y(eyeZ));
    for (int x = plot.area.x; x < plot.area.x + plot.area.width; x += 4 * scale) blendRect(picture, {x, eyeRow, 2 * scale, 1}, kEyeLevel);
}

void drawBlocks(const SliceTrace& trace, const Plot& plot, const Picture& picture) {
    for (const Hit& hit : trace.hits) {
        if (hit.depth >= plot.depth) continue;
        const int left = static_cast<int>(plot.x(hit.depth));
        const int right = std::max(left + 1, static_cast<int>(plot.x(hit.backDepth)));
        const int top = static_cast<int>(plot.y(hit.top.value()));
        const int bottom = std::max(top + 1, static_cast<int>(plot.y(hit.bottom.value())));
        const auto blendInside = [&](PixelRect rect, Colour colour) { blendRect(picture, shared(rect, plot.area), colour); };
        blendInside({left, top, right - left, bottom - top}, hit.filled.empty() ? kUnseenBlock : kSeenBlock);
        blendInside({left, top, right - left, 1}, kBlockEdge);
        blendInside({left, top, 1, bottom - top}, kBlockEdge);
    }
}

// Rays to the first and the last row of a run, and to some between.
template <typename DepthOf>
void drawRays(const SliceTrace& trace, const FilledRows& rows, const Plot& plot, double eyeZ, DepthOf depthOfSlope, const Picture& picture) {
    const Colour colour = kindColour(rows.what);
    const int count = std::max(1, (rows.last - rows.first + kRowsPerRay - 1) / kRowsPerRay);
    Point before;
    for (int i = 0; i <= count; ++i) {
        const double row = rows.first + static_cast<double>(rows.last - rows.first) * i / count;
        const SideRay ray = {plot, eyeZ, (trace.horizonRow - row) / trace.projectionDistance};
        const Point end = ray.at(depthOfSlope(ray.slope));
        drawLine(picture, plot.area, {plot.x(0.0), plot.y(eyeZ)}, end, withAlpha(colour, kRayAlpha));

        // What is seen, as a strong line
        if (i > 0 && rows.what != FilledRows::What::sky) {
            const bool upright = std::abs(end.y - before.y) > std::abs(end.x - before.x);
            for (int k = 0; k <= plot.scale; ++k) {
                const Point by = {upright ? -k : 0.0, upright ? 0.0 : -k};
                drawLine(picture, plot.area, {before.x + by.x, before.y + by.y}, {end.x + by.x, end.y + by.y}, colour);
            }
        }
        before = end;
    }
}

bool isSeen(const SliceTrace& trace, FilledRows::What what) {
    const auto among = [what](const std::vector<FilledRows>& filled) {
        return std::any_of(filled.begin(), filled.end(), [what](const FilledRows& rows) { return rows.what == what; });
    };
    return among(trace.planes) || std::any_of(trace.hits.begin(), trace.hits.end(), [&](const Hit& hit) { return among(hit.filled); });
}

void drawTitle(const SliceTrace& trace, PixelRect panel, int scale, const Picture& picture) {
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "slice %d   %zu blocks   %zu tiles", trace.column, trace.hits.size(), trace.tiles.size());
    std::string_view title(text.data());
    const int room = panel.width - 2 * kPanelPadding * scale;
    while (textWidth(title, scale) > room) title.remove_suffix(1);
    int x = panel.x + kPanelPadding * scale;
    const int y = panel.y + kPanelPadding * scale;
    drawText(picture, x, y, title, {.scale = scale});

    // What the colours in this slice mean, against the right edge
    x += textWidth(title, scale) + kGlyphAdvance * scale;
    int width = 0;
    for (const Kind& kind : kKinds) width += isSeen(trace, kind.what) ? textWidth(kind.name, scale) + 14 * scale : 0;
    const int right = panel.x + panel.width - kPanelPadding * scale;
    if (right - width < x) return;
    x = right - width + 7 * scale;
    for (const Kind& kind : kKinds) {
        if (!isSeen(trace, kind.what)) continue;
        blendRect(picture, {x, y + scale, 5 * scale, 5 * scale}, kind.colour);
        drawText(picture, x + 7 * scale, y, kind.name, {.colour = kAxis, .scale = scale});
        x += textWidth(kind.name, scale) + 14 * scale;
    }
}

}  // namespace

Colour kindColour(FilledRows::What what) {
    for (const Kind& kind : kKinds) {
        if (kind.what == what) return kind.colour;
    }
    return kAxis;
}

void drawSliceLine(const SliceTrace& trace, const Picture& picture) {
    const int scale = readableScale(picture.width, picture.height);
    const int stripe = 3 * scale;
    // Near the right edge the stripe is on the line's left.
    const bool left = trace.column + 1 + stripe > picture.width;
    const int x = left ? trace.column - stripe : trace.column + 1;
    blendRect(picture, {trace.column - 1, 0, 1, picture.height}, kBesideLine);
    blendRect(picture, {trace.column + 1, 0, 1, picture.height}, kBesideLine);
    blendRect(picture, {trace.column, 0, 1, picture.height}, kLine);
    const auto mark = [&](const FilledRows& rows) {
        blendRect(picture, {x, rows.first, stripe, rows.last - rows.first}, withAlpha(kindColour(rows.what), 235));
        blendRect(picture, {x, rows.first, stripe, 1}, {0, 0, 0, 200});
    };
    for (const FilledRows& rows : trace.planes) mark(rows);
    for (const Hit& hit : trace.hits) {
        for (const FilledRows& rows : hit.filled) mark(rows);
    }
}

void drawSideView(const SliceTrace& trace, const World& world, const Eye& eye, const Picture& picture) {
    const OverlayLayout layout = layoutOverlays(picture.width, picture.height);
    const PixelRect panel = layout.sideView;
    if (panel.width == 0 || eye.map < 0 || static_cast<std::size_t>(eye.map) >= world.maps.size()) return;
    const int scale = layout.scale;
    const int padding = kPanelPadding * scale;
    drawPanel(picture, panel);
    drawTitle(trace, panel, scale, picture);

    // Room for the title above, the marks of depth below and those of height on the left
    const int above = padding + (kGlyphHeight + 3) * scale;
    const int below = padding + (kGlyphHeight + 3) * scale;
    const int beside = padding + (2 * kGlyphAdvance + 5) * scale;
    const double eyeZ = eye.z.value();
    const Plot plot = makePlot(trace, eyeZ, {panel.x + beside, panel.y + above, panel.width - beside - padding, panel.height - above - below}, scale);
    drawAxes(plot, eyeZ, scale, picture);
    drawBlocks(trace, plot, picture);

    // Planes, then blocks, then the eye
    const double ceiling = world.maps[static_cast<std::size_t>(eye.map)].ceiling.height.value();
    for (const FilledRows& rows : trace.planes) {
        const bool isPlane = rows.what == FilledRows::What::floor || rows.what == FilledRows::What::ceiling;
        const double level = rows.what == FilledRows::What::ceiling ? ceiling : 0.0;
        drawRays(
            trace, rows, plot, eyeZ, [&](double slope) { return isPlane && slope != 0.0 ? std::abs((level - eyeZ) / slope) : plot.depth; }, picture);
    }
    for (const Hit& hit : trace.hits) {
        for (const FilledRows& rows : hit.filled) {
            drawRays(
                trace, rows, plot, eyeZ, [&](double slope) { return depthOf(hit, rows, eyeZ, slope); }, picture);
        }
    }
    drawDot(picture, panel, {plot.x(0.0), plot.y(eyeZ)}, 2.5 * scale + 1.0, {20, 20, 20, 200});
    drawDot(picture, panel, {plot.x(0.0), plot.y(eyeZ)}, 2.5 * scale, kEye);
}

}  // namespace slicecast
