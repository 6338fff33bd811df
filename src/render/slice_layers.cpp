// What a slice sees through. A see-through block closes no rows: the faces by which the ray enters
// and leaves it are gathered, nearest first, and laid over what lies behind when the walk is done.
// Its far faces count as much as its near ones.
#include "render/slice.h"

#include "base/bits.h"

#include <algorithm>

namespace slicecast {

// Of two touching see-through blocks of one blueprint the faces between them are left out, and so
// they are where a portal lies between.
bool Slice::isJoined(const Block& block, const Map& map, int x, int y, int level) const {
    return block.blueprint->join &&
           &frame_.world->blueprints[map.cell(x, y, level)] == block.blueprint;
}

// Whether a block joins one in the tile before.
bool Slice::joinsBefore(const Block& block) const {
    if (isArrival())
        return isJoined(block, *before_.map, before_.x, before_.y, block.level - before_.levels);
    return isJoined(block, *map_, beforeX(Border::enter), beforeY(Border::enter), block.level);
}

// Whether a block of the current tile joins the one above it, or below: a block that it touches, of
// its own blueprint or a part of the same thing that moves. A ray that leaves it may go through a
// portal there.
bool Slice::joinsNext(const Block& block, int up, bool leaving) const {
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

void Slice::enterThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!open_.mayHold(firstRow, lastRow) || !isThere(block, enteredFace(enter_)) ||
        joinsBefore(block))
        return;
    seeThroughSide(block, enteredFace(enter_), enter_, sideView(enter_), firstRow, lastRow);
}

// Behind the side there may be a portal: one of the whole tile, or one in the face of a block,
// which may be smaller than this one.
void Slice::leaveThroughSide(const Block& block, int firstRow, int lastRow) {
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

void Slice::passThroughTop(const Block& block, int firstRow, int lastRow, bool leaving) {
    if (!open_.mayHold(firstRow, lastRow) || !isThere(block, Face::top) ||
        joinsNext(block, 1, leaving))
        return;
    const FaceBlueprint& look = block.blueprint->face(Face::top);
    seeThroughPlane(block.level, FilledRows::What::roof,
                    {{block.top, look.texture, look.light, look.glow, false, false},
                     firstRow,
                     lastRow,
                     walk_.tileX,
                     walk_.tileY,
                     walk_.tileX,
                     walk_.tileY,
                     false});
}

void Slice::passThroughBottom(const Block& block, int firstRow, int lastRow, bool leaving) {
    if (!open_.mayHold(firstRow, lastRow) || !isThere(block, Face::bottom) ||
        joinsNext(block, -1, leaving))
        return;
    const FaceBlueprint& look = block.blueprint->face(Face::bottom);
    seeThroughPlane(block.level, FilledRows::What::underside,
                    {{block.bottom, look.texture, look.light, look.glow, true, false},
                     firstRow,
                     lastRow,
                     walk_.tileX,
                     walk_.tileY,
                     walk_.tileX,
                     walk_.tileY,
                     false});
}

void Slice::seeThroughPlane(int level, FilledRows::What what, const PlaneRun& run) {
    open_.each(run.first, run.last, [&](int first, int last) {
        PlaneRun part = run;
        part.first = first;
        part.last = last;
        layers_->add(part, *vista_);
        if (trace_)
            tracePlane(level, what, what == FilledRows::What::roof ? Face::top : Face::bottom, run,
                       first, last, true);
    });
}

// Objects that this column's ray passes, in the current tile: each splits the tile's stretch of the
// ray in two, for what the tile holds may lie before it or behind it.
void Slice::drawTileWithObjects() {
    const Crossing leave = leave_;
    for (; object_ != objectsEnd_ && vista_->objects[*object_].along < leave.along;
         ++object_, skipHiddenObjects()) {
        const FrameObject& object = vista_->objects[*object_];
        leave_ = crossingAt(object);
        drawStretch();
        drawObject(object);
        enter_ = leave_;
    }
    leave_ = leave;
    drawStretch();
}

// Objects outside the grid, where there is only the floor.
void Slice::drawObjectsBeyond() {
    for (; object_ != objectsEnd_ && !open_.none(); ++object_, skipHiddenObjects()) {
        const FrameObject& object = vista_->objects[*object_];
        leave_ = crossingAt(object);
        takeFloorBeyond(rowBelow(floorRise_, leave_));
        drawObject(object);
    }
}

// Several columns share a list of objects; those that this one passes by split nothing, nor do
// those whose rows are closed.
void Slice::skipHiddenObjects() {
    for (; object_ != objectsEnd_; ++object_) {
        const FrameObject& object = vista_->objects[*object_];
        if (!open_.mayHold(object.firstRow, object.lastRow)) continue;
        const double share = across(object);
        if (share >= 0.0 && share < 1.0) return;
    }
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

// An object's column of texels that this slice shows. A row through the lower edge's height is on
// the object, one through the upper edge's is not.
void Slice::drawObject(const FrameObject& object) {
    const SpriteLevel& level = *object.level;
    const int u = std::min(level.width - 1, static_cast<int>(across(object) * level.width));
    // Positions are in texels from the upper edge, with 32 bits after the point.
    constexpr double kTexel = 4294967296.0;
    const double perUnit = level.height * kTexel / ((object.top - object.bottom) / 65536.0);
    const double perRow = object.along;
    const auto end = static_cast<std::int64_t>(level.height) << 32;
    bool drawn = false;
    const int firstRow =
        object.top <= clip_.high
            ? object.firstRow
            : FrameObjects::firstRowBelow(*projection_, clip_.high, object.depth, true);
    const int lastRow = object.bottom >= clip_.low
                            ? object.lastRow
                            : FrameObjects::firstRowBelow(*projection_, clip_.low, object.depth);
    open_.each(firstRow, lastRow, [&](int first, int last) {
        const double down = object.top / 65536.0 - (projection_->horizon - (first + 0.5)) * perRow;
        const std::int64_t start = std::clamp<std::int64_t>(
            nearestInteger(std::clamp(down * perUnit, 0.0, static_cast<double>(end))), 0, end - 1);
        const int steps = last - first - 1;
        std::int64_t step =
            steps > 0 ? nearestInteger(std::min(perRow * perUnit, static_cast<double>(end))) : 0;
        if (start + steps * step >= end) step = (end - 1 - start) / steps;
        layers_->add({level.texels.data() +
                          static_cast<std::size_t>(u) * static_cast<std::size_t>(level.height),
                      32, first, last, static_cast<std::uint64_t>(start),
                      static_cast<std::uint64_t>(step), object.factor, object.fog,
                      vista_->lighting.haze});
        drawn = true;
        if (trace_)
            traceObject(object, u, static_cast<std::uint64_t>(start),
                        static_cast<std::uint64_t>(step), first, last);
    });
    if (drawn) ++report_.objectSlices;
}

// Lays what was seen through over the finished rows, from back to front.
void Slice::layOver() {
    report_.layers += static_cast<std::int64_t>(layers_->count());
    layers_->fromBack(
        [&](const SideRun& run) {
            count(run.first, run.last);
            if (waterFogs_ != nullptr) return fillFromWater(run, Lay::over);
            fillSide(pixels_ + run.first, run.last - run.first, run.texels, run.shift, run.start,
                     run.step, run.factor, run.fog, run.haze, Lay::over);
        },
        [&](const LayerPlane& plane) {
            lookInto(*plane.vista);
            fillRows(plane.run, Lay::over);
        });
    layers_->clear();
}

}  // namespace slicecast
