// The spans of a slice as text, by their bare numbers, for the messages of tests: a line for each,
// in their order. tests/render/span_text.h tells the same by names.
//
//     rows   12-40   layer side north   map 0  tile 3,4 level 1  texture 5  depth 2.5 ...
//     rows   40-64         floor        map 0  tile 1,4 to 3,4  texture 2  rise -32768 light 1
#pragma once

#include "render/spans/slice_spans.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace slicecast {

inline const char* nameOf(FilledRows::What what) {
    constexpr const char* kNames[] = {"side",    "roof", "underside", "floor",
                                      "ceiling", "sky",  "haze",      "object"};
    return kNames[static_cast<int>(what)];
}

inline bool isPlane(const Span& span) {
    using What = FilledRows::What;
    return span.what == What::roof || span.what == What::underside || span.what == What::floor ||
           span.what == What::ceiling;
}

inline bool hasTexelColumn(const Span& span) {
    return span.what == FilledRows::What::side || span.what == FilledRows::What::object;
}

// Appends what printf would print.
template <typename... Values>
void appendFormatted(std::string& text, const char* format, Values... values) {
    char line[200];
    std::snprintf(line, sizeof line, format, values...);
    text += line;
}

// Without its rows and without an end of line.
inline std::string textOf(const Span& span) {
    using What = FilledRows::What;
    std::string text;
    const std::string name =
        std::string(nameOf(span.what)) +
        (span.what == What::side
             ? std::string(" ") + kFaceNames[static_cast<std::size_t>(span.face)]
             : std::string());
    appendFormatted(text, "%s%-16s map %d", span.layer ? "layer " : "      ", name.c_str(),
                    span.vista->viewpoint.map);
    if (span.portals > 0) appendFormatted(text, " portals %d", span.portals);
    if (span.vista->viewpoint.upsideDown) text += " mirrored";
    if (span.what == What::object) appendFormatted(text, "  object %d", span.object);
    const TileRange& tiles = span.tiles;
    if (span.what == What::side || isPlane(span)) {
        appendFormatted(text, "  tile %d,%d", tiles.fromX, tiles.fromY);
        if (tiles.toX != tiles.fromX || tiles.toY != tiles.fromY)
            appendFormatted(text, " to %d,%d", tiles.toX, tiles.toY);
        if (isPlane(span) && tiles.endless) text += " and on";
        if (span.level != kNoLevel) appendFormatted(text, " level %d", span.level);
    }
    if (isPlane(span) || hasTexelColumn(span))
        appendFormatted(text, "  texture %d",
                        static_cast<int>(isPlane(span) ? span.look->plane.texture : span.image));
    if (isPlane(span)) {
        appendFormatted(text, "  rise %d light %g%s%s", span.look->plane.rise,
                        span.look->plane.light, span.look->plane.glow ? " glow" : "",
                        span.look->plane.mirror ? " mirror" : "");
        if (span.look->plane.sloped)
            appendFormatted(text, "  sloped, %.9g above the eye, horizon %.9g", span.slope.height,
                            span.slope.horizon);
    }
    if (hasTexelColumn(span)) {
        const TexelColumn& column = span.column;
        appendFormatted(text, "  depth %.9g detail %d light %u fog %u texels %.6f + %.6f",
                        column.depth, column.detail, column.factor, column.fog,
                        std::ldexp(static_cast<double>(column.start), -column.shift),
                        std::ldexp(static_cast<double>(column.step), -column.shift));
    }
    return text;
}

inline std::string textOf(const ColumnSpans& column) {
    std::string text;
    for (const Span& span : column.spans) {
        appendFormatted(text, "rows %4d-%-4d ", span.first, span.last);
        text += textOf(span) + "\n";
    }
    for (const PortalSpan& span : column.portals)
        appendFormatted(text, "rows %4d-%-4d go through portal %d, after %d others, at depth %g\n",
                        span.first, span.last, static_cast<int>(span.portal), span.portals,
                        span.depth);
    for (const MirrorSpan& span : column.mirrors)
        appendFormatted(text, "rows %4d-%-4d mirror with strength %u, at a rise of %d\n",
                        span.first, span.last, span.strength, span.rise);
    return text;
}

inline std::string textOf(const SliceSpans& slice) {
    std::string text = "column " + std::to_string(slice.column) + "\n" + textOf(slice.upright);
    if (!slice.upright.mirrors.empty()) text += "in mirrors\n" + textOf(slice.reflected);
    return text;
}

}  // namespace slicecast
