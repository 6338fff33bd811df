#include "render/column/object_cursor.h"

namespace slicecast {

void ObjectCursor::begin(int column, double nearest, double entered) {
    column_ = column;
    nearest_ = nearest;
    end();
    metDepth_ = 0.0;
    metIndex_ = -1;
    if (view_.vista->objects.none()) return;
    find(entered, entered);
}

void ObjectCursor::end() {
    objects_ = nullptr;
    next_ = 0;
    knownTo_ = kNever;
}

// Finds the objects between two places along the ray, and at least a unit more. Others may have
// made the list longer: what this column has met stays behind it.
void ObjectCursor::find(double from, double to) {
    const double distance = view_.projection->distance;
    objects_ =
        &view_.vista->objects.inColumn(column_, nearest_ * distance - 1.0, to * distance + 1.0);
    knownTo_ = objects_->to / distance;
    const auto isBehind = [&](const FrameObject& object) {
        return object.along < from || object.depth < metDepth_ ||
               (object.depth == metDepth_ && object.index <= metIndex_);
    };
    for (next_ = 0; any() && isBehind(object());) ++next_;
}

void ObjectCursor::skip(int first, int last) {
    for (; any(); ++next_) {
        const FrameObject& object = this->object();
        if (first >= last || object.firstRow >= object.lastRow || object.lastRow <= first ||
            object.firstRow >= last)
            continue;
        const double share = across();
        if (share >= 0.0 && share < 1.0) return;
    }
}

double ObjectCursor::across() const {
    const FrameObject& object = this->object();
    return (view_.projection->sidewaysSlope(column_) * object.depth - object.left) / object.width;
}

Crossing ObjectCursor::crossing() const {
    const FrameObject& object = this->object();
    Crossing at;
    at.along = object.along;
    at.distance = object.depth;
    at.speed = view_.projection->distance;
    at.rowsPerRaw = view_.projection->distance / object.depth * (1.0 / 65536.0);
    at.border = false;
    return at;
}

void ObjectCursor::pass() {
    metDepth_ = object().depth;
    metIndex_ = object().index;
    ++next_;
}

}  // namespace slicecast
