#include "overlay/slice_inspector.h"

#include "overlay/layout.h"

#include <array>

namespace slicecast {
namespace {

constexpr Colour kSliceLine = {255, 255, 255, 220};
constexpr Colour kBesideSliceLine = {0, 0, 0, 150};

constexpr auto kKinds = std::to_array<SliceKind>({
    {FilledRows::What::side, "side", {255, 196, 92, 255}},
    {FilledRows::What::roof, "roof", {242, 112, 92, 255}},
    {FilledRows::What::underside, "under", {206, 140, 240, 255}},
    {FilledRows::What::floor, "floor", {132, 214, 112, 255}},
    {FilledRows::What::ceiling, "ceiling", {255, 158, 188, 255}},
    {FilledRows::What::sky, "sky", {112, 178, 255, 255}},
    {FilledRows::What::haze, "haze", {186, 192, 200, 255}},
    {FilledRows::What::object, "object", kObjectColour},
});
static_assert([] {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        if (kKinds[i].what != static_cast<FilledRows::What>(i)) return false;
    }
    return kKinds.size() == FilledRows::kWhats;
}());

}  // namespace

std::span<const SliceKind> sliceKinds() {
    return kKinds;
}

Colour kindColour(FilledRows::What what) {
    return kKinds[static_cast<std::size_t>(what)].colour;
}

void drawSliceLine(const SliceTrace& trace, const Picture& picture) {
    const int scale = readableScale(picture.width, picture.height);
    const int stripe = 3 * scale;
    // Near the right edge the stripes are to the left of the line.
    const bool left = trace.column + 1 + 2 * stripe > picture.width;
    const auto stripeAt = [&](int from, int width) {
        return left ? trace.column - from - width : trace.column + 1 + from;
    };
    blendRect(picture, {trace.column - 1, 0, 1, picture.height}, kBesideSliceLine);
    blendRect(picture, {trace.column + 1, 0, 1, picture.height}, kBesideSliceLine);
    blendRect(picture, {trace.column, 0, 1, picture.height}, kSliceLine);
    const auto mark = [&](int first, int last, Colour colour) {
        blendRect(picture, {stripeAt(0, stripe), first, stripe, last - first},
                  withAlpha(colour, 235));
        blendRect(picture, {stripeAt(0, stripe), first, stripe, 1}, {0, 0, 0, 200});
    };
    for (const FilledRows& rows : trace.planes) mark(rows.first, rows.last, kindColour(rows.what));
    for (const Hit& hit : trace.hits) {
        for (const FilledRows& rows : hit.filled)
            mark(rows.first, rows.last, kindColour(rows.what));
    }
    for (const SeenObject& object : trace.objects) mark(object.first, object.last, kObjectColour);

    // A second stripe marks rows that went through a portal or are mirrored
    const auto markBeside = [&](int first, int last, Colour colour) {
        blendRect(picture, {stripeAt(stripe + scale, 2 * scale), first, 2 * scale, last - first},
                  withAlpha(colour, 235));
    };
    for (const PassedPortal& portal : trace.portals) {
        if (portal.portals == 0) markBeside(portal.first, portal.last, kPortalColour);
    }
    for (const MirroredRows& mirror : trace.mirrors)
        markBeside(mirror.first, mirror.last, kMirrorColour);
}

}  // namespace slicecast
