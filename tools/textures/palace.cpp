#include "palace.h"

#include <algorithm>
#include <cmath>

#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kPalaceSeed = 5400;

}  // namespace

// Large dark slabs with pale veins, lines of brass between them and a lozenge where four meet.
Picture paintMarbleDark() {
    constexpr int kSlab = 64;
    Surface surface;
    everyTexel([&](int x, int y) {
        const int slab = x / kSlab + 2 * (y / kSlab);
        const auto seed = kPalaceSeed + 7U * static_cast<std::uint32_t>(slab);
        const int fromX = std::min(x % kSlab, kSlab - 1 - x % kSlab);
        const int fromY = std::min(y % kSlab, kSlab - 1 - y % kSlab);
        const double cloud = fractalNoise(x / 32.0, y / 32.0, 4, 4, 3, seed) - 0.5;
        const double bent = fractalNoise((x + y) / 64.0 + 0.6 * cloud,
                                         (y - x + kSide) / 32.0 + 2.0 * cloud, 4, 8, 3, seed + 1U);
        const double vein = std::abs(bent - 0.5);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kSlateRamp;
        texel.tone = 1.2 + 0.8 * cloud + 0.12 * (slab % 3) +
                     (vein < 0.012 ? 1.3 : (vein < 0.035 ? 0.5 : 0.0));
        if (fromX + fromY < 9) {
            texel.ramp = fromX + fromY < 7 ? &kClayRamp : &kBrassRamp;
            texel.tone = fromX + fromY < 7 ? 1.5 + cloud : 2.8;
        } else if (std::min(fromX, fromY) < 1) {
            texel.ramp = &kBrassRamp;
            texel.tone = 2.3 + cloud;
        }
    });
    return lit(surface, {.gain = 0.0, .lightest = 0.0, .darkest = 0.0, .shadowReach = 0});
}

// White marble, fluted, with a gilded base and capital; round, so that it looks the same from
// everywhere.
Picture paintColumn() {
    constexpr double kMiddle = 30.0;
    constexpr int kShaftTop = 34;
    constexpr int kShaftFoot = 232;
    Surface surface = Surface::empty(60, 256);
    const Ramp* marble = &kStoneRamp;
    everyTexelIn(0, kShaftTop, 60, kShaftFoot, [&](int x, int y) {
        // It swells a little, and narrows upwards
        const double share = static_cast<double>(y - kShaftTop) / (kShaftFoot - kShaftTop);
        const double half = 14.5 + 3.2 * share - 0.8 * (2.0 * share - 1.0) * (2.0 * share - 1.0);
        const double off = (x + 0.5 - kMiddle) / half;
        if (std::abs(off) > 1.0) {
            return;
        }
        const double round = std::sqrt(1.0 - off * off);
        const double around = off * (0.8 + 0.2 * off * off) * 3.6;
        const double flute = std::abs(around - std::floor(around) - 0.5);
        const double vein = std::abs(
            fractalNoise(x / 16.0 + y / 40.0, y / 24.0, 8, 16, 3, kPalaceSeed + 20U) - 0.5);
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 16, 2, kPalaceSeed + 21U) - 0.5;
        // Light from the upper left
        surface.at(x, y) = {.height = 8.0 * round,
                            .tone = 5.3 - 1.2 * std::max(0.0, off) - 0.9 * off * off +
                                    0.5 * blotch - (flute < 0.17 ? 0.9 : 0.0) -
                                    (vein < 0.016 ? 0.8 : 0.0),
                            .ramp = marble,
                            .alpha = 255};
    });
    // Base: plinth and two rings; capital: ring, a calyx of leaves, volutes, slab
    drawBox(surface, 5, 246, 55, 256, {.ramp = marble, .tone = 4.4, .height = 9.0, .bulge = 0.15});
    drawBox(surface, 8, 239, 52, 246,
            {.ramp = &kBrassRamp, .tone = 3.0, .height = 8.0, .bulge = 0.5});
    drawBox(surface, 11, 232, 49, 239, {.ramp = marble, .tone = 4.8, .height = 7.0, .bulge = 0.5});
    drawBox(surface, 12, 31, 48, 36,
            {.ramp = &kBrassRamp, .tone = 3.1, .height = 8.0, .bulge = 0.5});
    drawOutline(surface, {{15.0, 31.5}, {45.0, 31.5}, {54.0, 9.0}, {6.0, 9.0}},
                {.ramp = &kBrassRamp, .tone = 2.4, .height = 6.0});
    for (int leaf = 0; leaf < 5; ++leaf) {
        const double x = 16.0 + 7.0 * leaf;
        drawLimb(surface, {x, 30.0}, 3.2, {kMiddle + 1.35 * (x - kMiddle), 17.0}, 2.4,
                 {.ramp = &kBrassRamp, .tone = 3.3 - 0.03 * x, .height = 9.0});
    }
    for (const double x : {9.5, 50.5}) {
        drawBall(surface, {x, 13.0}, 6.0, 6.0,
                 {.ramp = &kBrassRamp, .tone = 3.4, .height = 11.0, .bulge = 0.7});
        drawBall(surface, {x, 13.0}, 2.4, 2.4,
                 {.ramp = &kBrassRamp, .tone = 1.6, .height = 14.0, .bulge = 0.4});
    }
    drawBox(surface, 2, 1, 58, 8, {.ramp = marble, .tone = 5.2, .height = 12.0, .bulge = 0.1});
    return spriteOf(surface, {.gain = 0.35,
                              .lightest = 0.9,
                              .darkest = 1.4,
                              .shadowReach = 3,
                              .shadowSlope = 0.8,
                              .shadowDepth = 0.7});
}

// A wheel of brass on chains, candles all around it.
Picture paintChandelier() {
    constexpr double kMiddle = 64.0;
    constexpr double kRim = 92.0;
    Surface surface = Surface::empty(128, 120);
    const Ramp* brass = &kBrassRamp;
    drawLimb(surface, {kMiddle, 1.0}, 1.4, {kMiddle, 30.0}, 1.4, {.ramp = brass, .tone = 2.2});
    for (const double x : {20.0, 46.0, 82.0, 108.0}) {
        drawLimb(surface, {kMiddle, 30.0}, 1.1, {x, kRim}, 1.1, {.ramp = brass, .tone = 2.4});
    }
    drawBall(surface, {kMiddle, 30.0}, 6.0, 6.0, {.ramp = brass, .tone = 3.2, .height = 4.0});
    const auto candle = [&](double x, double y, double height) {
        drawLimb(surface, {x, y - 3.0}, 2.6, {x, y - 13.0}, 2.4,
                 {.ramp = &kStoneRamp, .tone = 6.2, .height = height, .bulge = 0.5});
        drawBall(surface, {x, y - 21.0}, 3.4, 6.0,
                 {.ramp = &kFireRamp, .tone = 6.0, .height = height, .bulge = 0.0});
        drawBall(surface, {x, y - 19.5}, 1.8, 3.6,
                 {.ramp = &kFireRamp, .tone = 7.0, .height = height, .bulge = 0.0});
        drawBall(surface, {x, y - 1.0}, 5.0, 2.4,
                 {.ramp = brass, .tone = 3.6, .height = height + 1.0, .bulge = 0.6});
    };
    // The far half of the wheel, then the near one
    for (int number = 0; number < 5; ++number) {
        const double x = kMiddle + 17.0 * (number - 2);
        candle(x, kRim - 7.0 + 0.005 * (x - kMiddle) * (x - kMiddle), 2.0);
    }
    everyTexelOn(surface, 0.0, kRim - 14.0, 128.0, kRim + 16.0, [&](int x, int y) {
        const double dx = (x + 0.5 - kMiddle) / 46.0;
        const double dy = (y + 0.5 - kRim) / 10.0;
        const double off = std::abs(std::sqrt(dx * dx + dy * dy) - 1.0);
        if (off < (dy > 0.0 ? 0.3 : 0.16)) {
            surface.at(x, y) = {.height = dy > 0.0 ? 9.0 - 5.0 * off : 3.0,
                                .tone = dy > 0.0 ? 3.4 - 2.0 * off : 2.0,
                                .ramp = brass,
                                .alpha = 255};
        }
    });
    for (int number = 0; number < 6; ++number) {
        const double x = kMiddle + 16.0 * (number - 2.5);
        candle(x, kRim + 9.0 - 0.005 * (x - kMiddle) * (x - kMiddle), 12.0);
    }
    drawLimb(surface, {kMiddle, kRim + 12.0}, 3.0, {kMiddle, 114.0}, 1.4,
             {.ramp = brass, .tone = 2.9, .height = 8.0});
    drawBall(surface, {kMiddle, 115.0}, 3.6, 3.6, {.ramp = brass, .tone = 3.5, .height = 9.0});
    return spriteOf(surface, {.gain = 0.3, .lightest = 0.8, .darkest = 0.9, .shadowReach = 0});
}

}  // namespace slicecast::textures
