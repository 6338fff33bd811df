#include "render/spans/plan_walk.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

// Whether the eye counts as moved eastward or southward from where it is: so it does in its own
// map, which may lie turned.
bool PlanWalk::isEyeMovedOn(bool alongX) const {
    return alongX ? eye_.turn % 3 == 0 : eye_.turn < 2;
}

// An edge that the eye is on has been crossed if the eye counts as moved past it. An edge along the
// ray has always been crossed, or never is.
Crossing PlanWalk::edge(int tile, Coordinate at, bool alongX) const {
    const double direction = alongX ? ray_.x : ray_.y;
    const double from = alongX ? eye_.tileX() + eye_.fractionX() : eye_.tileY() + eye_.fractionY();
    const double ahead = tile + at.value() - from;  // eastward or southward; exact
    if (direction == 0.0) {
        Crossing never = {.alongX = alongX, .border = false, .inner = true};
        const bool isPast = ahead < 0.0 || (ahead == 0.0 && isEyeMovedOn(alongX));
        never.along = isPast ? -kNever : kNever;
        return never;
    }
    Crossing crossing = walk_.innerCrossing(alongX, direction < 0.0 ? -ahead : ahead);
    if (crossing.distance < 0.0 || (crossing.distance == 0.0 && crossing.early))
        crossing.along = -kNever;
    return crossing;
}

PlanWalk::Edges PlanWalk::edges(const Plan& plan, int x, int y, bool alongX) const {
    const int tile = alongX ? x : y;
    const bool nearing = (alongX ? ray_.x : ray_.y) >= 0.0;
    const Coordinate low = alongX ? plan.west : plan.north;
    const Coordinate high = alongX ? plan.east : plan.south;
    const bool lowIsBorder = low == Coordinate{0};
    const bool highIsBorder = high == tileEdge(1);
    if (nearing)
        return {edge(tile, low, alongX), edge(tile, high, alongX), lowIsBorder, highIsBorder};
    return {edge(tile, high, alongX), edge(tile, low, alongX), highIsBorder, lowIsBorder};
}

// At one depth, what is met much sooner when the eye moves on comes first: eastward in its own map,
// and if that decides nothing, southward.
bool PlanWalk::isBefore(const Crossing& a, const Crossing& b) const {
    if (a.along != b.along) return a.along < b.along;
    const bool isTurned = eye_.turn % 2 != 0;
    const auto eastward = [isTurned](const Crossing& c) {
        if (c.cut == Cut::none && c.alongX == isTurned) return 0.0;
        return (c.early ? 1.0 : -1.0) / c.speed;
    };
    const auto southward = [&](const Crossing& c) {
        if (c.cut == Cut::none) return 0.0;
        return (c.cut == Cut::falling) == isTurned ? eastward(c) : -eastward(c);
    };
    if (eastward(a) != eastward(b)) return eastward(a) > eastward(b);
    return southward(a) > southward(b);
}

// Where the eye counts as moved to if it is on a cut.
bool PlanWalk::isEyeIn(Half half) const {
    const std::int64_t x = eye_.x - std::int64_t{walk_.tileX} * 65536;
    const std::int64_t y = eye_.y - std::int64_t{walk_.tileY} * 65536;
    const bool isFalling = isCutFalling(half);
    const std::int64_t eastward = isFalling ? x - y : x + y - 65536;
    const bool isEast = eastward > 0 || (eastward == 0 && isEyeMovedOn(isFalling));
    return isEast == isEastern(half);
}

// Where the ray crosses a half's cut: between the tile's borders, also where the quotient is
// rounded.
Crossing PlanWalk::cut(Half half) const {
    const bool isFalling = isCutFalling(half);
    const double x = walk_.tileX - eye_.tileX() - eye_.fractionX();
    const double y = walk_.tileY - eye_.tileY() - eye_.fractionY();
    const double eastward = isFalling ? ray_.x - ray_.y : ray_.x + ray_.y;
    const double distance = std::abs(isFalling ? x - y : x + y + 1.0);
    const double speed = std::abs(eastward);
    const Crossing enterTile = walk_.enter();
    const Crossing leaveTile = walk_.leave();
    const double along = speed > 0.0 ? distance / speed : 0.0;
    Crossing found = along > enterTile.along ? leaveTile : enterTile;
    if (along > enterTile.along && along < leaveTile.along) {
        found.along = along;
        found.distance = distance;
        found.speed = speed;
        found.rowsPerRaw = speed / distance * (1.0 / 65536.0);
    }
    found.alongX = found.border = false;
    found.inner = true;
    found.cut = isFalling ? Cut::falling : Cut::rising;
    found.nearing = (eastward > 0.0) != isFalling;
    found.early = (eastward > 0.0) == isEyeMovedOn(isFalling);
    return found;
}

// The ray is in the half where it enters the tile if that border is one of the half's sides.
PlanPassage PlanWalk::halfPassage(Half half) const {
    const bool isIn =
        walk_.hasEntered() ? hasSide(half, enteredFace(walk_.enter())) : isEyeIn(half);
    const bool staysIn = hasSide(half, leftFace(walk_.leave()));
    PlanPassage found;
    found.isMet = isIn || staysIn;
    if (isIn != staysIn) (isIn ? found.leave : found.enter) = cut(half);
    return found;
}

PlanPassage PlanWalk::passage(const Plan& plan) const {
    if (plan.half != Half::none) return halfPassage(plan.half);
    const Crossing enterTile = walk_.enter();
    const Crossing leaveTile = walk_.leave();
    PlanPassage found;
    for (const bool alongX : {true, false}) {
        const Edges own = edges(plan, walk_.tileX, walk_.tileY, alongX);
        if (!own.nearIsBorder) {
            const bool isPast =
                enterTile.border ? isBefore(own.near, enterTile) : own.near.along < 0.0;
            if (!isPast && (!found.enter.inner || isBefore(found.enter, own.near)))
                found.enter = own.near;
        }
        if (!own.farIsBorder) {
            const bool isPast =
                enterTile.border ? isBefore(own.far, enterTile) : own.far.along < 0.0;
            if (isPast) return {};
            if (isBefore(own.far, found.leave.inner ? found.leave : leaveTile))
                found.leave = own.far;
        }
    }
    const Crossing& end = found.leave.inner ? found.leave : leaveTile;
    found.isMet = !found.enter.inner || isBefore(found.enter, end);
    return found;
}

bool PlanWalk::touches(const Plan& plan, int x, int y, const Crossing& border, bool isAhead) const {
    if (plan.isWhole()) return true;
    if (plan.half != Half::none)
        return hasSide(plan.half, isAhead ? enteredFace(border) : leftFace(border));
    const Edges across = edges(plan, x, y, border.alongX);
    if (!(isAhead ? across.nearIsBorder : across.farIsBorder)) return false;
    const Edges along = edges(plan, x, y, !border.alongX);
    return isBefore(along.near, border) && isBefore(border, along.far);
}

void PlanEdges::add(const PlanWalk& walk, const Crossing& at, std::uint32_t enters,
                    std::uint32_t leaves) {
    std::size_t place = count_;
    while (place > 0 && walk.isBefore(at, edges_[place - 1].at)) --place;
    if (place > 0 && !walk.isBefore(edges_[place - 1].at, at)) {  // the same edge
        edges_[place - 1].enters |= enters;
        edges_[place - 1].leaves |= leaves;
        return;
    }
    std::move_backward(edges_.data() + place, edges_.data() + count_, edges_.data() + count_ + 1);
    edges_[place] = {at, enters, leaves};
    ++count_;
}

}  // namespace slicecast
