// Projects the contents of a tile and closes its rows, for all columns of a strip that pass it.
#include "render/strip_walk.h"

#include <algorithm>
#include <bit>
#include <span>

namespace slicecast {

// Finds the blocks of the current tile, from below; false if the columns cannot meet one of them
// together. A mirror cuts off everything below it; no ray enters a block from below, because a
// mirror under a block is invisible.
bool StripWalk::findBlocks(std::uint32_t reached) {
    const SliceWalk& any = this->any();
    blocks_ = 0;
    for (; reached != 0; reached &= reached - 1) {
        Block block = any.blockAt(tileX(v_), tileY(v_), std::countr_zero(reached));
        if (any.clipped_ && !any.cutToClip(block)) continue;
        const CellBlueprint& look = *block.blueprint;
        if (look.seeThrough || look.hasPortals || !look.isBox() ||
            (block.top < 0 && any.mirrorStrength(look.face(Face::top).mirror) > 0))
            return false;
        block_[blocks_++] = block;
    }
    return true;
}

void StripWalk::meet(unsigned bits, TextureId floor, TextureId ceiling) {
    mask_ = maskOf(bits);
    findPerRaw();
    changeCover(floor, blocks_ > 0 ? kNoTexture : ceiling);
    if (blocks_ == 0) return;
    report_.blocksMet += static_cast<std::int64_t>(blocks_) * std::popcount(bits);
    // The floor before the tile; it closes the rows below those of blocks on the floor
    takeFloor(mask_, Border::enter);
    meetFalling(ceiling);
    meetRising(ceiling);
    takeFloor(mask_, Border::leave);
}

void StripWalk::findPerRaw() {
    // At distance 0 or less, no column enters
    const auto per = [](double distance) {
        return distance > 0.0 ? 1.0 / (65536.0 * distance) : 0.0;
    };
    const double perU = per(near_);
    const double perV = per(enteredV_);
    const double leftPerU = per(far_);
    if (isWhole_) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            entered_[i] = speedU_[i] * perU;
            left_[i] = speedU_[i] * leftPerU;
        }
    } else {
        const LaneValues enteredAlongU(enteredAlongU_);
        const LaneValues leftAlongU(leftAlongU_);
        const double up = per(v_ + 1 - eyeV_ - fractionV_);
        const double down = per(fractionV_ + (eyeV_ - v_));
        for (std::size_t i = 0; i < kLanes; ++i) {
            entered_[i] = enteredAlongU.at[i] ? speedU_[i] * perU : speedV_[i] * perV;
            left_[i] =
                leftAlongU.at[i] ? speedU_[i] * leftPerU : speedV_[i] * (stepV_[i] > 0 ? up : down);
        }
    }
    viewsKnown_ = false;
}

// The same as firstRowBelow, for all columns that pass the tile.
Lanes StripWalk::rowsBelow(std::int32_t rise, Border at) const {
    constexpr double kMagic = 103079215104.0;  // see firstRowBelow
    const double* const perRaw = (at == Border::enter ? entered_ : left_).data();
    const double height = rise;
    const auto fixed = [&](std::size_t i) {
        const F64x2 a = projection_->horizonBelow - height * loadVector<F64x2>(perRaw + i);
        const F64x2 b = projection_->horizonBelow - height * loadVector<F64x2>(perRaw + i + 2);
        return lowHalves(heldBetween(a, 0.5, projection_->heightBelow) + kMagic,
                         heldBetween(b, 0.5, projection_->heightBelow) + kMagic);
    };
    const U32x4 rows[] = {fixed(0), fixed(4), fixed(8), fixed(12)};
    const auto isNear = [&](std::size_t i) { return (U32x4)(((rows[i] + 1) & 0xffff) < 3); };
    const Lanes found = {narrowed(rows[0] >> 16, rows[1] >> 16),
                         narrowed(rows[2] >> 16, rows[3] >> 16)};
    const U32x4 near[] = {isNear(0), isNear(1), isNear(2), isNear(3)};
    if (!anyOf(near[0] | near[1] | near[2] | near[3])) return found;
    const Lanes nearOnes = {narrowed(near[0], near[1]), narrowed(near[2], near[3])};
    return exactRows(found, bitsOf(nearOnes & mask_), rise, at);
}

Lanes StripWalk::exactRows(Lanes rows, unsigned bits, std::int32_t rise, Border at) const {
    LaneValues values(rows);
    eachLane(bits, [&](int i) {
        values.at[i] =
            static_cast<std::int16_t>(firstRowBelowExactly(*projection_, rise, crossingOf(i, at)));
    });
    return values.lanes();
}

// The same as GridWalk's crossing.
Crossing StripWalk::crossingOf(int lane, Border at) const {
    const auto i = static_cast<std::size_t>(lane);
    const bool entering = at == Border::enter;
    const bool alongU = bitsOf(entering ? enteredAlongU_ : leftAlongU_) >> lane & 1;
    const double leftV = stepV_[i] > 0 ? v_ + 1 - eyeV_ - fractionV_ : fractionV_ + (eyeV_ - v_);
    const double distance = alongU ? (entering ? near_ : far_) : (entering ? enteredV_ : leftV);
    const double speed = (alongU ? speedU_ : speedV_)[i];
    const bool nearing = (alongU ? stepU_ : stepV_[i]) > 0;
    const double rowsPerRaw = distance > 0.0 ? speed / distance * (1.0 / 65536.0) : kHugeRows;
    return {distance / speed, distance, speed, rowsPerRaw, alongU == alongX_, nearing, nearing};
}

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

// See SliceWalk::meetFalling; here all blocks are plain and none contains the eye.
void StripWalk::meetFalling(TextureId ceiling) {
    const SliceWalk& any = this->any();
    bool ceilingToCome = ceiling != kNoTexture && any.ceilingRise_ < 0;
    std::int32_t edge = kHighest;
    Lanes edgeRows = mask_;
    for (std::size_t n = blocks_; n-- > 0;) {
        const Block& block = block_[n];
        if (!(any.levelsToEye_ >> block.level & 1) || block.bottom > 0) continue;
        const bool covered = block.top == edge;
        const Lanes top = covered ? edgeRows : rowsBelow(block.top, Border::enter);
        edge = block.bottom;
        edgeRows = rowsBelow(edge, Border::enter);
        takeSide(block, top, edgeRows);
        if (block.top >= 0) continue;
        if (ceilingToCome && any.ceilingRise_ > block.top) {
            takeCeilingHere(ceiling);
            ceilingToCome = false;
        }
        if (!covered && bitsOf(mask_ & open_.reachAbove(top)) != 0)
            takeFace(block, Face::top, rowsBelow(block.top, Border::leave), top);
    }
    if (ceilingToCome) takeCeilingHere(ceiling);
}

void StripWalk::meetRising(TextureId ceiling) {
    const SliceWalk& any = this->any();
    bool ceilingToCome = ceiling != kNoTexture && any.ceilingRise_ > 0;
    std::int32_t edge = -kHighest;
    Lanes edgeRows = mask_;
    for (std::size_t n = 0; n < blocks_; ++n) {
        const Block& block = block_[n];
        if (block.bottom <= 0) continue;
        const bool covered = block.bottom == edge;
        const Lanes bottom = covered ? edgeRows : rowsBelow(block.bottom, Border::enter);
        edge = block.top;
        edgeRows = rowsBelow(edge, Border::enter);
        takeSide(block, edgeRows, bottom);
        if (ceilingToCome && any.ceilingRise_ < block.bottom) {
            takeCeilingHere(ceiling);
            ceilingToCome = false;
        }
        if (!covered && !block.cut && bitsOf(mask_ & open_.reachBelow(bottom)) != 0)
            takeFace(block, Face::bottom, bottom, rowsBelow(block.bottom, Border::leave));
    }
    if (ceilingToCome) takeCeilingHere(ceiling);
}

void StripWalk::takeSide(const Block& block, Lanes first, Lanes last) {
    const std::span<const LaneRows> taken = open_.take(mask_, first, last);
    if (taken.empty()) return;
    if (!viewsKnown_) findViews();
    const unsigned alongU = bitsOf(enteredAlongU_);
    const SliceWalk& any = this->any();
    const auto sideAlong = [&](bool isU) {
        const bool nearing = isU ? stepU_ > 0 : v_ > eyeV_;
        const Crossing border = {.alongX = isU == alongX_, .nearing = nearing};
        return any.sideOf(block, enteredFace(border), false);
    };
    const SliceWalk::Side sides[] = {sideAlong(false), sideAlong(true)};
    const TileRange here = {tileX(v_), tileY(v_), tileX(v_), tileY(v_), false};
    for (const auto& [i, from, to] : taken) {
        SliceWalk& walk = lane(i);
        walk.here_ = here;
        walk.addSide(sides[alongU >> i & 1], views_[static_cast<std::size_t>(i)], from, to);
    }
}

// The same as SliceWalk::sideView.
void StripWalk::findViews() {
    viewsKnown_ = true;
    const Lighting& lighting = any().vista_->lighting;
    const LaneValues alongU(enteredAlongU_);
    const double baseV = fractionV_ + (eyeV_ - v_);
    const double baseU = fractionU_ + (eyeU_ - u_);
    eachLane(bitsOf(mask_), [&](int lane) {
        const auto i = static_cast<std::size_t>(lane);
        const bool isU = alongU.at[i] != 0;
        const double distance = isU ? near_ : enteredV_;
        const double speed = isU ? speedU_[i] : speedV_[i];
        const double across = isU ? rayV_[i] : speedU_[i] * stepU_;
        SliceWalk::SideView& view = views_[i];
        view.along = distance / speed;
        view.fraction = SliceWalk::fractionBits((isU ? baseV : baseU) + across * distance / speed);
        view.depth = view.along * projection_->distance;
        view.brightness = lighting.brightnessAt(view.depth);
        view.fog = lighting.fogAt(view.depth);
    });
}

// Closes the rows of a roof or an underside.
void StripWalk::takeFace(const Block& block, Face face, Lanes first, Lanes last) {
    PlaneLook* look = nullptr;
    const TileRange here = {tileX(v_), tileY(v_), tileX(v_), tileY(v_), false};
    for (const auto& [i, from, to] : open_.take(mask_, first, last)) {
        SliceWalk& walk = lane(i);
        if (look == nullptr) look = &walk.lookOf(walk.planeOf(block, face));
        Span& span =
            walk.addPlane(face == Face::top ? What::roof : What::underside, *look, from, to, here);
        span.level = block.level;
        span.face = face;
    }
}

}  // namespace slicecast
