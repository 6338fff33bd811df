#include "foliage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cutout.h"
#include "leaves.h"
#include "noise.h"
#include "pieces.h"
#include "stonework.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kFoliageSeed = 1600;

}  // namespace

// Long plates of bark between deep furrows, some moss on the side of the weather.
Picture paintBark() {
    static const Pieces plates(nearest(spreadPoints(28, 0.2, kFoliageSeed + 40U), 0.2), 4.0,
                               kFoliageSeed + 41U);
    Surface surface;
    everyTexel([&](int x, int y) {
        const int piece = plates.pieceAt(x, y);
        const double inside = plates.edgeAt(x, y) - 0.9;
        const double fibre = valueNoise(x / 2.0, y / 16.0, 64, 8, kFoliageSeed + 42U) - 0.5;
        const double scale = valueNoise(x / 8.0, y / 4.0, 16, 32, kFoliageSeed + 43U) - 0.5;
        const double moss = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kFoliageSeed + 44U);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kTimberRamp;
        texel.height = inside <= 0.0 ? 0.0 : std::min(1.0 + 0.8 * inside, 4.5) + 1.6 * scale;
        texel.tone = inside <= 0.0 ? 0.3
                                   : 2.3 + 0.8 * (randomAt(piece, 1, kFoliageSeed + 45U) - 0.5) +
                                         1.0 * fibre + 0.6 * scale;
        if (inside > 0.6 && moss > 0.68) {
            texel.ramp = &kMossRamp;
            texel.tone += 0.5;
        }
    });
    return lit(surface, {.gain = 0.5,
                         .lightest = 0.9,
                         .darkest = 1.2,
                         .shadowReach = 3,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.7});
}

Picture paintHedge() {
    Surface surface;
    everyTexel(
        [&](int x, int y) { surface.at(x, y) = {.height = 0.0, .tone = 0.8, .ramp = &kMossRamp}; });
    // From the dark inside to the sunlit outside; leaves of one spray share their light
    Random random(kFoliageSeed);
    constexpr int kLayers = 4;
    for (int layer = 0; layer < kLayers; ++layer) {
        for (int number = 0; number < 230; ++number) {
            const double x = random.between(0.0, kSide);
            const double y = random.between(0.0, kSide);
            const double spray = valueNoise(x / 16.0, y / 16.0, 8, 8, kFoliageSeed + 1U);
            const Direction direction = kHanging[static_cast<std::size_t>(random.below(7))];
            const double length = random.between(5.5, 8.5);
            if (layer == kLayers - 1 && spray < 0.4) {
                continue;
            }
            drawLeaf(surface, {.x = x,
                               .y = y,
                               .direction = direction,
                               .length = length,
                               .width = 0.3 * length,
                               .height = 1.6 * (layer + 1),
                               .tone = 1.7 + 0.7 * layer + 0.9 * (spray - 0.5)});
        }
    }
    return lit(surface, {.gain = 0.1,
                         .lightest = 0.3,
                         .darkest = 0.3,
                         .shadowReach = 2,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.6,
                         .hollowDepth = 0.05});
}

// The outermost leaves of a hedge or a tree, with the sky between them.
Picture paintLeaves() {
    Surface surface = Surface::empty();
    Random random(kFoliageSeed + 60U);
    constexpr int kLayers = 3;
    for (int layer = 0; layer < kLayers; ++layer) {
        for (int number = 0; number < 170; ++number) {
            const double x = random.between(0.0, kSide);
            const double y = random.between(0.0, kSide);
            const double spray = fractalNoise(x / 21.34, y / 21.34, 6, 6, 2, kFoliageSeed + 61U);
            const Direction direction = kHanging[static_cast<std::size_t>(random.below(7))];
            const double length = random.between(7.0, 11.0);
            if (spray < 0.24 + 0.09 * layer) {
                continue;
            }
            drawLeaf(surface, {.x = x,
                               .y = y,
                               .direction = direction,
                               .length = length,
                               .width = 0.3 * length,
                               .height = 1.6 * (layer + 1),
                               .tone = 2.2 + 0.8 * layer + 1.4 * (spray - 0.5)});
        }
    }
    const Lighting lighting = {.gain = 0.1,
                               .lightest = 0.3,
                               .darkest = 0.3,
                               .shadowReach = 2,
                               .shadowSlope = 0.7,
                               .shadowDepth = 0.6,
                               .hollowDepth = 0.05};
    return holesFilled(lit(surface, lighting), Border::Repeats);
}

Picture paintIvy() {
    Surface surface = ashlarSurface();
    Random random(kFoliageSeed + 20U);
    for (int layer = 0; layer < 3; ++layer) {
        for (int number = 0; number < 210; ++number) {
            const double x = random.between(0.0, kSide);
            const double y = random.between(0.0, kSide);
            const double cover = fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kFoliageSeed + 21U);
            const Direction direction = kHanging[static_cast<std::size_t>(random.below(7))];
            const double length = random.between(6.5, 10.0);
            if (cover < 0.40 + 0.05 * layer) {
                continue;
            }
            // Three lobes make the leaf of ivy
            const Leaf leaf{.x = x,
                            .y = y,
                            .direction = direction,
                            .length = length,
                            .width = 0.27 * length,
                            .height = 3.5 + 1.5 * layer,
                            .tone = 1.9 + 0.65 * layer + 1.6 * (cover - 0.5)};
            Leaf lobe = leaf;
            lobe.length = 0.7 * length;
            lobe.direction = {0.6 * direction.x - 0.8 * direction.y,
                              0.8 * direction.x + 0.6 * direction.y};
            drawLeaf(surface, lobe);
            lobe.direction = {0.6 * direction.x + 0.8 * direction.y,
                              -0.8 * direction.x + 0.6 * direction.y};
            drawLeaf(surface, lobe);
            drawLeaf(surface, leaf);
        }
    }
    return lit(surface, {.gain = 0.3,
                         .lightest = 0.6,
                         .darkest = 0.9,
                         .shadowReach = 4,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.9,
                         .hollowDepth = 0.06});
}

}  // namespace slicecast::textures
