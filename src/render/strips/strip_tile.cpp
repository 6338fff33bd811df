// Where the columns of a strip see heights and sides at the borders of a tile.
#include "render/strips/strip_tile.h"

namespace slicecast {

__attribute__((noinline)) void StripTile::enter(unsigned bits) {
    mask = maskOf(bits);
    stretch = {};
    isDivided = isFirst = false;
    enteredViewsKnown_ = leftViewsKnown_ = false;
    findRowsPerRaw();
}

void StripTile::enterStretch(unsigned bits, const Stretch& part) {
    mask = maskOf(bits);
    stretch = part;
    isDivided = true;
    enteredViewsKnown_ = leftViewsKnown_ = false;
    eachLane(bits, [&](int lane) {
        entered_[indexOf(lane)] = enters[indexOf(lane)].rowsPerRaw;
        left_[indexOf(lane)] = leaves[indexOf(lane)].rowsPerRaw;
    });
}

void StripTile::place(int lane) {
    if (tileX() == view.startX && tileY() == view.startY) return;
    const bool isU = bitsOf(enteredAlongU) >> lane & 1;
    column(lane).walk.comeTo(tileX(), tileY(), isU == rays.alongX);
}

void StripTile::findRowsPerRaw() {
    // No column crosses a border that is behind the eye
    const auto per = [](double distance) {
        return distance > 0.0 ? 1.0 / (65536.0 * distance) : distance < 0.0 ? 0.0 : kHugeRows;
    };
    const double perU = per(near);
    const double leftPerU = per(far);
    if (isWhole) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            entered_[i] = rays.speedU[i] * perU;
            left_[i] = rays.speedU[i] * leftPerU;
        }
        return;
    }
    const LaneValues enteredU(enteredAlongU);
    const LaneValues leftU(leftAlongU);
    const double perV = per(enteredV);
    const double up = per(rays.leavesV(v, true));
    const double down = per(rays.leavesV(v, false));
    for (std::size_t i = 0; i < kLanes; ++i) {
        entered_[i] = enteredU.at[i] ? rays.speedU[i] * perU : rays.speedV[i] * perV;
        left_[i] = leftU.at[i] ? rays.speedU[i] * leftPerU
                               : rays.speedV[i] * (rays.stepV[i] > 0 ? up : down);
    }
}

// The same as firstRowBelow, for all columns that pass the tile. Near the middle of a row the
// product's rounding could decide; there the exact quotient and the tie rule do.
Lanes StripTile::rowsBelow(std::int32_t rise, Border at) const {
    // Adding this to a number below 2^16 leaves 16 bits of its fraction at the end of the double's
    // bits: cheaper than a conversion.
    constexpr double kMagic = 103079215104.0;  // 1.5 * 2^36
    const Projection& projection = *view.projection;
    const double* const perRaw = (at == Border::enter ? entered_ : left_).data();
    const double height = rise;
    const auto fixed = [&](std::size_t i) {
        const F64x2 a = projection.horizonBelow - height * loadVector<F64x2>(perRaw + i);
        const F64x2 b = projection.horizonBelow - height * loadVector<F64x2>(perRaw + i + 2);
        return lowHalves(heldBetween(a, 0.5, projection.heightBelow) + kMagic,
                         heldBetween(b, 0.5, projection.heightBelow) + kMagic);
    };
    const U32x4 rows[] = {fixed(0), fixed(4), fixed(8), fixed(12)};
    const auto isNear = [&](std::size_t i) { return (U32x4)(((rows[i] + 1) & 0xffff) < 3); };
    const Lanes found = {narrowed(rows[0] >> 16, rows[1] >> 16),
                         narrowed(rows[2] >> 16, rows[3] >> 16)};
    const U32x4 nearMiddle[] = {isNear(0), isNear(1), isNear(2), isNear(3)};
    if (!anyOf(nearMiddle[0] | nearMiddle[1] | nearMiddle[2] | nearMiddle[3])) return found;
    const Lanes nearOnes = {narrowed(nearMiddle[0], nearMiddle[1]),
                            narrowed(nearMiddle[2], nearMiddle[3])};
    return exactRows(found, bitsOf(nearOnes & mask), rise, at);
}

Lanes StripTile::exactRows(Lanes rows, unsigned bits, std::int32_t rise, Border at) const {
    LaneValues values(rows);
    eachLane(bits, [&](int i) {
        values.at[i] =
            static_cast<std::int16_t>(firstRowBelow(*view.projection, rise, crossingOf(i, at)));
    });
    return values.lanes();
}

// The same as GridWalk's crossing.
Crossing StripTile::crossingOf(int lane, Border at) const {
    const std::size_t i = indexOf(lane);
    const bool entering = at == Border::enter;
    if (isDivided) return (entering ? enters : leaves)[i];
    const bool isU = bitsOf(entering ? enteredAlongU : leftAlongU) >> lane & 1;
    const bool upward = rays.stepV[i] > 0;
    const double distance = isU        ? (entering ? near : far)
                            : entering ? enteredV
                                       : rays.leavesV(v, upward);
    const double speed = (isU ? rays.speedU : rays.speedV)[i];
    const bool nearing = isU ? rays.stepU > 0 : upward;
    const double rowsPerRaw = distance > 0.0 ? speed / distance * (1.0 / 65536.0) : kHugeRows;
    const bool isX = isU == rays.alongX;
    return {
        distance / speed, distance, speed, rowsPerRaw, isX, nearing, columns[i].walk.isEarly(isX)};
}

std::pair<int, int> StripTile::beyond(const CrossingLanes& crossing, Border border) const {
    if (at(border) != End::border) return {tileX(), tileY()};
    const int onward = crossing.nearing == (border == Border::leave) ? 1 : -1;
    return {tileX() + (crossing.alongX ? onward : 0), tileY() + (crossing.alongX ? 0 : onward)};
}

std::span<const CrossingLanes> StripTile::crossings(Border at) {
    const bool entering = at == Border::enter;
    std::size_t count = 0;
    const auto add = [&](Lanes lanes, bool alongX, bool nearing) {
        const Lanes some = mask & lanes;
        if (bitsOf(some) != 0) crossings_[count++] = {some, alongX, nearing};
    };
    if (isDivided) {
        unsigned bits[2][2] = {};
        eachLane(bitsOf(mask), [&](int lane) {
            const Crossing& crossing = (entering ? enters : leaves)[indexOf(lane)];
            bits[crossing.alongX][crossing.nearing] |= 1u << lane;
        });
        for (const bool alongX : {false, true}) {
            for (const bool nearing : {false, true})
                add(maskOf(bits[alongX][nearing]), alongX, nearing);
        }
        return {crossings_.data(), count};
    }
    const Lanes isU = entering ? enteredAlongU : leftAlongU;
    add(isU, rays.alongX, rays.stepU > 0);
    if (entering) {
        add(~isU, !rays.alongX, entersUpward);
    } else {
        const Lanes upward = inAllLanes(0) < rays.stepsV;
        add(~isU & upward, !rays.alongX, true);
        add(~isU & ~upward, !rays.alongX, false);
    }
    return {crossings_.data(), count};
}

const StripTile::SideViews& StripTile::viewsAt(Border at) {
    const bool entering = at == Border::enter;
    SideViews& views = entering ? enteredViews_ : leftViews_;
    bool& known = entering ? enteredViewsKnown_ : leftViewsKnown_;
    if (known) return views;
    known = true;
    const Lighting& lighting = view.vista->lighting;
    const double baseV = rays.fractionV + (rays.eyeV - v);
    const double baseU = rays.fractionU + (rays.eyeU - u);
    eachLane(bitsOf(mask), [&](int lane) {
        const std::size_t i = indexOf(lane);
        const Crossing crossing = crossingOf(lane, at);
        const bool isU = crossing.alongX == rays.alongX;
        // Along y for sides facing east and west, along x for the others
        const double across = isU ? rays.rayV[i] : rays.speedU[i] * rays.stepU;
        SideView& side = views[i];
        side.along = crossing.along;
        side.fraction =
            fractionBits((isU ? baseV : baseU) + across * crossing.distance / crossing.speed);
        side.depth = side.along * view.projection->distance;
        side.brightness = lighting.brightnessAt(side.depth);
        side.fog = lighting.fogAt(side.depth);
    });
    return views;
}

}  // namespace slicecast
