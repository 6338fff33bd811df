// What a slice sees through. A see-through block closes no rows: the faces by which the ray enters
// and leaves it are gathered, nearest first, and laid over what lies behind when the walk is done.
// Its far faces count as much as its near ones.
#include "render/slice_walk.h"

#include "base/bits.h"

#include <algorithm>

namespace slicecast {

// Of two touching see-through blocks of one blueprint the faces between them are left out, and so
// they are where a portal lies between.
bool SliceWalk::isJoined(const Block& block, const Map& map, int x, int y, int level) const {
    return block.blueprint->join &&
           &frame_.world->blueprints[map.cell(x, y, level)] == block.blueprint;
}

// Whether a block joins one in the tile before.
bool SliceWalk::joinsBefore(const Block& block) const {
    if (isArrival())
        return isJoined(block, *before_.map, before_.x, before_.y, block.level - before_.levels);
    return isJoined(block, *map_, beforeX(Border::enter), beforeY(Border::enter), block.level);
}

// Whether a block of the current tile joins the one above it, or below: a block that it touches, of
// its own blueprint or a part of the same thing that moves. A ray that leaves it may go through a
// portal there.
bool SliceWalk::joinsNext(const Block& block, int up, bool leaving) const {
    const bool above = up > 0;
    const auto reaches = [](const CellBlueprint& blueprint, bool top) {
        return top ? blueprint.top == tileEdge(1) : blueprint.bottom == Coordinate{0};
    };
    if (!reaches(*block.blueprint, above) || !block.blueprint->join) return false;
    const auto at = [&](const Map& map, int x, int y, int level) -> const CellBlueprint& {
        return frame_.world->blueprints[map.cell(x, y, level)];
    };
    const auto joins = [&](const CellBlueprint& next) {
        return reaches(next, !above) && (&next == block.blueprint ||
                                         (next.mover >= 0 && next.mover == block.blueprint->mover));
    };
    const int level = block.level + up;
    if (clipped_ && (above ? block.top == clip_.high : block.bottom == clip_.low)) {
        return isArrival() && joins(at(*before_.map, before_.x, before_.y, level - before_.levels));
    }
    const CellBlueprint& next = at(*map_, walk_.tileX, walk_.tileY, level);
    const PortalId portal =
        reaches(next, !above) ? next.face(above ? Face::bottom : Face::top).portal : kNoPortal;
    if (!leaving || !acts(portal)) return joins(next);
    const Portal& to = frame_.world->portals[portal];
    return joins(at(frame_.world->maps[static_cast<std::size_t>(to.toMap)], to.toX, to.toY,
                    level + to.levels));
}

void SliceWalk::enterThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!open_.mayHold(firstRow, lastRow) || !isThere(block, enteredFace(enter_)) ||
        joinsBefore(block))
        return;
    seeThroughSide(block, enteredFace(enter_), enter_, sideView(enter_), firstRow, lastRow);
}

// Behind the side there may be a portal: one of the whole tile, or one in the face of a block,
// which may be smaller than this one.
void SliceWalk::leaveThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!leave_.border || leave_.along <= 0.0 || !open_.mayHold(firstRow, lastRow) ||
        !isThere(block, leftFace(leave_)))
        return;
    const int x = behindX(Border::leave);
    const int y = behindY(Border::leave);
    const SideView view = sideView(leave_);
    const auto draw = [&](int first, int last) {
        seeThroughSide(block, leftFace(leave_), leave_, view, first, last);
    };
    const auto isJoinedBeyond = [&](PortalId portal) {
        const Portal& to = frame_.world->portals[portal];
        return isJoined(block, frame_.world->maps[static_cast<std::size_t>(to.toMap)], to.toX,
                        to.toY, block.level + to.levels);
    };
    const bool mayPass = portals_ < frame_.world->portalLimit;
    if (const PortalId portal = map_->tilePortal(x, y); portal != kNoPortal) {
        if (!mayPass || !isJoinedBeyond(portal)) draw(firstRow, lastRow);
        return;
    }
    const CellBlueprint& behind = frame_.world->blueprints[map_->cell(x, y, block.level)];
    if (const PortalId portal = behind.face(enteredFace(leave_)).portal;
        portal != kNoPortal && mayPass && isJoinedBeyond(portal)) {
        const std::int32_t base = tileEdge(block.level).raw - eyeZ_;
        draw(firstRow, std::min(lastRow, rowBelow(base + behind.top.raw, leave_)));
        draw(std::max(firstRow, rowBelow(base + behind.bottom.raw, leave_)), lastRow);
        return;
    }
    if (!isJoined(block, *map_, x, y, block.level)) draw(firstRow, lastRow);
}

// The roof or the underside.
void SliceWalk::passThroughPlane(const Block& block, Face face, int firstRow, int lastRow,
                                 bool leaving) {
    const bool isTop = face == Face::top;
    if (!open_.mayHold(firstRow, lastRow) || !isThere(block, face) ||
        joinsNext(block, isTop ? 1 : -1, leaving))
        return;
    seeThroughPlane(isTop ? What::roof : What::underside, planeOf(block, face), firstRow, lastRow,
                    here(), block.level);
}

void SliceWalk::seeThroughSide(const Block& block, Face face, const Crossing& border,
                               const SideView& view, int firstRow, int lastRow) {
    open_.each(firstRow, lastRow, [&](int first, int last) {
        if (!hasRoomForLayer()) return;
        addSide(block, face, border, view, first, last).layer = true;
    });
}

void SliceWalk::seeThroughPlane(What what, const Plane& plane, int firstRow, int lastRow,
                                const TileRange& tiles, int level) {
    open_.each(firstRow, lastRow, [&](int first, int last) {
        if (!hasRoomForLayer()) return;
        Span& span = addPlane(what, plane, first, last, tiles);
        span.face = what == What::roof ? Face::top : Face::bottom;
        span.level = level;
        span.layer = true;
    });
}

}  // namespace slicecast
