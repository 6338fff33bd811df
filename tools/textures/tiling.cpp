#include "tiling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "marks.h"
#include "noise.h"
#include "pieces.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kTilingSeed = 1200;

}  // namespace

Picture paintMarbleChecker() {
    constexpr int kTile = 32;
    Surface surface;
    everyTexel([&](int x, int y) {
        const int tile = x / kTile + 4 * (y / kTile);
        const bool dark = (x / kTile + y / kTile) % 2 == 1;
        const int localX = x % kTile;
        const int localY = y % kTile;
        const int inside = std::min({localX, kTile - 1 - localX, localY, kTile - 1 - localY});
        const auto seed = kTilingSeed + 5U * static_cast<std::uint32_t>(tile);
        // Veins: where two noises cross a level, each tile cut from another place of the block
        const double cloud = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, seed) - 0.5;
        const double bent = fractalNoise((x + y) / 32.0 + 0.5 * cloud,
                                         (y - x + kSide) / 16.0 + 2.5 * cloud, 8, 16, 2, seed + 1U);
        const bool vein = std::abs(bent - 0.5) < 0.022;
        const double gloss = localX + localY < 24 ? 0.25 : 0.0;
        Texel& texel = surface.at(x, y);
        texel.ramp = dark ? &kSlateRamp : &kStoneRamp;
        texel.tone = dark ? 1.9 + 0.7 * cloud + gloss : 4.6 + 0.9 * cloud + gloss;
        if (vein) {
            texel.tone += dark ? 0.9 : -0.8;
        }
        if (inside == 0) {
            texel.tone += localX == 0 || localY == 0 ? 0.5 : -0.8;
        }
    });
    return lit(surface, {.gain = 0.0, .lightest = 0.0, .darkest = 0.0, .shadowReach = 0});
}

// Octagons of fired clay with small glazed squares between.
Picture paintTerracotta() {
    constexpr int kTile = 32;
    constexpr int kDot = 9;  // half the diagonal of the small square
    Surface surface;
    everyTexel([&](int x, int y) {
        const int fromCornerX = std::min(x % kTile, kTile - x % kTile);
        const int fromCornerY = std::min(y % kTile, kTile - y % kTile);
        const double diagonal = (fromCornerX + fromCornerY - kDot) * 0.7071;
        const int side = std::min(x % kTile, kTile - 1 - x % kTile);
        const int end = std::min(y % kTile, kTile - 1 - y % kTile);
        const int tile = x / kTile + 4 * (y / kTile);
        const int corner = (x + kTile / 2) / kTile % 4 + 4 * ((y + kTile / 2) / kTile % 4);
        const double blotch = fractalNoise(x / 8.0, y / 8.0, 16, 16, 3, kTilingSeed + 100U) - 0.5;
        Texel& texel = surface.at(x, y);
        if (diagonal < -0.8) {
            texel.ramp = &kSeaRamp;
            texel.height = std::min(1.2, -diagonal - 0.8);
            texel.tone = 2.2 + 0.5 * (randomAt(corner, 1, kTilingSeed + 101U) - 0.5) + 0.5 * blotch;
            return;
        }
        const double inside = std::min({diagonal - 0.8, side + 0.0, end + 0.0});
        if (inside <= 0.0) {
            texel = {.height = 0.0, .tone = 2.6 + blotch, .ramp = &kStoneRamp};
            return;
        }
        texel.ramp = &kClayRamp;
        texel.height = std::min(1.4, inside * 0.8);
        texel.tone = 2.9 + 0.9 * (randomAt(tile, 2, kTilingSeed + 101U) - 0.5) + 0.9 * blotch;
    });
    return lit(surface, {.gain = 0.6,
                         .lightest = 0.7,
                         .darkest = 0.9,
                         .shadowReach = 1,
                         .shadowSlope = 0.6,
                         .shadowDepth = 0.4});
}

// Small cubes of stone: a braided border about a star, one field to the block.
Picture paintMosaic() {
    constexpr int kCube = 4;
    constexpr int kCubes = kSide / kCube;
    Surface surface;
    everyTexel([&](int x, int y) {
        const int column = x / kCube;
        const int row = y / kCube;
        const int fromX =
            std::abs(2 * column - (kCubes - 1)) / 2;  // 0 at the middle, 15 at the border
        const int fromY = std::abs(2 * row - (kCubes - 1)) / 2;
        const int ring = std::max(fromX, fromY);
        const int sum = fromX + fromY;
        const Ramp* ramp = &kStoneRamp;
        double tone = 4.9;
        if (ring == 15) {
            ramp = &kSeaRamp;
            tone = 1.4;
        } else if (ring >= 12) {
            const bool braid = (column + row) % 6 < 3;
            ramp = braid ? &kClayRamp : &kStoneRamp;
            tone = braid ? 2.6 : 4.8;
        } else if (ring == 11) {
            ramp = &kSeaRamp;
            tone = 1.4;
        } else if (std::min(fromX, fromY) * 3 + ring < 11) {
            ramp = &kSeaRamp;
            tone = sum < 4 ? 3.4 : 2.2;
        } else if (std::abs(fromX - fromY) < 2 && sum < 13) {
            ramp = &kBrassRamp;
            tone = 3.0;
        }
        if (sum == 0) {
            ramp = &kBrassRamp;
            tone = 3.6;
        }
        Texel& texel = surface.at(x, y);
        texel.ramp = ramp;
        texel.tone = tone + 1.0 * (randomAt(column, row, kTilingSeed + 200U) - 0.5);
        if (x % kCube == kCube - 1 || y % kCube == kCube - 1) {
            texel.tone -= 0.9;
        } else if (x % kCube == 0 && y % kCube == 0) {
            texel.tone += 0.4;
        }
    });
    return lit(surface, {.gain = 0.0, .lightest = 0.0, .darkest = 0.0, .shadowReach = 0});
}

// Sunk panels between crossing ribs, a gilded rosette in each.
Picture paintCeilingCoffers() {
    constexpr int kCoffer = 64;
    static constexpr std::array<double, 4> kSteps = {9.0, 14.0, 19.0,
                                                     64.0};  // from the rib's middle inwards
    Surface surface;
    everyTexel([&](int x, int y) {
        const int localX = x % kCoffer;
        const int localY = y % kCoffer;
        const int inside = std::min({localX, kCoffer - 1 - localX, localY, kCoffer - 1 - localY});
        const double grain = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kTilingSeed + 300U) - 0.5;
        int step = 0;
        while (inside >= kSteps[static_cast<std::size_t>(step)]) {
            ++step;
        }
        Texel& texel = surface.at(x, y);
        texel.ramp = step == 3 ? &kClayRamp : &kOakRamp;
        texel.height = 7.0 - 2.2 * step;
        texel.tone =
            step == 3
                ? 0.9 + 0.5 * grain
                : 3.1 - 0.35 * step +
                      0.8 * woodGrain(std::abs(localX - 31.5) > std::abs(localY - 31.5) ? y : x,
                                      std::abs(localX - 31.5) > std::abs(localY - 31.5) ? x : y,
                                      kTilingSeed + 301U);
        if (inside == 9 || inside == 8) {
            texel.ramp = &kBrassRamp;
            texel.tone = 2.4;
        }
    });
    // Rosettes: eight petals on a disc
    static constexpr std::array<Point, 8> kDirections = {{{1.0, 0.0},
                                                          {0.7071, 0.7071},
                                                          {0.0, 1.0},
                                                          {-0.7071, 0.7071},
                                                          {-1.0, 0.0},
                                                          {-0.7071, -0.7071},
                                                          {0.0, -1.0},
                                                          {0.7071, -0.7071}}};
    for (const int middleY : {32, 96}) {
        for (const int middleX : {32, 96}) {
            for (const Point& direction : kDirections) {
                drawStud(surface, {.x = middleX + 6.2 * direction.x,
                                   .y = middleY + 6.2 * direction.y,
                                   .radius = 2.7,
                                   .height = 2.4,
                                   .tone = 2.7,
                                   .ramp = &kBrassRamp});
            }
            drawStud(surface, {.x = middleX + 0.0,
                               .y = middleY + 0.0,
                               .radius = 3.4,
                               .height = 3.4,
                               .tone = 2.9,
                               .ramp = &kBrassRamp});
        }
    }
    return lit(surface, {.gain = 0.4,
                         .lightest = 0.9,
                         .darkest = 1.2,
                         .shadowReach = 5,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.9});
}

}  // namespace slicecast::textures
