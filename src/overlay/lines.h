// Draws smooth lines and dots. Positions are pixels as real numbers: pixel n is [n, n + 1).
#pragma once

#include "overlay/blend.h"
#include "slicecast/picture.h"

namespace slicecast {

struct Point {
    double x = 0.0;
    double y = 0.0;
};

// The intersection of two rectangles.
PixelRect shared(PixelRect a, PixelRect b);

// A line of this width in pixels, clipped to `inside`. Both ends must be finite.
void drawLine(const Picture& picture, PixelRect inside, Point from, Point to, Colour colour,
              int width = 1);

// A filled circle, at most a million pixels away.
void drawDot(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour);

// A circle's outline of this width in pixels.
void drawRing(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour,
              int width = 1);

}  // namespace slicecast
