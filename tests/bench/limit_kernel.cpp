#include "limit_kernel.h"

#include "base/random.h"
#include "render/pixels/vectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

using F32x4 = float __attribute__((vector_size(16)));

constexpr int kSizeBits = 6;
constexpr std::uint32_t kSize = 1u << kSizeBits;
constexpr int kLimitColumns = 16;
constexpr std::uint32_t kEven = 0x00ff00ff;
constexpr std::uint32_t kOdd = 0xff00ff00;

// A float of at least 2^23 and below 2^24 has no bits after the point: adding this leaves a number,
// rounded, in the low bits.
constexpr float kFloatMagic = 12582912.0f;

inline std::uint32_t shadedOne(std::uint32_t texel, std::uint32_t factor) {
    const std::uint32_t even = ((texel & kEven) * factor + 0x00800080) >> 8;
    const std::uint32_t odd = ((texel >> 8) & kEven) * factor + 0x00800080;
    return (even & kEven) | (odd & kOdd) | 0xff000000;
}

[[maybe_unused]] inline U32x4 shadedFour(U32x4 texels, U32x4 factors) {
    const U16x8 half = (U16x8)allLanes(0x00800080);
    const U16x8 even = ((U16x8)(texels & kEven) * (U16x8)factors + half) >> 8;
    const U16x8 odd = ((U16x8)texels >> 8) * (U16x8)factors + half;
    return (U32x4)even | ((U32x4)odd & kOdd) | 0xff000000;
}

inline std::uint32_t bitsOf(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

// The hot loops are functions of their own, which WebAssembly engines optimise soon; a loop within
// one long call stays slow.
__attribute__((noinline)) void drawWall(Pixel* out, int rows, const Pixel* texels,
                                        std::uint32_t step, std::uint32_t factor) {
    constexpr std::uint32_t kMask = kSize - 1;
    std::uint32_t position = 0;
    int row = 0;
    if constexpr (kHasVectors) {
        const U32x4 factors = allLanes(factor);
        for (; row + 4 <= rows; row += 4) {
            const std::uint32_t second = position + step;
            const std::uint32_t third = second + step;
            const std::uint32_t fourth = third + step;
            const U32x4 four = {texels[(position >> 16) & kMask], texels[(second >> 16) & kMask],
                                texels[(third >> 16) & kMask], texels[(fourth >> 16) & kMask]};
            storeVector(out + row, shadedFour(four, factors));
            position = fourth + step;
        }
    }
    for (; row < rows; ++row) {
        out[row] = shadedOne(texels[(position >> 16) & kMask], factor & 0xffff);
        position += step;
    }
}

__attribute__((noinline)) void drawPlane(Pixel* column, int first, int last, const Pixel* texels,
                                         const float* inverseOffsets, const std::uint32_t* factors,
                                         float eastPerInverse, float southPerInverse) {
    // East is scaled so that its texel's index stands where it is needed.
    constexpr std::uint32_t kEastMask = (kSize - 1) << kSizeBits;
    constexpr std::uint32_t kSouthMask = kSize - 1;
    const float east = eastPerInverse * static_cast<float>(kSize);
    int row = first;
    if constexpr (kHasVectors) {
        const F32x4 east4 = {east, east, east, east};
        const F32x4 south4 = {southPerInverse, southPerInverse, southPerInverse, southPerInverse};
        const F32x4 magic = {kFloatMagic, kFloatMagic, kFloatMagic, kFloatMagic};
        for (; row + 4 <= last; row += 4) {
            const auto inverse = loadVector<F32x4>(inverseOffsets + row);
            const U32x4 u = (U32x4)(inverse * east4 + magic) & kEastMask;
            const U32x4 v = (U32x4)(inverse * south4 + magic) & kSouthMask;
            const U32x4 index = u | v;
            const U32x4 four = {texels[index[0]], texels[index[1]], texels[index[2]],
                                texels[index[3]]};
            storeVector(column + row, shadedFour(four, loadVector<U32x4>(factors + row)));
        }
    }
    for (; row < last; ++row) {
        const std::uint32_t u = bitsOf(inverseOffsets[row] * east + kFloatMagic) & kEastMask;
        const std::uint32_t v =
            bitsOf(inverseOffsets[row] * southPerInverse + kFloatMagic) & kSouthMask;
        column[row] = shadedOne(texels[u | v], factors[row] & 0xffff);
    }
}

[[maybe_unused]] inline U32x4 lowPairs(U32x4 a, U32x4 b) {
#if defined(__clang__)
    return __builtin_shufflevector(a, b, 0, 4, 1, 5);
#else
    return __builtin_shuffle(a, b, U32x4{0, 4, 1, 5});
#endif
}

[[maybe_unused]] inline U32x4 highPairs(U32x4 a, U32x4 b) {
#if defined(__clang__)
    return __builtin_shufflevector(a, b, 2, 6, 3, 7);
#else
    return __builtin_shuffle(a, b, U32x4{2, 6, 3, 7});
#endif
}

// A whole strip into the rows of the frame: 16 pixels of each are one cache line.
__attribute__((noinline)) void transpose(const Pixel* strip, int stride, int height, Pixel* out,
                                         int pitch) {
    int y = 0;
    if constexpr (kHasVectors) {
        for (; y + 4 <= height; y += 4) {
            for (int c = 0; c < kLimitColumns; c += 4) {
                const Pixel* from = strip + c * stride + y;
                const auto c0 = loadVector<U32x4>(from);
                const auto c1 = loadVector<U32x4>(from + stride);
                const auto c2 = loadVector<U32x4>(from + 2 * stride);
                const auto c3 = loadVector<U32x4>(from + 3 * stride);
                const U32x4 even = lowPairs(c0, c2);
                const U32x4 odd = lowPairs(c1, c3);
                const U32x4 evenHigh = highPairs(c0, c2);
                const U32x4 oddHigh = highPairs(c1, c3);
                Pixel* to = out + static_cast<std::ptrdiff_t>(y) * pitch + c;
                storeVector(to, lowPairs(even, odd));
                storeVector(to + pitch, highPairs(even, odd));
                storeVector(to + 2 * pitch, lowPairs(evenHigh, oddHigh));
                storeVector(to + 3 * pitch, highPairs(evenHigh, oddHigh));
            }
        }
    }
    for (; y < height; ++y) {
        for (int c = 0; c < kLimitColumns; ++c)
            out[static_cast<std::ptrdiff_t>(y) * pitch + c] = strip[c * stride + y];
    }
}

std::vector<Pixel> anyTexture(Random& random) {
    std::vector<Pixel> texels(kSize * kSize);
    for (Pixel& texel : texels) texel = static_cast<Pixel>(random.next()) | 0xff000000;
    return texels;
}

}  // namespace

LimitKernel::LimitKernel(int width, int height)
    : width_(width / kLimitColumns * kLimitColumns),
      height_(height),
      stride_(16 * (((height + 15) / 16) | 1)),
      strip_(static_cast<std::size_t>(stride_) * kLimitColumns) {
    Random random(1);
    wall_ = anyTexture(random);
    floor_ = anyTexture(random);
    ceiling_ = anyTexture(random);

    // The planes, half a unit above and below the eye.
    const double distance = width / 2.0 / 0.57735;
    for (int row = 0; row < height; ++row) {
        const double inverse = 1.0 / std::fabs(row + 0.5 - height / 2.0);
        inverseOffsets_.push_back(static_cast<float>(inverse));
        const double light = std::min(1.0, 3.0 / (0.5 * distance * inverse));
        factors_.push_back(static_cast<std::uint32_t>(256.0 * light) * 0x00010001u);
    }

    // Walls as of a room that is looked at askew: a quarter to two thirds of the height, and back.
    for (int x = 0; x < width_; ++x) {
        const double across = (x + 0.5) / width_;
        const double share = 0.25 + (2.0 / 3.0 - 0.25) * std::fabs(2.0 * across - 1.0);
        const int rows = static_cast<int>(share * height);
        const int first = (height - rows) / 2;
        const double sideways = (x + 0.5 - width_ / 2.0) / distance;
        const double texelsPerInverse = 0.5 * distance * kSize;
        columns_.push_back(
            {first, first + rows,
             static_cast<std::uint32_t>(across * 20.0 * kSize) % kSize << kSizeBits,
             static_cast<std::uint32_t>(65536.0 * kSize / rows),
             static_cast<std::uint32_t>(256.0 * std::min(1.0, 0.3 + share)) * 0x00010001u,
             static_cast<float>(texelsPerInverse * (0.8 - 0.6 * sideways)),
             static_cast<float>(texelsPerInverse * (0.6 + 0.8 * sideways))});
    }
}

void LimitKernel::draw(Pixel* frame) {
    for (int x = 0; x < width_; x += kLimitColumns) {
        for (int c = 0; c < kLimitColumns; ++c) {
            const Column& column = columns_[static_cast<std::size_t>(x + c)];
            Pixel* out = strip_.data() + c * stride_;
            drawPlane(out, 0, column.wallFirst, ceiling_.data(), inverseOffsets_.data(),
                      factors_.data(), column.eastPerInverse, column.southPerInverse);
            drawWall(out + column.wallFirst, column.wallLast - column.wallFirst,
                     wall_.data() + column.texels, column.step, column.factor);
            drawPlane(out, column.wallLast, height_, floor_.data(), inverseOffsets_.data(),
                      factors_.data(), column.eastPerInverse, column.southPerInverse);
        }
        transpose(strip_.data(), stride_, height_, frame + x, width_);
    }
}

}  // namespace slicecast
