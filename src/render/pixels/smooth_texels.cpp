#include "render/pixels/smooth_texels.h"

#include "render/pixels/lanes.h"

namespace slicecast {
namespace {

// The four texels round a point, by their numbers along u and then v.
struct FourTexels {
    Pixel at[4];
    std::uint32_t shareU;
    std::uint32_t shareV;

    FourTexels(const Pixel* left, const Pixel* right, const SmoothPlace& u, const SmoothPlace& v)
        : at{left[v.first], left[v.second], right[v.first], right[v.second]},
          shareU(u.share),
          shareV(v.share) {}

    Pixel nearest() const { return at[(shareU >= 64 ? 2 : 0) + (shareV >= 64 ? 1 : 0)]; }
};

// Two shares of 128 in the halves of all lanes, for dotPairs.
U32x4 sharesOf(std::uint32_t second) {
    return allLanes((128 - second) | second << 16);
}

// 128 times what lies between two texels: red, green, blue, alpha.
U32x4 blend(Pixel first, Pixel second, U32x4 shares) {
    return dotPairs((U32x4)bytesInTurn(first, second), shares);
}

// Red, green, blue and alpha, blended.
U32x4 blended(const FourTexels& four) {
    const U32x4 down = sharesOf(four.shareV);
    const U32x4 left = blend(four.at[0], four.at[1], down);
    const U32x4 right = blend(four.at[2], four.at[3], down);
    return (dotPairs(left | right << 16, sharesOf(four.shareU)) + 8192) >> 14;
}

// The same as a pixel, with the alpha of the nearest texel and without the colours of holes.
Pixel withAlpha(FourTexels four) {
    const Pixel nearest = four.nearest();
    for (Pixel& texel : four.at) texel = texel >> 24 == 0 ? nearest : texel;
    const U32x4 colour = blended(four);
    return colour[0] | colour[1] << 8 | colour[2] << 16 | (nearest & 0xff000000);
}

// Fills the rows [first, last) of `out`; four(row) gives their texels.
template <typename Four>
void blendRows(Pixel* out, int first, int last, bool seeThrough, Four&& four) {
    int row = first;
    if (!seeThrough) {
        for (; row + 4 <= last; row += 4) {
            U32x4 colours[4];  // by a loop, which keeps the program small
            for (int i = 0; i < 4; ++i) colours[i] = blended(four(row + i));
            const auto a = (U16x8)narrowed(colours[0], colours[1]);
            const auto b = (U16x8)narrowed(colours[2], colours[3]);
            storeVector(out + row, upperBytes(a << 8, b << 8));
        }
    }
    for (; row < last; ++row) out[row] = withAlpha(four(row));
}

const Pixel* texelsOfColumn(const SmoothTexture& texture, std::uint32_t number) {
    return texture.texels + (static_cast<std::size_t>(number) << texture.bits);
}

}  // namespace

Pixel smoothTexel(const SmoothTexture& texture, std::uint32_t u, std::uint32_t v) {
    const SmoothPlace across = smoothPlace(u, texture.bits, texture.uReversed);
    return withAlpha(FourTexels(texelsOfColumn(texture, across.first),
                                texelsOfColumn(texture, across.second), across,
                                smoothPlace(v, texture.bits, texture.vReversed)));
}

void blendSide(Pixel* out, int rows, const SmoothTexture& texture, std::uint32_t u,
               const TexelColumn& column) {
    const SmoothPlace across = smoothPlace(u, texture.bits, texture.uReversed);
    const Pixel* const left = texelsOfColumn(texture, across.first);
    const Pixel* const right = texelsOfColumn(texture, across.second);
    const int bits = texture.bits;
    blendRows(out, 0, rows, texture.seeThrough, [&](int row) {
        const std::uint64_t position = column.start + static_cast<std::uint64_t>(row) * column.step;
        const auto v = static_cast<std::uint32_t>(position >> (kTexturePositionBits - 32));
        return FourTexels(left, right, across, smoothPlace(v, bits, false));
    });
}

void blendPlane(Pixel* out, int first, int last, const SmoothTexture& texture,
                const PlaneLine& line, const double* inverseOffsets) {
    const SmoothTexture from = texture;
    const PlaneLine at = line;
    blendRows(out, first, last, from.seeThrough, [&](int row) {
        const double inverse = inverseOffsets[row];
        const SmoothPlace u =
            smoothPlace(PlaneLine::fractionBits(at.eastStart, at.eastPerInverse, inverse),
                        from.bits, from.uReversed);
        const SmoothPlace v =
            smoothPlace(PlaneLine::fractionBits(at.southStart, at.southPerInverse, inverse),
                        from.bits, from.vReversed);
        return FourTexels(texelsOfColumn(from, u.first), texelsOfColumn(from, u.second), u, v);
    });
}

}  // namespace slicecast
