#include "render/light/smooth_light.h"

#include "render/light/lit_texels.h"
#include "render/pixels/lanes.h"

#include <algorithm>

namespace slicecast {
namespace {

// channel = (c * light + 128) >> 8
Pixel timesLight(Pixel colour, U32x4 light) {
    const U32x4 channels = {colour & 0xff, colour >> 8 & 0xff, colour >> 16 & 0xff, colour >> 24};
    const U32x4 lit = (channels * light + 128) >> 8;
    return lit[0] | lit[1] << 8 | lit[2] << 16 | lit[3] << 24;
}

// Colours of the rows [first, last) times light; lightOf(row) is 0 to 256 for each channel.
template <typename LightOf>
void timesLightOfRows(Pixel* colours, int first, int last, LightOf&& lightOf) {
    int row = first;
    for (; row + 4 <= last; row += 4) {
        const U8x16 bytes = loadVector<U8x16>(colours + row);
        U32x4 light[4];  // by a loop, which keeps the program small
        for (int i = 0; i < 4; ++i) light[i] = lightOf(row + i);
        const auto upper = (U16x8)narrowed(light[0], light[1]);
        const auto lower = (U16x8)narrowed(light[2], light[3]);
        storeVector(colours + row,
                    upperBytes(lowBytes(bytes) * upper + 128, highBytes(bytes) * lower + 128));
    }
    for (; row < last; ++row) colours[row] = timesLight(colours[row], lightOf(row));
}

// The weights of two nodes, of 128, in the halves of all lanes, at a place in 1/65536 of a tile.
U32x4 nodeWeights(std::int32_t place) {
    const auto weight = static_cast<std::uint32_t>((place & 32767) >> 8);
    return allLanes((128 - weight) | weight << 16);
}

// 128 times what lies between two nodes.
U32x4 betweenNodes(Pixel low, Pixel high, U32x4 weights) {
    return dotPairs((U32x4)bytesInTurn(low, high), weights);
}

// The light between two of these.
U32x4 lightBetween(U32x4 low, U32x4 high, U32x4 weights) {
    return lightInSteps(dotPairs(low | high << 16, weights) + 8192);
}

// The light between the four nodes of a square.
U32x4 lightIn(const FaceNodes& nodes, std::int32_t a, std::int32_t b) {
    const Pixel* const square = nodes.nodes.data() + FaceNodes::index(a >> 15, b >> 15, 0, 0);
    const U32x4 alongA = nodeWeights(a);
    return lightBetween(betweenNodes(square[0], square[2], alongA),
                        betweenNodes(square[1], square[3], alongA), nodeWeights(b));
}

}  // namespace

Pixel litAt(Pixel colour, const FaceNodes& nodes, std::int32_t a, std::int32_t b) {
    return timesLight(colour, lightIn(nodes, a, b));
}

void lightSide(Pixel* colours, int rows, const FaceNodes& nodes, std::int32_t a,
               const TexelColumn& column, Coordinate rise) {
    // The nodes of the lower and the upper square, between those along the side
    const U32x4 alongA = nodeWeights(a);
    U32x4 node[2][2];
    for (int square = 0; square < 2; ++square) {
        for (int end = 0; end < 2; ++end) {
            const std::size_t at = FaceNodes::index(a >> 15, square, 0, end);
            node[square][end] = betweenNodes(nodes.nodes[at], nodes.nodes[at + 2], alongA);
        }
    }
    timesLightOfRows(colours, 0, rows, [&](int row) {
        const std::uint64_t position = column.start + static_cast<std::uint64_t>(row) * column.step;
        const auto down = static_cast<std::int32_t>(position >> (kTexturePositionBits - 16));
        const std::int32_t b = std::min(65535, 65536 - ((down - rise.raw) & 65535));
        const U32x4* const ends = node[b >> 15];
        return lightBetween(ends[0], ends[1], nodeWeights(b));
    });
}

void lightPlane(Pixel* colours, int first, int last, const FaceNodes& nodes, const PlaneLine& line,
                const double* inverseOffsets) {
    const PlaneLine at = line;
    timesLightOfRows(colours, first, last, [&](int row) {
        const double inverse = inverseOffsets[row];
        const auto place = [&](double start, double perInverse) {
            return static_cast<std::int32_t>(PlaneLine::fractionBits(start, perInverse, inverse) >>
                                             16);
        };
        return lightIn(nodes, place(at.eastStart, at.eastPerInverse),
                       place(at.southStart, at.southPerInverse));
    });
}

}  // namespace slicecast
