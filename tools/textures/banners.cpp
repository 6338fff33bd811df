#include "banners.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "marks.h"
#include "noise.h"
#include "stonework.h"

namespace slicecast::textures {

namespace {

struct Cloth {
    const Ramp* field;
    double tone;
};

Picture paintBannerOf(const Cloth& cloth) {
    constexpr int kLeft = 30;
    constexpr int kRight = 98;
    constexpr int kTop = 16;
    constexpr int kBottom = 118;
    constexpr double kMiddle = 63.5;
    static constexpr std::array<std::array<double, 2>, 8> kRays = {{{1.0, 0.0},
                                                                    {0.7071, 0.7071},
                                                                    {0.0, 1.0},
                                                                    {-0.7071, 0.7071},
                                                                    {-1.0, 0.0},
                                                                    {-0.7071, -0.7071},
                                                                    {0.0, -1.0},
                                                                    {0.7071, -0.7071}}};
    const Surface wall = ashlarSurface();
    Surface surface = wall;
    everyTexelIn(kLeft, kTop, kRight, kBottom, [&](int x, int y) {
        // Swallow tail
        const double fromMiddle = std::abs(x - kMiddle);
        const double lowerEdge = kBottom - 22.0 + 22.0 * fromMiddle / 34.0;
        if (y > lowerEdge) {
            return;
        }
        const double inside = std::min({x - kLeft + 0.5, kRight - x - 0.5, (lowerEdge - y) * 0.8});
        const double fold = wave((x - kMiddle) / 26.0 + 0.1 + 0.004 * (y - kTop));
        Texel& texel = surface.at(x, y);
        texel.height = 4.0 + 1.1 * fold;
        texel.ramp = cloth.field;
        texel.tone = cloth.tone + 0.35 * fold;
        const auto gild = [&](double tone) {
            texel.ramp = &kBrassRamp;
            texel.tone = tone + 0.3 * fold;
        };
        if (inside > 3.0 && inside < 6.5) {
            gild(3.0);
        }
        // The sun over the sea
        const double dx = x - kMiddle;
        const double dy = y - 50.0;
        const double distance = std::sqrt(dx * dx + dy * dy);
        if (distance < 10.0) {
            gild(distance < 8.0 ? 3.8 - 0.06 * (dx + dy) : 2.2);
        } else if (distance > 11.5 && distance < 21.0) {
            for (const auto& ray : kRays) {
                const double along = dx * ray[0] + dy * ray[1];
                const double across = std::abs(dx * ray[1] - dy * ray[0]);
                if (along > 0.0 && across < (21.0 - along) * 0.3) {
                    gild(3.2);
                }
            }
        }
        for (int crest = 0; crest < 2; ++crest) {
            const double swell = 78.0 + 9.0 * crest + 2.6 * wave(dx / 17.0);
            if (std::abs(y - swell) < 2.0 && inside > 9.0) {
                texel.ramp = &kStoneRamp;
                texel.tone = 5.6 + 0.4 * fold;
            }
        }
    });
    // The rod, its knobs, and the loops that hold the cloth
    everyTexelIn(24, 12, 105, 17, [&](int x, int y) {
        const int across = std::min(y - 12, 16 - y);
        surface.at(x, y) = {.height = 5.0 + 0.8 * across, .tone = 2.6, .ramp = &kBrassRamp};
    });
    drawStud(
        surface,
        {.x = 23.0, .y = 14.5, .radius = 4.0, .height = 4.0, .tone = 3.0, .ramp = &kBrassRamp});
    drawStud(
        surface,
        {.x = 105.0, .y = 14.5, .radius = 4.0, .height = 4.0, .tone = 3.0, .ramp = &kBrassRamp});
    for (int loop = 0; loop < 5; ++loop) {
        const int left = kLeft + 2 + loop * 15;
        everyTexelIn(left, 11, left + 5, 18, [&](int x, int y) {
            surface.at(x, y) = {.height = 6.0, .tone = cloth.tone, .ramp = cloth.field};
        });
    }
    return litOver(wall, ashlarLighting(), surface,
                   {.gain = 0.45,
                    .lightest = 0.8,
                    .darkest = 1.0,
                    .shadowReach = 5,
                    .shadowSlope = 0.8,
                    .shadowDepth = 1.0,
                    .hollowDepth = 0.04});
}

}  // namespace

Picture paintBanner() {
    return paintBannerOf({&kCrimsonRamp, 2.4});
}

Picture paintBannerSea() {
    return paintBannerOf({&kSeaRamp, 1.4});
}

}  // namespace slicecast::textures
