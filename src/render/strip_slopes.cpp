// Blocks with slopes, for all columns of a strip that pass a tile. See slice_slopes.cpp; here no
// ray is inside a block, so none leaves it.
#include "render/strip_walk.h"

namespace slicecast {

StripWalk::FaceOfSlopes StripWalk::faceOfSlopes(const Block& block, Face face) const {
    const Slopes& slopes = block.blueprint->slopes;
    const Slant& slant = slopes.of(face);
    FaceOfSlopes found;
    found.face = face;
    found.isSloped = !slant.isLevel();
    if (!found.isSloped) {
        const std::int32_t rise = face == Face::top ? block.top : block.bottom;
        found.atEnter = rowsBelow(rise, Border::enter);
        found.atLeave = rowsBelow(rise, Border::leave);
        return found;
    }
    LaneValues enter(inAllLanes(0));
    LaneValues leave(inAllLanes(0));
    const std::int32_t base = tileEdge(block.level).raw - any().eyeZ_;
    const Viewpoint& eye = any().vista_->viewpoint;
    eachLane(bitsOf(mask_), [&](int i) {
        const SlopedPlane plane(slopes, slant, tileX(v_), tileY(v_), base, eye,
                                lanes_[indexOf(i)].ray_, *projection_);
        found.height = plane.height;
        found.horizon[indexOf(i)] = plane.horizon;
        enter.at[i] = inLane(firstRowBelow(*projection_, plane, crossingOf(i, Border::enter)));
        leave.at[i] = inLane(firstRowBelow(*projection_, plane, crossingOf(i, Border::leave)));
    });
    found.atEnter = enter.lanes();
    found.atLeave = leave.lanes();
    return found;
}

// See SliceWalk::firstRowNotReflected.
Lanes StripWalk::firstRowsNotReflected(Border at) const {
    const HeightClip& clip = any().clip_;
    return clip.isMirror ? rowsBelow(clip.low, at) : inAllLanes(projection_->height);
}

StripWalk::MetSlopes StripWalk::enterSlopes(const Block& block) {
    const MetSlopes met = {faceOfSlopes(block, Face::top), faceOfSlopes(block, Face::bottom)};
    takeSide(block, met.top.atEnter,
             lesser(met.bottom.atEnter, firstRowsNotReflected(Border::enter)));
    if (!met.top.isSloped) passFace(block, met.top);
    if (!met.bottom.isSloped) passFace(block, met.bottom);
    return met;
}

void StripWalk::passSlopes(const Block& block, const MetSlopes& met) {
    if (met.top.isSloped) passFace(block, met.top);
    if (met.bottom.isSloped) passFace(block, met.bottom);
}

void StripWalk::passFace(const Block& block, const FaceOfSlopes& at) {
    const bool isTop = at.face == Face::top;
    Lanes first = isTop ? at.atLeave : at.atEnter;
    Lanes last = lesser(isTop ? at.atEnter : at.atLeave, firstRowsNotReflected(Border::leave));
    if (!at.isSloped) {
        const std::int32_t rise = isTop ? block.top : block.bottom;
        if (rise == 0 || isTop != (rise < 0)) return;
        const Lanes horizon = inAllLanes(projection_->firstFallingRow);
        if (isTop) {
            first = greater(first, horizon);
        } else {
            last = lesser(last, horizon);
        }
        return takePlane(block, at.face, first, last);
    }
    if (at.height == 0.0) return;  // it is met at depth 0
    PlaneLook* look = nullptr;
    for (const auto& [i, from, to] : open_.take(mask_, first, last)) {
        SliceWalk& walk = lane(i);
        if (look == nullptr) {
            Plane plane = walk.planeOf(block, at.face);
            plane.rise = 0;
            plane.sloped = true;
            look = &walk.lookOf(plane);
        }
        Span& span = walk.addPlane(isTop ? What::roof : What::underside, *look, from, to, here());
        span.face = at.face;
        span.level = block.level;
        span.slope = {at.height, at.horizon[indexOf(i)]};
    }
}

}  // namespace slicecast
