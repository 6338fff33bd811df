// Objects that a slice meets.
#include "base/bits.h"
#include "render/slice_walk.h"
#include "render/texel_cut.h"

#include <algorithm>

namespace slicecast {

// Meets a tile that holds objects. Each object splits the tile's stretch of the ray in two, because
// the tile's contents may be before or behind it.
void SliceWalk::meetTileWithObjects() {
    const Crossing leave = leave_;
    for (; nextObjectAlong() < leave.along; ++object_, skipHiddenObjects()) {
        const FrameObject& object = this->object();
        leave_ = crossingAt(object);
        meetStretch();
        meetObject(object);
        enter_ = leave_;
    }
    leave_ = leave;
    meetStretch();
}

// Meets objects outside the grid, where there is only the floor.
void SliceWalk::meetObjectsBeyond() {
    if (objectsTo_ < kNever) findObjects(kNever);
    for (skipHiddenObjects(); hasObject() && !open_.none(); ++object_, skipHiddenObjects()) {
        const FrameObject& object = this->object();
        leave_ = crossingAt(object);
        takeFloorBeyond(rowBelow(floorRise_, leave_));
        meetObject(object);
    }
}

// Finds the objects from the current tile on, up to some place along the ray and at least a unit
// more.
void SliceWalk::findObjects(double to) {
    const double distance = projection_->distance;
    objects_ =
        &vista_->objects.inColumn(column_, walk_.entered * distance - 1.0, to * distance + 1.0);
    objectsTo_ = objects_->to / distance;
    for (object_ = 0; hasObject() && object().along < walk_.entered;) ++object_;
}

// Several columns share a list of objects; skips those that this one passes by, and those whose
// rows are closed. A full column has no more objects.
void SliceWalk::skipHiddenObjects() {
    if (isFull()) {
        objects_ = nullptr;
        objectsTo_ = kNever;
    }
    for (; hasObject(); ++object_) {
        const FrameObject& object = this->object();
        if (!open_.mayHold(object.firstRow, object.lastRow)) continue;
        const double share = across(object);
        if (share >= 0.0 && share < 1.0) return;
    }
}

// Where the ray passes an object, as a part of its width from the left.
double SliceWalk::across(const FrameObject& object) const {
    return (projection_->sidewaysSlope(column_) * object.depth - object.left) / object.width;
}

// The ray at an object's depth, which is not a tile border.
Crossing SliceWalk::crossingAt(const FrameObject& object) const {
    Crossing at;
    at.along = object.along;
    at.distance = object.depth;
    at.speed = projection_->distance;
    at.rowsPerRaw = projection_->distance / object.depth * (1.0 / 65536.0);
    at.border = false;
    return at;
}

// Adds an object's column of texels. A row exactly through the lower edge is on the object, one
// through the upper edge is not.
void SliceWalk::meetObject(const FrameObject& object) {
    const SpriteLevel& level = *object.level;
    const int u = std::min(level.width - 1, static_cast<int>(across(object) * level.width));
    // Positions are in texels from the upper edge, with 32 fractional bits
    constexpr double kTexel = 4294967296.0;
    const double perUnit = level.height * kTexel / ((object.top - object.bottom) / 65536.0);
    const double perRow = object.along;
    const auto end = static_cast<std::int64_t>(level.height) << 32;
    const SpriteId sprite = map_->objects[static_cast<std::size_t>(object.index)].sprite;
    bool drawn = false;
    const int firstRow =
        object.top <= clip_.high
            ? object.firstRow
            : FrameObjects::firstRowBelow(*projection_, clip_.high, object.depth, true);
    const int lastRow = object.bottom >= clip_.low
                            ? object.lastRow
                            : FrameObjects::firstRowBelow(*projection_, clip_.low, object.depth);
    const auto add = [&](const TexelColumn& column, int first, int last, bool layer) {
        if (!layer) open_.take(first, last);
        Span& span = this->add(What::object, first, last);
        span.layer = layer;
        span.object = object.index;
        span.image = sprite;
        span.column = column;
    };
    for (const auto& [first, last] : open_.within(firstRow, lastRow)) {
        const double down = object.top / 65536.0 - (projection_->horizon - (first + 0.5)) * perRow;
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
        if (cuts_) {
            cutTexels(column, level.runs.of(u), first, last, cutMargin(), add);
        } else {
            add(column, first, last, true);
        }
        drawn = true;
    }
    if (drawn) ++report_.objectSlices;
}

}  // namespace slicecast
