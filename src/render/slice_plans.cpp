// Tiles whose blocks fill only parts of them.
#include "render/slice_walk.h"

#include <bit>
#include <utility>

namespace slicecast {

bool SliceWalk::hasPlansHere() const {
    const int x = walk_.tileX;
    const int y = walk_.tileY;
    if (!map_->contains(x, y)) return false;
    for (std::uint32_t rest = map_->occupied[map_->tileIndex(x, y)]; rest != 0; rest &= rest - 1) {
        if (!blockAt(x, y, std::countr_zero(rest)).blueprint->plan.isWhole()) return true;
    }
    return false;
}

// Finds where the blocks of the current tile begin and end within it, and which of them the ray
// does not meet at its entry.
void SliceWalk::findPlanEdges(PlanEdges& edges) {
    const int x = walk_.tileX;
    const int y = walk_.tileY;
    const PlanWalk plans = plansHere();
    for (std::uint32_t rest = map_->occupied[map_->tileIndex(x, y)]; rest != 0; rest &= rest - 1) {
        const int level = std::countr_zero(rest);
        const Plan& plan = blockAt(x, y, level).blueprint->plan;
        if (plan.isWhole()) continue;
        const std::uint32_t bit = std::uint32_t{1} << level;
        const PlanPassage passage = plans.passage(plan);
        if (!passage.isMet || passage.enter.inner) absent_ |= bit;
        if (!passage.isMet) continue;
        if (passage.enter.inner) edges.add(plans, passage.enter, bit, 0);
        if (passage.leave.inner) edges.add(plans, passage.leave, 0, bit);
    }
}

// Edges and objects split the tile into stretches. What an edge and an object at one depth show
// comes in this order.
void SliceWalk::meetTileWithPlans() {
    PlanEdges edges;
    findPlanEdges(edges);
    const Crossing leave = leave_;
    const std::uint32_t reached = reached_;
    const PlanEdge* edge = edges.begin();
    for (;;) {
        const double object = nextObjectAlong();
        const bool isEdge = edge != edges.end() && edge->at.along <= object;
        if (!isEdge && !(object < leave.along)) break;
        leave_ = isEdge ? edge->at : crossingAt(vista_->objects[*object_]);
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
            meetObject(vista_->objects[*object_]);
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
