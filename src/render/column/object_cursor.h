// The objects of a map that one column passes, nearest first: found as it goes on, some at a time.
#pragma once

#include "render/column/part_view.h"
#include "render/spans/grid_walk.h"
#include "render/view/frame_objects.h"

#include <cstddef>

namespace slicecast {

class ObjectCursor {
public:
    // The view must outlive the cursor.
    explicit ObjectCursor(const PartView& view) : view_(view) {}

    // Begins a part of a column, at `entered` along its ray. `nearest` is the least such place of
    // the columns that walk together: they share a list, which would begin anew before a nearer
    // one.
    void begin(int column, double nearest, double entered);
    void end();  // there are no more objects

    // The next place along the ray where an object is, or where one has to be looked for.
    double nextAlong() const { return any() ? object().along : knownTo_; }
    // How far along the ray all are known.
    double knownTo() const { return knownTo_; }
    void find(double from, double to);
    // Skips objects that the column passes by, and those that cover none of the rows [first, last).
    void skip(int first, int last);

    bool any() const { return objects_ != nullptr && next_ < objects_->objects.size(); }
    const FrameObject& object() const { return view_.vista->objects[objects_->objects[next_]]; }
    // Where the ray passes the next object, as a part of its width from the left.
    double across() const;
    // The ray at its depth, which is not a tile border.
    Crossing crossing() const;
    void pass();  // it has been met

private:
    const PartView& view_;
    int column_ = 0;
    const ColumnObjects* objects_ = nullptr;  // null in a map without objects
    std::size_t next_ = 0;                    // of them
    double nearest_ = 0.0;                    // see begin()
    double knownTo_ = kNever;
    double metDepth_ = 0.0;  // of the last one that was met
    int metIndex_ = -1;
};

}  // namespace slicecast
