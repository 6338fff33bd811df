#include "trees.h"

#include <algorithm>
#include <cmath>

#include "crown.h"
#include "leaves.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kTreesSeed = 3400;

constexpr Lighting kLeafLight = {.gain = 0.12,
                                 .lightest = 0.5,
                                 .darkest = 0.6,
                                 .shadowReach = 3,
                                 .shadowSlope = 0.8,
                                 .shadowDepth = 0.5,
                                 .hollowDepth = 0.04};

// Grass at the foot hides where a trunk meets the ground.
void drawTuft(Surface& surface, double from, double to, int blades, std::uint32_t seed) {
    Random random(seed);
    for (int blade = 0; blade < blades; ++blade) {
        const double x = random.between(from, to);
        const double lean = random.between(-3.0, 3.0);
        const double height = random.between(4.0, 9.0);
        drawLimb(
            surface, {x, surface.height + 0.0}, 1.2, {x + lean, surface.height - height}, 0.6,
            {.ramp = &kMossRamp, .tone = random.between(2.2, 4.0), .height = 14.0, .bulge = 0.3});
    }
}

}  // namespace

Picture paintOak() {
    Surface surface = Surface::empty(216, 244);
    const Paint wood = {.ramp = &kOakRamp, .tone = 3.1};
    // Trunk, roots and boughs
    drawLimb(surface, {108.0, 232.0}, 13.0, {106.0, 160.0}, 10.5, wood);
    drawLimb(surface, {103.0, 222.0}, 8.0, {86.0, 243.0}, 5.0, wood);
    drawLimb(surface, {112.0, 222.0}, 8.0, {131.0, 243.0}, 5.0, wood);
    drawLimb(surface, {108.0, 228.0}, 9.0, {109.0, 244.0}, 8.0, wood);
    drawLimb(surface, {104.0, 180.0}, 7.5, {62.0, 132.0}, 4.0, wood);
    drawLimb(surface, {109.0, 176.0}, 7.5, {154.0, 130.0}, 4.0, wood);
    drawLimb(surface, {106.0, 165.0}, 9.0, {110.0, 110.0}, 5.0, wood);
    drawLimb(surface, {132.0, 154.0}, 3.5, {172.0, 142.0}, 2.5, wood);
    addGrain(surface, &kOakRamp, 1.2, kTreesSeed);
    // A hollow where a bough broke off
    drawBall(surface, {103.0, 203.0}, 4.0, 6.0,
             {.ramp = &kOakRamp, .tone = 0.6, .height = 8.0, .bulge = -0.5});
    drawLeafage(
        surface,
        {{108.0, 52.0, 44.0},
         {66.0, 66.0, 36.0},
         {150.0, 64.0, 36.0},
         {108.0, 32.0, 28.0},
         {38.0, 98.0, 31.0},
         {178.0, 98.0, 31.0},
         {78.0, 40.0, 27.0},
         {138.0, 38.0, 27.0},
         {108.0, 88.0, 38.0},
         {60.0, 124.0, 26.0},
         {154.0, 122.0, 27.0},
         {84.0, 118.0, 25.0},
         {130.0, 114.0, 26.0}},
        {.tone = 2.7, .contrast = 1.25, .length = 8.0, .width = 0.34, .seed = kTreesSeed + 1U});
    drawTuft(surface, 78.0, 138.0, 34, kTreesSeed + 2U);
    return spriteOf(surface, kLeafLight);
}

// Tiers of drooping branches, each throwing its shadow on the one below.
Picture paintPine() {
    constexpr int kWidth = 140;
    constexpr double kMiddle = kWidth / 2.0;
    constexpr int kTiers = 10;
    Surface surface = Surface::empty(kWidth, 252);
    drawLimb(surface, {kMiddle, 251.0}, 7.0, {kMiddle, 40.0}, 3.0,
             {.ramp = &kOakRamp, .tone = 2.6});
    drawLimb(surface, {kMiddle - 3.0, 244.0}, 5.0, {kMiddle - 12.0, 252.0}, 3.0,
             {.ramp = &kOakRamp, .tone = 2.5});
    drawLimb(surface, {kMiddle + 3.0, 244.0}, 5.0, {kMiddle + 13.0, 252.0}, 3.0,
             {.ramp = &kOakRamp, .tone = 2.5});
    addGrain(surface, &kOakRamp, 1.1, kTreesSeed + 10U);
    Random random(kTreesSeed + 11U);
    for (int tier = 0; tier < kTiers; ++tier) {
        const double share = static_cast<double>(tier) / (kTiers - 1);
        const double half = 64.0 - 56.0 * share;
        const double depth = 48.0 - 24.0 * share;
        const double top = 172.0 - 164.0 * share;
        const double base = 3.0 * tier + 4.0;
        // The dark inside
        const double dark = (tier == 0 ? 0.3 : 0.5) * half;
        drawOutline(surface,
                    {{kMiddle, top + 6.0},
                     {kMiddle + dark, top + depth * 0.72},
                     {kMiddle, top + depth * 0.66},
                     {kMiddle - dark, top + depth * 0.72}},
                    {.ramp = &kPineRamp, .tone = 0.9, .height = base});
        // Boughs from the trunk outwards, needles along each
        const int boughs = 13 + static_cast<int>(half / 5.0);
        for (int bough = 0; bough < boughs; ++bough) {
            const double side = 2.0 * (bough + random.between(0.1, 0.9)) / boughs - 1.0;
            const double reach = random.between(0.88, 1.08) * (1.0 - 0.08 * side * side);
            const double endX = kMiddle + side * half * reach;
            const double endY = top + depth * reach * (0.93 + 0.14 * (1.0 - std::abs(side)));
            const double light = -0.55 * side;
            const int needles = 6 + static_cast<int>(depth / 6.0);
            for (int needle = 0; needle < needles; ++needle) {
                const double along = 0.2 + 0.8 * needle / (needles - 1);
                const double bend = along * along;
                const double x = kMiddle + (endX - kMiddle) * along;
                const double y = top + (endY - top) * (0.25 * along + 0.75 * bend);
                const double fan = random.between(-0.45, 0.45);
                const double dx = 0.75 * side + fan;
                const double length = std::sqrt(dx * dx + 1.0);
                drawLeaf(surface, {.x = x,
                                   .y = y - 5.0,
                                   .direction = {dx / length, 1.0 / length},
                                   .length = random.between(9.0, 13.0) * (1.0 - 0.4 * share),
                                   .width = 1.7,
                                   .height = base + 2.0 + 1.5 * along,
                                   .tone = 2.0 + 1.5 * light + 2.8 * along * along +
                                           0.9 * share * share + random.between(-0.4, 0.5),
                                   .ramp = &kPineRamp,
                                   .cutOff = true});
            }
        }
    }
    drawLimb(surface, {kMiddle, 14.0}, 1.6, {kMiddle, 2.0}, 0.8,
             {.ramp = &kPineRamp, .tone = 4.0, .height = 40.0});
    drawTuft(surface, 48.0, 92.0, 18, kTreesSeed + 12U);
    return spriteOf(surface, kLeafLight);
}

Picture paintBirch() {
    Surface surface = Surface::empty(140, 252);
    const Paint bark = {.ramp = &kStoneRamp, .tone = 5.9};
    const Paint shaded = {.ramp = &kStoneRamp, .tone = 4.2};
    drawLimb(surface, {72.0, 251.0}, 6.5, {68.0, 150.0}, 4.6, shaded);
    drawLimb(surface, {68.0, 152.0}, 4.6, {74.0, 40.0}, 2.0, shaded);
    drawLimb(surface, {70.5, 251.0}, 4.6, {66.5, 150.0}, 3.2, bark);
    drawLimb(surface, {66.5, 152.0}, 3.2, {73.4, 40.0}, 1.4, bark);
    drawLimb(surface, {69.0, 168.0}, 3.2, {44.0, 112.0}, 1.8, bark);
    drawLimb(surface, {70.0, 150.0}, 3.2, {98.0, 96.0}, 1.7, bark);
    drawLimb(surface, {70.0, 118.0}, 2.6, {46.0, 72.0}, 1.5, bark);
    drawLimb(surface, {72.0, 98.0}, 2.4, {94.0, 58.0}, 1.4, bark);
    drawLimb(surface, {75.0, 242.0}, 5.0, {84.0, 252.0}, 3.0, bark);
    drawLimb(surface, {69.0, 242.0}, 5.0, {60.0, 252.0}, 3.0, bark);
    // Dark scars across the white bark, denser and rougher at the foot
    Random random(kTreesSeed + 20U);
    for (int scar = 0; scar < 60; ++scar) {
        const double share = random.fraction();
        const int y = 245 - static_cast<int>(190.0 * share);
        const int x = 63 + random.below(14);
        const int length = 2 + random.below(share < 0.35 ? 7 : 4);
        everyTexelOn(surface, x, y, x + length, y + (random.fraction() < 0.3 ? 2 : 1),
                     [&](int scarX, int scarY) {
                         Texel& texel = surface.at(scarX, scarY);
                         if (texel.alpha > 0) {
                             texel.ramp = &kSlateRamp;
                             texel.tone = 1.4;
                             texel.height -= 0.5;
                         }
                     });
    }
    // Airy leaves in hanging sprays
    drawLeafage(surface,
                {{74.0, 36.0, 24.0},
                 {50.0, 64.0, 25.0},
                 {96.0, 58.0, 25.0},
                 {72.0, 66.0, 27.0},
                 {36.0, 100.0, 25.0},
                 {104.0, 94.0, 27.0},
                 {70.0, 102.0, 26.0},
                 {46.0, 132.0, 21.0},
                 {98.0, 128.0, 22.0}},
                {.tone = 3.7,
                 .contrast = 1.1,
                 .length = 5.4,
                 .width = 0.36,
                 .density = 0.36,
                 .filled = false,
                 .hanging = true,
                 .seed = kTreesSeed + 21U});
    drawTuft(surface, 52.0, 92.0, 20, kTreesSeed + 22U);
    return spriteOf(surface, kLeafLight);
}

Picture paintBush() {
    Surface surface = Surface::empty(132, 76);
    drawLeafage(
        surface,
        {{66.0, 34.0, 30.0},
         {38.0, 46.0, 26.0},
         {94.0, 46.0, 26.0},
         {26.0, 58.0, 18.0},
         {107.0, 58.0, 18.0},
         {52.0, 54.0, 22.0},
         {80.0, 54.0, 23.0},
         {66.0, 62.0, 18.0}},
        {.tone = 2.6, .contrast = 1.3, .length = 7.0, .width = 0.34, .seed = kTreesSeed + 30U});
    drawTuft(surface, 14.0, 118.0, 46, kTreesSeed + 31U);
    return spriteOf(surface, kLeafLight);
}

Picture paintFlowerBush() {
    Surface surface = Surface::empty(120, 84);
    drawLeafage(
        surface,
        {{60.0, 36.0, 28.0},
         {34.0, 50.0, 25.0},
         {86.0, 50.0, 25.0},
         {60.0, 58.0, 25.0},
         {26.0, 66.0, 17.0},
         {94.0, 66.0, 17.0}},
        {.tone = 2.4, .contrast = 1.1, .length = 7.5, .width = 0.3, .seed = kTreesSeed + 40U});
    // Blossoms of five petals, in drifts, lighter above
    Random random(kTreesSeed + 41U);
    for (int number = 0; number < 240; ++number) {
        const double x = random.between(10.0, 110.0);
        const double y = random.between(8.0, 78.0);
        const double own = random.between(-0.5, 0.5);
        const int at = static_cast<int>(x);
        const int row = static_cast<int>(y);
        const bool inside = surface.at(at, row).alpha > 0 &&
                            surface.at(wrap(at + 4, 120), row).alpha > 0 &&
                            surface.at(wrap(at - 4, 120), row).alpha > 0;
        if (!inside || valueNoise(x / 14.0, y / 14.0, 8, 8, kTreesSeed + 42U) < 0.47) {
            continue;
        }
        const double tone = 3.9 - y / 45.0 + own;
        constexpr Place kPetals[] = {
            {0.0, -2.2}, {2.1, -0.7}, {1.3, 1.8}, {-1.3, 1.8}, {-2.1, -0.7}};
        for (const Place& petal : kPetals) {
            drawBall(surface, {x + petal.x, y + petal.y}, 1.5, 1.5,
                     {.ramp = &kBlossomRamp, .tone = tone, .height = 16.0, .bulge = 0.6});
        }
        drawBall(surface, {x, y}, 0.9, 0.9, {.ramp = &kBrassRamp, .tone = 3.8, .height = 17.0});
    }
    drawTuft(surface, 14.0, 106.0, 40, kTreesSeed + 43U);
    return spriteOf(surface, kLeafLight);
}

}  // namespace slicecast::textures
