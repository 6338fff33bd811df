// Images in memory, and PNG files to and from them.
#pragma once

#include "base/colour.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace slicecast {

// Row by row from the upper left, width x height pixels, no padding.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;

    Image() = default;
    Image(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    Pixel& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    Pixel at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    bool empty() const { return pixels.empty(); }
    bool isOpaque() const;
};

// What decoding gave: an image, or an empty image and the fault in words ("is not a PNG file", "is
// 4096x2 pixels; at most 1024x1024 are read").
struct DecodedImage {
    Image image;
    std::string fault;
};

// How many pixels the file says that it has; 0 if it is no PNG. Nothing else of it is read.
std::int64_t pixelsOfPng(std::span<const std::uint8_t> bytes);

// Reads a PNG of at most maxWidth x maxHeight pixels; the size is checked before any pixel memory
// is taken. With `blank` it gives an image of that size, for pixels that somebody else has.
DecodedImage decodePng(std::span<const std::uint8_t> bytes, int maxWidth, int maxHeight,
                       bool blank = false);

// Bytes as the compressed data of a PNG file (zlib, RFC 1950).
std::vector<std::uint8_t> compressed(std::span<const std::uint8_t> bytes);

// The bytes of a PNG file with these rows; `pitch` is the distance from one row to the next, in
// pixels.
std::vector<std::uint8_t> encodePng(const Pixel* pixels, int width, int height, int pitch);

}  // namespace slicecast
