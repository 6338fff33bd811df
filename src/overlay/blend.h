// Paints over a picture with translucent colours. Everything but blendRow is clipped to the
// picture.
#pragma once

#include "base/pixels.h"
#include "slicecast/colour.h"
#include "slicecast/picture.h"

#include <cstdint>

namespace slicecast {

// Pixel columns and rows from the upper left; empty if width or height is not positive.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

// Blends `over` on an opaque pixel: (over * a + under * (255 - a) + 127) / 255 per channel. Works
// on two channels at a time: with n = over * a + under * (255 - a) + 128 that is (n + n / 256) /
// 256, and no n exceeds 16 bits. Always inlined, even where code is optimised for size, because a
// call would dominate the cost of a pixel.
__attribute__((always_inline)) constexpr Pixel blended(Pixel under, Pixel over) {
    const Pixel a = over >> 24;
    const Pixel even = (over & kRedAndBlue) * a + (under & kRedAndBlue) * (255 - a) + 0x00800080;
    const Pixel odd =
        (over >> 8 & kRedAndBlue) * a + (under >> 8 & kRedAndBlue) * (255 - a) + 0x00800080;
    return ((even + (even >> 8 & kRedAndBlue)) >> 8 & kRedAndBlue) |
           ((odd + (odd >> 8 & kRedAndBlue)) & 0x0000ff00) | kOpaque;
}
constexpr Pixel blended(Pixel under, Colour over) {
    return blended(under, toPixel(over));
}

constexpr Colour withAlpha(Colour colour, int alpha) {
    return {colour.r, colour.g, colour.b, static_cast<std::uint8_t>(alpha)};
}

// Lays a colour over one pixel.
void blendPixel(const Picture& picture, int x, int y, Colour colour);

// Blends a colour, or as many pixels with their own alpha, over a row. Not clipped.
void blendRow(Pixel* row, int count, Colour colour);
void blendRow(Pixel* row, int count, const Pixel* over);

// Lays a colour over a rectangle.
void blendRect(const Picture& picture, PixelRect rect, Colour colour);

// A panel: a dark translucent rectangle with round corners and a fine light rim, the background of
// all overlays. `scale` is that of its text.
inline constexpr Colour kPanelColour = {16, 20, 28, 208};
inline constexpr Colour kPanelRim = {226, 214, 186, 96};
void drawPanel(const Picture& picture, PixelRect rect, int scale = 1);

// The pixels at each end of a panel's row that are outside its round corners; rows are counted from
// the nearer edge.
constexpr int plateInset(int rowFromEdge, int scale) {
    return rowFromEdge < scale ? 2 * scale : rowFromEdge < 2 * scale ? scale : 0;
}

}  // namespace slicecast
