// Tiles whose blocks fill only parts of them.
#include "render/slice_walk.h"

#include <bit>
#include <utility>

namespace slicecast {

// The levels with plans of a tile in the grid.
std::uint32_t SliceWalk::levelsWithPlans(int x, int y) const {
    std::uint32_t found = 0;
    if (!frame_.world->hasPlans) return found;
    for (std::uint32_t rest = map_->occupied[map_->tileIndex(x, y)]; rest != 0; rest &= rest - 1) {
        if (!blockAt(x, y, std::countr_zero(rest)).blueprint->plan.isWhole()) found |= rest & -rest;
    }
    return found;
}

// Finds where blocks of the current tile begin and end within it, and which of them the ray does
// not meet at its entry.
void SliceWalk::findPlanEdges(std::uint32_t levels) {
    planEdges_.clear();
    const PlanWalk plans = plansHere();
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1) {
        const int level = std::countr_zero(rest);
        const std::uint32_t bit = std::uint32_t{1} << level;
        const PlanPassage passage =
            plans.passage(blockAt(walk_.tileX, walk_.tileY, level).blueprint->plan);
        if (!passage.isMet || passage.enter.inner) absent_ |= bit;
        if (!passage.isMet) continue;
        if (passage.enter.inner) planEdges_.add(plans, passage.enter, bit, 0);
        if (passage.leave.inner) planEdges_.add(plans, passage.leave, 0, bit);
    }
}

// Edges and objects split the tile into stretches. What an edge and an object at one depth show
// comes in this order.
void SliceWalk::meetTileWithPlans(std::uint32_t levels) {
    findPlanEdges(levels);
    const Crossing leave = leave_;
    const std::uint32_t reached = reached_;
    const PlanEdge* edge = planEdges_.begin();
    for (;;) {
        const double objectAlong = nextObjectAlong();
        const bool isEdge = edge != planEdges_.end() && edge->at.along <= objectAlong;
        if (!isEdge && !(objectAlong < leave.along)) break;
        leave_ = isEdge ? edge->at : crossingAt(object());
        staying_ = isEdge ? ~edge->leaves : 0;
        reached_ = reached & ~absent_;
        meetStretch();
        within_ = ~absent_;
        if (isEdge) {
            absent_ = (absent_ | edge->leaves) & ~edge->enters;
            within_ &= ~absent_;
            late_ |= edge->at.along > 0.0 ? edge->enters : 0;
            enteredSideKnown_ = false;
            ++edge;
        } else {
            meetObject(object());
            ++object_;
            skipHiddenObjects();
        }
        enter_ = leave_;
    }
    leave_ = leave;
    staying_ = 0;
    reached_ = reached & ~absent_;
    meetStretch();
    absent_ = within_ = late_ = 0;
}

}  // namespace slicecast
