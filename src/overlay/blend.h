// Painting over a picture with translucent colours. Everything is clipped to the picture.
#pragma once

#include "base/colour.h"
#include "render/picture.h"

namespace slicecast {

// Rows and columns of pixels from the upper left; empty where width or height is not positive.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

// `over` laid on an opaque pixel by its alpha: (over * a + under * (255 - a) + 127) / 255 per
// channel.
constexpr Pixel blended(Pixel under, Colour over) {
    const Colour below = toColour(under);
    const unsigned a = over.a;
    const auto mix = [a](unsigned top, unsigned bottom) {
        return static_cast<std::uint8_t>((top * a + bottom * (255u - a) + 127u) / 255u);
    };
    return toPixel({mix(over.r, below.r), mix(over.g, below.g), mix(over.b, below.b), 255});
}

constexpr Colour withAlpha(Colour colour, int alpha) {
    return {colour.r, colour.g, colour.b, static_cast<std::uint8_t>(alpha)};
}

// Lays a colour over one pixel.
void blendPixel(const Picture& picture, int x, int y, Colour colour);

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
