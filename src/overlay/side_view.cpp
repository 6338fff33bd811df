// The slice inspector's view from the side.
#include "base/words.h"
#include "overlay/slice_inspector.h"

#include "overlay/beyond_portals.h"
#include "overlay/layout.h"
#include "overlay/lines.h"
#include "overlay/side_plot.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace slicecast {
namespace {

constexpr Colour kAxis = {168, 180, 192, 255};
constexpr Colour kAxisLine = {168, 180, 192, 120};
constexpr Colour kUnseenBlock = {104, 120, 140, 70};
constexpr Colour kSeenBlock = {120, 148, 184, 170};
constexpr Colour kBlockEdge = {226, 232, 240, 110};
constexpr Colour kEye = {255, 214, 74, 255};
constexpr Colour kEyeLevel = {255, 214, 74, 70};
constexpr int kRayAlpha = 110;
constexpr int kReflectedAlpha = 56;
constexpr int kObjectAlpha = 90;
constexpr int kRowsPerRay = 24;  // rows between rays to one run, for fine rays
constexpr double kLeastDepth = 4.0;
constexpr double kGreatestDepth = 200.0;
constexpr double kLeastHeight = 2.0;

// A top or an underside: heights are above the floor of the eye's map.
struct Surface {
    double height;
    double depth;  // where it has that height
    double rise;   // per unit of depth; 0 if it is level

    double at(double d) const { return height + rise * (d - depth); }
};

Surface topOf(const SliceTrace& trace, const Hit& hit, double eyeZ) {
    const double depth = hit.entered ? hit.depth : hit.backDepth;
    const double row = hit.entered ? hit.topFrontRow : hit.topBackRow;
    return {heightInRow(trace, eyeZ, row, depth), depth, hit.topSlope};
}
Surface bottomOf(const SliceTrace& trace, const Hit& hit, double eyeZ) {
    const double depth = hit.entered ? hit.depth : hit.backDepth;
    const double row = hit.entered ? hit.bottomFrontRow : hit.bottomBackRow;
    return {heightInRow(trace, eyeZ, row, depth), depth, hit.bottomSlope};
}

// The plot covers all visible parts of blocks and objects, and the eye.
SidePlot makePlot(const SliceTrace& trace, double eyeZ, PixelRect area, int scale) {
    double depth = 0.0;
    double lowest = 0.0;
    double highest = eyeZ;
    for (const Hit& hit : trace.hits) {
        if (hit.filled.empty()) continue;
        depth = std::max(depth, std::min(hit.backDepth, hit.depth + 4.0));
        const Surface top = topOf(trace, hit, eyeZ);
        const Surface bottom = bottomOf(trace, hit, eyeZ);
        highest = std::max({highest, top.at(hit.depth), top.at(hit.backDepth)});
        lowest = std::min({lowest, bottom.at(hit.depth), bottom.at(hit.backDepth)});
    }
    for (const SeenObject& object : trace.objects) {
        depth = std::max(depth, object.depth + 0.5);
        highest = std::max(highest, heightInRow(trace, eyeZ, object.first, object.depth));
    }
    for (const PassedPortal& portal : trace.portals) depth = std::max(depth, portal.depth + 2.0);
    if (depth == 0.0 && !trace.tiles.empty()) depth = trace.tiles.back().depth;
    return {.area = area,
            .scale = scale,
            .line = lineWidth(scale),
            .depth = std::clamp(depth * 1.08, kLeastDepth, kGreatestDepth),
            .lowest = lowest,
            .highest = std::max(highest + 0.4, kLeastHeight),
            .eyeZ = eyeZ};
}

// A distance between marks of 1, 2, 5, 10 ... units that keeps them `least` pixels apart.
double markStep(double units, int pixels, int least) {
    double step = 1.0;
    for (int i = 0; step * pixels < least * units; ++i) step *= i % 3 == 1 ? 2.5 : 2.0;
    return step;
}

void drawAxes(const SidePlot& plot, const Picture& picture) {
    std::array<char, 16> text;
    const int scale = plot.scale;
    const int bottom = plot.area.y + plot.area.height;
    blendRect(picture, {plot.area.x, bottom, plot.area.width, plot.line}, kAxisLine);
    blendRect(picture, {plot.area.x - 1, plot.area.y, 1, plot.area.height + 1}, kAxisLine);

    // Depths below, heights on the left; "+ 0.0" turns -0 into 0
    const double across = markStep(plot.depth, plot.area.width, 30 * scale);
    for (double depth = across; depth < plot.depth * 0.97; depth += across) {
        const std::string_view label = write(text, Fixed{depth, 0});
        const int x = static_cast<int>(plot.x(depth));
        blendRect(picture, {x, bottom, plot.line, 3 * scale}, kAxis);
        drawText(picture, x - textWidth(label, scale) / 2, bottom + 4 * scale, label,
                 {.colour = kAxis, .scale = scale});
    }
    const double up = markStep(plot.highest - plot.lowest, plot.area.height, 14 * scale);
    for (double height = std::ceil(plot.lowest / up) * up + 0.0; height < plot.highest;
         height += up) {
        const std::string_view label = write(text, Fixed{height, 0});
        const int y = static_cast<int>(plot.y(height));
        if (y - 4 * scale < plot.area.y) break;
        blendRect(picture, {plot.area.x - 3 * scale, y, 3 * scale, plot.line}, kAxis);
        drawText(picture, plot.area.x - 5 * scale - textWidth(label, scale), y - 3 * scale, label,
                 {.colour = kAxis, .scale = scale});
    }
    const int eyeRow = static_cast<int>(plot.y(plot.eyeZ));
    for (int x = plot.area.x; x < plot.area.x + plot.area.width; x += 4 * scale)
        blendRect(picture, {x, eyeRow, 2 * scale, plot.line}, kEyeLevel);
}

// Behind portals only visible blocks: other rays may be elsewhere at the same depth.
void drawBlocks(const SliceTrace& trace, const SidePlot& plot, const Picture& picture) {
    for (const Hit& hit : trace.hits) {
        if (hit.depth >= plot.depth || (hit.portals > 0 && hit.filled.empty())) continue;
        const int left = static_cast<int>(plot.x(hit.depth));
        const int right = std::max(left + 1, static_cast<int>(plot.x(hit.backDepth)));
        const Surface above = topOf(trace, hit, plot.eyeZ);
        const Surface below = bottomOf(trace, hit, plot.eyeZ);
        const auto blendInside = [&](PixelRect rect, Colour colour) {
            blendRect(picture, shared(rect, plot.area), colour);
        };
        // A block with slopes column by column, any other at once
        const bool hasSlopes = above.rise != 0.0 || below.rise != 0.0;
        const double perPixel = (hit.backDepth - hit.depth) / (right - left);
        for (int x = left; x < right; x += hasSlopes ? 1 : right - left) {
            const double depth = hit.depth + perPixel * (x - left + 0.5);
            const int width = hasSlopes ? 1 : right - left;
            double high = hasSlopes ? above.at(depth) : above.height;
            double low = hasSlopes ? below.at(depth) : below.height;
            if (hasSlopes && hit.portals == 0) {  // a part of what moves ends with its cell
                constexpr double kRounding = 1e-6;
                high = std::min(high, hit.top.value());
                low = std::max(low, hit.bottom.value());
                if (high < low - kRounding) continue;
            }
            const int top = static_cast<int>(plot.y(high));
            const int bottom = std::max(top + 1, static_cast<int>(plot.y(low)));
            blendInside({x, top, width, bottom - top},
                        hit.filled.empty() ? kUnseenBlock : kSeenBlock);
            blendInside({x, top, width, plot.line}, kBlockEdge);
            if (x == left) blendInside({left, top, plot.line, bottom - top}, kBlockEdge);
        }
    }
}

// What rays meet: a horizontal plane at a height, or anything else. A thick line is drawn for solid
// things.
struct Met {
    Colour colour;
    bool isThing = true;
    bool isLevel = false;
    double height = 0.0;
};

// Rays to the first and the last of some rows and to some between, and the thing seen there as a
// thick line.
template <typename DepthOf>
void drawRays(const SliceTrace& trace, int first, int last, const SidePlot& plot, const Met& met,
              DepthOf depthOf, const Picture& picture) {
    const int rowsPerRay = kRowsPerRay * plot.line;
    const int count = std::max(1, (last - first + rowsPerRay - 1) / rowsPerRay);
    Point before;
    for (int i = 0; i <= count; ++i) {
        const double slope =
            slopeOfRow(trace, first + static_cast<double>(last - first) * i / count);
        const double depth = depthOf(slope);
        const Point rayEnd = plot.onRay(slope, depth);
        drawLine(picture, plot.area, {plot.x(0.0), plot.y(plot.eyeZ)}, rayEnd,
                 withAlpha(met.colour, kRayAlpha), plot.line);
        // A plane stays level where it goes beyond the plot
        const Point end = met.isLevel ? Point{plot.x(depth), plot.y(met.height)} : rayEnd;
        if (i > 0 && met.isThing) {
            const bool upright = std::abs(end.y - before.y) > std::abs(end.x - before.x);
            for (int k = 0; k <= plot.scale; ++k) {
                const Point by = {upright ? -k : 0.0, upright ? 0.0 : -k};
                drawLine(picture, plot.area, {before.x + by.x, before.y + by.y},
                         {end.x + by.x, end.y + by.y}, met.colour);
            }
        }
        before = end;
    }
}

// The depth at which a ray is at a height.
double depthAt(const SidePlot& plot, double height, double slope) {
    return slope != 0.0 ? std::abs((height - plot.eyeZ) / slope) : plot.depth;
}

void drawPlanes(const SliceTrace& trace, const World& world, int eyeMap, const SidePlot& plot,
                const Picture& picture) {
    for (const FilledRows& rows : trace.planes) {
        const Beyond beyond = beyondPortals(trace, world, eyeMap, rows.first);
        const bool isCeiling = rows.what == FilledRows::What::ceiling;
        const bool isPlane = isCeiling || rows.what == FilledRows::What::floor;
        const double height =
            (isCeiling ? world.maps[static_cast<std::size_t>(beyond.map)].ceiling.height.value()
                       : 0.0) -
            beyond.levels;
        drawRays(
            trace, rows.first, rows.last, plot,
            {.colour = kindColour(rows.what),
             .isThing = rows.what != FilledRows::What::sky,
             .isLevel = isPlane,
             .height = height},
            [&](double slope) { return isPlane ? depthAt(plot, height, slope) : plot.depth; },
            picture);
    }
}

void drawHits(const SliceTrace& trace, const SidePlot& plot, const Picture& picture) {
    for (const Hit& hit : trace.hits) {
        for (const FilledRows& rows : hit.filled) {
            const bool isSide = rows.what == FilledRows::What::side;
            const double sideDepth =
                hit.entered && rows.face == hit.face ? hit.depth : hit.backDepth;
            const Surface plane = rows.what == FilledRows::What::roof
                                      ? topOf(trace, hit, plot.eyeZ)
                                      : bottomOf(trace, hit, plot.eyeZ);
            const bool isLevel = !isSide && plane.rise == 0.0;
            const auto planeDepth = [&](double slope) {
                if (isLevel) return depthAt(plot, plane.height, slope);
                const double over = plane.at(0.0) - plot.eyeZ;
                return slope != plane.rise ? over / (slope - plane.rise) : hit.backDepth;
            };
            drawRays(
                trace, rows.first, rows.last, plot,
                {.colour = kindColour(rows.what), .isLevel = isLevel, .height = plane.height},
                [&](double slope) {
                    return isSide ? sideDepth
                                  : std::clamp(planeDepth(slope), hit.depth, hit.backDepth);
                },
                picture);
        }
    }
}

// Each object as a faint bar, its visible part as a strong one.
void drawObjects(const SliceTrace& trace, const World& world, int eyeMap, const SidePlot& plot,
                 const Picture& picture) {
    for (const SeenObject& seen : trace.objects) {
        if (seen.depth > plot.depth) continue;
        const Object& object = world.maps[static_cast<std::size_t>(seen.map)]
                                   .objects[static_cast<std::size_t>(seen.object)];
        const int levels = beyondPortals(trace, world, eyeMap, seen.first).levels;
        const int x = static_cast<int>(plot.x(seen.depth));
        const int top = static_cast<int>(plot.y((object.z + object.height).value() - levels));
        const int bottom = static_cast<int>(plot.y(object.z.value() - levels));
        blendRect(picture,
                  shared({x - plot.scale, top, 2 * plot.scale + 1, bottom - top}, plot.area),
                  withAlpha(kObjectColour, kObjectAlpha));
        drawRays(
            trace, seen.first, seen.last, plot, {.colour = kObjectColour},
            [&](double) { return seen.depth; }, picture);
    }
}

// Mirrors as dashed lines, with a few of the reflected rays.
void drawMirrors(const SliceTrace& trace, const World& world, int eyeMap, const SidePlot& plot,
                 const Picture& picture) {
    for (const MirroredRows& mirror : trace.mirrors) {
        const double height =
            mirror.height.value() - beyondPortals(trace, world, eyeMap, mirror.first).levels;
        const auto depthOfRow = [&](double row) {
            return std::min(depthAt(plot, height, slopeOfRow(trace, row)), plot.depth);
        };
        const int left = static_cast<int>(plot.x(depthOfRow(mirror.last)));
        const int right = static_cast<int>(plot.x(depthOfRow(mirror.first)));
        const int y = static_cast<int>(plot.y(height));
        for (int x = left; x < right; x += 6 * plot.scale) {
            blendRect(
                picture,
                shared({x, y - 3 * plot.scale, std::min(3 * plot.scale, right - x), plot.scale},
                       plot.area),
                kMirrorColour);
        }
        for (const double part : {0.0, 0.5, 1.0}) {
            const double row = mirror.first + part * (mirror.last - mirror.first);
            const double slope = slopeOfRow(trace, row);
            const double from = depthOfRow(row);
            if (from >= plot.depth || slope >= 0.0) continue;
            const double to = std::min(plot.depth, from + (plot.highest - height) / -slope);
            drawLine(picture, plot.area, {plot.x(from), plot.y(height)},
                     {plot.x(to), plot.y(height - slope * (to - from))},
                     withAlpha(kMirrorColour, kReflectedAlpha), plot.line);
        }
    }
}

// Vertical lines where rays pass a portal, with the name of the map behind it if there is room.
void drawPortals(const SliceTrace& trace, const World& world, const SidePlot& plot,
                 const Picture& picture) {
    int labelled = plot.area.x;
    for (const PassedPortal& passed : trace.portals) {
        if (passed.depth >= plot.depth) continue;
        const int x = static_cast<int>(plot.x(passed.depth));
        const int top =
            static_cast<int>(plot.onRay(slopeOfRow(trace, passed.first), passed.depth).y);
        const int bottom =
            static_cast<int>(plot.onRay(slopeOfRow(trace, passed.last), passed.depth).y);
        blendRect(picture,
                  shared({x, top, std::max(1, plot.scale / 2), bottom - top + 1}, plot.area),
                  kPortalColour);
        const std::string_view name =
            world.maps[static_cast<std::size_t>(world.portals[passed.portal].toMap)].name;
        const int width = textWidth(name, plot.scale);
        const int left = x + 3 * plot.scale;
        if (x < labelled || left + width > plot.area.x + plot.area.width) continue;
        blendRect(
            picture,
            {left - plot.scale, plot.area.y, width + 2 * plot.scale, kGlyphHeight * plot.scale},
            kPanelColour);
        drawText(picture, left, plot.area.y + plot.scale, name,
                 {.colour = kPortalColour, .scale = plot.scale});
        labelled = left + width + 3 * plot.scale;
    }
}

bool isSeen(const SliceTrace& trace, FilledRows::What what) {
    if (what == FilledRows::What::object) return !trace.objects.empty();
    const auto among = [what](const std::vector<FilledRows>& filled) {
        return std::any_of(filled.begin(), filled.end(),
                           [what](const FilledRows& rows) { return rows.what == what; });
    };
    return among(trace.planes) || std::any_of(trace.hits.begin(), trace.hits.end(),
                                              [&](const Hit& hit) { return among(hit.filled); });
}

// Names the colours of this slice.
class Legend {
public:
    explicit Legend(const SliceTrace& trace) {
        for (const SliceKind& kind : sliceKinds())
            add(isSeen(trace, kind.what), kind.name, kind.colour);
        add(!trace.portals.empty(), "portal", kPortalColour);
        add(!trace.mirrors.empty(), "mirror", kMirrorColour);
    }

    int width(int scale) const {
        int sum = 0;
        for (int i = 0; i < count_; ++i) sum += textWidth(entry(i).name, scale) + 14 * scale;
        return sum;
    }
    void draw(const Picture& picture, int x, int y, int scale) const {
        for (int i = 0; i < count_; ++i) {
            blendRect(picture, {x, y + scale, 5 * scale, 5 * scale}, entry(i).colour);
            drawText(picture, x + 7 * scale, y, entry(i).name, {.colour = kAxis, .scale = scale});
            x += textWidth(entry(i).name, scale) + 14 * scale;
        }
    }

private:
    struct Entry {
        const char* name;
        Colour colour;
    };
    const Entry& entry(int i) const { return entries_[static_cast<std::size_t>(i)]; }
    void add(bool isThere, const char* name, Colour colour) {
        if (isThere) entries_[static_cast<std::size_t>(count_++)] = {name, colour};
    }

    std::array<Entry, FilledRows::kWhats + 2> entries_{};
    int count_ = 0;
};

// The slice's number, and the legend against the right edge.
void drawTitle(const SliceTrace& trace, PixelRect panel, int scale, const Picture& picture) {
    std::array<char, 64> text;
    std::string_view title = write(text, {"slice ", trace.column, "   ", trace.hits.size(),
                                          " blocks   ", trace.tiles.size(), " tiles"});
    const int room = panel.width - 2 * kPanelPadding * scale;
    const Legend legend(trace);
    const int gap = kGlyphAdvance * scale;
    // Only the slice's number if not all fits
    if (textWidth(title, scale) + gap + legend.width(scale) > room)
        title = title.substr(0, title.find("   "));
    while (textWidth(title, scale) > room) title.remove_suffix(1);
    const int y = panel.y + kPanelPadding * scale;
    drawText(picture, panel.x + kPanelPadding * scale, y, title, {.scale = scale});
    if (textWidth(title, scale) + gap + legend.width(scale) > room) return;
    legend.draw(picture,
                panel.x + panel.width - kPanelPadding * scale - legend.width(scale) + 7 * scale, y,
                scale);
}

}  // namespace

void drawSideView(const SliceTrace& trace, const World& world, const Eye& eye,
                  const Picture& picture) {
    const OverlayLayout layout = layoutOverlays(picture.width, picture.height);
    const PixelRect panel = layout.sideView;
    if (panel.width == 0 || eye.map < 0 || static_cast<std::size_t>(eye.map) >= world.maps.size())
        return;
    const int scale = layout.scale;
    const int padding = kPanelPadding * scale;
    drawPanel(picture, panel, scale);
    drawTitle(trace, panel, scale, picture);

    // Space for the title above, depth labels below and height labels on the left
    const int above = padding + (kGlyphHeight + 3) * scale;
    const int below = padding + (kGlyphHeight + 3) * scale;
    const int beside = padding + (2 * kGlyphAdvance + 5) * scale;
    const SidePlot plot = makePlot(trace, eye.z.value(),
                                   {panel.x + beside, panel.y + above,
                                    panel.width - beside - padding, panel.height - above - below},
                                   scale);
    drawAxes(plot, picture);
    drawBlocks(trace, plot, picture);
    drawPlanes(trace, world, eye.map, plot, picture);
    drawHits(trace, plot, picture);
    drawObjects(trace, world, eye.map, plot, picture);
    drawMirrors(trace, world, eye.map, plot, picture);
    drawPortals(trace, world, plot, picture);
    const Point eyePoint = {plot.x(0.0), plot.y(plot.eyeZ)};
    drawDot(picture, panel, eyePoint, 2.5 * scale + 1.0, {20, 20, 20, 200});
    drawDot(picture, panel, eyePoint, 2.5 * scale, kEye);
}

}  // namespace slicecast
