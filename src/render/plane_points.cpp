#include "render/plane_points.h"

namespace slicecast {
// The fraction of a tile at a position of a plane's row, in 1/2^32, held within [first, end).
std::uint32_t PlanePoints::held(double first, double end, double start, double perInverse,
                                double inverse) {
    const double position = start + perInverse * inverse;
    if (position < first) return 0;
    if (position >= end - kHalfStep) return ~std::uint32_t{0};
    return PlaneLine::fractionBits(start, perInverse, inverse);
}

PlanePoints::Point PlanePoints::heldAt(double inverseOffset) const {
    return {held(box_.east, box_.eastEnd, line.eastStart, line.eastPerInverse, inverseOffset),
            held(box_.south, box_.southEnd, line.southStart, line.southPerInverse, inverseOffset)};
}

// A point on the border of two tiles exactly belongs to the one behind it, for the eye counts as a
// trifle further east and south. Behind a portal that turns, that may be west or north: then it
// belongs to the one before, and its fraction there is 1 and not 0.
PlanePoints::Point PlanePoints::at(double inverseOffset) const {
    const auto before = [this](std::uint32_t bits, bool isTurned) {
        return bits == 0 && turn_ != 0 && isTurned ? ~std::uint32_t{0} : bits;
    };
    const Point point = heldAt(inverseOffset);
    return {before(point.east, turn_ != 3), before(point.south, turn_ != 1)};
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
