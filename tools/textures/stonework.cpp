#include "stonework.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "marks.h"
#include "noise.h"
#include "pieces.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kStoneworkSeed = 200;

const Pieces& ashlar() {
    static const Pieces pieces(coursed({{32, 10, {44, 36, 48}},
                                        {32, 34, {56, 40, 32}},
                                        {32, 4, {38, 50, 40}},
                                        {32, 26, {48, 34, 46}}}),
                               0.0, kStoneworkSeed);
    return pieces;
}

double variationOf(int piece) {
    return randomAt(piece, 3, kStoneworkSeed) - 0.5;
}

}  // namespace

Lighting ashlarLighting() {
    return {.gain = 0.5,
            .lightest = 0.9,
            .darkest = 1.3,
            .shadowReach = 3,
            .shadowSlope = 0.6,
            .shadowDepth = 0.9};
}

Surface ashlarSurface() {
    Surface surface;
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        const int piece = ashlar().pieceAt(x, y);
        const double ragged =
            1.2 * std::max(0.0, valueNoise(x / 4.0, y / 4.0, 32, 32, kStoneworkSeed + 1U) - 0.55);
        const double inside = ashlar().edgeAt(x, y) - 0.6 - ragged;
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kStoneworkSeed + 2U) - 0.5;
        texel.height = std::clamp(inside * 0.8, 0.0, 2.4);
        texel.ramp = &kStoneRamp;
        texel.tone = inside <= 0.0 ? 1.6 : 3.6 + 1.0 * variationOf(piece) + 1.5 * blotch;
    });
    // The mason's chisel: short slanting strokes, lighter below
    Random random(kStoneworkSeed + 3U);
    for (int stroke = 0; stroke < 90; ++stroke) {
        const int x = random.below(kSide);
        const int y = random.below(kSide);
        const int length = 2 + random.below(3);
        for (int step = 0; step < length; ++step) {
            if (ashlar().edgeAt(x - step, y + step) > 3.5) {
                surface.at(x - step, y + step).height -= 0.7;
                surface.at(x - step, y + step).tone -= 0.3;
            }
        }
    }
    return surface;
}

Picture paintStoneBlocks() {
    return lit(ashlarSurface(), ashlarLighting());
}

Picture paintStoneBlocksWorn() {
    Surface surface = ashlarSurface();
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        const double inside = ashlar().edgeAt(x, y) - 0.6;
        const double bite = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kStoneworkSeed + 10U);
        if (inside <= 0.0) {
            return;
        }
        // Corners and edges broken away
        const double worn = inside - 10.0 * std::max(0.0, bite - 0.58);
        texel.height = std::clamp(worn * 0.7, 0.3, 2.4);
        texel.tone -= worn < 1.0 ? 0.3 : 0.0;
        // Rain stains running down, lichen on the lit shoulders
        const double stain = valueNoise(x / 4.0, y / 64.0, 32, 2, kStoneworkSeed + 11U);
        texel.tone -= stain > 0.72 ? 0.5 : 0.0;
        const double lichen = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kStoneworkSeed + 12U);
        if (lichen > 0.7) {
            texel.ramp = &kLichenRamp;
            texel.tone += 0.5;
        }
    });
    drawCrack(surface, {.x = 60, .y = 34, .length = 48, .depth = 1.6, .darkening = 1.2, .seed = 3});
    drawCrack(surface,
              {.x = 104, .y = 98, .length = 40, .depth = 1.6, .darkening = 1.2, .seed = 14});
    drawCrack(surface, {.x = 18, .y = 70, .length = 22, .depth = 1.6, .darkening = 1.0, .seed = 8});
    return lit(surface, ashlarLighting());
}

// Two courses of rough-faced blocks in slate, for towers and cellars.
Picture paintStoneBlocksDark() {
    static const Pieces pieces(
        coursed({{64, 0, {64, 64}}, {32, 32, {64, 64}}, {32, 0, {48, 40, 40}}}), 1.0,
        kStoneworkSeed + 20U, kFine);
    Surface surface(kFineSide, kFineSide);
    everyFineTexel([&](int fineX, int fineY) {
        const double x = fineX / 2.0;
        const double y = fineY / 2.0;
        Texel& texel = surface.at(fineX, fineY);
        const double chipped =
            1.6 * std::max(0.0, valueNoise(x / 3.2, y / 3.2, 40, 40, kStoneworkSeed + 22U) - 0.6);
        const double inside = pieces.edgeAt(fineX, fineY) - 0.8 - chipped;
        const double rough = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kStoneworkSeed + 21U);
        const double grain = randomAt(fineX, fineY, kStoneworkSeed + 23U);
        const double variation = randomAt(pieces.pieceAt(fineX, fineY), 5, kStoneworkSeed) - 0.5;
        texel.ramp = &kSlateRamp;
        if (inside <= 0.0) {  // mortar with grains of sand
            texel.height = grain > 0.82 ? 0.8 : 0.0;
            texel.tone = 1.2 + (grain > 0.82 ? 0.6 : 0.0);
            return;
        }
        // Split along its bed: thin steps; and here and there a vein
        const double bed =
            valueNoise((x + y) / 32.0, (y - x + kSide) / 2.0, 8, 128, kStoneworkSeed + 24U);
        const double vein =
            std::abs(fractalNoise(x / 32.0, y / 32.0, 4, 4, 4, kStoneworkSeed + 25U) - 0.5);
        texel.height = 2.0 * std::min(1.0 + inside * 0.6, 3.0);
        texel.tone = 3.4 + 0.9 * variation + 0.9 * (rough - 0.5);
        if (inside > 1.5) {
            texel.height += (inside > 3.0 ? 10.0 * (rough - 0.5) : 0.0) - (bed < 0.22 ? 0.9 : 0.0);
            texel.tone += bed > 0.82 ? 0.4 : 0.0;
        }
        texel.tone += vein < 0.004 ? 0.9 : (grain > 0.985 ? 0.6 : (grain < 0.015 ? -0.6 : 0.0));
    });
    drawPits(surface, 500, 1.4, kStoneworkSeed + 26U);
    return lit(surface, {.gain = 0.55,
                         .lightest = 1.0,
                         .darkest = 1.2,
                         .shadowReach = 6,
                         .shadowSlope = 0.6,
                         .shadowDepth = 0.8});
}

Picture paintStoneRubble() {
    const double flatness = 1.35;
    static const Pieces pieces(nearest(spreadPoints(30, flatness, kStoneworkSeed + 30U), flatness),
                               1.5, kStoneworkSeed + 31U, kFine);
    static const std::array<const Ramp*, 4> ramps = {&kStoneRamp, &kStoneRamp, &kEarthRamp,
                                                     &kFlintRamp};
    Surface surface(kFineSide, kFineSide);
    everyFineTexel([&](int fineX, int fineY) {
        const double x = fineX / 2.0;
        const double y = fineY / 2.0;
        Texel& texel = surface.at(fineX, fineY);
        const int piece = pieces.pieceAt(fineX, fineY);
        const double chipped =
            1.2 * std::max(0.0, valueNoise(x / 3.2, y / 3.2, 40, 40, kStoneworkSeed + 34U) - 0.6);
        const double inside = pieces.edgeAt(fineX, fineY) - 1.3 - chipped;
        const double rough = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kStoneworkSeed + 32U) - 0.5;
        const double skin = valueNoise(x / 2.0, y / 2.0, 64, 64, kStoneworkSeed + 35U) - 0.5;
        const double grain = randomAt(fineX, fineY, kStoneworkSeed + 36U);
        if (inside <= 0.0) {  // mortar, rubbed smooth, with grains of sand
            texel.ramp = &kStoneRamp;
            texel.tone = 2.3 + 1.0 * rough + (grain > 0.9 ? 0.7 : (grain < 0.1 ? -0.6 : 0.0));
            texel.height = 0.8 * rough + (grain > 0.9 ? 0.6 : 0.0);
            return;
        }
        // Most stones show the bed that they were split from
        const double bed = valueNoise((x + 2.0 * skin) / 16.0, (y + 3.0 * rough) / 1.6, 8, 80,
                                      kStoneworkSeed + 40U + static_cast<std::uint32_t>(piece));
        const bool isBedded = hashOf(piece, 8, kStoneworkSeed) % 3U != 0U;
        const auto kind = hashOf(piece, 4, kStoneworkSeed) % ramps.size();
        texel.ramp = ramps[kind];
        texel.tone = (kind == 2   ? 4.2
                      : kind == 3 ? 4.6
                                  : 3.6) +
                     1.1 * (randomAt(piece, 6, kStoneworkSeed) - 0.5) + 1.2 * rough + 0.3 * skin;
        texel.tone += grain > 0.985 ? 0.7 : (grain < 0.02 ? -0.6 : 0.0);
        texel.height = std::min(inside, 3.0) * 1.8 + 0.3 * inside + 2.4 * rough + 0.8 * skin;
        if (isBedded && bed < 0.25) {
            texel.height -= 0.9;
            texel.tone -= 0.2;
        }
    });
    drawPits(surface, 520, 1.2, kStoneworkSeed + 37U);
    drawCrack(surface, {.x = 58, .y = 40, .length = 34, .depth = 1.5, .darkening = 0.9, .seed = 7});
    drawCrack(surface,
              {.x = 200, .y = 170, .length = 30, .depth = 1.5, .darkening = 0.9, .seed = 9});
    return lit(surface, {.gain = 0.45,
                         .lightest = 0.9,
                         .darkest = 1.3,
                         .shadowReach = 6,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.8});
}

Picture paintSandstone() {
    static const Pieces pieces(
        coursed({{32, 0, {64, 64}}, {32, 40, {48, 80}}, {32, 16, {64, 64}}, {32, 0, {72, 56}}}),
        0.0, kStoneworkSeed + 40U);
    Surface surface;
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        const int piece = pieces.pieceAt(x, y);
        const double inside = pieces.edgeAt(x, y) - 0.6;
        // Beds of the stone: long, nearly level bands, different in every block
        const double bend = 3.0 * valueNoise(x / 16.0, y / 32.0, 8, 4, kStoneworkSeed + 41U);
        const double bed = valueNoise(x / 32.0, (y + bend) / 4.0, 4, 32,
                                      kStoneworkSeed + 42U + static_cast<std::uint32_t>(piece));
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kStoneworkSeed + 43U) - 0.5;
        texel.ramp = &kSandRamp;
        texel.height = std::clamp(inside * 0.8, 0.0, 2.2) - (bed < 0.2 ? 0.6 : 0.0);
        texel.tone = 2.9 + 1.1 * (randomAt(piece, 1, kStoneworkSeed + 44U) - 0.5) + 1.3 * blotch;
        texel.tone += bed > 0.78 ? 0.4 : (bed < 0.2 ? -0.4 : 0.0);
        if (inside <= 0.0) {
            texel.tone = 0.6;
        }
    });
    drawPits(surface, 220, 0.9, kStoneworkSeed + 45U);
    return lit(surface, ashlarLighting());
}

// Living rock: facets that lean this way and that, with ledges.
Picture paintRock() {
    const double flatness = 1.3;
    static const std::vector<Point> points = spreadPoints(26, flatness, kStoneworkSeed + 50U);
    static const Pieces pieces(nearest(points, flatness), 4.0, kStoneworkSeed + 51U);
    Surface surface;
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        const int piece = pieces.pieceAt(x, y);
        const Point& middle = points[static_cast<std::size_t>(piece)];
        const double rough = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kStoneworkSeed + 52U) - 0.5;
        // Each facet is a plane; its lean decides how much light it takes
        const double leanX = randomAt(piece, 2, kStoneworkSeed + 54U) - 0.5;
        const double leanY = randomAt(piece, 4, kStoneworkSeed + 54U) - 0.6;
        const double plane =
            leanX * wrappedDifference(middle.x, x) + leanY * wrappedDifference(middle.y, y);
        texel.ramp = &kRockRamp;
        texel.tone = 3.1 + 1.2 * (leanX + leanY) + 0.9 * rough + 0.03 * plane;
        texel.height = 3.0 * randomAt(piece, 3, kStoneworkSeed + 54U) + 0.25 * plane +
                       std::min(pieces.edgeAt(x, y), 2.5) * 0.7 + 3.0 * rough;
    });
    return lit(surface, {.gain = 0.5,
                         .lightest = 1.3,
                         .darkest = 1.3,
                         .shadowReach = 5,
                         .shadowSlope = 0.6,
                         .shadowDepth = 0.9});
}

}  // namespace slicecast::textures
