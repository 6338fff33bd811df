// A view of pixels that the caller owns: rows from the top, bytes R, G, B, A with A = 255.
#pragma once

#include "slicecast/colour.h"

#include <cstddef>

namespace slicecast {

inline constexpr int kMaxPictureSide = 8192;  // pixels

constexpr bool isPictureSize(int width, int height) {
    return width >= 1 && height >= 1 && width <= kMaxPictureSide && height <= kMaxPictureSide;
}

struct Picture {
    Pixel* pixels = nullptr;
    int width = 0;
    int height = 0;
    int pitch = 0;  // pixels from one row to the next, >= width

    Pixel* row(int y) const { return pixels + static_cast<std::ptrdiff_t>(y) * pitch; }
};

}  // namespace slicecast
