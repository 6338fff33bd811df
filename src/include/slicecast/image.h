// An image in memory that owns its pixels.
#pragma once

#include "slicecast/colour.h"
#include "slicecast/picture.h"

#include <cstddef>
#include <vector>

namespace slicecast {

// Rows from the top, pixels from the left, width x height pixels, no padding.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;

    Image() = default;
    // Both sides >= 0; all pixels are 0.
    Image(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    // 0 <= x < width, 0 <= y < height.
    Pixel& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    Pixel at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    bool empty() const { return pixels.empty(); }
    bool isOpaque() const;  // every alpha is 255

    // To draw into. Valid until the image is destroyed, moved or resized.
    Picture view() { return {pixels.data(), width, height, width}; }
};

}  // namespace slicecast
