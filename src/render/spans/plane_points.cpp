#include "render/spans/plane_points.h"

namespace slicecast {
// A position in 1/2^32 of a tile, clamped to [first, end). Exactly on an inner border it is there,
// or just before if the point belongs to the tile `before`; along a border on which the eye is, the
// ray's direction decides.
__attribute__((noinline)) std::int64_t PlanePoints::held(double first, double end, double start,
                                                         double perInverse, double inverse,
                                                         bool before) {
    constexpr double kTile = 4294967296.0;
    const double position = start + perInverse * inverse;
    if (position < first + kHalfStep) return static_cast<std::int64_t>(first * kTile);
    if (position >= end - kHalfStep) return static_cast<std::int64_t>(end * kTile) - 1;
    const std::int64_t held = PlaneLine::position(start, perInverse, inverse);
    if (static_cast<std::uint32_t>(held) != 0) return held;
    const bool isAlong =
        start == 0.0 && perInverse != 0.0 && position < kHalfStep && position >= -kHalfStep;
    return (isAlong ? perInverse < 0.0 : before) ? held - 1 : held;
}

// A point exactly on a border belongs to the tile behind it, because the eye counts as slightly
// further east and south. Behind a portal that turns, that direction may be west or north: then the
// point belongs to the tile before, and its fraction there is 1 instead of 0.
PlanePoints::Point PlanePoints::at(double inverseOffset) const {
    const std::int64_t east = held(box_.first[0], box_.end[0], line.eastStart, line.eastPerInverse,
                                   inverseOffset, turn_ == 1 || turn_ == 2);
    const std::int64_t south = held(box_.first[1], box_.end[1], line.southStart,
                                    line.southPerInverse, inverseOffset, turn_ == 2 || turn_ == 3);
    return {static_cast<std::uint32_t>(east), static_cast<std::uint32_t>(south),
            static_cast<int>(east >> 32), static_cast<int>(south >> 32)};
}

bool PlanePoints::anyOnBorderTurned(const double* inverseOffsets, int first, int last) const {
    bool any = false;
    for (int row = first; row < last; ++row) {
        const double inverse = inverseOffsets[row];
        const bool east =
            PlaneLine::fractionBits(line.eastStart, line.eastPerInverse, inverse) == 0;
        const bool south =
            PlaneLine::fractionBits(line.southStart, line.southPerInverse, inverse) == 0;
        any |= (east && turn_ != 3) || (south && turn_ != 1);
    }
    return any;
}

}  // namespace slicecast
