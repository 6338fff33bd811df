// Blocks with slopes. Rays above a top that end up below it in the tile have entered the block, and
// rays that do the reverse have left it, whether they rise or fall: a block may show its roof and
// its underside.
//
// A mirror's rays are walked from the eye on. Below the mirror's height they are still on their way
// to it, and meet nothing; in the mirror's own tile, blocks are wholly above it or below.
#include "render/slice_walk.h"

#include <algorithm>

namespace slicecast {

// The first row whose ray passes below the top or the underside of a block in tile (x, y).
int SliceWalk::rowOfFace(const CellBlueprint& block, Face face, int x, int y, int level,
                         const Crossing& at) const {
    const std::int32_t base = tileEdge(level).raw - eyeZ_;
    const Slant& slant = block.slopes.of(face);
    const int end = rowBelow(base + (face == Face::top ? block.top : block.bottom).raw, at);
    if (slant.isLevel()) return end;
    const int row = firstRowBelow(
        *projection_,
        SlopedPlane(block.slopes, slant, x, y, base, vista_->viewpoint, ray_, *projection_), at);
    if (face == Face::top) return block.isCutAbove() ? std::max(row, end) : row;
    return block.isCutBelow() ? std::min(row, end) : row;
}

// Finds where a face is met: between its rows at the two borders.
SliceWalk::FaceOfSlopes SliceWalk::faceOfSlopes(const Block& block, Face face) const {
    const Slopes& slopes = block.blueprint->slopes;
    const Slant& slant = slopes.of(face);
    FaceOfSlopes found;
    found.face = face;
    if (slant.isLevel()) {
        const std::int32_t rise = face == Face::top ? block.top : block.bottom;
        found.atEnter = rowBelow(rise, enter_);
        found.atLeave = rowBelow(rise, leave_);
        return found;
    }
    const SlopedPlane plane(slopes, slant, walk_.tileX, walk_.tileY,
                            tileEdge(block.level).raw - eyeZ_, vista_->viewpoint, ray_,
                            *projection_);
    found.isSloped = true;
    found.plane = plane;
    found.atEnter = firstRowBelow(*projection_, plane, enter_);
    found.atLeave = firstRowBelow(*projection_, plane, leave_);
    return found;
}

// Meets the side that rays enter, and the level face at the block's end nearer to the eye's height.
SliceWalk::MetSlopes SliceWalk::enterSlopes(const Block& block) {
    const MetSlopes met = {faceOfSlopes(block, Face::top), faceOfSlopes(block, Face::bottom)};
    enterSide(
        block, endOfSide(block, met.top, Border::enter),
        std::min(endOfSide(block, met.bottom, Border::enter), firstRowNotReflected(Border::enter)));
    if (!met.top.isSloped) passFace(block, met.top, false);
    if (!met.bottom.isSloped) passFace(block, met.bottom, false);
    return met;
}

// Meets the rest. A ceiling may lie between, at the height of the block's end.
void SliceWalk::passSlopes(const Block& block, const MetSlopes& met) {
    if (met.top.isSloped) passFace(block, met.top, false);
    if (met.bottom.isSloped) passFace(block, met.bottom, false);
    passFace(block, met.top, true);
    passFace(block, met.bottom, true);
    leaveSide(
        block, endOfSide(block, met.top, Border::leave),
        std::min(endOfSide(block, met.bottom, Border::leave), firstRowNotReflected(Border::leave)));
}

// The first row below a side's upper or lower end at a border.
int SliceWalk::endOfSide(const Block& block, const FaceOfSlopes& face, Border at) const {
    const int row = at == Border::enter ? face.atEnter : face.atLeave;
    if (face.face == Face::top)
        return block.blueprint->isCutAbove() ? std::max(row, rowBelow(block.top, at)) : row;
    return block.blueprint->isCutBelow() ? std::min(row, rowBelow(block.bottom, at)) : row;
}

// Leaves the rows in which a part of a moving block has a slope: elsewhere other parts have it.
void SliceWalk::cutToPart(const Block& block, const FaceOfSlopes& at, bool isDownwards, int& first,
                          int& last) const {
    const auto keep = [&](std::int32_t rise, bool keepsBelow) {
        keepRowsAt(*projection_, at.plane, rise / 65536.0, keepsBelow, isDownwards, first, last);
    };
    const Slant& slant = block.blueprint->slopes.of(at.face);
    if (slant.most() > block.blueprint->top) keep(block.top, true);
    if (slant.least() < block.blueprint->bottom) keep(block.bottom, false);
}

// Takes the rows that enter a block through a face, or leave it.
void SliceWalk::passFace(const Block& block, const FaceOfSlopes& at, bool leaving) {
    const bool isTop = at.face == Face::top;
    const bool isDownwards = isTop != leaving;
    int first = isDownwards ? at.atLeave : at.atEnter;
    int last = isDownwards ? at.atEnter : at.atLeave;
    if (!at.isSloped) {
        const std::int32_t rise = isTop ? block.top : block.bottom;
        if (rise == 0 || isDownwards != (rise < 0)) return;
        const int horizon = projection_->firstFallingRow;
        (isDownwards ? first : last) =
            isDownwards ? std::max(first, horizon) : std::min(last, horizon);
        if (goesOn(block, isTop ? 1 : -1)) return;
    } else if (at.plane.height == 0.0) {
        return;  // it is met at depth 0
    } else {
        cutToPart(block, at, isDownwards, first, last);
    }
    last = std::min(last, firstRowNotReflected(Border::leave));
    if (first >= last || !open_.mayHold(first, last)) return;
    if (at.isSloped) return takeSlope(block, at, first, last);
    if (leaving) return isTop ? leaveTop(block, first, last) : leaveBottom(block, first, last);
    if (isTop) return enterTop(block, first, last);
    if (!block.cut) enterBottom(block, first, last);
}

void SliceWalk::takeSlope(const Block& block, const FaceOfSlopes& at, int firstRow, int lastRow) {
    Plane plane = planeOf(block, at.face);
    plane.rise = 0;
    plane.sloped = true;
    const bool isLayer = block.blueprint->seeThrough;
    for (const auto& [first, last] :
         isLayer ? open_.within(firstRow, lastRow) : open_.take(firstRow, lastRow)) {
        if (isLayer && !countLayer()) return;
        Span& span = addPlane(at.face == Face::top ? What::roof : What::underside, lookOf(plane),
                              first, last, here_);
        span.face = at.face;
        span.level = block.level;
        span.layer = isLayer;
        span.slope = {at.plane.height, at.plane.horizon};
    }
}

}  // namespace slicecast
