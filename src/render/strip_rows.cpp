// Where the columns of a strip see heights at the borders of a tile.
#include "render/strip_walk.h"

namespace slicecast {

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
    enteredViewsKnown_ = leftViewsKnown_ = false;
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

}  // namespace slicecast
