// Objects that a slice meets.
#include "base/bits.h"
#include "render/column/slice_column.h"
#include "render/spans/texel_cut.h"

#include <algorithm>

namespace slicecast {

// Adds the next object's column of texels. A full column has no more objects. A row exactly through
// the lower edge is on the object, one through the upper edge is not.
void SliceColumn::meetObject() {
    if (isFull()) return objects.end();
    const FrameObject& object = objects.object();
    const SpriteLevel& level = *object.level;
    const int u = std::min(level.width - 1, static_cast<int>(objects.across() * level.width));
    // Positions are in texels from the upper edge, with 32 fractional bits
    constexpr double kTexel = 4294967296.0;
    const double perUnit = level.height * kTexel / ((object.top - object.bottom) / 65536.0);
    const double perRow = object.along;
    const auto end = static_cast<std::int64_t>(level.height) << 32;
    const SpriteId sprite = view_.map->objects[static_cast<std::size_t>(object.index)].sprite;
    bool drawn = false;
    const int firstRow =
        object.top <= view_.clip.high
            ? object.firstRow
            : FrameObjects::firstRowBelow(*view_.projection, view_.clip.high, object.depth, true);
    const int lastRow =
        object.bottom >= view_.clip.low
            ? object.lastRow
            : FrameObjects::firstRowBelow(*view_.projection, view_.clip.low, object.depth);
    const auto add = [&](const TexelColumn& column, int first, int last, bool layer) {
        if (!layer) open.take(first, last);
        Span& span = this->add(What::object, first, last);
        span.layer = layer;
        span.object = object.index;
        span.image = sprite;
        span.column = column;
    };
    for (const auto& [first, last] : open.within(firstRow, lastRow)) {
        const double down =
            object.top / 65536.0 - (view_.projection->horizon - (first + 0.5)) * perRow;
        const std::int64_t start = std::clamp<std::int64_t>(
            nearestInteger(std::clamp(down * perUnit, 0.0, static_cast<double>(end))), 0, end - 1);
        const int steps = last - first - 1;
        std::int64_t step =
            steps > 0 ? nearestInteger(std::min(perRow * perUnit, static_cast<double>(end))) : 0;
        if (start + steps * step >= end) step = (end - 1 - start) / steps;
        if (!countLayer()) continue;
        const TexelColumn column = {
            .texels = level.texels.data() +
                      static_cast<std::size_t>(u) * static_cast<std::size_t>(level.height),
            .start = static_cast<std::uint64_t>(start),
            .step = static_cast<std::uint64_t>(step),
            .depth = object.depth,
            .factor = object.factor,
            .fog = object.fog,
            .shift = 32,
            .detail = object.detail};
        if (view_.cuts) {
            cutTexels(column, level.runs.of(u), first, last, view_.cutMargin(), add);
        } else {
            add(column, first, last, true);
        }
        drawn = true;
    }
    if (drawn) ++report_.objectSlices;
    objects.pass();
}

}  // namespace slicecast
