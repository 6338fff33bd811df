// The shapes of which sprites are built: balls, limbs and flat outlines, laid over one another from
// back to front.
//
// Each has a base height of its own; where a shape is round it bulges from there, so that `lit`
// models it. What lies outside the surface is cut off, not wrapped around. Places are in texels;
// the middle of the first texel is (0.5, 0.5).
#pragma once

#include <vector>

#include "surface.h"

namespace slicecast::textures {

struct Paint {
    const Ramp* ramp;
    double tone;
    double height = 0.0;
    double bulge = 1.0;  // how round a shape is: 1 is a ball, 0 is flat
    std::uint8_t alpha = 255;
};

struct Place {
    double x;
    double y;
};

// The standard light of sprites.
inline constexpr Lighting kSpriteLight = {.gain = 0.35,
                                          .lightest = 1.1,
                                          .darkest = 1.5,
                                          .shadowReach = 4,
                                          .shadowSlope = 0.8,
                                          .shadowDepth = 0.8};

// The picture of a sprite: lit, with blended edges.
Picture spriteOf(const Surface& surface, const Lighting& lighting = kSpriteLight);

// Adds wood grain to everything painted with that ramp.
void addGrain(Surface& surface, const Ramp* ramp, double strength, std::uint32_t seed);

// An ellipse.
void drawBall(Surface& surface, Place middle, double radiusX, double radiusY, const Paint& paint);

// A stroke with round ends, thick at one end and thin at the other: limbs, trunks, posts, ropes.
void drawLimb(Surface& surface, Place from, double fromRadius, Place to, double toRadius,
              const Paint& paint);

// A filled outline; corners in order.
void drawOutline(Surface& surface, const std::vector<Place>& corners, const Paint& paint);

// An upright rectangle; right and bottom are outside it. `bulge` makes it round from left to right,
// like a post.
void drawBox(Surface& surface, int left, int top, int right, int bottom, const Paint& paint);

// Calls paint(x, y) for the texels of a rectangle that lie on the surface; right and bottom are
// outside it.
template <typename Draw>
void everyTexelOn(const Surface& surface, double left, double top, double right, double bottom,
                  Draw draw) {
    const auto held = [](double value, int limit) {
        return value < 0.0 ? 0 : (value > limit ? limit : static_cast<int>(value));
    };
    everyTexelIn(held(left, surface.width), held(top, surface.height), held(right, surface.width),
                 held(bottom, surface.height), draw);
}

}  // namespace slicecast::textures
