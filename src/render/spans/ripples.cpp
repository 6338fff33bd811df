#include "render/spans/ripples.h"

#include "render/pixels/lanes.h"
#include "render/spans/slice_spans.h"
#include "render/view/frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

bool isSamePlane(const ColumnSpans& found, const MirrorSpan& a, const MirrorSpan& b) {
    const auto vistaOf = [&](const MirrorSpan& span) {
        return found.parts[static_cast<std::size_t>(span.part)].vista;
    };
    return a.rise == b.rise && vistaOf(a) == vistaOf(b);
}

// From -4096 to 4096, for a phase of 256 a period.
int wave(int phase) {
    const int f = phase & 127;
    const int sign = -(phase >> 7 & 1);  // without a branch: it would be mispredicted
    return ((f * (128 - f)) ^ sign) - sign;
}

I16x8 wave(U16x8 phase) {
    const auto f = (I16x8)(phase & 127);
    const I16x8 sign = -(I16x8)(phase >> 7 & 1);
    return ((f * (128 - f)) ^ sign) - sign;
}

constexpr int kHighestWave = 512;

// How high the waves are at a point, or at eight, in 1/256 units; from -kHighestWave to
// kHighestWave. Only the low 11 bits of places and step matter.
template <typename Place>
auto waveAt(Place x, Place y, Place step) {
    return (2 * wave((5 * x + 3 * y + 8 * step) >> 3) + wave((9 * y - 4 * x + 8 * step) >> 2) +
            wave((11 * x - 6 * y + 10 * step) >> 2)) >>
           5;
}

// By row: the square of its offset from the horizon, divided, 1/262144. The same for all columns
// that see a mirror's plane.
const double* squaresOf(RippleMemory& memory, double perSquare, double horizon, std::size_t rows) {
    for (const RippleMemory::Squares& known : memory.squares) {
        if (known.perSquare == perSquare && known.horizon == horizon && known.byRow.size() == rows)
            return known.byRow.data();
    }
    RippleMemory::Squares& made = memory.squares[memory.oldest++ % memory.squares.size()];
    made.perSquare = perSquare;
    made.horizon = horizon;
    made.byRow.resize(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        const double offset = static_cast<double>(row) + 0.5 - horizon;
        made.byRow[row] = offset * offset / perSquare / 262144.0;
    }
    return made.byRow.data();
}

// What does not change along the rows of a mirror.
struct MirrorRows {
    const double* inverseOffsets;  // by row
    const double* squares;
    PlaneLine line;
    U16x8 eyeX;  // 1/256 units
    U16x8 eyeY;
    U16x8 step;
    double ripples;
    int most;
    int lowest;
    int highest;

    // The places of eight rows along an axis, in 1/256 of a tile.
    U16x8 places(int row, double start, double perInverse) const {
        const auto bits = [&](int i) {
            const F64x2 inverse = loadVector<F64x2>(inverseOffsets + row + i);
            return (F64x2)((U64x2)(start + PlaneLine::kFractionMagic + perInverse * inverse) >> 24);
        };
        return (U16x8)lowHalves(lowHalves(bits(0), bits(2)), lowHalves(bits(4), bits(6)));
    }

    // Writes which rows eight rows reflect: see rippledBy.
    void find(int row, int* shown) const {
        const U16x8 x = places(row, line.eastStart, line.eastPerInverse) + eyeX;
        const U16x8 y = places(row, line.southStart, line.southPerInverse) + eyeY;
        const I16x8 waves = waveAt(x, y, step);
        const double limit = most;
        const auto four = [&](I32x4 high, int i) {
            const auto moved = [&](F64x2 two, int first) {
                const F64x2 shift = loadVector<F64x2>(squares + row + first) * (two * ripples);
                return heldBetween(shift, -limit, limit) + (limit + 0.5);
            };
            const I32x4 rows = wholeOf(moved(firstTwo(high), i), moved(lastTwo(high), i + 2));
            storeVector(shown + i, heldBetween(rows + (I32x4{0, 1, 2, 3} + (row + i - most)),
                                               lowest, highest));
        };
        four(firstFour(waves), 0);
        four(lastFour(waves), 4);
    }
};

}  // namespace

int rippledBy(const RippledPoint& point, int most) {
    const double shift = point.offset * point.offset / point.perSquare *
                         (waveAt(point.x, point.y, point.step) * point.ripples) / 262144.0;
    // Rounds down by a conversion, from above 0
    const double limit = most;
    return static_cast<int>(std::clamp(shift, -limit, limit) + (limit + 0.5)) - most;
}

void findMirrorPlanes(const Frame& frame, const ColumnSpans& found) {
    std::vector<int>& planes = frame.ripples.planes;
    planes.assign(static_cast<std::size_t>(frame.vistas.projection().height), 0);
    const std::vector<MirrorSpan>& mirrors = found.mirrors;
    int plane = 0;
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        if (i == 0 || !isSamePlane(found, mirrors[i], mirrors[i - 1])) {
            plane = 0;
            while (!isSamePlane(found, mirrors[i], mirrors[static_cast<std::size_t>(plane)]))
                ++plane;
        }
        std::fill(planes.begin() + mirrors[i].first, planes.begin() + mirrors[i].last, plane + 1);
    }
}

const int* findRippledRows(const Frame& frame, int column, const ColumnSpans& found,
                           const MirrorSpan& span) {
    const std::vector<int>& planes = frame.ripples.planes;
    std::vector<int>& rows = frame.ripples.rows;
    rows.resize(planes.size());
    // As far as the mirror goes on above and below
    const auto isMirror = [&](int row) {
        return planes[static_cast<std::size_t>(row)] ==
               planes[static_cast<std::size_t>(span.first)];
    };
    int first = span.first;
    const int highest = std::max(0, first - frame.rippleRows);
    while (first > highest && isMirror(first - 1)) --first;
    int last = span.last;
    const int lowest = std::min(static_cast<int>(planes.size()), last + frame.rippleRows);
    while (last < lowest && isMirror(last)) ++last;

    const Vista& vista = *found.parts[static_cast<std::size_t>(span.part)].vista;
    const double height = Coordinate{-span.rise}.value();
    const GroundDirection ray = vista.ray(column);
    const PlaneLine line = {vista.viewpoint.fractionX(), vista.viewpoint.fractionY(),
                            height * ray.x, height * ray.y, false};
    const int eyeX = vista.viewpoint.tileX() * 256;
    const int eyeY = vista.viewpoint.tileY() * 256;
    const double perSquare = height * vista.projection->distance;
    const int step = static_cast<int>(frame.world->steps & 1023);
    const int most = frame.rippleRows;
    // Rows near the horizon show the far water, whose waves are too low to move anything
    const double stillOffset =
        std::sqrt(0.499 * 262144.0 / kHighestWave / span.ripples * perSquare);
    const double stillEnd = vista.projection->horizon + stillOffset - 0.5;
    const int firstMoved = static_cast<int>(
        std::clamp(stillEnd, static_cast<double>(span.first), static_cast<double>(span.last)));
    for (int row = span.first; row < firstMoved; ++row) rows[static_cast<std::size_t>(row)] = row;
    int row = firstMoved;
    const MirrorRows mirror = {
        vista.inverseOffsets,
        squaresOf(frame.ripples, perSquare, vista.projection->horizon, planes.size()),
        line,
        inEight(eyeX),
        inEight(eyeY),
        inEight(step),
        static_cast<double>(span.ripples),
        most,
        first,
        last - 1};
    // Eight at a time, also where some of them are behind the last one
    const int end = static_cast<int>(planes.size());
    for (; row < span.last && row + 8 <= end; row += 8) mirror.find(row, rows.data() + row);
    for (; row < span.last; ++row) {
        const double inverse = vista.inverseOffsets[row];
        const int x =
            eyeX + static_cast<int>(
                       PlaneLine::position(line.eastStart, line.eastPerInverse, inverse) >> 24);
        const int y =
            eyeY + static_cast<int>(
                       PlaneLine::position(line.southStart, line.southPerInverse, inverse) >> 24);
        const double offset = row + 0.5 - vista.projection->horizon;
        const int moved = rippledBy({x, y, step, span.ripples, offset, perSquare}, most);
        rows[static_cast<std::size_t>(row)] = std::clamp(row + moved, first, last - 1);
    }
    return rows.data();
}

}  // namespace slicecast
