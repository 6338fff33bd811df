#include "render/lit_texels.h"

#include "base/bits.h"
#include "render/lanes.h"

#include <algorithm>

namespace slicecast {
namespace {

// Positions that agree down to this bit, of 32 for a tile, are in one square.
constexpr int kSquareBits = 31;

// Four numbers: red, green, blue, alpha.
using Rgba = U32x4;

// channel = (c * light + 128) >> 8
Pixel litTexel(Pixel texel, Rgba light) {
    const Rgba channels = {texel & 0xff, texel >> 8 & 0xff, texel >> 16 & 0xff, texel >> 24};
    const Rgba lit = (channels * light + 128) >> 8;
    return lit[0] | lit[1] << 8 | lit[2] << 16 | lit[3] << 24;
}

// The light of a weighted sum of nodes: 0 to 256.
U32x4 inSteps(U32x4 sum) {
    return (sum >> 14) + (sum >> 21);
}

// Two weights of 128 in the halves of all lanes, for dotPairs.
U32x4 weights(std::uint32_t weight) {
    return allLanes((128 - weight) | weight << 16);
}

// 128 times what lies between two nodes.
Rgba between(Pixel low, Pixel high, U32x4 weights) {
    return dotPairs((U32x4)bytesInTurn(low, high), weights);
}
// The same between two such sums, of 16384.
Rgba between(Rgba low, Rgba high, U32x4 weights) {
    return dotPairs(low | high << 16, weights);
}

// How far behind the lower node of its square a texel is, of 128.
U32x4 weightOf(U32x4 texel, int bits) {
    return ((2 * texel + 1) << 7 >> bits) & 127;
}

// Lights texels, four at a time, whose sums grow by `more` from one to the next.
void lightEvenly(const Pixel* texels, Pixel* out, int count, Rgba sum, Rgba more) {
    for (int i = 0; i < count; i += 4) {
        const Rgba second = sum + more;
        const Rgba third = second + more;
        const Rgba fourth = third + more;
        const U8x16 bytes = loadVector<U8x16>(texels + i);
        const U16x8 a = lowBytes(bytes) * (U16x8)narrowed(inSteps(sum), inSteps(second)) + 128;
        const U16x8 b = highBytes(bytes) * (U16x8)narrowed(inSteps(third), inSteps(fourth)) + 128;
        storeVector(out + i, upperBytes(a, b));
        sum = fourth + more;
    }
}

// Lights the colours of the rows [first, last); lightOf(row) is 0 to 256 for each channel.
template <typename LightOf>
void lightRows(Pixel* colours, int first, int last, LightOf&& lightOf) {
    int row = first;
    for (; row + 4 <= last; row += 4) {
        const U8x16 bytes = loadVector<U8x16>(colours + row);
        const auto upper = (U16x8)narrowed(lightOf(row), lightOf(row + 1));
        const auto lower = (U16x8)narrowed(lightOf(row + 2), lightOf(row + 3));
        storeVector(colours + row,
                    upperBytes(lowBytes(bytes) * upper + 128, highBytes(bytes) * lower + 128));
    }
    for (; row < last; ++row) colours[row] = litTexel(colours[row], lightOf(row));
}

// The weights of a place in 1/65536 of a tile.
U32x4 weightsAt(std::int32_t place) {
    return weights(static_cast<std::uint32_t>((place & 32767) >> 8));
}

// The light between the four nodes of a square.
U32x4 lightIn(const FaceNodes& nodes, std::int32_t a, std::int32_t b) {
    const Pixel* const square = nodes.nodes.data() + FaceNodes::index(a >> 15, b >> 15, 0, 0);
    const U32x4 alongA = weightsAt(a);
    return inSteps(between(between(square[0], square[2], alongA),
                           between(square[1], square[3], alongA), weightsAt(b)) +
                   8192);
}

// A square's nodes, two of a channel in one number: the lower one along a in its lower half.
struct Pairs {
    U32x4 low;  // along b; a lane for each channel
    U32x4 high;

    explicit Pairs(const LitSquare& square) {
        const Pixel* const nodes =
            square.nodes.nodes.data() + FaceNodes::index(square.squareA, square.squareB, 0, 0);
        low = (U32x4)bytesInTurn(nodes[0], nodes[2]);
        high = (U32x4)bytesInTurn(nodes[1], nodes[3]);
    }
};

}  // namespace

int fetchLit(Pixel* out, int first, int last, const LitSquare& square, const PlaneLine& line,
             const double* inverseOffsets) {
    const int bits = square.bits;
    const int shift = 32 - bits;
    const Pixel* const texels = square.texels;
    const std::uint32_t reverse = line.southReversed ? (1u << bits) - 1 : 0;
    const Pairs pairs(square);
    const double eastStart = line.eastStart + PlaneLine::kFractionMagic;
    const double southStart = line.southStart + PlaneLine::kFractionMagic;
    const U16x8 half = (U16x8)allLanes(0x00800080);
    const auto firstBits = [&](double start, double perInverse) {
        const double at = start + perInverse * inverseOffsets[first];
        return (I64x2)F64x2{at, at};
    };
    const I64x2 firstEast = firstBits(eastStart, line.eastPerInverse);
    const I64x2 firstSouth = firstBits(southStart, line.southPerInverse);
    int row = first;
    int inside = 4;  // how many of four rows are in the square
    for (; row < last && inside == 4; row += inside) {
        const F64x2 inverseA = loadVector<F64x2>(inverseOffsets + row);
        const F64x2 inverseB = loadVector<F64x2>(inverseOffsets + row + 2);
        const F64x2 eastA = eastStart + line.eastPerInverse * inverseA;
        const F64x2 eastB = eastStart + line.eastPerInverse * inverseB;
        const F64x2 southA = southStart + line.southPerInverse * inverseA;
        const F64x2 southB = southStart + line.southPerInverse * inverseB;
        const I64x2 apartA = ((I64x2)eastA ^ firstEast) | ((I64x2)southA ^ firstSouth);
        const I64x2 apartB = ((I64x2)eastB ^ firstEast) | ((I64x2)southB ^ firstSouth);
        const I64x2 apart = apartA | apartB;
        if ((apart[0] | apart[1]) >> kSquareBits != 0) {
            inside = apartA[0] >> kSquareBits != 0   ? 0
                     : apartA[1] >> kSquareBits != 0 ? 1
                     : apartB[0] >> kSquareBits != 0 ? 2
                                                     : 3;
            if (inside == 0) break;
        }
        const U32x4 u = lowHalves(eastA, eastB) >> shift;
        const U32x4 v = lowHalves(southA, southB) >> shift;
        const U32x4 index = (u << bits) | (v ^ reverse);
        const U32x4 four = {texels[index[0]], texels[index[1]], texels[index[2]], texels[index[3]]};
        const U32x4 a = weightOf(u, bits);
        const U32x4 b = weightOf(v, bits);
        // The weights of the two nodes along a, in the halves of one number
        const U16x8 alongA = (U16x8)((128 - a) | a << 16);
        const U16x8 alongB = (U16x8)(b | b << 16);
        const U32x4 low = (U32x4)(alongA * ((U16x8)allLanes(0x00800080) - alongB));
        const U32x4 high = (U32x4)(alongA * alongB);
        const auto light = [&](int channel) {
            return inSteps(dotPairs(low, allLanes(pairs.low[channel])) +
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

Pixel litAt(Pixel texel, const FaceNodes& nodes, std::int32_t a, std::int32_t b) {
    return litTexel(texel, lightIn(nodes, a, b));
}

void lightSide(Pixel* colours, int rows, const FaceNodes& nodes, std::int32_t a,
               const TexelColumn& column, Coordinate rise) {
    // The nodes of the lower and the upper square, between those along the side
    const U32x4 alongA = weightsAt(a);
    Rgba node[2][2];
    for (int square = 0; square < 2; ++square) {
        for (int end = 0; end < 2; ++end) {
            const std::size_t at = FaceNodes::index(a >> 15, square, 0, end);
            node[square][end] = between(nodes.nodes[at], nodes.nodes[at + 2], alongA);
        }
    }
    lightRows(colours, 0, rows, [&](int row) {
        const std::uint64_t position = column.start + static_cast<std::uint64_t>(row) * column.step;
        const auto down = static_cast<std::int32_t>(position >> (kTexturePositionBits - 16));
        const std::int32_t b = std::min(65535, 65536 - ((down - rise.raw) & 65535));
        const Rgba* const ends = node[b >> 15];
        return inSteps(between(ends[0], ends[1], weightsAt(b)) + 8192);
    });
}

void lightPlane(Pixel* colours, int first, int last, const FaceNodes& nodes, const PlaneLine& line,
                const double* inverseOffsets) {
    const PlaneLine at = line;
    lightRows(colours, first, last, [&](int row) {
        const double inverse = inverseOffsets[row];
        const auto place = [&](double start, double perInverse) {
            return static_cast<std::int32_t>(PlaneLine::fractionBits(start, perInverse, inverse) >>
                                             16);
        };
        return lightIn(nodes, place(at.eastStart, at.eastPerInverse),
                       place(at.southStart, at.southPerInverse));
    });
}

Pixel litTexelAt(const Pixel* texels, int bits, const FaceNodes& nodes, std::uint32_t east,
                 std::uint32_t south, const TexelLay& lay) {
    const std::uint32_t u = texelIn(east, lay.east, bits);
    const std::uint32_t v = texelIn(south, lay.south, bits);
    const std::uint32_t reverse = lay.southReversed ? (1u << bits) - 1 : 0;
    const auto placeOf = [&](std::uint32_t texel, Coordinate shift) {
        return (middleOf(static_cast<int>(texel), 1 << bits) + shift.raw) & 65535;
    };
    return litAt(texels[(u << bits) | (v ^ reverse)], nodes, placeOf(u, lay.east),
                 placeOf(v, lay.south));
}

void lightColumn(Pixel* out, int first, int last, const SideTexels& side, const FaceNodes& nodes) {
    const int size = side.level.size;
    const bool reversed = side.face == LitFace::north || side.face == LitFace::east;
    const std::int32_t a =
        (middleOf(reversed ? size - 1 - side.u : side.u, size) + side.slide.raw) & 65535;
    const U32x4 alongA = weights(static_cast<std::uint32_t>((a & 32767) >> 8));
    const auto node = [&](int squareB, int nodeB) {
        const std::size_t at = FaceNodes::index(a >> 15, squareB, 0, nodeB);
        return between(nodes.nodes[at], nodes.nodes[at + 2], alongA);
    };
    const Pixel* const texels =
        side.level.texels.data() + (static_cast<std::size_t>(side.u) << side.level.bits);
    constexpr int kLeastEven = 8;
    constexpr int kMostEven = 256;  // up to this size the weights grow evenly
    if (size >= kLeastEven && size <= kMostEven && side.rise.raw == 0) {
        // Downwards, from the upper square to the lower one
        const int half = size / 2;
        const auto begin = static_cast<std::uint32_t>(128 / size);
        const auto step = static_cast<std::uint32_t>(256 / size);
        for (int squareB = 1; squareB >= 0; --squareB) {
            const int upper = squareB == 1 ? 0 : half;
            const int from = std::max(first & ~3, upper);
            const int to = std::min(last, upper + half);
            if (from >= to) continue;
            const Rgba low = node(squareB, 0);
            const Rgba high = node(squareB, 1);
            const auto weight = begin + static_cast<std::uint32_t>(upper + half - 1 - from) * step;
            const Rgba sum = between(low, high, weights(weight));
            // May wrap around; the sums do not
            const Rgba more = between(low, high, weights(0)) - between(low, high, weights(step));
            lightEvenly(texels + from, out + from, to - from, sum + 8192, more);
        }
        return;
    }
    for (int v = first; v < last; ++v) {
        const std::int32_t b =
            std::min(65535, 65536 - ((middleOf(v, size) - side.rise.raw) & 65535));
        const int squareB = b >> 15;
        const auto weightB = static_cast<std::uint32_t>((b & 32767) >> 8);
        out[v] =
            litTexel(texels[v],
                     inSteps(between(node(squareB, 0), node(squareB, 1), weights(weightB)) + 8192));
    }
}

void lightAll(Pixel* out, const Pixel* texels, std::size_t first, std::size_t last,
              const LightColour& light) {
    const Rgba all = {static_cast<std::uint32_t>(light[0]), static_cast<std::uint32_t>(light[1]),
                      static_cast<std::uint32_t>(light[2]), 256};
    for (std::size_t i = first; i < last; ++i) out[i] = litTexel(texels[i], all);
}

}  // namespace slicecast
