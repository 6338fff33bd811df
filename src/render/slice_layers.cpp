// What a slice sees through. A see-through block closes no rows: the faces by which the ray enters and leaves it are gathered, nearest first, and laid over what
// lies behind when the walk is done. Its far faces count as much as its near ones.
#include "render/slice.h"

#include "base/bits.h"

#include <algorithm>

namespace slicecast {

// Of two touching see-through blocks of one blueprint the faces between them are left out.
bool Slice::joinsBeside(const Block& block, Border border) const {
    if (!block.blueprint->join) return false;
    const bool before = border == Border::enter;
    const int x = before ? beforeX(border) : behindX(border);
    const int y = before ? beforeY(border) : behindY(border);
    return &frame_.world->blueprints[map_->cell(x, y, block.level)] == block.blueprint;
}

// Whether the blocks of a level and the next in the current tile touch, and are of one blueprint or parts of one thing that moves.
bool Slice::joinsAbove(int level) const {
    const std::vector<CellBlueprint>& blueprints = frame_.world->blueprints;
    const CellBlueprint& lower = blueprints[map_->cell(walk_.tileX, walk_.tileY, level)];
    const CellBlueprint& upper = blueprints[map_->cell(walk_.tileX, walk_.tileY, level + 1)];
    const bool touch = lower.top == tileEdge(1) && upper.bottom == Coordinate{0};
    return touch && lower.join && (&lower == &upper || (lower.mover >= 0 && lower.mover == upper.mover));
}

void Slice::enterThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!open_.mayHold(firstRow, lastRow) || joinsBeside(block, Border::enter)) return;
    seeThroughSide(block, enteredFace(enter_), enter_, sideView(enter_), firstRow, lastRow);
}

void Slice::leaveThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!leave_.border || leave_.along <= 0.0 || !open_.mayHold(firstRow, lastRow) || joinsBeside(block, Border::leave)) return;
    seeThroughSide(block, leftFace(leave_), leave_, sideView(leave_), firstRow, lastRow);
}

void Slice::passThroughTop(const Block& block, int firstRow, int lastRow) {
    if (!open_.mayHold(firstRow, lastRow) || joinsAbove(block.level)) return;
    const FaceBlueprint& look = block.blueprint->face(Face::top);
    seeThroughPlane(block.level, FilledRows::What::roof,
                    {{block.top, look.texture, look.light, look.glow, false, false}, firstRow, lastRow, walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY, false});
}

void Slice::passThroughBottom(const Block& block, int firstRow, int lastRow) {
    if (!open_.mayHold(firstRow, lastRow) || joinsAbove(block.level - 1)) return;
    const FaceBlueprint& look = block.blueprint->face(Face::bottom);
    seeThroughPlane(block.level, FilledRows::What::underside,
                    {{block.bottom, look.texture, look.light, look.glow, true, false}, firstRow, lastRow, walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY, false});
}

void Slice::seeThroughPlane(int level, FilledRows::What what, const PlaneRun& run) {
    open_.each(run.first, run.last, [&](int first, int last) {
        PlaneRun part = run;
        part.first = first;
        part.last = last;
        layers_->add(part, *vista_);
        note(level, what, what == FilledRows::What::roof ? Face::top : Face::bottom, first, last);
    });
}

// Objects that this column's ray passes, in the current tile: each splits the tile's stretch of the ray in two, for what the tile holds may lie before it or
// behind it.
void Slice::drawTileWithObjects() {
    const Crossing leave = leave_;
    while (object_ != objectsEnd_ && vista_->objects[*object_].along < leave.along) {
        const FrameObject& object = vista_->objects[*object_];
        leave_ = crossingAt(object);
        drawStretch();
        drawObject(object);
        enter_ = leave_;
        ++object_;
        skipObjectsBeside();
    }
    leave_ = leave;
    drawStretch();
}

// Objects outside the grid, where there is only the floor.
void Slice::drawObjectsBeyond() {
    while (object_ != objectsEnd_ && !open_.none()) {
        const FrameObject& object = vista_->objects[*object_];
        leave_ = crossingAt(object);
        takeFloorBeyond(rowBelow(floorRise_, leave_));
        drawObject(object);
        ++object_;
        skipObjectsBeside();
    }
}

// Several columns share a list of objects; those that this one passes by split nothing.
void Slice::skipObjectsBeside() {
    const auto isBeside = [&](double share) { return share < 0.0 || share >= 1.0; };
    while (object_ != objectsEnd_ && isBeside(across(vista_->objects[*object_]))) ++object_;
}

// Where the ray passes an object, as a share of its width from the left.
double Slice::across(const FrameObject& object) const {
    return (projection_->sidewaysSlope(column_) * object.depth - object.left) / object.width;
}

// The ray where it comes to an object's depth; no border of a tile.
Crossing Slice::crossingAt(const FrameObject& object) const {
    Crossing at;
    at.along = object.along;
    at.distance = object.depth;
    at.speed = projection_->distance;
    at.rowsPerRaw = projection_->distance / object.depth * (1.0 / 65536.0);
    at.border = false;
    return at;
}

// An object's column of texels that this slice shows. A row through the lower edge's height is on the object, one through the upper edge's is not.
void Slice::drawObject(const FrameObject& object) {
    const SpriteLevel& level = *object.level;
    const int u = std::min(level.width - 1, static_cast<int>(across(object) * level.width));
    const std::int32_t top = object.top - eyeZ_;
    const std::int32_t bottom = object.bottom - eyeZ_;
    const auto rowOf = [&](std::int32_t rise) {
        return projection_->firstRowBelowRow(projection_->horizon - rise / 65536.0 * projection_->distance / object.depth, false);
    };
    // Positions are in texels from the upper edge, with 32 bits after the point.
    constexpr double kTexel = 4294967296.0;
    const double perUnit = level.height * kTexel / ((top - bottom) / 65536.0);
    const double perRow = object.along;
    const auto end = static_cast<std::int64_t>(level.height) << 32;
    bool drawn = false;
    open_.each(rowOf(std::min(top, clip_.high)), rowOf(std::max(bottom, clip_.low)), [&](int first, int last) {
        const double down = top / 65536.0 - (projection_->horizon - (first + 0.5)) * perRow;
        const std::int64_t start = std::clamp<std::int64_t>(nearestInteger(std::clamp(down * perUnit, 0.0, static_cast<double>(end))), 0, end - 1);
        const int steps = last - first - 1;
        std::int64_t step = steps > 0 ? nearestInteger(std::min(perRow * perUnit, static_cast<double>(end))) : 0;
        if (start + steps * step >= end) step = (end - 1 - start) / steps;
        layers_->add({level.texels.data() + static_cast<std::size_t>(u) * static_cast<std::size_t>(level.height), 32, first, last,
                      static_cast<std::uint64_t>(start), static_cast<std::uint64_t>(step), object.factor, object.fog, vista_->lighting.haze});
        drawn = true;
    });
    if (drawn) ++report_.objectSlices;
}

// Lays what was seen through over the finished rows, from back to front.
void Slice::layOver() {
    report_.layers += static_cast<std::int64_t>(layers_->count());
    layers_->fromBack(
        [&](const SideRun& run) {
            count(run.first, run.last);
            fillSide(pixels_ + run.first, run.last - run.first, run.texels, run.shift, run.start, run.step, run.factor, run.fog, run.haze, Lay::over);
        },
        [&](const LayerPlane& plane) {
            lookInto(*plane.vista);
            fillRows(plane.run, Lay::over);
        });
    layers_->clear();
}

}  // namespace slicecast
