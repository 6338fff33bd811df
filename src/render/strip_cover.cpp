// Floor and ceiling, for all columns of a strip that pass a tile.
#include "render/strip_walk.h"

#include <span>

namespace slicecast {

// Where floor or ceiling changes, its run ends at the border: the ceiling's before the floor's.
void StripWalk::changeCover(TextureId floor, TextureId ceiling) {
    const Lanes otherFloor = mask_ & ~(floor_.lanes() == inAllLanes(floor));
    const Lanes changed = otherFloor | (mask_ & ~(ceiling_.lanes() == inAllLanes(ceiling)));
    if (bitsOf(changed) == 0) return;
    coverChanged_ = true;
    if (ceiling != kNoTexture || onlyCeiling_ != kNoTexture) {
        const Lanes rows = rowsBelow(any().ceilingRise_, Border::enter);
        takeCeiling(changed, rows, Border::enter);
        startCeiling(changed, ceiling, rows);
    }
    if (bitsOf(otherFloor) == 0) return;
    takeFloor(otherFloor, Border::enter);
    floor_ = LaneValues(chosen(otherFloor, inAllLanes(floor), floor_.lanes()));
}

void StripWalk::takeFloor(Lanes mask, Border at) {
    const bool entering = at == Border::enter;
    const int height = projection_->height;
    const Lanes rows =
        greater(rowsBelow(any().floorRise_, at), inAllLanes(any().vista_->firstFloorRow));
    for (const auto& [i, first, last] : open_.take(mask, rows, inAllLanes(height))) {
        SliceWalk& walk = lane(i);
        walk.floor_.texture = static_cast<TextureId>(floor_.at[i]);
        walk.addFloor(first, last, rangeTo(i, at, floorFromU_.at[i], floorFromV_.at[i]));
    }
    const Lanes alongU = leftAlongU_;
    const Lanes here = inAllLanes(v_);
    const Lanes behind = here + stepsV_;
    const Lanes nextU =
        entering ? inAllLanes(u_) : chosen(alongU, inAllLanes(u_ + stepU_), inAllLanes(u_));
    const Lanes nextV = entering ? here : chosen(alongU, here, behind);
    floorFromU_ = LaneValues(chosen(mask, nextU, floorFromU_.lanes()));
    floorFromV_ = LaneValues(chosen(mask, nextV, floorFromV_.lanes()));
}

// From a tile to the one before a border of the current one.
TileRange StripWalk::rangeTo(int i, Border at, int fromU, int fromV) const {
    int u = u_;
    int v = v_;
    if (at == Border::enter) {
        if (bitsOf(enteredAlongU_) >> i & 1) {
            u -= stepU_;
        } else {
            v -= stepV_[static_cast<std::size_t>(i)];
        }
    }
    return alongX_ ? TileRange{fromU, fromV, u, v, false} : TileRange{fromV, fromU, v, u, false};
}

void StripWalk::startCeiling(Lanes mask, TextureId texture, Lanes rows) {
    ceiling_ = LaneValues(chosen(mask, inAllLanes(texture), ceiling_.lanes()));
    ceilingRow_ = LaneValues(chosen(mask, rows, ceilingRow_.lanes()));
    ceilingFromU_ = LaneValues(chosen(mask, inAllLanes(u_), ceilingFromU_.lanes()));
    ceilingFromV_ = LaneValues(chosen(mask, inAllLanes(v_), ceilingFromV_.lanes()));
}

// Ends the ceilings of some columns at a border; `rows` are the ceiling's rows there.
void StripWalk::takeCeiling(Lanes mask, Lanes rows, Border at) {
    const SliceWalk& any = this->any();
    const Lanes there = mask & ~(ceiling_.lanes() == inAllLanes(kNoTexture));
    unsigned bits = bitsOf(there);
    if (bits == 0 || any.ceilingRise_ == 0) return;
    const Lanes first = lesser(ceilingRow_.lanes(), rows);
    const Lanes last = greater(ceilingRow_.lanes(), rows);
    const auto planeOf = [&](int i) {
        return Plane{any.ceilingRise_,
                     static_cast<TextureId>(ceiling_.at[i]),
                     map_->ceiling.light,
                     map_->ceiling.glow,
                     true,
                     false};
    };
    const auto tilesOf = [&](int i) {
        return rangeTo(i, at, ceilingFromU_.at[i], ceilingFromV_.at[i]);
    };
    unsigned layers = 0;
    eachLane(bits, [&](int i) {
        if (!frame_.textures[static_cast<TextureId>(ceiling_.at[i])].seeThrough) return;
        layers |= 1u << i;
        open_.write(i);
        lane(i).seeThroughPlane(What::ceiling, planeOf(i), LaneValues(first).at[i],
                                LaneValues(last).at[i], tilesOf(i));
    });
    for (const auto& [i, from, to] : open_.take(maskOf(bits & ~layers), first, last)) {
        SliceWalk& walk = lane(i);
        walk.addPlane(What::ceiling, walk.lookOf(planeOf(i)), from, to, tilesOf(i));
    }
}

void StripWalk::takeCeilingHere(TextureId texture) {
    const std::int32_t rise = any().ceilingRise_;
    startCeiling(mask_, texture, rowsBelow(rise, Border::enter));
    takeCeiling(mask_, rowsBelow(rise, Border::leave), Border::leave);
    ceiling_ = LaneValues(chosen(mask_, inAllLanes(kNoTexture), ceiling_.lanes()));
}

}  // namespace slicecast
