// A colour: four bytes R, G, B, A in memory in that order, sRGB, alpha not premultiplied.
#pragma once

#include <cstdint>

namespace slicecast {

// A pixel as one 32-bit number whose bytes in memory are R, G, B, A (all supported machines are
// little-endian).
using Pixel = std::uint32_t;

struct Colour {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;

    friend constexpr bool operator==(Colour, Colour) = default;
};

constexpr Pixel toPixel(Colour c) {
    return static_cast<Pixel>(c.r) | static_cast<Pixel>(c.g) << 8 | static_cast<Pixel>(c.b) << 16 |
           static_cast<Pixel>(c.a) << 24;
}

constexpr Colour toColour(Pixel p) {
    return {static_cast<std::uint8_t>(p), static_cast<std::uint8_t>(p >> 8),
            static_cast<std::uint8_t>(p >> 16), static_cast<std::uint8_t>(p >> 24)};
}

}  // namespace slicecast
