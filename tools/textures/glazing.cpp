#include "glazing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cutout.h"
#include "marks.h"
#include "noise.h"
#include "shapes.h"
#include "stonework.h"
#include "surface.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kGlazingSeed = 2600;

constexpr Lighting kLeadLight = {.gain = 0.5, .lightest = 1.0, .darkest = 1.2, .shadowReach = 0};

// Clear glass: a breath of green, and the sky's reflection slanting across each pane.
Texel clearGlass(int localX, int localY, double own) {
    const int slant = wrap(localX + localY + static_cast<int>(20.0 * own), 64);
    const bool broad = slant > 34 && slant < 45;
    const bool narrow = slant > 48 && slant < 52;
    const double tone = broad || narrow ? 5.2 : 3.6 + 0.4 * own;
    const int alpha = broad ? 120 : (narrow ? 96 : 56);
    return {
        .height = -1.0, .tone = tone, .ramp = &kSeaRamp, .alpha = static_cast<std::uint8_t>(alpha)};
}

// What a stained window shows, as numbers of its pieces of glass.
enum Glass {
    kNoGlass = 0,
    kSun = 1,
    kRay = 2,
    kRing = 20,
    kBorder = 60,
    kField = 200,
    kStem = 600,
    kLeafGlass = 610,
    kBlossom = 620
};

constexpr double kPaneMiddle = 64.0;

// Distance inwards from the pointed arch of the opening; negative in the stone.
double insidePointedArch(double x, double y) {
    constexpr double kHalf = 45.0;
    constexpr double kSpring = 62.0;
    constexpr double kSill = 118.0;
    const double off = std::abs(x - kPaneMiddle);
    double inside = std::min(kHalf - off, kSill - y);
    if (y < kSpring) {
        // Each side is an arc around a point beyond the middle
        constexpr double kBeyond = 22.0;
        const double dx = off + kBeyond;
        const double dy = y - kSpring;
        inside = std::min(inside, kHalf + kBeyond - std::sqrt(dx * dx + dy * dy));
    }
    return inside;
}

int octantOf(double dx, double dy) {
    // Sixteen directions, told apart without angles
    const double ax = std::abs(dx);
    const double ay = std::abs(dy);
    const double low = std::min(ax, ay) / std::max({ax, ay, 1.0e-9});
    const int part = low < 0.1989 ? 0 : (low < 0.6682 ? 1 : 2);
    const int quarter = ax >= ay ? part : 4 - part;
    const int side = dx >= 0.0 ? (dy >= 0.0 ? 0 : 3) : (dy >= 0.0 ? 1 : 2);
    const std::array<int, 4> turned = {quarter, 8 - quarter, 8 + quarter, 16 - quarter};
    return turned[static_cast<std::size_t>(side)] % 16;
}

int glassAt(int texelX, int texelY) {
    const double x = texelX + 0.5;
    const double y = texelY + 0.5;
    const double inside = insidePointedArch(x, y);
    if (inside < 0.0) {
        return kNoGlass;
    }
    if (inside < 7.0) {
        // A border of short pieces along the stone
        return kBorder + static_cast<int>(y) / 14 + (x < kPaneMiddle ? 40 : 0);
    }
    const double dx = x - kPaneMiddle;
    const double dy = y - 52.0;
    const double distance = std::sqrt(dx * dx + dy * dy);
    if (distance < 8.5) {
        return kSun;
    }
    if (distance < 22.0) {
        return kRay + octantOf(dx, dy);
    }
    if (distance < 28.0) {
        return kRing + octantOf(dx * 0.9239 - dy * 0.3827, dx * 0.3827 + dy * 0.9239);
    }
    // A lily below: stem, leaves, and the field of diamonds behind
    if (std::abs(dx) < 3.0 && y > 88.0) {
        return kStem;
    }
    for (const double side : {-1.0, 1.0}) {
        const double leafX = side * dx - 12.0;
        const double leafY = y - 101.0 + 0.45 * leafX;
        if (leafX * leafX / 110.0 + leafY * leafY / 26.0 < 1.0) {
            return kLeafGlass + (side > 0.0 ? 1 : 0);
        }
    }
    const int rising = static_cast<int>(std::floor((x + y * 0.75) / 16.0));
    const int falling = static_cast<int>(std::floor((x - y * 0.75 + 256.0) / 16.0));
    return kField + rising + 20 * falling;
}

Texel stainedTexel(int piece, double cloud) {
    const double own = randomAt(piece, 1, kGlazingSeed + 10U) - 0.5;
    const Ramp* ramp = &kSeaRamp;
    double tone = 3.3;
    int alpha = 190;
    if (piece == kSun) {
        ramp = &kBrassRamp;
        tone = 4.5;
    } else if (piece < kRing) {
        ramp = piece % 2 == 0 ? &kBrassRamp : &kCrimsonRamp;
        tone = piece % 2 == 0 ? 3.5 : 3.2;
    } else if (piece < kBorder) {
        tone = piece % 2 == 0 ? 1.7 : 2.6;
        alpha = 205;
    } else if (piece < kField) {
        ramp = piece % 2 == 0 ? &kCrimsonRamp : &kSeaRamp;
        tone = piece % 2 == 0 ? 2.8 : 1.9;
        alpha = 205;
    } else if (piece == kStem || piece == kLeafGlass || piece == kLeafGlass + 1) {
        ramp = &kMossRamp;
        tone = 4.3;
    } else {
        // The field is pale, so that the view behind shimmers through
        tone = 4.6;
        ramp = piece % 3 == 0 ? &kBrassRamp : &kSeaRamp;
        alpha = 130;
    }
    return {.height = -2.0,
            .tone = tone + 0.8 * own + 0.9 * cloud,
            .ramp = ramp,
            .alpha = static_cast<std::uint8_t>(alpha + static_cast<int>(24.0 * own))};
}

}  // namespace

// Clear panes in thin leads. The outer lead is half as wide, for a neighbour brings the other half.
Picture paintGlassPane() {
    Surface surface;
    everyTexel([&](int x, int y) {
        const int localX = (x + 2) % 64;
        const int localY = (y + 2) % 64;
        const int lead = std::min(std::min(localX, localY), 4);
        if (lead < 4) {
            const int across = std::min(localX, localY) == localX ? localX : localY;
            surface.at(x, y) = {.height = across == 1 || across == 2 ? 1.5 : 0.6,
                                .tone = across == 1 || across == 2 ? 3.2 : 2.0,
                                .ramp = &kSlateRamp};
            return;
        }
        const int pane = (x + 2) / 64 % 2 + 2 * ((y + 2) / 64 % 2);
        surface.at(x, y) = clearGlass(localX, localY, randomAt(pane, 3, kGlazingSeed));
        // Thicker, greener glass towards the leads
        if (localX == 4 || localY == 4 || localX == 63 || localY == 63) {
            surface.at(x, y).alpha = 120;
            surface.at(x, y).tone = 2.6;
        }
    });
    for (const int y : {0, 64}) {
        for (const int x : {0, 64}) {
            drawStud(surface, {.x = x + 0.0,
                               .y = y + 0.0,
                               .radius = 3.4,
                               .height = 1.5,
                               .tone = 3.2,
                               .ramp = &kSlateRamp});
        }
    }
    return lit(surface, kLeadLight);
}

Picture paintStainedGlass() {
    const Surface wall = ashlarSurface();
    Surface surface = wall;
    everyTexel([&](int x, int y) {
        const double inside = insidePointedArch(x + 0.5, y + 0.5);
        if (inside < -9.0) {
            return;
        }
        if (inside < 0.0) {
            // The frame of dressed stone, with a groove
            const double round = std::min({-inside, inside + 9.0, 3.0});
            surface.at(x, y) = {.height = 1.0 + round,
                                .tone = -inside > 3.5 && -inside < 5.0 ? 3.2 : 4.5,
                                .ramp = &kStoneRamp};
            return;
        }
        const int piece = glassAt(x, y);
        bool lead = inside < 1.5;
        for (int near = 1; near < 4; ++near) {
            lead = lead || glassAt(x + near % 2, y + near / 2) != piece;
        }
        const double cloud = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kGlazingSeed + 11U) - 0.5;
        surface.at(x, y) = lead ? Texel{.height = -2.0, .tone = 0.8, .ramp = &kSlateRamp}
                                : stainedTexel(piece, cloud);
    });
    return litOver(wall, ashlarLighting(), surface,
                   {.gain = 0.5,
                    .lightest = 0.8,
                    .darkest = 1.2,
                    .shadowReach = 4,
                    .shadowSlope = 0.8,
                    .shadowDepth = 0.6});
}

// A shop's front: an awning, a large window with goods on the sill, panelling below.
Picture paintShopWindow() {
    constexpr int kSill = 92;
    Surface surface;
    everyTexel([&](int x, int y) {
        surface.at(x, y) = {.height = 0.0,
                            .tone = 2.4 + 0.8 * woodGrain(y, x, kGlazingSeed + 30U),
                            .ramp = &kOakRamp};
    });
    // Glass from post to post, parted by thin bars
    everyTexelIn(10, 20, 118, kSill, [&](int x, int y) {
        const int localX = (x - 10) % 36;
        const int localY = (y - 20) % 36;
        if (localX == 35 || localX == 34 || localY == 35 || localY == 34) {
            surface.at(x, y) = {
                .height = 0.5, .tone = localX == 34 || localY == 34 ? 3.2 : 2.0, .ramp = &kOakRamp};
        } else {
            surface.at(x, y) = clearGlass(
                localX, localY, randomAt((x - 10) / 36, (y - 20) / 36, kGlazingSeed + 31U));
            surface.at(x, y).height = -3.0;
        }
    });
    // Goods behind the glass: loaves in a basket, a jug, apples, a cheese
    drawBall(surface, {24.0, 85.0}, 8.0, 4.5,
             {.ramp = &kSandRamp, .tone = 2.2, .height = -3.0, .bulge = 0.6});
    drawBall(surface, {35.0, 85.0}, 8.0, 4.5,
             {.ramp = &kSandRamp, .tone = 1.8, .height = -3.0, .bulge = 0.6});
    drawBall(surface, {29.0, 79.5}, 8.5, 4.5,
             {.ramp = &kSandRamp, .tone = 2.5, .height = -2.0, .bulge = 0.6});
    for (const int x : {24, 29, 34}) {
        surface.at(x, 78).tone = 0.8;
        surface.at(x - 1, 79).tone = 0.8;
    }
    drawBall(surface, {63.0, 81.0}, 8.0, 9.0,
             {.ramp = &kSeaRamp, .tone = 2.4, .height = -3.0, .bulge = 0.7});
    drawBox(surface, 60, 66, 67, 75,
            {.ramp = &kSeaRamp, .tone = 2.4, .height = -3.0, .bulge = 0.7});
    drawBox(surface, 58, 64, 69, 67,
            {.ramp = &kSeaRamp, .tone = 3.4, .height = -2.5, .bulge = 0.4});
    everyTexelIn(56, 79, 71, 82,
                 [&](int x, int y) { surface.at(x, y).tone = y == 80 ? 4.8 : 3.6; });
    int number = 0;
    for (const Place apple : {Place{86.0, 86.0}, Place{94.0, 86.0}, Place{102.0, 86.0},
                              Place{90.0, 80.0}, Place{98.0, 80.0}, Place{94.0, 74.5}}) {
        const bool red = number % 3 != 1;
        drawBall(surface, apple, 4.4, 4.2,
                 {.ramp = red ? &kCrimsonRamp : &kMossRamp,
                  .tone = red ? 3.8 : 4.6,
                  .height = -3.0 + number / 3,
                  .bulge = 0.6});
        ++number;
    }
    // Posts at the sides, half of each in this tile; sill; panels
    everyTexel([&](int x, int y) {
        const int off = std::min(x, kSide - 1 - x);
        if (off < 9 && y >= 14) {
            surface.at(x, y).height = 3.0 - (off > 6 ? 0.8 * (off - 6) : 0.0);
            surface.at(x, y).tone =
                2.9 + 0.8 * woodGrain(y, x, kGlazingSeed + 32U) - (off == 3 ? 0.8 : 0.0);
        }
    });
    drawSlab(surface, {.left = 0,
                       .top = kSill,
                       .right = 128,
                       .bottom = kSill + 6,
                       .height = 5.0,
                       .bevel = 2.0,
                       .tone = 3.6,
                       .ramp = &kOakRamp});
    for (int panel = 0; panel < 3; ++panel) {
        const int left = 12 + 36 * panel;
        drawSlab(surface, {.left = left,
                           .top = 102,
                           .right = left + 32,
                           .bottom = 124,
                           .height = -1.2,
                           .bevel = 1.0,
                           .tone = 1.7,
                           .ramp = &kSeaRamp});
        drawSlab(surface, {.left = left + 3,
                           .top = 105,
                           .right = left + 29,
                           .bottom = 121,
                           .height = 0.8,
                           .bevel = 2.0,
                           .tone = 2.1,
                           .ramp = &kSeaRamp});
    }
    // The awning, striped, with a scalloped hem
    everyTexelIn(0, 0, kSide, 27, [&](int x, int y) {
        const int local = x % 16;
        const double off = local + 0.5 - 8.0;
        const double hem = 19.0 + 7.0 * std::sqrt(std::max(0.0, 1.0 - off * off / 64.0));
        if (y < hem) {
            const bool red = x / 16 % 2 == 0;
            const double fold = y < 19 ? -0.03 * y : -0.9;
            surface.at(x, y) = {.height = 7.0 + 0.12 * y,
                                .tone = (red ? 3.4 : 6.2) + fold - (local == 15 ? 0.6 : 0.0),
                                .ramp = red ? &kCrimsonRamp : &kStoneRamp};
        }
    });
    return lit(surface, {.gain = 0.45,
                         .lightest = 0.8,
                         .darkest = 1.3,
                         .shadowReach = 5,
                         .shadowSlope = 0.8,
                         .shadowDepth = 1.0,
                         .hollowDepth = 0.05});
}

}  // namespace slicecast::textures
