#include "openings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "arch.h"
#include "brickwork.h"
#include "marks.h"
#include "noise.h"
#include "stonework.h"
#include "woodwork.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kOpeningsSeed = 1800;

// Panes of glass with bars between them.
struct Panes {
    int left;
    int top;
    int columns;
    int rows;
    int paneWidth;
    int paneHeight;
    bool lamp;  // lit from inside; otherwise they mirror the sky
};

constexpr int kPaneBar = 3;

void drawPanes(Surface& surface, const Panes& panes) {
    const int width = panes.columns * (panes.paneWidth + kPaneBar) + kPaneBar;
    const int height = panes.rows * (panes.paneHeight + kPaneBar) + kPaneBar;
    everyTexelIn(panes.left, panes.top, panes.left + width, panes.top + height, [&](int x, int y) {
        const int localX = (x - panes.left) % (panes.paneWidth + kPaneBar);
        const int localY = (y - panes.top) % (panes.paneHeight + kPaneBar);
        Texel& texel = surface.at(x, y);
        if (localX < kPaneBar || localY < kPaneBar) {
            texel = {.height = -1.5, .tone = 2.6, .ramp = &kOakRamp};
            return;
        }
        const int column = (x - panes.left) / (panes.paneWidth + kPaneBar);
        const int row = (y - panes.top) / (panes.paneHeight + kPaneBar);
        const double own = randomAt(column, row, kOpeningsSeed) - 0.5;
        texel.height = -4.0;
        if (panes.lamp) {
            const double dx = (x - panes.left - width / 2.0) / width;
            const double dy = (y - panes.top - height * 0.6) / height;
            texel.ramp = &kBrassRamp;
            texel.tone = 4.7 - 5.2 * std::sqrt(dx * dx + dy * dy) + 0.5 * own;
            return;
        }
        // Bright sky above, a slanting reflection across all panes
        const double down = static_cast<double>(y - panes.top) / height;
        const int slant = wrap(x - panes.left + (y - panes.top), 46);
        texel.ramp = &kSeaRamp;
        texel.tone = 2.2 - 1.1 * down + 0.5 * own;
        texel.tone += slant > 30 && slant < 39 ? 1.2 : (slant > 41 && slant < 44 ? 0.7 : 0.0);
    });
}

Picture paintBrickWindow(bool lamp) {
    const Surface wall = brickSurface();
    Surface surface = wall;
    // The recess, then lintel and sill of dressed stone
    drawSlab(surface, {.left = 35,
                       .top = 32,
                       .right = 93,
                       .bottom = 96,
                       .height = -1.0,
                       .bevel = 1.0,
                       .tone = 1.6,
                       .ramp = &kOakRamp});
    drawPanes(surface, {.left = 38,
                        .top = 34,
                        .columns = 3,
                        .rows = 3,
                        .paneWidth = 14,
                        .paneHeight = 16,
                        .lamp = lamp});
    drawSlab(surface, {.left = 29,
                       .top = 17,
                       .right = 99,
                       .bottom = 32,
                       .height = 3.0,
                       .bevel = 2.0,
                       .tone = 4.2,
                       .ramp = &kStoneRamp});
    drawSlab(surface, {.left = 27,
                       .top = 96,
                       .right = 101,
                       .bottom = 106,
                       .height = 4.0,
                       .bevel = 2.0,
                       .tone = 4.4,
                       .ramp = &kStoneRamp});
    drawSlab(surface, {.left = 57,
                       .top = 14,
                       .right = 71,
                       .bottom = 33,
                       .height = 4.0,
                       .bevel = 2.0,
                       .tone = 4.5,
                       .ramp = &kStoneRamp});
    return litOver(wall, brickLighting(), surface,
                   {.gain = 0.5,
                    .lightest = 0.8,
                    .darkest = 1.3,
                    .shadowReach = 4,
                    .shadowSlope = 0.7,
                    .shadowDepth = 1.1,
                    .hollowDepth = 0.06});
}

}  // namespace

Picture paintDoor() {
    constexpr int kBoard = 15;
    const Surface wall = ashlarSurface();
    Surface surface = wall;
    everyTexel([&](int x, int y) {
        const double outside = outsideArch(x, y);
        if (outside > 0.0) {
            return;
        }
        Texel& texel = surface.at(x, y);
        // The boards, set back
        const int along = x - 26;
        const int board = along / kBoard;
        const int inside = std::min(along % kBoard, kBoard - 1 - along % kBoard);
        texel.ramp = &kTimberRamp;
        texel.height = -3.0 + std::min(1.2, 0.7 * inside);
        texel.tone = 2.5 + 0.7 * (randomAt(board, 2, kOpeningsSeed + 12U) - 0.5) +
                     0.9 * woodGrain(y, x, kOpeningsSeed + 13U + static_cast<std::uint32_t>(board));
        texel.tone = inside == 0 ? texel.tone - 1.2 : texel.tone;
        texel.tone -= outside > -2.5 ? 0.8 : 0.0;
    });
    drawArch(surface);
    // Iron straps with pointed ends, nails, and a ring to pull
    for (const int top : {46, 98}) {
        everyTexelIn(27, top, 96, top + 9, [&](int x, int y) {
            const int fromEdge = std::min(y - top, top + 8 - y);
            if (x < 88 || x - 88 <= 2 * fromEdge) {
                surface.at(x, y) = {.height = -1.0 + std::min(1.0, 0.6 * fromEdge),
                                    .tone = 2.1,
                                    .ramp = &kSlateRamp};
            }
        });
        for (const int x : {33, 48, 63, 78}) {
            drawStud(surface, {.x = x + 0.5,
                               .y = top + 4.5,
                               .radius = 2.0,
                               .height = 1.8,
                               .tone = 2.8,
                               .ramp = &kSlateRamp});
        }
    }
    drawStud(
        surface,
        {.x = 90.0, .y = 70.0, .radius = 3.0, .height = 2.0, .tone = 2.8, .ramp = &kBrassRamp});
    everyTexelIn(82, 69, 99, 86, [&](int x, int y) {
        const double dx = x + 0.5 - 90.0;
        const double dy = y + 0.5 - 77.0;
        const double off = std::abs(std::sqrt(dx * dx + dy * dy) - 6.0);
        if (off < 1.4) {
            surface.at(x, y) = {.height = 0.5 - off, .tone = 3.1, .ramp = &kBrassRamp};
        }
    });
    return litOver(wall, ashlarLighting(), surface,
                   {.gain = 0.5,
                    .lightest = 0.9,
                    .darkest = 1.3,
                    .shadowReach = 5,
                    .shadowSlope = 0.7,
                    .shadowDepth = 1.0,
                    .hollowDepth = 0.06});
}

Picture paintWindowBrick() {
    return paintBrickWindow(false);
}

Picture paintWindowLit() {
    return paintBrickWindow(true);
}

// With a lamp behind its panes, or without.
static Picture paintTimberWindow(bool lamp) {
    Surface surface = timberFrameSurface();
    drawSlab(surface, {.left = 41,
                       .top = 26,
                       .right = 87,
                       .bottom = 92,
                       .height = 2.0,
                       .bevel = 1.5,
                       .tone = 2.8,
                       .ramp = &kOakRamp});
    drawPanes(surface, {.left = 43,
                        .top = 28,
                        .columns = 2,
                        .rows = 3,
                        .paneWidth = 18,
                        .paneHeight = 17,
                        .lamp = lamp});
    // Shutters folded back, painted in sea green, with louvres
    for (const int left : {18, 88}) {
        drawSlab(surface, {.left = left,
                           .top = 25,
                           .right = left + 22,
                           .bottom = 93,
                           .height = 2.6,
                           .bevel = 1.5,
                           .tone = 1.9,
                           .ramp = &kSeaRamp});
        everyTexelIn(left + 4, 30, left + 18, 88, [&](int x, int y) {
            const int slat = (y - 30) % 29 % 6;
            if ((y - 30) % 29 < 26) {
                surface.at(x, y).height = 1.0 + 0.3 * slat;
                surface.at(x, y).tone = slat == 5 ? 0.8 : 1.6 + 0.15 * (5 - slat);
            }
        });
    }
    // The sill, and a box of flowers on it
    drawSlab(surface, {.left = 37,
                       .top = 92,
                       .right = 91,
                       .bottom = 98,
                       .height = 4.0,
                       .bevel = 1.5,
                       .tone = 3.2,
                       .ramp = &kOakRamp});
    Random random(kOpeningsSeed + 30U);
    for (int leaf = 0; leaf < 90; ++leaf) {
        const double x = random.between(40.0, 88.0);
        const double y = random.between(84.0, 95.0);
        drawStud(surface, {.x = x,
                           .y = y,
                           .radius = 1.7,
                           .height = 2.0,
                           .tone = random.between(2.4, 4.2),
                           .ramp = &kMossRamp});
    }
    for (int flower = 0; flower < 16; ++flower) {
        const double x = random.between(41.0, 87.0);
        const double y = random.between(83.0, 93.0);
        const bool yellow = random.fraction() < 0.3;
        drawStud(surface, {.x = x,
                           .y = y,
                           .radius = 1.8,
                           .height = 1.6,
                           .tone = 3.8,
                           .ramp = yellow ? &kBrassRamp : &kCrimsonRamp});
    }
    return lit(surface, timberLighting());
}

Picture paintWindowTimber() {
    return paintTimberWindow(false);
}

Picture paintWindowTimberLit() {
    return paintTimberWindow(true);
}

}  // namespace slicecast::textures
