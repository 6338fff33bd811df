// See-through blocks. They close no rows: the faces by which a ray enters and leaves them are
// collected, nearest first, and blended over the background when the walk is done. Far faces are
// drawn like near ones.
#include "render/slice_walk.h"

#include "base/bits.h"

#include <algorithm>

namespace slicecast {
namespace {

// Only a block that reaches the end of its level can touch the one above it, or below.
bool reachesEnd(const CellBlueprint& blueprint, int up) {
    return up > 0 ? blueprint.fillsUp() : blueprint.fillsDown();
}

}  // namespace

// The block of a cell if it joins `block`, else null. Faces between touching see-through blocks of
// one kind are left out, also if a portal lies between.
const CellBlueprint* SliceWalk::joinedAt(const Block& block, const Map& map, int x, int y,
                                         int level) const {
    const CellBlueprint& neighbour = frame_.world->blueprints[map.cell(x, y, level)];
    return areJoined(*frame_.world, *block.blueprint, neighbour) ? &neighbour : nullptr;
}

// The same behind a portal, through which two blocks join only if both fill their tiles and have no
// slopes.
const CellBlueprint* SliceWalk::joinedBeyond(const Block& block, const Map& map, int x, int y,
                                             int level) const {
    const CellBlueprint* const joined = joinedAt(block, map, x, y, level);
    return joined != nullptr && joined->isBox() && block.blueprint->isBox() ? joined : nullptr;
}

// The block in the tile before that joins `block`.
const CellBlueprint* SliceWalk::joinedBefore(const Block& block) const {
    if (enter_.inner) return nullptr;
    if (isArrival())
        return joinedBeyond(block, *before_.map, before_.x, before_.y,
                            block.level - before_.levels);
    return joinedNear(block, Border::enter);
}

// The block on the other side of a border that joins `block`.
const CellBlueprint* SliceWalk::joinedNear(const Block& block, Border border) const {
    const bool isAhead = border == Border::leave;
    const Crossing& at = isAhead ? leave_ : enter_;
    const int x = isAhead ? behindX(border) : beforeX(border);
    const int y = isAhead ? behindY(border) : beforeY(border);
    const CellBlueprint* joined = joinedAt(block, *map_, x, y, block.level);
    if (joined == nullptr && block.blueprint->mover >= 0) {
        const CellBlueprint& next = frame_.world->blueprints[map_->cell(x, y, block.level)];
        if (areOneAlong(*frame_.world, *block.blueprint, next, at.alongX ? Axis::x : Axis::y))
            joined = &next;
    }
    if (joined == nullptr || joined->plan.isWhole()) return joined;
    return plansHere().touches(joined->plan, x, y, at, isAhead) ? joined : nullptr;
}

// Whether a block and the one above it, or below, are parts of one mover: then nothing is between
// them, whether or not they are see-through.
bool SliceWalk::goesOn(const Block& block, int up) const {
    const auto reaches = [](const CellBlueprint& blueprint, int end) {
        return end > 0 ? blueprint.goesUp() : blueprint.goesDown();
    };
    if (block.blueprint->mover < 0 || !reaches(*block.blueprint, up) || isAbsent(block.level + up))
        return false;
    if (up > 0 ? block.top == clip_.high : block.bottom == clip_.low) return false;
    const CellBlueprint& next =
        frame_.world->blueprints[map_->cell(walk_.tileX, walk_.tileY, block.level + up)];
    return areOneMover(*block.blueprint, next) && reaches(next, -up);
}

// Whether a block of the current tile joins the one above it, or below: a touching block of its
// kind or of the same mover. A ray that leaves the block may go through a portal there.
bool SliceWalk::joinsNext(const Block& block, int up, bool leaving) const {
    if (goesOn(block, up)) return true;
    if (!reachesEnd(*block.blueprint, up) || !block.blueprint->join) return false;
    const auto touches = [&](const CellBlueprint* joined) {
        return joined != nullptr && reachesEnd(*joined, -up);
    };
    const int level = block.level + up;
    if (clipped_ && (up > 0 ? block.top == clip_.high : block.bottom == clip_.low))
        return isArrival() && touches(joinedBeyond(block, *before_.map, before_.x, before_.y,
                                                   level - before_.levels));
    if (isAbsent(level)) return false;
    const CellBlueprint& next =
        frame_.world->blueprints[map_->cell(walk_.tileX, walk_.tileY, level)];
    const PortalId portal =
        reachesEnd(next, -up) ? next.face(up > 0 ? Face::bottom : Face::top).portal : kNoPortal;
    if (!leaving || !acts(portal, false))
        return touches(joinedAt(block, *map_, walk_.tileX, walk_.tileY, level));
    const Portal& to = frame_.world->portals[portal];
    return touches(joinedBeyond(block, frame_.world->maps[static_cast<std::size_t>(to.toMap)],
                                to.toX, to.toY, level + to.levels));
}

// Draws a side at a border, except where it touches a joined block.
void SliceWalk::seeUnjoined(const Block& block, const CellBlueprint* joined, Face face, Border at,
                            int firstRow, int lastRow) {
    const CellBlueprint& own = *block.blueprint;
    const Crossing& border = at == Border::enter ? enter_ : leave_;
    const SideView view = sideView(border);
    const Side side = sideOf(block, face, true);
    const auto draw = [&](int first, int last) {
        if (first < last) seeThroughSide(side, view, first, last);
    };
    if (joined == nullptr) return draw(firstRow, lastRow);
    if (joined->slopes.any() || own.slopes.any()) {
        const int x = at == Border::enter ? beforeX(at) : behindX(at);
        const int y = at == Border::enter ? beforeY(at) : behindY(at);
        const int top = rowOfFace(*joined, Face::top, x, y, block.level, border);
        const int bottom = rowOfFace(*joined, Face::bottom, x, y, block.level, border);
        if (top >= bottom) return draw(firstRow, lastRow);
        draw(firstRow, std::min(lastRow, top));
        return draw(std::max(firstRow, bottom), lastRow);
    }
    const std::int32_t base = tileEdge(block.level).raw - eyeZ_;
    if (joined->top < own.top)
        draw(firstRow, std::min(lastRow, rowBelow(base + joined->top.raw, border)));
    if (joined->bottom > own.bottom)
        draw(std::max(firstRow, rowBelow(base + joined->bottom.raw, border)), lastRow);
}

void SliceWalk::enterThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!mayAddLayer(firstRow, lastRow) || !isThere(block, enteredFace(enter_))) return;
    seeUnjoined(block, joinedBefore(block), enteredFace(enter_), Border::enter, firstRow, lastRow);
}

// Behind the side there may be a portal of the whole tile, or of a block's face, which may be
// smaller than the side.
void SliceWalk::leaveThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!mayAddLayer(firstRow, lastRow) || !isThere(block, leftFace(leave_))) return;
    if (leave_.inner)
        return seeUnjoined(block, nullptr, leftFace(leave_), Border::leave, firstRow, lastRow);
    const int x = behindX(Border::leave);
    const int y = behindY(Border::leave);
    const auto draw = [&](const CellBlueprint* joined, int first, int last) {
        seeUnjoined(block, joined, leftFace(leave_), Border::leave, first, last);
    };
    const bool mayPass = portals_ < frame_.world->portalLimit;
    const auto joinedAfter = [&](PortalId portal) {
        const Portal& to = frame_.world->portals[portal];
        return mayPass ? joinedBeyond(block, frame_.world->maps[static_cast<std::size_t>(to.toMap)],
                                      to.toX, to.toY, block.level + to.levels)
                       : nullptr;
    };
    if (const PortalId portal = map_->tilePortal(x, y); portal != kNoPortal)
        return draw(joinedAfter(portal), firstRow, lastRow);
    const CellBlueprint& behind = frame_.world->blueprints[map_->cell(x, y, block.level)];
    const PortalId portal = behind.face(enteredFace(leave_)).portal;
    if (portal == kNoPortal || !mayPass)
        return draw(joinedNear(block, Border::leave), firstRow, lastRow);
    const CellBlueprint* const joined = joinedAfter(portal);
    if (joined == nullptr) return draw(nullptr, firstRow, lastRow);
    const std::int32_t base = tileEdge(block.level).raw - eyeZ_;
    const int top = rowBelow(base + behind.top.raw, leave_);
    const int bottom = rowBelow(base + behind.bottom.raw, leave_);
    draw(nullptr, firstRow, std::min(lastRow, top));
    draw(joined, std::max(firstRow, top), std::min(lastRow, bottom));
    draw(nullptr, std::max(firstRow, bottom), lastRow);
}

// Draws the roof or the underside.
void SliceWalk::passThroughPlane(const Block& block, Face face, int firstRow, int lastRow,
                                 bool leaving) {
    const bool isTop = face == Face::top;
    if (!mayAddLayer(firstRow, lastRow) || !isThere(block, face) ||
        joinsNext(block, isTop ? 1 : -1, leaving))
        return;
    seeThroughPlane(isTop ? What::roof : What::underside, planeOf(block, face), firstRow, lastRow,
                    here_, block.level);
}

void SliceWalk::seeThroughSide(const Side& side, const SideView& view, int firstRow, int lastRow) {
    for (const OpenRows::Run& rows : open_.within(firstRow, lastRow)) {
        if (countLayer()) addSide(side, view, rows.first, rows.last);
    }
}

void SliceWalk::seeThroughPlane(What what, const Plane& plane, int firstRow, int lastRow,
                                const TileRange& tiles, int level) {
    for (const auto& [first, last] : open_.within(firstRow, lastRow)) {
        if (!countLayer()) return;
        Span& span = addPlane(what, lookOf(plane), first, last, tiles);
        span.face = what == What::roof ? Face::top : Face::bottom;
        span.level = level;
        span.layer = true;
    }
}

}  // namespace slicecast
