#include "render/strip.h"

#include "render/vectors.h"

namespace slicecast {
namespace {

template <typename V>
inline V lowPairs(V a, V b) {
#if defined(__clang__)
    return __builtin_shufflevector(a, b, 0, 4, 1, 5);
#else
    return __builtin_shuffle(a, b, U32x4{0, 4, 1, 5});
#endif
}

template <typename V>
inline V highPairs(V a, V b) {
#if defined(__clang__)
    return __builtin_shufflevector(a, b, 2, 6, 3, 7);
#else
    return __builtin_shuffle(a, b, U32x4{2, 6, 3, 7});
#endif
}

// Four rows of four columns: element r of column c goes to element c of row r.
inline void transposeFour(const Pixel* columns, std::ptrdiff_t stride, Pixel* rows, std::ptrdiff_t pitch) {
    const auto a = loadVector<U32x4>(columns);
    const auto b = loadVector<U32x4>(columns + stride);
    const auto c = loadVector<U32x4>(columns + 2 * stride);
    const auto d = loadVector<U32x4>(columns + 3 * stride);
    const U32x4 acLow = lowPairs(a, c);
    const U32x4 acHigh = highPairs(a, c);
    const U32x4 bdLow = lowPairs(b, d);
    const U32x4 bdHigh = highPairs(b, d);
    storeVector(rows, lowPairs(acLow, bdLow));
    storeVector(rows + pitch, highPairs(acLow, bdLow));
    storeVector(rows + 2 * pitch, lowPairs(acHigh, bdHigh));
    storeVector(rows + 3 * pitch, highPairs(acHigh, bdHigh));
}

}  // namespace

void Strip::resize(int height) {
    height_ = height;
    // An odd number of cache lines, so that neighbouring columns never fall on the same cache sets.
    const int lines = (height + 15) / 16;
    stride_ = 16 * (lines | 1);
    pixels_.resize(static_cast<std::size_t>(stride_) * kStripColumns);
}

void Strip::copyTo(const Picture& picture, int x, int columns) const {
    // Copies of their own, which the stores below cannot be thought to change.
    const Pixel* const strip = pixels_.data();
    const std::ptrdiff_t stride = stride_;
    const std::ptrdiff_t pitch = picture.pitch;
    const int height = height_;
    Pixel* row = picture.pixels + x;
    int y = 0;
    if (kHasVectors && columns == kStripColumns) {
        for (; y + 4 <= height; y += 4, row += 4 * pitch) {
            for (int c = 0; c < kStripColumns; c += 4) transposeFour(strip + c * stride + y, stride, row + c, pitch);
        }
    }
    for (; y < height; ++y, row += pitch) {
        for (int c = 0; c < columns; ++c) row[c] = strip[c * stride + y];
    }
}

}  // namespace slicecast
