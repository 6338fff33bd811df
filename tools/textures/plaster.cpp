#include "plaster.h"

#include <algorithm>

#include "brickwork.h"
#include "marks.h"
#include "noise.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kPlasterSeed = 600;

// Strokes of the trowel: overlapping shallow arcs, each a little higher at its lower right rim.
void drawTrowelling(Surface& surface, int strokes, std::uint32_t seed) {
    Random random(seed);
    for (int stroke = 0; stroke < strokes; ++stroke) {
        const int middleX = random.below(kSide);
        const int middleY = random.below(kSide);
        const double radius = random.between(11.0, 20.0);
        const double squash = random.between(1.3, 2.2);
        const double lift = random.between(-0.16, 0.16);
        const int reach = static_cast<int>(radius);
        everyTexelIn(middleX - reach, middleY - reach, middleX + reach, middleY + reach,
                     [&](int x, int y) {
                         const double dx = x - middleX;
                         const double dy = (y - middleY) * squash;
                         if (dx * dx + dy * dy < radius * radius) {
                             surface.at(x, y).height += 0.7;
                             surface.at(x, y).tone += lift;
                         }
                     });
    }
}

Surface plasterSurface(const Ramp& ramp, double tone, std::uint32_t seed) {
    Surface surface;
    everyTexel([&](int x, int y) {
        const double cloud = fractalNoise(x / 32.0, y / 32.0, 4, 4, 3, seed) - 0.5;
        surface.at(x, y) = {.height = 0.0, .tone = tone + 1.0 * cloud, .ramp = &ramp};
    });
    drawTrowelling(surface, 46, seed + 1U);
    return surface;
}

Surface warmSurface() {
    Surface surface = plasterSurface(kSandRamp, 3.9, kPlasterSeed + 20U);
    drawCrack(surface,
              {.x = 40, .y = 100, .length = 30, .depth = 0.6, .darkening = 1.0, .seed = 11});
    drawCrack(surface,
              {.x = 104, .y = 48, .length = 16, .depth = 0.6, .darkening = 0.9, .seed = 15});
    return surface;
}

}  // namespace

Lighting plasterLighting() {
    return {.gain = 0.5,
            .lightest = 0.4,
            .darkest = 0.5,
            .shadowReach = 0,
            .shadowSlope = 1.0,
            .shadowDepth = 0.0,
            .hollowDepth = 0.0};
}

Surface whitewashSurface() {
    Surface surface = plasterSurface(kStoneRamp, 5.6, kPlasterSeed);
    everyTexel([&](int x, int y) { surface.at(x, y).height *= 0.5; });
    return surface;
}

Picture paintPlasterWhite() {
    Surface surface = whitewashSurface();
    drawCrack(surface, {.x = 90, .y = 20, .length = 26, .depth = 0.6, .darkening = 0.9, .seed = 4});
    drawCrack(surface, {.x = 30, .y = 84, .length = 18, .depth = 0.6, .darkening = 0.8, .seed = 6});
    return lit(surface, plasterLighting());
}

Picture paintPlasterWarm() {
    return lit(warmSurface(), plasterLighting());
}

// Plaster that has fallen off in places and shows the bricks. Its border stays whole, to stand
// among sound plaster.
Picture paintPlasterBroken() {
    constexpr double kLayer = 3.2;  // thickness of the plaster
    const Surface plaster = warmSurface();
    const Surface bricks = brickSurface();
    Surface surface = plaster;
    everyTexel([&](int x, int y) {
        const double fromBorder = std::min({x, kSide - 1 - x, y, kSide - 1 - y});
        const double loose = fractalNoise(x / 32.0, y / 32.0, 4, 4, 4, kPlasterSeed + 144U) -
                             0.5 * (1.0 - smoothStep(4.0, 30.0, fromBorder));
        Texel& texel = surface.at(x, y);
        if (loose > 0.52) {
            texel = bricks.at(x, y);
            texel.height -= kLayer;
        } else if (loose > 0.505) {
            texel.tone += 0.5;
        }
    });
    return litOver(plaster, plasterLighting(), surface,
                   {.gain = 0.5,
                    .lightest = 0.5,
                    .darkest = 1.2,
                    .shadowReach = 3,
                    .shadowSlope = 0.7,
                    .shadowDepth = 1.0,
                    .hollowDepth = 0.05});
}

}  // namespace slicecast::textures
