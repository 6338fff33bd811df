// Images to and from PNG files.
#pragma once

#include "slicecast/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace slicecast {

// What decoding gave: an image, or an empty image and the fault in words ("is not a PNG file", "is
// 4096x2 pixels; at most 1024x1024 are read").
struct DecodedImage {
    Image image;
    std::string fault;
};

// The number of pixels that the header of a PNG states; 0 if it is no PNG.
std::int64_t pixelsOfPng(std::span<const std::uint8_t> bytes);

// Reads a PNG of at most maxWidth x maxHeight pixels; the size is checked before any pixel memory
// is taken. A pixel of a colour that the palette lacks is a fault: the PNG specification calls such
// a file an error (11.2.2), and leaves open what is shown. With `blank`, decodes nothing: gives an
// image of that size for the caller to fill.
DecodedImage decodePng(std::span<const std::uint8_t> bytes, int maxWidth, int maxHeight,
                       bool blank = false);

// Bytes as the compressed data of a PNG file (zlib, RFC 1950).
std::vector<std::uint8_t> compressed(std::span<const std::uint8_t> bytes);

// The bytes of a PNG file with these rows; `pitch` is the distance from one row to the next, in
// pixels.
std::vector<std::uint8_t> encodePng(const Pixel* pixels, int width, int height, int pitch);

}  // namespace slicecast
