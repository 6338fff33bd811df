// A material before it is lit: for each texel a height, a ramp of colours and a tone on it.
//
// Painters set heights and tones; `lit` then paints every surface with the same light from the
// upper left, so that all materials agree: slopes that face the light gain tone, others lose it,
// what stands out throws a short shadow, and hollows are darker. Heights are in texels, tones in
// steps of the ramp.
//
// A surface is a block texture unless its size is given. Texels may be see-through: alpha 0 is a
// hole, 255 is opaque.
#pragma once

#include <cstdint>
#include <vector>

#include "picture.h"

namespace slicecast::textures {

struct Texel {
    double height = 0.0;
    double tone = 3.0;
    const Ramp* ramp = &kStoneRamp;
    std::uint8_t alpha = 255;

    friend bool operator==(const Texel&, const Texel&) = default;
};

class Surface {
public:
    explicit Surface(int w = kSide, int h = kSide)
        : width(w), height(h), texels_(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    // One in which nothing has been drawn yet: all of it a hole.
    static Surface empty(int w = kSide, int h = kSide);

    Texel& at(int x, int y) { return texels_[indexOf(x, y)]; }
    const Texel& at(int x, int y) const { return texels_[indexOf(x, y)]; }

    int width;
    int height;

private:
    std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(wrap(y, height)) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(wrap(x, width));
    }

    std::vector<Texel> texels_;
};

struct Lighting {
    double gain = 0.45;         // tone per texel of slope towards the light
    double lightest = 1.0;      // most tone that a lit slope gains
    double darkest = 1.5;       // most tone that a slope in shade loses
    int shadowReach = 4;        // longest shadow, in texels
    double shadowSlope = 0.8;   // how fast a shadow falls, in height per diagonal texel
    double shadowDepth = 1.0;   // tone lost in a shadow
    double hollowDepth = 0.12;  // tone lost per texel that the surroundings lie above
};

Picture lit(const Surface& surface, const Lighting& lighting = {});

// Something put on a wall. Where the surface differs from the bare wall, and close by, it is lit by
// `lighting`. Elsewhere it is exactly like the bare wall, so it has no seam beside bare walls.
Picture litOver(const Surface& wall, const Lighting& wallLighting, const Surface& surface,
                const Lighting& lighting);

// Calls paint(x, y) for every texel of a block texture.
template <typename Paint>
void everyTexel(Paint paint) {
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            paint(x, y);
        }
    }
}

// The same for a picture of kFineSide texels.
template <typename Paint>
void everyFineTexel(Paint paint) {
    for (int y = 0; y < kFineSide; ++y) {
        for (int x = 0; x < kFineSide; ++x) {
            paint(x, y);
        }
    }
}

// The same for the texels of a rectangle; right and bottom are outside it. It may reach over the
// edges.
template <typename Paint>
void everyTexelIn(int left, int top, int right, int bottom, Paint paint) {
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
            paint(x, y);
        }
    }
}

}  // namespace slicecast::textures
