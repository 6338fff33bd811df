#include "signs.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "glyphs.h"
#include "marks.h"
#include "noise.h"
#include "stonework.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kSignsSeed = 4100;

// A board of oak on two iron hooks, with a word cut into it and gilded.
Picture paintSign(std::string_view word) {
    constexpr int kLeft = 14;
    constexpr int kRight = 114;
    constexpr int kTop = 42;
    constexpr int kBottom = 86;
    constexpr int kZoom = 3;
    const Surface wall = ashlarSurface();
    Surface surface = wall;
    for (const int hook : {26, 102}) {
        everyTexelIn(hook - 2, 26, hook + 2, kTop + 5, [&](int x, int y) {
            surface.at(x, y) = {.height = 3.0, .tone = 2.2, .ramp = &kSlateRamp};
        });
        drawStud(surface, {.x = static_cast<double>(hook),
                           .y = 26.0,
                           .radius = 4.0,
                           .height = 3.0,
                           .tone = 2.6,
                           .ramp = &kSlateRamp});
    }
    drawSlab(surface, {.left = kLeft,
                       .top = kTop,
                       .right = kRight,
                       .bottom = kBottom,
                       .height = 5.0,
                       .bevel = 2.0,
                       .tone = 1.8,
                       .ramp = &kOakRamp});
    everyTexelIn(kLeft + 4, kTop + 4, kRight - 4, kBottom - 4, [&](int x, int y) {
        const int inside = std::min({x - kLeft - 4, kRight - 5 - x, y - kTop - 4, kBottom - 5 - y});
        surface.at(x, y) = {.height = inside == 0 ? 3.4 : 4.2,
                            .tone = 2.1 + 0.7 * woodGrain(x, y, kSignsSeed),
                            .ramp = &kOakRamp};
    });
    const int letters = static_cast<int>(word.size());
    int left = (kSide - (letters * (kGlyphWidth + 1) - 1) * kZoom) / 2;
    for (const char letter : word) {
        const GlyphRows& rows = glyphOf(letter);
        const int top = (kTop + kBottom - kGlyphHeight * kZoom) / 2;
        const int first = left;
        everyTexelIn(first, top, first + kGlyphWidth * kZoom, top + kGlyphHeight * kZoom,
                     [&](int x, int y) {
                         if (rows[static_cast<std::size_t>((y - top) / kZoom)]
                                 [static_cast<std::size_t>((x - first) / kZoom)] == '#') {
                             surface.at(x, y) = {.height = 4.8, .tone = 4.4, .ramp = &kBrassRamp};
                         }
                     });
        left += (kGlyphWidth + 1) * kZoom;
    }
    return litOver(wall, ashlarLighting(), surface,
                   {.gain = 0.5,
                    .lightest = 0.9,
                    .darkest = 1.3,
                    .shadowReach = 5,
                    .shadowSlope = 0.7,
                    .shadowDepth = 1.0,
                    .hollowDepth = 0.06});
}

}  // namespace

Picture paintSignClimb() {
    return paintSign("CLIMB");
}

Picture paintSignCourt() {
    return paintSign("COURT");
}

Picture paintSignDeep() {
    return paintSign("DEEP");
}

Picture paintSignInn() {
    return paintSign("INN");
}

Picture paintSignLane() {
    return paintSign("LANE");
}

Picture paintSignMoor() {
    return paintSign("MOOR");
}

Picture paintSignNight() {
    return paintSign("NIGHT");
}

Picture paintSignRound() {
    return paintSign("ROUND");
}

Picture paintSignShore() {
    return paintSign("SHORE");
}

// Pale stone with rings that pass through one another, one above the other without an end, between
// two mouldings.
Picture paintCarvedJamb() {
    constexpr double kMiddle = 63.5;
    constexpr double kApart = 32.0;  // the rings' middles
    constexpr double kRadius = 23.0;
    constexpr double kHalfWidth = 5.0;
    Surface surface;
    everyTexel([&](int x, int y) {
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kSignsSeed + 30U) - 0.5;
        const int side = std::min(x, kSide - 1 - x);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kStoneRamp;
        texel.tone = 4.3 + 0.8 * blotch;
        if (side < 10) {
            texel.height = 5.0 - 0.12 * (side - 5) * (side - 5);
            return;
        }
        if (side < 16) {
            texel.height = 1.5;
            return;
        }
        texel.height = 0.0;
        texel.tone -= 1.3;
        // Each ring passes over the next one to its right, and under it to its left
        for (int ring = -1; ring <= 4; ++ring) {
            const double dx = x - kMiddle;
            const double dy = y + 0.5 - kApart * (ring + 0.5);
            const double off = std::abs(std::sqrt(dx * dx + dy * dy) - kRadius);
            if (off > kHalfWidth) continue;
            const bool over = (dx > 0.0) == (dy > 0.0);
            const double height = 2.6 + (over ? 1.4 : 0.0) - 0.05 * off * off;
            if (height > texel.height) {
                texel.height = height;
                texel.tone = 4.3 + 0.8 * blotch - (off > kHalfWidth - 1.0 ? 0.6 : 0.0);
            }
        }
        // A gilded boss in each
        const int middle = static_cast<int>(kApart) / 2;
        const double up = (y % static_cast<int>(kApart)) + 0.5 - middle;
        const double across = x - kMiddle;
        if (across * across + up * up < 20.0) {
            texel = {.height = 3.2 - 0.1 * (across * across + up * up),
                     .tone = 3.4,
                     .ramp = &kBrassRamp};
        }
    });
    return lit(surface, {.gain = 0.5,
                         .lightest = 0.9,
                         .darkest = 1.4,
                         .shadowReach = 4,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.9,
                         .hollowDepth = 0.08});
}

}  // namespace slicecast::textures
