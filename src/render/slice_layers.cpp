// What a slice sees through. A see-through block closes no rows: the faces by which the ray enters and leaves it are gathered, nearest first, and laid over what
// lies behind when the walk is done. Its far faces count as much as its near ones.
#include "render/slice.h"

#include <algorithm>

namespace slicecast {

// Of two touching see-through blocks of one blueprint the faces between them are left out.
bool Slice::joins(const Block& block, int x, int y, int level) const {
    if (!block.blueprint->join) return false;
    return &frame_.world->blueprints[map_.cell(x, y, level)] == block.blueprint;
}

void Slice::enterThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!open_.mayHold(firstRow, lastRow) || joins(block, beforeX(Border::enter), beforeY(Border::enter), block.level)) return;
    seeThroughSide(block, enteredFace(enter_), enter_, sideView(enter_), firstRow, lastRow);
}

void Slice::leaveThroughSide(const Block& block, int firstRow, int lastRow) {
    if (leave_.along <= 0.0 || !open_.mayHold(firstRow, lastRow) || joins(block, behindX(Border::leave), behindY(Border::leave), block.level)) return;
    seeThroughSide(block, leftFace(leave_), leave_, sideView(leave_), firstRow, lastRow);
}

void Slice::passThroughTop(const Block& block, int firstRow, int lastRow) {
    const bool full = block.top - block.bottom == tileEdge(1).raw;
    if (!open_.mayHold(firstRow, lastRow) || (full && joins(block, walk_.tileX, walk_.tileY, block.level + 1))) return;
    const FaceBlueprint& look = block.blueprint->face(Face::top);
    seeThroughPlane(block.level, FilledRows::What::roof,
                    {{block.top, look.texture, look.light, look.glow, false}, firstRow, lastRow, walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY, false});
}

void Slice::passThroughBottom(const Block& block, int firstRow, int lastRow) {
    const bool full = block.top - block.bottom == tileEdge(1).raw;
    if (!open_.mayHold(firstRow, lastRow) || (full && joins(block, walk_.tileX, walk_.tileY, block.level - 1))) return;
    const FaceBlueprint& look = block.blueprint->face(Face::bottom);
    seeThroughPlane(block.level, FilledRows::What::underside,
                    {{block.bottom, look.texture, look.light, look.glow, true}, firstRow, lastRow, walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY, false});
}

void Slice::seeThroughPlane(int level, FilledRows::What what, const PlaneRun& run) {
    open_.each(run.first, run.last, [&](int first, int last) {
        PlaneRun part = run;
        part.first = first;
        part.last = last;
        layers_.add(part);
        note(level, what, what == FilledRows::What::roof ? Face::top : Face::bottom, first, last);
    });
}

// Lays what was seen through over the finished rows, from back to front.
void Slice::layOver() {
    layers_.fromBack(
        [&](const SideRun& run) {
            count(run.first, run.last);
            fillSide(pixels_ + run.first, run.last - run.first, *run.level, run.texelColumn, run.start, run.step, run.factor, run.fog, frame_.lighting.haze,
                     Lay::over);
        },
        [&](const PlaneRun& run) { fillRows(run, Lay::over); });
    layers_.clear();
}

}  // namespace slicecast
