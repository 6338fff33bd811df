#include "render/plan_walk.h"

#include <algorithm>

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

PlanPassage PlanWalk::passage(const Plan& plan) const {
    const Crossing enterTile = walk_.enter();
    const Crossing leaveTile = walk_.leave();
    PlanPassage found;
    for (const bool alongX : {true, false}) {
        const Edges own = edges(plan, walk_.tileX, walk_.tileY, alongX);
        if (!own.nearIsBorder) {
            const bool isPast =
                enterTile.border ? walk_.isBefore(own.near, enterTile) : own.near.along < 0.0;
            if (!isPast && (!found.enter.inner || walk_.isBefore(found.enter, own.near)))
                found.enter = own.near;
        }
        if (!own.farIsBorder) {
            const bool isPast =
                enterTile.border ? walk_.isBefore(own.far, enterTile) : own.far.along < 0.0;
            if (isPast) return {};
            if (walk_.isBefore(own.far, found.leave.inner ? found.leave : leaveTile))
                found.leave = own.far;
        }
    }
    const Crossing& end = found.leave.inner ? found.leave : leaveTile;
    found.isMet = !found.enter.inner || walk_.isBefore(found.enter, end);
    return found;
}

bool PlanWalk::touches(const Plan& plan, int x, int y, const Crossing& border, bool isAhead) const {
    if (plan.isWhole()) return true;
    const Edges across = edges(plan, x, y, border.alongX);
    if (!(isAhead ? across.nearIsBorder : across.farIsBorder)) return false;
    const Edges along = edges(plan, x, y, !border.alongX);
    return walk_.isBefore(along.near, border) && walk_.isBefore(border, along.far);
}

void PlanEdges::add(const GridWalk& walk, const Crossing& at, std::uint32_t enters,
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
