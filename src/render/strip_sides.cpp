// The sides of blocks, for all columns of a strip that pass a tile.
#include "render/strip_walk.h"

#include <span>

namespace slicecast {

// How columns that enter or leave the tile along one axis cross its border. On the eye's own row of
// tiles they may leave along v to either side.
Crossing StripWalk::borderOf(Border at, bool alongU, bool up) const {
    const bool nearing = alongU ? stepU_ > 0 : at == Border::enter ? v_ > eyeV_ : up;
    return {.alongX = alongU == alongX_, .nearing = nearing};
}

void StripWalk::takeSide(const Block& block, Lanes first, Lanes last) {
    const std::span<const LaneRows> taken = open_.take(mask_, first, last);
    if (taken.empty()) return;
    const SideViews& views = viewsAt(Border::enter);
    const unsigned alongU = bitsOf(enteredAlongU_);
    const auto sideAlong = [&](bool isU) {
        return any().sideOf(block, enteredFace(borderOf(Border::enter, isU, false)), false);
    };
    const SliceWalk::Side sides[] = {sideAlong(false), sideAlong(true)};
    for (const auto& [i, from, to] : taken) {
        lane(i).here_ = here();
        lane(i).addSide(sides[alongU >> i & 1], views[indexOf(i)], from, to);
    }
}

// Adds layers of the sides by which columns enter or leave a see-through block, except where they
// touch a joined block.
void StripWalk::seeSide(const Block& block, Border at, Lanes first, Lanes last) {
    const Lanes seen = mask_ & (first < last) & open_.reachBelow(first) & open_.reachAbove(last);
    if (bitsOf(seen) == 0) return;
    const bool entering = at == Border::enter;
    const Lanes alongU = entering ? enteredAlongU_ : leftAlongU_;
    const Lanes upward = inAllLanes(0) < stepsV_;
    const struct {
        Lanes those;
        bool isU;
        bool up;
    } groups[] = {
        {alongU, true, false}, {~alongU & upward, false, true}, {~alongU & ~upward, false, false}};
    for (const auto& [those, isU, up] : groups) {
        const Lanes some = seen & those;
        const Crossing border = borderOf(at, isU, up);
        const Face face = entering ? enteredFace(border) : leftFace(border);
        if (bitsOf(some) == 0 || !any().isThere(block, face)) continue;
        const int onward = (border.nearing ? 1 : -1) * (entering ? -1 : 1);
        const CellBlueprint& next =
            frame_.world
                ->blueprints[map_->cell(tileX(v_) + (border.alongX ? onward : 0),
                                        tileY(v_) + (border.alongX ? 0 : onward), block.level)];
        const SliceWalk::Side side = any().sideOf(block, face, true);
        if (!areJoined(*frame_.world, *block.blueprint, next)) {
            seeRows(some, side, at, first, last);
            continue;
        }
        const std::int32_t base = tileEdge(block.level).raw - any().eyeZ_;
        if (next.top < block.blueprint->top)
            seeRows(some, side, at, first, lesser(last, rowsBelow(base + next.top.raw, at)));
        if (next.bottom > block.blueprint->bottom)
            seeRows(some, side, at, greater(first, rowsBelow(base + next.bottom.raw, at)), last);
    }
}

void StripWalk::seeRows(Lanes mask, const SliceWalk::Side& side, Border at, Lanes first,
                        Lanes last) {
    const unsigned bits = bitsOf(mask & (first < last));
    if (bits == 0) return;
    const SideViews& views = viewsAt(at);
    const LaneValues from(first);
    const LaneValues to(last);
    eachLane(bits, [&](int i) {
        open_.write(i);
        lane(i).here_ = here();
        lane(i).seeThroughSide(side, views[indexOf(i)], from.at[i], to.at[i]);
        // Opaque texels have closed rows
        open_.read(i);
    });
}

// The same as SliceWalk::sideView.
const StripWalk::SideViews& StripWalk::viewsAt(Border at) {
    const bool entering = at == Border::enter;
    SideViews& views = entering ? enteredViews_ : leftViews_;
    bool& known = entering ? enteredViewsKnown_ : leftViewsKnown_;
    if (known) return views;
    known = true;
    const Lighting& lighting = any().vista_->lighting;
    const LaneValues alongU(entering ? enteredAlongU_ : leftAlongU_);
    const double baseV = fractionV_ + (eyeV_ - v_);
    const double baseU = fractionU_ + (eyeU_ - u_);
    eachLane(bitsOf(mask_), [&](int lane) {
        const auto i = static_cast<std::size_t>(lane);
        const bool isU = alongU.at[i] != 0;
        const double leftV =
            stepV_[i] > 0 ? v_ + 1 - eyeV_ - fractionV_ : fractionV_ + (eyeV_ - v_);
        const double distance = isU ? (entering ? near_ : far_) : entering ? enteredV_ : leftV;
        const double speed = isU ? speedU_[i] : speedV_[i];
        const double across = isU ? rayV_[i] : speedU_[i] * stepU_;
        SliceWalk::SideView& view = views[i];
        view.along = distance / speed;
        view.fraction = SliceWalk::fractionBits((isU ? baseV : baseU) + across * distance / speed);
        view.depth = view.along * projection_->distance;
        view.brightness = lighting.brightnessAt(view.depth);
        view.fog = lighting.fogAt(view.depth);
    });
    return views;
}

}  // namespace slicecast
