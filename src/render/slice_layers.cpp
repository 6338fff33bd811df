// What a slice sees through. A see-through block closes no rows: the faces by which the ray enters
// and leaves it are gathered, nearest first, and laid over what lies behind when the walk is done.
// Its far faces count as much as its near ones.
#include "render/slice.h"

#include "base/bits.h"

#include <algorithm>

namespace slicecast {
namespace {

// Only a block that ends where its level does can touch the one above it, or below.
bool reachesEnd(const CellBlueprint& blueprint, int up) {
    return up > 0 ? blueprint.top == tileEdge(1) : blueprint.bottom == Coordinate{0};
}

}  // namespace

// The block of a cell if it joins that one; null if it does not. Of two touching see-through blocks
// of one kind the faces between them are left out, and so they are where a portal lies between.
const CellBlueprint* Slice::joinedAt(const Block& block, const Map& map, int x, int y,
                                     int level) const {
    const CellBlueprint& other = frame_.world->blueprints[map.cell(x, y, level)];
    return areJoined(*frame_.world, *block.blueprint, other) ? &other : nullptr;
}

// What a block in the tile before joins.
const CellBlueprint* Slice::joinedBefore(const Block& block) const {
    if (isArrival())
        return joinedAt(block, *before_.map, before_.x, before_.y, block.level - before_.levels);
    return joinedAt(block, *map_, beforeX(Border::enter), beforeY(Border::enter), block.level);
}

// Whether a block and the one above it, or below, are parts of one thing that moves: then there is
// nothing between them, whether or not they are see-through.
bool Slice::goesOn(const Block& block, int up) const {
    if (block.blueprint->mover < 0 || !reachesEnd(*block.blueprint, up)) return false;
    if (up > 0 ? block.top == clip_.high : block.bottom == clip_.low) return false;
    const CellBlueprint& next =
        frame_.world->blueprints[map_->cell(walk_.tileX, walk_.tileY, block.level + up)];
    return areOneMover(*block.blueprint, next) && reachesEnd(next, -up);
}

// Whether a block of the current tile joins the one above it, or below: a block that it touches, of
// its own kind or a part of the same thing that moves. A ray that leaves it may go through a portal
// there.
bool Slice::joinsNext(const Block& block, int up, bool leaving) const {
    if (goesOn(block, up)) return true;
    if (!reachesEnd(*block.blueprint, up) || !block.blueprint->join) return false;
    const auto joins = [&](const Map& map, int x, int y, int level) {
        const CellBlueprint* const next = joinedAt(block, map, x, y, level);
        return next != nullptr && reachesEnd(*next, -up);
    };
    const int level = block.level + up;
    if (clipped_ && (up > 0 ? block.top == clip_.high : block.bottom == clip_.low))
        return isArrival() && joins(*before_.map, before_.x, before_.y, level - before_.levels);
    const CellBlueprint& next =
        frame_.world->blueprints[map_->cell(walk_.tileX, walk_.tileY, level)];
    const PortalId portal =
        reachesEnd(next, -up) ? next.face(up > 0 ? Face::bottom : Face::top).portal : kNoPortal;
    if (!leaving || !acts(portal, false)) return joins(*map_, walk_.tileX, walk_.tileY, level);
    const Portal& to = frame_.world->portals[portal];
    return joins(frame_.world->maps[static_cast<std::size_t>(to.toMap)], to.toX, to.toY,
                 level + to.levels);
}

// A side at a border, but for what of it touches a block that it joins.
void Slice::drawUnjoined(const Block& block, const CellBlueprint* joined, Face face,
                         const Crossing& border, int firstRow, int lastRow) {
    const CellBlueprint& own = *block.blueprint;
    const SideView view = sideView(border);
    const auto draw = [&](int first, int last) {
        if (first < last) seeThroughSide(block, face, border, view, first, last);
    };
    if (joined == nullptr) return draw(firstRow, lastRow);
    const std::int32_t base = tileEdge(block.level).raw - eyeZ_;
    if (joined->top < own.top)
        draw(firstRow, std::min(lastRow, rowBelow(base + joined->top.raw, border)));
    if (joined->bottom > own.bottom)
        draw(std::max(firstRow, rowBelow(base + joined->bottom.raw, border)), lastRow);
}

void Slice::enterThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!open_.mayHold(firstRow, lastRow) || !isThere(block, enteredFace(enter_))) return;
    drawUnjoined(block, joinedBefore(block), enteredFace(enter_), enter_, firstRow, lastRow);
}

// Behind the side there may be a portal: one of the whole tile, or one in the face of a block,
// which may be smaller than this one.
void Slice::leaveThroughSide(const Block& block, int firstRow, int lastRow) {
    if (!leave_.border || leave_.along <= 0.0 || !open_.mayHold(firstRow, lastRow) ||
        !isThere(block, leftFace(leave_)))
        return;
    const int x = behindX(Border::leave);
    const int y = behindY(Border::leave);
    const auto draw = [&](const CellBlueprint* joined, int first, int last) {
        drawUnjoined(block, joined, leftFace(leave_), leave_, first, last);
    };
    const bool mayPass = portals_ < frame_.world->portalLimit;
    const auto joinedBeyond = [&](PortalId portal) {
        const Portal& to = frame_.world->portals[portal];
        return mayPass ? joinedAt(block, frame_.world->maps[static_cast<std::size_t>(to.toMap)],
                                  to.toX, to.toY, block.level + to.levels)
                       : nullptr;
    };
    if (const PortalId portal = map_->tilePortal(x, y); portal != kNoPortal)
        return draw(joinedBeyond(portal), firstRow, lastRow);
    const CellBlueprint& behind = frame_.world->blueprints[map_->cell(x, y, block.level)];
    const PortalId portal = behind.face(enteredFace(leave_)).portal;
    if (portal == kNoPortal || !mayPass)
        return draw(joinedAt(block, *map_, x, y, block.level), firstRow, lastRow);
    const CellBlueprint* const joined = joinedBeyond(portal);
    if (joined == nullptr) return draw(nullptr, firstRow, lastRow);
    const std::int32_t base = tileEdge(block.level).raw - eyeZ_;
    const int top = rowBelow(base + behind.top.raw, leave_);
    const int bottom = rowBelow(base + behind.bottom.raw, leave_);
    draw(nullptr, firstRow, std::min(lastRow, top));
    draw(joined, std::max(firstRow, top), std::min(lastRow, bottom));
    draw(nullptr, std::max(firstRow, bottom), lastRow);
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
