#include "render/light/lit_texels.h"

#include <algorithm>

namespace slicecast {
namespace {

// Four numbers: red, green, blue, alpha.
using Rgba = U32x4;

// channel = (c * light + 128) >> 8
Pixel litTexel(Pixel texel, Rgba light) {
    const Rgba channels = {texel & 0xff, texel >> 8 & 0xff, texel >> 16 & 0xff, texel >> 24};
    const Rgba lit = (channels * light + 128) >> 8;
    return lit[0] | lit[1] << 8 | lit[2] << 16 | lit[3] << 24;
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

// Lights texels, four at a time. Sums grow by `more` from one to the next, or to the one after
// `alike` of them.
void lightEvenly(const Pixel* texels, Pixel* out, int count, Rgba sum, Rgba more, int alike) {
    const Rgba zero = {};
    const Rgba toSecond = alike == 1 ? more : zero;
    const Rgba toThird = alike <= 2 ? more : zero;
    for (int i = 0; i < count; i += 4) {
        const Rgba second = sum + toSecond;
        const Rgba third = second + toThird;
        const Rgba fourth = third + toSecond;
        const U8x16 bytes = loadVector<U8x16>(texels + i);
        const U16x8 a =
            lowBytes(bytes) * (U16x8)narrowed(lightInSteps(sum), lightInSteps(second)) + 128;
        const U16x8 b =
            highBytes(bytes) * (U16x8)narrowed(lightInSteps(third), lightInSteps(fourth)) + 128;
        storeVector(out + i, upperBytes(a, b));
        sum = fourth + more;
    }
}

}  // namespace

std::int32_t TexelAxis::placeOf(int texel, int size) const {
    if (way == Way::downward)
        return std::min(65535, 65536 - ((middleOf(texel, size) - shift.raw) & 65535));
    const int along = way == Way::backward ? size - 1 - texel : texel;
    return (middleOf(along, size) + shift.raw) & 65535;
}

FaceTexels::FaceTexels(const TextureLevel& shown, LitFace face, Coordinate shiftA,
                       Coordinate shiftB)
    : level(shown) {
    using Way = TexelAxis::Way;
    const bool isSide = face <= LitFace::west;
    const bool isReversed = face == LitFace::north || face == LitFace::east;
    const bool isFromBelow =
        face == LitFace::bottom || face == LitFace::ceilingBelow || face == LitFace::ceilingAbove;
    a = {isReversed ? Way::backward : Way::forward, shiftA};
    b = {isSide ? Way::downward : isFromBelow ? Way::backward : Way::forward, shiftB};
}

LightColour lightAt(const FaceNodes& nodes, std::int32_t a, std::int32_t b) {
    LightColour light{};
    for (std::size_t channel = 0; channel < light.size(); ++channel) {
        int sum = 8192;
        for (const int nodeA : {0, 1}) {
            for (const int nodeB : {0, 1}) {
                const int weightA = (a & 32767) >> 8;
                const int weightB = (b & 32767) >> 8;
                const Pixel node = nodes.nodes[FaceNodes::index(a >> 15, b >> 15, nodeA, nodeB)];
                sum += static_cast<int>(node >> (8 * channel) & 255) *
                       (nodeA == 1 ? weightA : 128 - weightA) *
                       (nodeB == 1 ? weightB : 128 - weightB);
            }
        }
        light[channel] = (sum >> 14) + (sum >> 21);
    }
    return light;
}

void lightColumn(Pixel* out, int u, int first, int last, const FaceTexels& face,
                 const FaceNodes& nodes) {
    const TextureLevel& level = face.level;
    const int size = level.size;
    const std::int32_t a = face.a.placeOf(u, size);
    const U32x4 alongA = weights(static_cast<std::uint32_t>((a & 32767) >> 8));
    const auto node = [&](int squareB, int nodeB) {
        const std::size_t at = FaceNodes::index(a >> 15, squareB, 0, nodeB);
        return between(nodes.nodes[at], nodes.nodes[at + 2], alongA);
    };
    const auto weightOf = [](std::int32_t place) {
        return static_cast<std::uint32_t>((place & 32767) >> 8);
    };
    const Pixel* const texels = level.texels.data() + (static_cast<std::size_t>(u) << level.bits);
    constexpr int kLeastEven = 8;
    constexpr int kMostEven = 256;  // above this size, several texels have the same weight
    if (size >= kLeastEven && face.b.shift.raw == 0) {
        const int half = size / 2;
        const int alike = std::max(1, size / kMostEven);
        const auto step = static_cast<std::uint32_t>(std::max(1, 256 / size));
        for (const int begin : {0, half}) {
            const int from = std::max(first & ~3, begin);
            const int to = std::min(last, begin + half);
            if (from >= to) continue;
            const std::int32_t b = face.b.placeOf(from, size);
            const Rgba low = node(b >> 15, 0);
            const Rgba high = node(b >> 15, 1);
            const Rgba sum = between(low, high, weights(weightOf(b)));
            // May wrap around; the sums do not
            const Rgba rise = between(low, high, weights(step)) - between(low, high, weights(0));
            const bool forward = face.b.way == TexelAxis::Way::forward;
            lightEvenly(texels + from, out + (from - first), to - from, sum + 8192,
                        forward ? rise : -rise, alike);
        }
        return;
    }
    for (int v = first; v < last; ++v) {
        const std::int32_t b = face.b.placeOf(v, size);
        const int squareB = b >> 15;
        out[v - first] = litTexel(
            texels[v],
            lightInSteps(between(node(squareB, 0), node(squareB, 1), weights(weightOf(b))) + 8192));
    }
}

void lightAll(Pixel* out, const Pixel* texels, std::size_t first, std::size_t last,
              const LightColour& light) {
    const Rgba all = {static_cast<std::uint32_t>(light[0]), static_cast<std::uint32_t>(light[1]),
                      static_cast<std::uint32_t>(light[2]), 256};
    const auto twice = (U16x8)narrowed(all, all);
    std::size_t i = first;
    for (; i + 4 <= last; i += 4) {
        const U8x16 bytes = loadVector<U8x16>(texels + i);
        storeVector(out + i,
                    upperBytes(lowBytes(bytes) * twice + 128, highBytes(bytes) * twice + 128));
    }
    for (; i < last; ++i) out[i] = litTexel(texels[i], all);
}

}  // namespace slicecast
