#include "street.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "marks.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kStreetSeed = 3600;

// The front of a box of boards with a frame and a brace, and its lid seen a little from above.
void drawCrate(Surface& surface, int left, int top, int size, std::uint32_t seed) {
    constexpr int kFrame = 7;
    constexpr int kLid = 7;
    const double base = 4.0;
    drawOutline(surface,
                {{left + 5.0, top - kLid + 0.0},
                 {left + size - 5.0, top - kLid + 0.0},
                 {left + size + 0.0, top + 0.5},
                 {left + 0.0, top + 0.5}},
                {.ramp = &kTimberRamp, .tone = 4.7, .height = base});
    everyTexelIn(left, top, left + size, top + size, [&](int x, int y) {
        const int localX = x - left;
        const int localY = y - top;
        const int border = std::min({localX, size - 1 - localX, localY, size - 1 - localY});
        const double brace = std::abs(localX - (size - 1 - localY)) * 0.7071;
        const bool upright = std::min(localX, size - 1 - localX) < kFrame;
        Texel texel = {
            .height = base, .tone = 2.6 + 0.9 * woodGrain(x, y, seed), .ramp = &kTimberRamp};
        const int board = localY % 11;
        texel.tone += 0.5 * (randomAt(localY / 11, 1, seed) - 0.5);
        if (board == 10) {
            texel.tone = 0.9;
            texel.height -= 0.8;
        }
        if (border < kFrame || brace < 4.0) {
            const double inside =
                border < kFrame ? std::min(border + 0.6, kFrame - 0.4 - border) : 4.2 - brace;
            const double grain = border >= kFrame ? woodGrain(x - y, x + y, seed + 3U)
                                                  : (upright ? woodGrain(y, x, seed + 4U)
                                                             : woodGrain(x, y, seed + 5U));
            texel = {.height = base + 1.2 + std::min(1.2, 0.8 * inside),
                     .tone = 3.4 + 0.8 * grain,
                     .ramp = &kTimberRamp};
        }
        surface.at(x, y) = texel;
    });
    for (const int x : {left + 3, left + size - 5}) {
        for (const int y : {top + 3, top + size - 5}) {
            surface.at(x, y).tone = 0.4;
            surface.at(x + 1, y).tone = 0.8;
            surface.at(x, y + 1).tone = 0.8;
        }
    }
}

}  // namespace

Picture paintStreetLamp() {
    constexpr double kMiddle = 28.0;
    Surface surface = Surface::empty(56, 216);
    const Ramp* iron = &kSlateRamp;
    // Foot in steps, a fluted shaft with rings
    drawBox(surface, 10, 206, 46, 216, {.ramp = iron, .tone = 2.3, .bulge = 0.25});
    drawBox(surface, 14, 196, 42, 206, {.ramp = iron, .tone = 2.5, .height = 1.0, .bulge = 0.3});
    drawBox(surface, 19, 170, 37, 196, {.ramp = iron, .tone = 2.4, .height = 1.0, .bulge = 0.6});
    drawLimb(surface, {kMiddle, 165.0}, 6.0, {kMiddle, 62.0}, 3.6,
             {.ramp = iron, .tone = 2.5, .height = 1.0});
    for (const int y : {168, 118, 70}) {
        drawBall(surface, {kMiddle, y + 0.0}, y == 168 ? 11.0 : 7.5, 4.0,
                 {.ramp = iron, .tone = 2.9, .height = 4.0});
    }
    everyTexelIn(20, 172, 36, 194,
                 [&](int x, int y) { surface.at(x, y).tone -= x % 5 == 0 ? 0.9 : 0.0; });
    // The cross-bar for the lamplighter's ladder
    drawLimb(surface, {12.0, 78.0}, 1.8, {44.0, 78.0}, 1.8,
             {.ramp = iron, .tone = 2.6, .height = 6.0});
    drawBall(surface, {11.0, 78.0}, 2.8, 2.8, {.ramp = iron, .tone = 3.0, .height = 6.0});
    drawBall(surface, {45.0, 78.0}, 2.8, 2.8, {.ramp = iron, .tone = 3.0, .height = 6.0});
    // The lantern: wider above, four panes of lamplight, brightest around the flame
    drawOutline(surface, {{13.0, 22.0}, {43.0, 22.0}, {37.0, 60.0}, {19.0, 60.0}},
                {.ramp = &kBrassRamp, .tone = 3.0, .height = 3.0});
    everyTexelIn(12, 22, 44, 60, [&](int x, int y) {
        Texel& texel = surface.at(x, y);
        if (texel.alpha > 0 && texel.ramp == &kBrassRamp) {
            const double dx = (x + 0.5 - kMiddle) / 13.0;
            const double dy = (y + 0.5 - 44.0) / 20.0;
            texel.tone = 5.6 - 2.6 * (dx * dx + dy * dy);
            texel.height = 3.0;
        }
    });
    const Paint frame = {.ramp = iron, .tone = 2.2, .height = 5.0};
    drawLimb(surface, {13.0, 21.0}, 1.6, {19.5, 60.0}, 1.6, frame);
    drawLimb(surface, {43.0, 21.0}, 1.6, {36.5, 60.0}, 1.6, frame);
    drawLimb(surface, {kMiddle, 21.0}, 1.0, {kMiddle, 60.0}, 1.0, frame);
    drawBox(surface, 17, 59, 39, 64, {.ramp = iron, .tone = 2.6, .height = 4.0, .bulge = 0.3});
    drawOutline(surface, {{kMiddle, 5.0}, {20.0, 12.0}, {9.0, 23.0}, {47.0, 23.0}, {36.0, 12.0}},
                {.ramp = iron, .tone = 2.6, .height = 7.0});
    drawBox(surface, 9, 21, 47, 24, {.ramp = iron, .tone = 3.2, .height = 8.0, .bulge = 0.0});
    drawBall(surface, {kMiddle, 5.0}, 3.2, 3.6, {.ramp = &kBrassRamp, .tone = 3.2, .height = 7.0});
    return spriteOf(surface);
}

Picture paintStandingBarrel() {
    constexpr double kMiddle = 36.0;
    constexpr int kTop = 8;
    constexpr int kFoot = 84;
    Surface surface = Surface::empty(72, kFoot);
    // Half the width at a height: wider in the belly
    const auto halfAt = [](double y) {
        const double share = (y - 46.0) / 38.0;
        return 33.5 - 6.5 * share * share;
    };
    everyTexelIn(0, kTop, 72, kFoot, [&](int x, int y) {
        const double off = (x + 0.5 - kMiddle) / halfAt(y);
        if (std::abs(off) > 1.0) {
            return;
        }
        // The foot is round, too
        const double round = std::sqrt(std::max(0.0, 1.0 - off * off));
        if (y > kFoot - 6 + 6.0 * round) {
            return;
        }
        // Staves grow narrow towards the sides
        const double around = off * (0.85 + 0.15 * off * off) * 4.6 + 5.0;
        const int stave = static_cast<int>(around);
        const double within = around - stave;
        Texel& texel = surface.at(x, y);
        texel = {.height = 20.0 * round,
                 .tone = 3.0 + 0.7 * (randomAt(stave, 1, kStreetSeed) - 0.5) +
                         0.9 * woodGrain(y, stave * 16 + 8.0 * within, kStreetSeed + 1U),
                 .ramp = &kTimberRamp,
                 .alpha = 255};
        if (within < 0.09) {
            texel.tone -= 1.5;
        }
        // Hoops bend with the barrel
        const double level = y - 5.0 * round;
        for (const double hoop : {10.0, 24.0, 56.0, 70.0}) {
            if (level >= hoop && level < hoop + 6.0) {
                texel.ramp = &kSlateRamp;
                texel.tone = 2.7 - (level < hoop + 1.0 || level >= hoop + 5.0 ? 0.5 : 0.0);
                texel.height += 1.4;
            }
        }
    });
    // The lid lies a little below the rim
    drawBall(surface, {kMiddle, 9.0}, 27.5, 8.0,
             {.ramp = &kTimberRamp, .tone = 3.8, .height = 14.0, .bulge = 0.0});
    everyTexelIn(0, 0, 72, 20, [&](int x, int y) {
        const double dx = (x + 0.5 - kMiddle) / 24.5;
        const double dy = (y + 0.5 - 9.5) / 6.0;
        if (dx * dx + dy * dy < 1.0) {
            surface.at(x, y) = {.height = 11.0,
                                .tone = 3.1 + 0.8 * woodGrain(x, y * 3, kStreetSeed + 2U) -
                                        (x % 13 == 0 ? 1.2 : 0.0),
                                .ramp = &kTimberRamp,
                                .alpha = 255};
        }
    });
    drawBall(surface, {46.0, 10.0}, 2.2, 1.4, {.ramp = &kOakRamp, .tone = 1.2, .height = 12.0});
    return spriteOf(surface, {.gain = 0.4,
                              .lightest = 1.0,
                              .darkest = 1.6,
                              .shadowReach = 2,
                              .shadowSlope = 0.8,
                              .shadowDepth = 0.6});
}

Picture paintCrateStack() {
    Surface surface = Surface::empty(132, 128);
    drawCrate(surface, 66, 68, 60, kStreetSeed + 10U);
    drawCrate(surface, 2, 66, 62, kStreetSeed + 20U);
    drawCrate(surface, 34, 14, 52, kStreetSeed + 30U);
    return spriteOf(surface, {.gain = 0.4,
                              .lightest = 0.9,
                              .darkest = 1.4,
                              .shadowReach = 4,
                              .shadowSlope = 0.7,
                              .shadowDepth = 0.9});
}

Picture paintMarketStall() {
    constexpr int kWidth = 208;
    constexpr int kHeight = 176;
    constexpr int kCounter = 112;
    Surface surface = Surface::empty(kWidth, kHeight);
    // Posts behind and in front
    for (const int x : {26, 174}) {
        drawBox(surface, x, 40, x + 6, kHeight - 6, {.ramp = &kOakRamp, .tone = 1.9, .bulge = 0.6});
    }
    // Herbs and onions hang from a line under the roof
    drawLimb(surface, {14.0, 58.0}, 1.0, {194.0, 58.0}, 1.0, {.ramp = &kSandRamp, .tone = 2.0});
    Random random(kStreetSeed + 40U);
    for (int bunch = 0; bunch < 9; ++bunch) {
        const double x = 34.0 + 17.5 * bunch;
        if (bunch % 3 == 1) {
            for (int onion = 0; onion < 4; ++onion) {
                drawBall(surface, {x + (onion % 2 == 0 ? -2.5 : 2.5), 64.0 + 5.0 * onion}, 3.6, 3.6,
                         {.ramp = &kClayRamp, .tone = 3.8, .height = 2.0});
            }
        } else {
            for (int stem = 0; stem < 9; ++stem) {
                const double lean = random.between(-5.0, 5.0);
                const double length = random.between(12.0, 19.0);
                const double tone = random.between(2.0, 4.0);
                drawLimb(surface, {x, 60.0}, 1.2, {x + lean, 60.0 + length}, 1.8,
                         {.ramp = &kMossRamp, .tone = tone, .height = 2.0, .bulge = 0.6});
            }
        }
    }
    // Crates on the counter, tilted to the buyer, heaped with fruit
    struct Heap {
        int left;
        int right;
        const Ramp* ramp;
        double tone;
        double size;
    };
    constexpr std::array<Heap, 4> kHeaps = {{{18, 62, &kCrimsonRamp, 3.4, 4.6},
                                             {64, 104, &kMossRamp, 4.2, 6.4},
                                             {106, 146, &kBrassRamp, 3.6, 4.8},
                                             {148, 190, &kClayRamp, 3.8, 6.0}}};
    for (const Heap& heap : kHeaps) {
        drawBox(surface, heap.left, kCounter - 14, heap.right, kCounter,
                {.ramp = &kOakRamp, .tone = 1.4, .bulge = 0.0});
        for (int row = 0; row < 4; ++row) {
            const double step = 1.75 * heap.size;
            const int count =
                static_cast<int>((heap.right - heap.left - 2.0 * heap.size) / step) + 1 - row;
            for (int fruit = 0; fruit < count; ++fruit) {
                const double x =
                    0.5 * (heap.left + heap.right) + (fruit - 0.5 * (count - 1)) * step;
                const double y =
                    kCounter - 12.0 - row * heap.size * 1.25 + random.between(-0.8, 0.8);
                const double aside = random.between(-0.6, 0.6);
                const double own = random.between(-0.5, 0.3);
                drawBall(surface, {x + aside, y}, heap.size, 0.95 * heap.size,
                         {.ramp = heap.ramp,
                          .tone = heap.tone + own,
                          .height = 2.0 + row,
                          .bulge = 0.8});
            }
        }
        drawBox(surface, heap.left, kCounter - 11, heap.right, kCounter,
                {.ramp = &kTimberRamp, .tone = 3.4, .height = 6.0, .bulge = 0.0});
        everyTexelIn(heap.left, kCounter - 7, heap.right, kCounter - 5,
                     [&](int x, int y) { surface.at(x, y).tone = 1.2; });
    }
    // The counter, and the boards of its front
    drawBox(surface, 8, kCounter, kWidth - 8, kCounter + 7,
            {.ramp = &kTimberRamp, .tone = 4.2, .height = 7.0, .bulge = 0.0});
    everyTexelIn(14, kCounter + 7, kWidth - 14, kHeight - 4, [&](int x, int y) {
        const int board = (x - 14) / 15;
        const int inside = std::min((x - 14) % 15, 14 - (x - 14) % 15);
        surface.at(x, y) = {.height = 2.0 + std::min(1.0, 0.7 * inside),
                            .tone = 2.6 + 0.7 * (randomAt(board, 1, kStreetSeed + 41U) - 0.5) -
                                    (inside == 0 ? 1.3 : 0.0),
                            .ramp = &kTimberRamp,
                            .alpha = 255};
    });
    drawBox(surface, 14, 160, kWidth - 14, 168,
            {.ramp = &kTimberRamp, .tone = 3.2, .height = 4.0, .bulge = 0.0});
    addGrain(surface, &kTimberRamp, 0.9, kStreetSeed + 42U);
    // A cloth hangs over the middle of the front
    drawOutline(surface,
                {{70.0, kCounter + 2.0},
                 {138.0, kCounter + 2.0},
                 {138.0, 146.0},
                 {104.0, 157.0},
                 {70.0, 146.0}},
                {.ramp = &kSeaRamp, .tone = 1.9, .height = 8.5});
    everyTexelIn(70, kCounter + 2, 138, 158, [&](int x, int y) {
        Texel& texel = surface.at(x, y);
        if (texel.ramp == &kSeaRamp) {
            const double hem = 146.0 + 11.0 * (1.0 - std::abs(x + 0.5 - 104.0) / 34.0);
            texel.height += 0.8 * wave((x - 70) / 17.0);
            if (y > hem - 6.0 && y < hem - 2.0) {
                texel.ramp = &kBrassRamp;
                texel.tone = 3.4;
            }
        }
    });
    drawBall(surface, {104.0, 132.0}, 8.0, 8.0,
             {.ramp = &kBrassRamp, .tone = 3.5, .height = 9.0, .bulge = 0.1});
    drawBall(surface, {107.0, 130.0}, 6.5, 6.5,
             {.ramp = &kSeaRamp, .tone = 1.9, .height = 9.0, .bulge = 0.0});
    for (const int x : {8, 190}) {
        drawBox(surface, x, 30, x + 10, kHeight,
                {.ramp = &kOakRamp, .tone = 2.9, .height = 9.0, .bulge = 0.7});
    }
    addGrain(surface, &kOakRamp, 0.8, kStreetSeed + 43U);
    // The awning: it slopes towards the viewer, striped, with a scalloped hem
    constexpr int kStripes = 12;
    everyTexelIn(0, 4, kWidth, 56, [&](int x, int y) {
        const double share = std::min(1.0, (y - 4) / 36.0);
        const double half = 86.0 + 17.0 * share;
        const double along = (x + 0.5 - kWidth / 2.0) / half;
        if (std::abs(along) > 1.0) {
            return;
        }
        const double stripes = (along + 1.0) * 0.5 * kStripes;
        const int stripe = std::min(kStripes - 1, static_cast<int>(stripes));
        const double off = 2.0 * (stripes - stripe) - 1.0;
        if (y >= 40 && y > 45.0 + 9.0 * std::sqrt(std::max(0.0, 1.0 - off * off))) {
            return;
        }
        const bool red = stripe % 2 == 0;
        const double fold = y < 40 ? 0.5 - 0.02 * (y - 4) : -0.5;
        surface.at(x, y) = {.height = 14.0 + 0.2 * share - 0.5 * off * off,
                            .tone = (red ? 3.2 : 5.9) + fold - (y == 40 ? 0.7 : 0.0),
                            .ramp = red ? &kCrimsonRamp : &kStoneRamp,
                            .alpha = 255};
    });
    drawLimb(surface, {19.0, 4.0}, 2.4, {189.0, 4.0}, 2.4,
             {.ramp = &kOakRamp, .tone = 3.4, .height = 16.0});
    return spriteOf(surface, {.gain = 0.4,
                              .lightest = 0.9,
                              .darkest = 1.4,
                              .shadowReach = 7,
                              .shadowSlope = 0.8,
                              .shadowDepth = 0.9});
}

}  // namespace slicecast::textures
