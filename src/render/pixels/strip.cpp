#include "render/pixels/strip.h"

#include "render/pixels/vectors.h"

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

// Transposes four columns of four rows: element r of column c goes to element c of row r.
inline void transposeFour(const Pixel* columns, std::ptrdiff_t stride, Pixel* rows,
                          std::ptrdiff_t pitch) {
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

// Transposes all whole groups of four rows of a full strip; returns the number of these rows. A
// function of its own, called often, so that WebAssembly engines compile it well.
__attribute__((noinline)) int transposeRows(const Pixel* strip, std::ptrdiff_t stride, int height,
                                            Pixel* row, std::ptrdiff_t pitch) {
    static_assert(kStripColumns == 16);
    const Pixel* a = strip;
    const Pixel* b = strip + 4 * stride;
    const Pixel* c = strip + 8 * stride;
    const Pixel* d = strip + 12 * stride;
    int y = 0;
    for (; y + 4 <= height; y += 4) {
#ifndef __wasm__
        // The same rows of the next strip: nothing else announces them
        for (int i = 0; i < 4; ++i) __builtin_prefetch(row + 16 + i * pitch, 1, 2);
#endif
        transposeFour(a, stride, row, pitch);
        transposeFour(b, stride, row + 4, pitch);
        transposeFour(c, stride, row + 8, pitch);
        transposeFour(d, stride, row + 12, pitch);
        a += 4;
        b += 4;
        c += 4;
        d += 4;
        row += 4 * pitch;
    }
    return y;
}

}  // namespace

void Strip::resize(int height) {
    height_ = height;
    // An odd number of cache lines, so that neighbouring columns never fall on the same cache sets
    const int lines = (height + 15) / 16;
    stride_ = 16 * (lines | 1);
    pixels_.resize(static_cast<std::size_t>(stride_) * kStripColumns);
}

void Strip::copyTo(const Picture& picture, int x, int columns) const {
    const Pixel* const strip = pixels_.data();
    int y = 0;
    if (kHasVectors && columns == kStripColumns)
        y = transposeRows(strip, stride_, height_, picture.pixels + x, picture.pitch);
    // #region copy
    for (; y < height_; ++y) {
        Pixel* row = picture.row(y) + x;
        for (int c = 0; c < columns; ++c)
            row[c] = strip[static_cast<std::ptrdiff_t>(c) * stride_ + y];
    }
    // #endregion
}

}  // namespace slicecast
