// Smooth lines and dots. Places are in pixels as real numbers: pixel n is [n, n + 1).
#pragma once

#include "overlay/blend.h"
#include "slicecast/picture.h"

namespace slicecast {

struct Point {
    double x = 0.0;
    double y = 0.0;
};

// The part of two rectangles that they share.
PixelRect shared(PixelRect a, PixelRect b);

// A line so many pixels wide; nothing outside `inside`. Both ends are finite.
void drawLine(const Picture& picture, PixelRect inside, Point from, Point to, Colour colour,
              int width = 1);

// A filled circle, not a million pixels away.
void drawDot(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour);

// A circle's edge, so many pixels wide.
void drawRing(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour,
              int width = 1);

}  // namespace slicecast
