#include "glow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cutout.h"
#include "loops.h"
#include "marks.h"
#include "noise.h"
#include "shapes.h"
#include "surface.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kGlowSeed = 3200;

struct Stroke {
    int fromX;
    int fromY;
    int toX;
    int toY;
};

// Nine signs on a grid of 4 x 6, as strokes.
const std::array<std::vector<Stroke>, 9> kRunes = {{
    {{1, 0, 1, 6}, {1, 0, 4, 2}, {1, 2, 4, 4}},
    {{0, 6, 0, 0}, {0, 0, 4, 3}, {4, 3, 4, 6}},
    {{2, 0, 2, 6}, {0, 1, 2, 3}, {4, 1, 2, 3}},
    {{0, 0, 4, 6}, {4, 0, 0, 6}, {0, 0, 4, 0}},
    {{2, 0, 0, 3}, {0, 3, 2, 6}, {2, 6, 4, 3}, {4, 3, 2, 0}, {2, 2, 2, 4}},
    {{1, 0, 1, 6}, {3, 0, 3, 6}, {1, 2, 3, 4}},
    {{2, 0, 2, 6}, {2, 0, 4, 2}, {2, 6, 0, 4}},
    {{0, 0, 4, 0}, {2, 0, 2, 6}, {0, 6, 4, 6}},
    {{0, 2, 2, 0}, {2, 0, 4, 2}, {2, 0, 2, 6}, {0, 6, 2, 4}, {4, 6, 2, 4}},
}};

double distanceTo(const Stroke& stroke, double left, double top, double scale, double x, double y) {
    const double fromX = left + scale * stroke.fromX;
    const double fromY = top + scale * stroke.fromY;
    const double lengthX = scale * (stroke.toX - stroke.fromX);
    const double lengthY = scale * (stroke.toY - stroke.fromY);
    const double along = std::clamp(
        ((x - fromX) * lengthX + (y - fromY) * lengthY) / (lengthX * lengthX + lengthY * lengthY),
        0.0, 1.0);
    const double dx = x - fromX - along * lengthX;
    const double dy = y - fromY - along * lengthY;
    return std::sqrt(dx * dx + dy * dy);
}

// How strongly a rune glows: the light goes around the outer eight, the inner one breathes.
double glowOf(std::size_t rune, double time) {
    static constexpr std::array<double, 9> kTurn = {0.0,   0.125, 0.25,  0.875, 0.0,
                                                    0.375, 0.75,  0.625, 0.5};
    if (rune == 4) {
        return 0.75 + 0.25 * wave(time);
    }
    const double phase = time - kTurn[rune];
    const double since = phase - std::floor(phase);
    return 0.3 + 0.7 * (since < 0.125 ? 1.0 : std::max(0.0, 1.0 - (since - 0.125) * 2.2));
}

}  // namespace

// A slab of slate in a brass rim; the runes cut into it light up one after another.
Picture paintRunePanel() {
    constexpr double kScale = 4.6;
    std::vector<Picture> frames;
    for (int frame = 0; frame < kLoopFrames; ++frame) {
        const double time = static_cast<double>(frame) / kLoopFrames;
        Surface surface;
        everyTexel([&](int x, int y) {
            const int inside = std::min({x, kSide - 1 - x, y, kSide - 1 - y});
            const double cloud = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kGlowSeed + 1U) - 0.5;
            Texel& texel = surface.at(x, y);
            if (inside < 8) {
                texel = {
                    .height = inside == 0 ? 0.0 : std::min({2.5, 0.9 * inside, 0.9 * (8 - inside)}),
                    .tone = 2.6 + 0.5 * cloud,
                    .ramp = &kBrassRamp};
                return;
            }
            texel = {.height = 0.6 * fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kGlowSeed + 2U),
                     .tone = 1.7 + 1.3 * cloud,
                     .ramp = &kSlateRamp};
            for (std::size_t rune = 0; rune < kRunes.size(); ++rune) {
                const double left = 19.0 + 36.0 * static_cast<double>(rune % 3);
                const double top = 14.0 + 36.0 * static_cast<double>(rune / 3);
                double away = 99.0;
                for (const Stroke& stroke : kRunes[rune]) {
                    away = std::min(away, distanceTo(stroke, left, top, kScale, x + 0.5, y + 0.5));
                }
                if (away > 9.0) {
                    continue;
                }
                const double glow = glowOf(rune, time);
                if (away < 1.7) {
                    texel = {
                        .height = -1.0, .tone = 2.0 + 4.0 * glow - 0.5 * away, .ramp = &kSeaRamp};
                } else if (away < 2.7) {
                    texel = {.height = -0.5, .tone = 0.6 + 1.9 * glow, .ramp = &kSeaRamp};
                } else if (glow > 0.45) {
                    // The stone around it is lit
                    const double light = glow * (1.0 - (away - 2.7) / 6.3);
                    if (light > 0.25) {
                        texel.ramp = &kSeaRamp;
                        texel.tone = 0.5 + 1.8 * light + 0.6 * cloud;
                    }
                }
            }
        });
        for (const int y : {4, kSide - 4}) {
            for (const int x : {4, kSide - 4}) {
                drawStud(surface, {.x = x + 0.0,
                                   .y = y + 0.0,
                                   .radius = 2.6,
                                   .height = 2.0,
                                   .tone = 3.4,
                                   .ramp = &kBrassRamp});
            }
        }
        frames.push_back(lit(surface, {.gain = 0.5,
                                       .lightest = 0.9,
                                       .darkest = 1.2,
                                       .shadowReach = 2,
                                       .shadowSlope = 0.6,
                                       .shadowDepth = 0.5}));
    }
    return inARow(frames);
}

// An iron bowl on three feet, with a fire that flickers upwards.
Picture paintBrazier() {
    constexpr double kMiddle = 64.0;
    constexpr double kBowl = 78.0;  // the rim's row
    std::vector<Picture> frames;
    for (int frame = 0; frame < kLoopFrames; ++frame) {
        const double time = static_cast<double>(frame) / kLoopFrames;
        Surface surface = Surface::empty();
        // Legs from the back to the front, with a ring that ties them
        drawLimb(surface, {64.0, 92.0}, 2.4, {64.0, 122.0}, 2.2,
                 {.ramp = &kSlateRamp, .tone = 1.8});
        drawLimb(surface, {54.0, 92.0}, 2.8, {38.0, 125.0}, 2.4,
                 {.ramp = &kSlateRamp, .tone = 2.6});
        drawLimb(surface, {74.0, 92.0}, 2.8, {90.0, 125.0}, 2.4,
                 {.ramp = &kSlateRamp, .tone = 2.6});
        drawLimb(surface, {46.0, 110.0}, 1.8, {82.0, 110.0}, 1.8,
                 {.ramp = &kSlateRamp, .tone = 2.3, .height = 1.0});
        for (const double x : {37.0, 91.0}) {
            drawBall(surface, {x, 125.0}, 4.5, 3.2, {.ramp = &kSlateRamp, .tone = 2.6});
        }
        // The flame: tongues narrow upwards and lick from side to side; hottest low in the middle
        everyTexelIn(16, 0, 112, static_cast<int>(kBowl) + 2, [&](int x, int y) {
            const double up = (kBowl + 2.0 - y) / 78.0;
            const double rise = y + time * kSide;
            const double lick =
                (valueNoise(x / 64.0, rise / 32.0, 2, 4, kGlowSeed + 10U) - 0.5) * 26.0 * up;
            const double off = std::abs(x + 0.5 - kMiddle + lick) / 30.0;
            const double tongue = fractalNoise((x + lick) / 8.0, (y + 2.0 * time * kSide) / 32.0,
                                               16, 4, 2, kGlowSeed + 11U);
            const double body = 1.0 - off * off * (0.85 + 3.2 * up) - 1.2 * up;
            const double fire = body + 1.5 * (tongue - 0.5) * (0.15 + 2.6 * up * (1.0 - up));
            if (fire > 0.06) {
                const double heat = std::min(1.0, fire * 1.15);
                surface.at(x, y) = {.height = 0.0,
                                    .tone = std::floor((3.6 + 3.4 * heat) * 2.0 + 0.5) / 2.0,
                                    .ramp = &kFireRamp};
            }
        });
        // Sparks rise once in a loop
        for (int spark = 0; spark < 7; ++spark) {
            const double begun = time + randomAt(spark, 1, kGlowSeed + 12U);
            const double age = begun - std::floor(begun);
            const double x = kMiddle + 34.0 * (randomAt(spark, 2, kGlowSeed + 12U) - 0.5) +
                             7.0 * wave(age + randomAt(spark, 3, kGlowSeed + 12U));
            const double y = 40.0 - 38.0 * age;
            if (age < 0.85) {
                drawBall(surface, {x, y}, 1.3, 1.3,
                         {.ramp = &kFireRamp, .tone = 6.0 - 1.5 * age, .bulge = 0.0});
            }
        }
        // Coals, then the bowl in front of them
        for (int coal = 0; coal < 9; ++coal) {
            const double x = 42.0 + 5.5 * coal;
            const double glow = loopNoise(coal + 0.5, 0.5, 16, 1, time, 4, kGlowSeed + 13U);
            drawBall(surface, {x, 79.0 - 2.0 * randomAt(coal, 4, kGlowSeed + 13U)}, 4.6, 3.6,
                     {.ramp = &kFireRamp, .tone = 2.6 + 3.0 * glow, .bulge = 0.4});
        }
        everyTexelIn(30, 79, 98, 100, [&](int x, int y) {
            const double down = (y + 0.5 - 79.0) / 19.0;
            const double half = 31.0 * std::sqrt(std::max(0.0, 1.0 - down * down));
            const double off = x + 0.5 - kMiddle;
            if (std::abs(off) <= half) {
                const double rest = half * half - off * off;
                surface.at(x, y) = {.height = 3.0 + 0.5 * std::sqrt(rest) * (1.0 - 0.6 * down),
                                    .tone = 2.5,
                                    .ramp = &kSlateRamp};
                // Slots through which the coals are seen
                const double slot = std::abs(wrap(static_cast<int>(off + 68.5), 11) - 5.0);
                if (y > 86 && y < 93 && slot < 2.0 && std::abs(off) < 24.0) {
                    surface.at(x, y) = {.height = 6.0,
                                        .tone = 4.6 + 1.4 * loopNoise(x / 11.0, 0.5, 16, 1, time, 4,
                                                                      kGlowSeed + 13U),
                                        .ramp = &kFireRamp};
                }
            }
        });
        drawLimb(surface, {33.0, 80.0}, 2.6, {95.0, 80.0}, 2.6,
                 {.ramp = &kSlateRamp, .tone = 3.0, .height = 8.0});
        for (int rivet = 0; rivet < 6; ++rivet) {
            drawStud(surface, {.x = 39.0 + 10.0 * rivet,
                               .y = 80.0,
                               .radius = 1.4,
                               .height = 1.4,
                               .tone = 4.0,
                               .ramp = &kSlateRamp});
        }
        frames.push_back(holesFilled(edgesSoftened(lit(surface, {.gain = 0.4,
                                                                 .lightest = 1.0,
                                                                 .darkest = 1.4,
                                                                 .shadowReach = 0,
                                                                 .hollowDepth = 0.0})),
                                     Border::Ends));
    }
    return inARow(frames);
}

}  // namespace slicecast::textures
