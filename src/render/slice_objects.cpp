// Objects that a slice meets.
#include "base/bits.h"
#include "render/slice_column.h"
#include "render/texel_cut.h"

#include <algorithm>

namespace slicecast {

// Finds the objects between two places along the ray, and at least a unit more. Columns share a
// list, which others may have made longer: what this one has met stays behind it.
void SliceColumn::findObjects(double from, double to) {
    const double distance = view_.projection->distance;
    objects_ = &view_.vista->objects.inColumn(number, from * distance - 1.0, to * distance + 1.0);
    objectsTo_ = objects_->to / distance;
    const auto isBehind = [&](const FrameObject& object) {
        return object.along < from || object.depth < metDepth_ ||
               (object.depth == metDepth_ && object.index <= metIndex_);
    };
    for (object_ = 0; hasObject() && isBehind(object());) ++object_;
}

// Several columns share a list of objects. A full column has no more objects.
void SliceColumn::skipObjects(int first, int last) {
    if (found_->isFull()) {
        objects_ = nullptr;
        objectsTo_ = kNever;
    }
    for (; hasObject(); ++object_) {
        const FrameObject& object = this->object();
        if (first >= last || object.firstRow >= object.lastRow || object.lastRow <= first ||
            object.firstRow >= last)
            continue;
        const double share = across(object);
        if (share >= 0.0 && share < 1.0) return;
    }
}

// Where the ray passes an object, as a part of its width from the left.
double SliceColumn::across(const FrameObject& object) const {
    return (view_.projection->sidewaysSlope(number) * object.depth - object.left) / object.width;
}

// The ray at the next object's depth, which is not a tile border.
Crossing SliceColumn::crossingAtObject() const {
    const FrameObject& object = this->object();
    Crossing at;
    at.along = object.along;
    at.distance = object.depth;
    at.speed = view_.projection->distance;
    at.rowsPerRaw = view_.projection->distance / object.depth * (1.0 / 65536.0);
    at.border = false;
    return at;
}

// Adds the next object's column of texels. A row exactly through the lower edge is on the object,
// one through the upper edge is not.
void SliceColumn::meetObject() {
    const FrameObject& object = this->object();
    const SpriteLevel& level = *object.level;
    const int u = std::min(level.width - 1, static_cast<int>(across(object) * level.width));
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
    metDepth_ = object.depth;
    metIndex_ = object.index;
    ++object_;
}

}  // namespace slicecast
