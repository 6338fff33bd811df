// Part of the painter: the lit texels of a plane's rows. Near the eye, where rows show most of a
// square's texels, they are read from lit images; farther away each is lit as it is read.
#include "base/bits.h"
#include "render/lanes.h"
#include "render/lit_planes.h"
#include "render/lit_texels.h"
#include "render/slice_paint.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

// Rows that pass over more texels than this are far away.
constexpr double kTexelsOfFarRow = 3.0;

// Where a line over a plane is at its rows: as bits, in 1/2^32 of a tile above those of the magic
// number.
struct RowPoints {
    double eastStart;
    double eastPer;
    double southStart;
    double southPer;
    const double* inverseOffsets;

    RowPoints(const PlaneLine& line, const double* inverses)
        : eastStart(line.eastStart + PlaneLine::kFractionMagic),
          eastPer(line.eastPerInverse),
          southStart(line.southStart + PlaneLine::kFractionMagic),
          southPer(line.southPerInverse),
          inverseOffsets(inverses) {}

    I64x2 firstEast(int row) const { return twice(eastStart + eastPer * inverseOffsets[row]); }
    I64x2 firstSouth(int row) const { return twice(southStart + southPer * inverseOffsets[row]); }
    static I64x2 twice(double at) { return (I64x2)F64x2{at, at}; }
};
struct FourPoints {
    F64x2 eastA;
    F64x2 eastB;
    F64x2 southA;
    F64x2 southB;

    FourPoints(const RowPoints& points, int row) {
        const F64x2 inverseA = loadVector<F64x2>(points.inverseOffsets + row);
        const F64x2 inverseB = loadVector<F64x2>(points.inverseOffsets + row + 2);
        eastA = points.eastStart + points.eastPer * inverseA;
        eastB = points.eastStart + points.eastPer * inverseB;
        southA = points.southStart + points.southPer * inverseA;
        southB = points.southStart + points.southPer * inverseB;
    }
    // How many of them, from the first on, agree with the given ones from bit `shift` up.
    int beside(I64x2 east, I64x2 south, int shift) const {
        const I64x2 apartA = ((I64x2)eastA ^ east) | ((I64x2)southA ^ south);
        const I64x2 apartB = ((I64x2)eastB ^ east) | ((I64x2)southB ^ south);
        const I64x2 apart = apartA | apartB;
        if ((apart[0] | apart[1]) >> shift == 0) return 4;
        return apartA[0] >> shift != 0   ? 0
               : apartA[1] >> shift != 0 ? 1
               : apartB[0] >> shift != 0 ? 2
                                         : 3;
    }
};

U32x4 fourTexels(const Pixel* texels, U32x4 index) {
    return U32x4{texels[index[0]], texels[index[1]], texels[index[2]], texels[index[3]]};
}

// The functions below put the lit texel of each row from `first` on into out[row], while rows lie
// in the square of the first one, and return the first row beyond. They may also read and write the
// three places behind `last`.

// A square of a level, from litSquare.
struct PixelSquare {
    const Pixel* texels;
    int levelBits;
};
// Reads the texels of rows that lie in one lit square.
int readRows(Pixel* out, int first, int last, const PixelSquare& square, const PlaneLine& line,
             const double* inverseOffsets) {
    const int bits = litSquareBits(square.levelBits);
    // A place within a tile has its texel in the bits from here up, and its square from there up. A
    // single texel has no bits.
    const int shift = std::min(32 - square.levelBits, 31);
    const int squareShift = 32 - square.levelBits + bits;
    const std::uint32_t within = (1u << bits) - 1;
    const std::uint32_t reverse = line.southReversed ? within : 0;
    const Pixel* const texels = square.texels;
    const RowPoints points(line, inverseOffsets);
    const I64x2 firstEast = points.firstEast(first);
    const I64x2 firstSouth = points.firstSouth(first);
    int row = first;
    int inside = 4;  // how many of four rows are in the square
    for (; row < last && inside == 4; row += inside) {
        const FourPoints at(points, row);
        inside = at.beside(firstEast, firstSouth, squareShift);
        const U32x4 u = lowHalves(at.eastA, at.eastB) >> shift & within;
        const U32x4 v = (lowHalves(at.southA, at.southB) >> shift & within) ^ reverse;
        storeVector(out + row, fourTexels(texels, u << bits | v));
    }
    return std::min(row, last);
}

// A level, and the nodes between which a square of the tile lies.
struct NodeSquare {
    const Pixel* texels;
    int bits;  // above 0: a single texel has no square of its own
    const FaceNodes& nodes;
    int squareA;
    int squareB;
};

// Places that agree down to this bit, of 32 for a tile, are between the same nodes.
constexpr int kSquareBits = 31;

// How far behind the lower node of its square a texel is, of 128.
U32x4 nodeWeightOf(U32x4 texel, int bits) {
    return ((2 * texel + 1) << 7 >> bits) & 127;
}

// A square's nodes, two of a channel in one number: the lower one along a in its lower half.
struct Pairs {
    U32x4 low;  // along b; a lane for each channel
    U32x4 high;

    explicit Pairs(const NodeSquare& square) {
        const Pixel* const nodes =
            square.nodes.nodes.data() + FaceNodes::index(square.squareA, square.squareB, 0, 0);
        low = (U32x4)bytesInTurn(nodes[0], nodes[2]);
        high = (U32x4)bytesInTurn(nodes[1], nodes[3]);
    }
};

// Lights the texels of rows that lie between the same nodes.
int lightRows(Pixel* out, int first, int last, const NodeSquare& square, const PlaneLine& line,
              const double* inverseOffsets) {
    const int bits = square.bits;
    const int shift = 32 - bits;
    const Pixel* const texels = square.texels;
    const std::uint32_t reverse = line.southReversed ? (1u << bits) - 1 : 0;
    const Pairs pairs(square);
    const U16x8 half = (U16x8)allLanes(0x00800080);
    const RowPoints points(line, inverseOffsets);
    const I64x2 firstEast = points.firstEast(first);
    const I64x2 firstSouth = points.firstSouth(first);
    int row = first;
    int inside = 4;  // how many of four rows are in the square
    for (; row < last && inside == 4; row += inside) {
        const FourPoints at(points, row);
        inside = at.beside(firstEast, firstSouth, kSquareBits);
        const U32x4 u = lowHalves(at.eastA, at.eastB) >> shift;
        const U32x4 v = lowHalves(at.southA, at.southB) >> shift;
        const U32x4 index = (u << bits) | (v ^ reverse);
        const U32x4 four = fourTexels(texels, index);
        const U32x4 a = nodeWeightOf(u, bits);
        const U32x4 b = nodeWeightOf(v, bits);
        // The weights of the two nodes along a, in the halves of one number
        const U16x8 alongA = (U16x8)((128 - a) | a << 16);
        const U16x8 alongB = (U16x8)(b | b << 16);
        const U32x4 low = (U32x4)(alongA * ((U16x8)allLanes(0x00800080) - alongB));
        const U32x4 high = (U32x4)(alongA * alongB);
        const auto light = [&](int channel) {
            return lightInSteps(dotPairs(low, allLanes(pairs.low[channel])) +
                                dotPairs(high, allLanes(pairs.high[channel])) + 8192);
        };
        const U16x8 even = (U16x8)(light(0) | light(2) << 16);
        const U16x8 odd = (U16x8)(light(1) | allLanes(256u << 16));
        const U16x8 redBlue = ((U16x8)(four & 0x00ff00ff) * even + half) >> 8;
        const U16x8 greenAlpha = ((U16x8)(four >> 8 & 0x00ff00ff) * odd + half) >> 8;
        storeVector(out + row, (U32x4)redBlue | (U32x4)greenAlpha << 8);
    }
    return std::min(row, last);
}

}  // namespace

// The lit texels of rows, by row; valid until the next ones are made.
const Pixel* SlicePainter::fetchLitRows(const PlaneRun& run, int first, int last,
                                        const TextureLevel& level, const PlaneLine& line,
                                        const double* inverseOffsets) const {
    Pixel* const lit = frame_.lit.scratch(static_cast<std::size_t>(last + kRowsBeyond));
    // From one row to the next, a line moves on by inverse * inverse times this, texels
    const double perInverse =
        std::max(std::fabs(line.eastPerInverse), std::fabs(line.southPerInverse)) * level.size;
    for (int row = first; row < last;) {
        const double inverse = inverseOffsets[row];
        const std::int64_t east = PlaneLine::position(line.eastStart, line.eastPerInverse, inverse);
        const std::int64_t south =
            PlaneLine::position(line.southStart, line.southPerInverse, inverse);
        const auto tileX = static_cast<int>(east >> 32);
        const auto tileY = static_cast<int>(south >> 32);
        if (level.bits >= kLitSquareBits && perInverse * inverse * inverse > kTexelsOfFarRow) {
            const NodeSquare square = {
                level.texels.data(), level.bits, planeNodes(run, tileX, tileY),
                static_cast<int>(east >> 31 & 1), static_cast<int>(south >> 31 & 1)};
            row = lightRows(lit, row, last, square, line, inverseOffsets);
        } else {
            const auto u = texelIn(static_cast<std::uint32_t>(east), {}, level.bits);
            const auto v = texelIn(static_cast<std::uint32_t>(south), {}, level.bits);
            const PixelSquare square = {litSquare(run, level, tileX, tileY, u, v), level.bits};
            row = readRows(lit, row, last, square, line, inverseOffsets);
        }
    }
    return lit;
}

// The lit texels of the square that holds a texel of a plane's tile, whose place is relative to the
// eye's. Texels are counted in the map's direction.
const Pixel* SlicePainter::litSquare(const PlaneRun& run, const TextureLevel& level, int tileX,
                                     int tileY, std::uint32_t u, std::uint32_t v) {
    const Plane& plane = run.look->plane;
    if (plane.southReversed) v = static_cast<std::uint32_t>(level.size - 1) - v;
    const LitSquare square = {planeFace(run, tileX, tileY), level,      u >> kLitSquareBits,
                              v >> kLitSquareBits,          plane.east, plane.south};
    const Pixel* const known = run.vista->lit->knownTexels(square);
    return known != nullptr ? known : run.vista->lit->makeTexels(square, ownFace(run));
}

}  // namespace slicecast
