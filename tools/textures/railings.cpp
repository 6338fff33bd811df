#include "railings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cutout.h"
#include "marks.h"
#include "noise.h"
#include "surface.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kRailingsSeed = 2400;

constexpr Lighting kRailingLight = {.gain = 0.7,
                                    .lightest = 1.5,
                                    .darkest = 1.5,
                                    .shadowReach = 3,
                                    .shadowSlope = 0.6,
                                    .shadowDepth = 0.9};
constexpr Lighting kRopeLight = {.gain = 0.5,
                                 .lightest = 1.0,
                                 .darkest = 1.4,
                                 .shadowReach = 3,
                                 .shadowSlope = 0.6,
                                 .shadowDepth = 0.8};

double rust(int x, int y) {
    return fractalNoise(x / 8.0, y / 8.0, 16, 16, 3, kRailingsSeed + 1U);
}

// Iron as it is painted everywhere here: dark, cool, with rust where water stays.
Texel iron(int x, int y, double height, double tone) {
    const double spot = rust(x, y);
    if (spot > 0.66) {
        return {.height = height, .tone = tone + 0.2, .ramp = &kRustRamp};
    }
    return {.height = height, .tone = tone + 0.9 * (spot - 0.5), .ramp = &kSlateRamp};
}

// Height of a round bar at a distance from its middle; negative outside it.
double roundBar(double off, double radius) {
    const double rest = radius * radius - off * off;
    return rest < 0.0 ? -1.0 : std::sqrt(rest);
}

}  // namespace

Picture paintIronBars() {
    constexpr int kSpacing = 32;
    constexpr double kRadius = 4.0;
    Surface surface = Surface::empty();
    everyTexel([&](int x, int y) {
        const double off = x % kSpacing + 0.5 - kSpacing / 2.0;
        const double bar = roundBar(off, kRadius);
        if (bar >= 0.0) {
            surface.at(x, y) = iron(x, y, bar, 2.7);
        }
    });
    // Flat straps hold the bars; each crossing swells and is riveted
    for (const int top : {26, 90}) {
        everyTexelIn(0, top, kSide, top + 9, [&](int x, int y) {
            const double off = std::abs(x % kSpacing + 0.5 - kSpacing / 2.0);
            const int inside = std::min(y - top, top + 8 - y);
            surface.at(x, y) =
                iron(x, y, std::min(1.0, 0.6 + inside) * 2.5 + (off < 6.0 ? 2.4 : 0.0),
                     off < 6.0 ? 3.0 : 2.5);
        });
        for (int x = kSpacing / 2; x < kSide; x += kSpacing) {
            drawStud(surface, {.x = x + 0.0,
                               .y = top + 4.5,
                               .radius = 2.2,
                               .height = 2.0,
                               .tone = 3.6,
                               .ramp = &kSlateRamp});
        }
    }
    return holesFilled(lit(surface, kRailingLight), Border::Repeats);
}

Picture paintGrate() {
    constexpr int kSpacing = 16;
    Surface surface = Surface::empty();
    everyTexel([&](int x, int y) {
        const int offX = x % kSpacing - kSpacing / 2;
        const int offY = y % kSpacing - kSpacing / 2;
        const int across = std::min(offX + 2, 2 - offX);  // flat bars, five texels wide
        const int along = std::min(offY + 1, 1 - offY);   // rods through them, three texels wide
        if (across >= 0) {
            surface.at(x, y) = iron(x, y, 2.0 + std::min(1, across), across == 0 ? 2.3 : 3.2);
            if (along >= 0 && across > 0) {
                surface.at(x, y).tone += along == 1 ? 0.8 : 0.3;
            }
        } else if (along >= 0) {
            surface.at(x, y) = iron(x, y, 0.6 + 0.5 * along, 2.2);
        }
    });
    return holesFilled(lit(surface, kRailingLight), Border::Repeats);
}

// A picket fence as high as half a block: it stands in the lower half, so that a block of half
// height shows it whole.
Picture paintFence() {
    constexpr int kSpacing = 16;
    constexpr int kWidth = 12;
    Surface surface = Surface::empty();
    for (const int top : {82, 108}) {
        everyTexelIn(0, top, kSide, top + 8, [&](int x, int y) {
            const int inside = std::min(y - top, top + 7 - y);
            surface.at(x, y) = {.height = std::min(1.5, 0.8 + 0.7 * inside),
                                .tone = 2.3 + 0.8 * woodGrain(x, y,
                                                              kRailingsSeed + 10U +
                                                                  static_cast<std::uint32_t>(top)),
                                .ramp = &kTimberRamp};
        });
    }
    for (int picket = 0; picket < kSide / kSpacing; ++picket) {
        const int left = picket * kSpacing + 2;
        const auto seed = kRailingsSeed + 20U + 10U * static_cast<std::uint32_t>(picket);
        const int tip = 66 + static_cast<int>(3.0 * randomAt(picket, 1, kRailingsSeed + 11U));
        const double own = 0.7 * (randomAt(picket, 2, kRailingsSeed + 11U) - 0.5);
        everyTexelIn(left, tip, left + kWidth, kSide, [&](int x, int y) {
            const double off = std::abs(x + 0.5 - left - kWidth / 2.0);
            if (y - tip < off * 1.1 - 0.6) {
                return;
            }
            const double inside = kWidth / 2.0 - off;
            // Splashed and mossy at the foot
            const double damp = smoothStep(
                108.0, 128.0, y + 10.0 * (randomAt(x, y / 3, kRailingsSeed + 12U) - 0.5));
            surface.at(x, y) = {.height = 3.0 + std::min(1.6, 0.8 * inside),
                                .tone = 4.1 + own + 1.0 * woodGrain(y, x, seed) - 1.0 * damp,
                                .ramp = &kTimberRamp};
            if (damp > 0.75 && randomAt(x, y, kRailingsSeed + 13U) < 0.5) {
                surface.at(x, y).ramp = &kMossRamp;
                surface.at(x, y).tone = 2.6;
            }
        });
        for (const int y : {85, 111}) {
            for (const int x : {left + 4, left + 8}) {
                surface.at(x, y).tone = 0.2;
                surface.at(x, y + 1).tone -= 1.0;
            }
        }
    }
    return holesFilled(lit(surface, {.gain = 0.45,
                                     .lightest = 0.9,
                                     .darkest = 1.4,
                                     .shadowReach = 4,
                                     .shadowSlope = 0.7,
                                     .shadowDepth = 1.1}),
                       Border::Repeats);
}

// Knotted rope in diamonds.
Picture paintNet() {
    constexpr int kMesh = 32;
    constexpr double kRadius = 2.6;
    Surface surface = Surface::empty();
    everyTexel([&](int x, int y) {
        // Ropes run both ways along the diagonals, sagging a little between the knots
        const double sag = 1.2 * wave((x + y) / 32.0) + 0.8 * wave((x - y) / 64.0);
        for (const bool rising : {false, true}) {
            const int line = rising ? x + y : x - y;
            const double off =
                (wrap(line, kMesh) + 0.5 - kMesh / 2.0 + (rising ? sag : -sag)) * 0.7071;
            const double rope = roundBar(off, kRadius);
            if (rope < 0.0) {
                continue;
            }
            const int along = rising ? x - y : x + y;
            const int twist = wrap(along + static_cast<int>(std::floor(off * 2.0)), 8);
            const double lift = rising ? 1.5 : 0.0;
            surface.at(x, y) = {.height = lift + rope,
                                .tone = twist < 3 ? 1.9
                                                  : 3.2 + 0.5 * (randomAt(along / 16, line / kMesh,
                                                                          kRailingsSeed + 31U) -
                                                                 0.5),
                                .ramp = &kSandRamp};
        }
    });
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 4; ++column) {
            const double x = column * kMesh + (row % 2 == 0 ? 16.0 : 0.0);
            drawStud(surface, {.x = x,
                               .y = row * 16.0,
                               .radius = 5.4,
                               .height = 4.0,
                               .tone = 1.9,
                               .ramp = &kSandRamp});
            for (int turn = -3; turn <= 3; ++turn) {
                surface.at(static_cast<int>(x) + turn, row * 16 - turn / 2).tone = 1.4;
            }
        }
    }
    return holesFilled(lit(surface, kRopeLight), Border::Repeats);
}

// Two ropes sagging between posts; the posts stand on the borders of the tile, half of each in this
// one. Half a block high.
Picture paintRopeRailing() {
    Surface surface = Surface::empty();
    for (const int hung : {72, 98}) {
        for (int x = 0; x < kSide; ++x) {
            const double share = (x + 0.5) / kSide;
            const double middle = hung + 40.0 * share * (1.0 - share);
            const int top = static_cast<int>(std::floor(middle)) - 3;
            for (int y = top; y < top + 7; ++y) {
                const double rope = roundBar(y + 0.5 - middle, 3.0);
                if (rope >= 0.0) {
                    const int twist = wrap(x + 2 * (y - top), 8);
                    surface.at(x, y) = {
                        .height = rope, .tone = twist < 3 ? 2.0 : 3.5, .ramp = &kSandRamp};
                }
            }
        }
    }
    constexpr int kHalf = 7;
    everyTexelIn(-kHalf, 64, kHalf, kSide, [&](int x, int y) {
        const double off = x + 0.5;
        const int fromTop = y - 64;
        if (fromTop < 3 && std::abs(off) > 4.0 + fromTop) {
            return;
        }
        surface.at(x, y) = {.height = 3.0 + 0.7 * roundBar(off, kHalf),
                            .tone = 3.0 + 0.9 * woodGrain(y, x + 64, kRailingsSeed + 40U) -
                                    (fromTop < 2 ? -0.8 : 0.0),
                            .ramp = &kOakRamp};
    });
    // Where the ropes are wound around the post
    for (const int top : {69, 95}) {
        everyTexelIn(-kHalf - 1, top, kHalf + 1, top + 9, [&](int x, int y) {
            const int turn = (y - top) % 3;
            surface.at(x, y) = {.height = 4.5 +
                                          0.7 * std::max(0.0, roundBar(x + 0.5, kHalf + 1.0)) -
                                          (turn == 2 ? 1.0 : 0.0),
                                .tone = turn == 2 ? 1.5 : 3.3,
                                .ramp = &kSandRamp};
        });
    }
    return holesFilled(lit(surface, kRopeLight), Border::Repeats);
}

}  // namespace slicecast::textures
