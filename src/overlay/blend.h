// Painting over a picture with translucent colours. Everything but rows is clipped to the
// picture.
#pragma once

#include "slicecast/colour.h"
#include "slicecast/picture.h"

#include <cstdint>

namespace slicecast {

// Rows and columns of pixels from the upper left; empty where width or height is not positive.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

inline constexpr Pixel kTwoChannels = 0x00ff00ff;  // a pixel's red and blue

// `over` laid on an opaque pixel by its alpha: (over * a + under * (255 - a) + 127) / 255 per
// channel. Two channels at a time: with n = over * a + under * (255 - a) + 128 that is
// (n + n / 256) / 256, and no n exceeds 16 bits. Inlined even where code is kept small, for that is
// most of what a pixel takes.
__attribute__((always_inline)) constexpr Pixel blended(Pixel under, Pixel over) {
    const Pixel a = over >> 24;
    const Pixel even = (over & kTwoChannels) * a + (under & kTwoChannels) * (255 - a) + 0x00800080;
    const Pixel odd =
        (over >> 8 & kTwoChannels) * a + (under >> 8 & kTwoChannels) * (255 - a) + 0x00800080;
    return ((even + (even >> 8 & kTwoChannels)) >> 8 & kTwoChannels) |
           ((odd + (odd >> 8 & kTwoChannels)) & 0x0000ff00) | 0xff000000;
}
constexpr Pixel blended(Pixel under, Colour over) {
    return blended(under, toPixel(over));
}

constexpr Colour withAlpha(Colour colour, int alpha) {
    return {colour.r, colour.g, colour.b, static_cast<std::uint8_t>(alpha)};
}

// Lays a colour over one pixel.
void blendPixel(const Picture& picture, int x, int y, Colour colour);

// Lays a colour over pixels of a row, or as many others, each by its own alpha. Nothing is clipped.
void blendRow(Pixel* row, int count, Colour colour);
void blendRow(Pixel* row, int count, const Pixel* over);

// Lays a colour over a rectangle.
void blendRect(const Picture& picture, PixelRect rect, Colour colour);

// A plate: a dark translucent rectangle with round corners and a fine light rim, on which all
// overlays stand. The scale is that of its text.
inline constexpr Colour kPanelColour = {16, 20, 28, 208};
inline constexpr Colour kPanelRim = {226, 214, 186, 96};
void drawPanel(const Picture& picture, PixelRect rect, int scale = 1);

// How many pixels at both ends of a plate's row, counted from its nearer edge, are outside its
// round corners.
constexpr int plateInset(int rowFromEdge, int scale) {
    return rowFromEdge < scale ? 2 * scale : rowFromEdge < 2 * scale ? scale : 0;
}

}  // namespace slicecast
