// The limit: a frame like the renderer's with nothing left out of the pixels and everything else
// left out. In every column one wall of a quarter to two thirds of the height, floor and ceiling
// elsewhere, all textured (64x64) and shaded; no walk, no world, no levels of detail. Slices of 16
// columns side by side in memory that stays in the cache, transposed into the rows of the frame:
// the fastest arrangement that is known. Figures of the renderer are quoted as ratios to this,
// measured in the same run.
#pragma once

#include "slicecast/colour.h"

#include <cstdint>
#include <vector>

namespace slicecast {

class LimitKernel {
public:
    LimitKernel(int width, int height);

    // Draws into width x height pixels, row after row.
    void draw(Pixel* frame);

private:
    struct Column {
        int wallFirst;
        int wallLast;          // one past the end
        std::uint32_t texels;  // where the wall's column of texels begins
        std::uint32_t step;    // texels of the wall from one row to the next, in 1/65536
        std::uint32_t factor;  // the wall's light in both halves
        float eastPerInverse;  // texels on the planes
        float southPerInverse;
    };

    int width_;
    int height_;
    int stride_;  // of the strip, pixels
    std::vector<Column> columns_;
    std::vector<float> inverseOffsets_;   // by row
    std::vector<std::uint32_t> factors_;  // the planes' light by row, in both halves
    std::vector<Pixel> wall_;             // 64 x 64 texels, column after column
    std::vector<Pixel> floor_;
    std::vector<Pixel> ceiling_;
    std::vector<Pixel> strip_;
};

}  // namespace slicecast
