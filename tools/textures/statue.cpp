#include "statue.h"

#include <algorithm>
#include <cmath>

#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kStatueSeed = 3800;

// A robe: its outline by half widths at heights, its folds as ripples of the surface.
void drawRobe(Surface& surface) {
    struct Girth {
        double y;
        double left;
        double right;
    };
    static constexpr Girth kGirths[] = {{38.0, 36.0, 47.0}, {44.0, 27.0, 56.0}, {54.0, 26.0, 57.0},
                                        {72.0, 31.0, 53.0}, {84.0, 29.0, 55.0}, {112.0, 25.0, 58.0},
                                        {134.0, 23.0, 61.0}};
    everyTexelOn(surface, 0, 38, 84, 134, [&](int x, int y) {
        std::size_t part = 0;
        while (kGirths[part + 1].y <= y + 0.5) {
            ++part;
        }
        const Girth& above = kGirths[part];
        const Girth& below = kGirths[part + 1];
        const double share = (y + 0.5 - above.y) / (below.y - above.y);
        const double left = above.left + share * (below.left - above.left);
        const double right = above.right + share * (below.right - above.right);
        if (x + 0.5 < left || x + 0.5 > right) {
            return;
        }
        const double across = (x + 0.5 - left) / (right - left);
        const double off = 2.0 * across - 1.0;
        // Folds run down from the girdle and spread; above it they cross the breast
        const double fold =
            y > 74 ? wave(across * 3.5 + 0.08 * wave(y / 40.0)) * std::min(1.0, (y - 70) / 26.0)
                   : 0.7 * wave(across * 2.2 + y / 30.0);
        surface.at(x, y) = {
            .height = 6.0 + 10.0 * std::sqrt(std::max(0.0, 1.0 - off * off)) + 1.7 * fold,
            .tone = 4.3 + 0.35 * fold,
            .ramp = &kFlintRamp,
            .alpha = 255};
    });
}

}  // namespace

// A wayfarer of stone with staff and lantern, weathered, moss in the joints of the pedestal.
Picture paintStatue() {
    Surface surface = Surface::empty(84, 200);
    const Ramp* stone = &kFlintRamp;
    const auto paint = [stone](double tone, double height) {
        return Paint{.ramp = stone, .tone = tone, .height = height};
    };
    // Pedestal: plinth, die with a panel, cornice
    drawBox(surface, 2, 188, 82, 200, {.ramp = stone, .tone = 3.8, .height = 4.0, .bulge = 0.0});
    drawBox(surface, 7, 181, 77, 188, {.ramp = stone, .tone = 4.4, .height = 3.0, .bulge = 0.0});
    drawBox(surface, 11, 148, 73, 181, {.ramp = stone, .tone = 3.7, .height = 1.5, .bulge = 0.0});
    drawBox(surface, 18, 153, 66, 176, {.ramp = stone, .tone = 3.3, .height = 0.4, .bulge = 0.0});
    drawBox(surface, 7, 142, 77, 148, {.ramp = stone, .tone = 4.3, .height = 3.5, .bulge = 0.0});
    drawBox(surface, 4, 134, 80, 142, {.ramp = stone, .tone = 4.8, .height = 5.0, .bulge = 0.0});
    for (int line = 0; line < 3; ++line) {
        const int half = line == 1 ? 19 : 15;
        everyTexelIn(42 - half, 158 + 6 * line, 42 + half, 160 + 6 * line, [&](int x, int y) {
            if (hashOf(x / 2, line, kStatueSeed) % 4U != 0U) {
                surface.at(x, y).height -= 0.8;
                surface.at(x, y).tone -= 1.2;
            }
        });
    }
    // The figure, from back to front: cloak, feet, robe, arms, head
    drawOutline(
        surface,
        {{34.0, 36.0}, {49.0, 36.0}, {63.0, 56.0}, {67.0, 130.0}, {18.0, 132.0}, {22.0, 56.0}},
        {.ramp = stone, .tone = 2.9, .height = 1.0});
    everyTexelOn(surface, 16, 44, 70, 134, [&](int x, int y) {
        if (surface.at(x, y).alpha > 0 && y < 133) {
            surface.at(x, y).height += 1.0 * wave((x + 0.08 * y) / 9.0);
        }
    });
    drawBall(surface, {34.0, 132.0}, 6.5, 3.5, paint(4.0, 4.0));
    drawBall(surface, {50.0, 132.0}, 6.5, 3.5, paint(4.0, 4.0));
    drawRobe(surface);
    drawBox(surface, 30, 72, 54, 76, {.ramp = stone, .tone = 3.4, .height = 16.0, .bulge = 0.2});
    // The staff in the left of the picture, the hand on it
    drawLimb(surface, {15.0, 132.0}, 2.0, {17.0, 20.0}, 2.0, paint(4.0, 14.0));
    drawBall(surface, {17.0, 18.0}, 4.2, 4.2, paint(4.4, 14.0));
    drawLimb(surface, {29.0, 50.0}, 6.0, {22.0, 66.0}, 5.0, paint(4.5, 16.0));
    drawLimb(surface, {22.0, 66.0}, 4.6, {18.0, 54.0}, 3.6, paint(4.5, 17.0));
    drawBall(surface, {17.0, 52.0}, 3.8, 4.2, paint(4.8, 19.0));
    // The other arm holds out a lantern
    drawLimb(surface, {54.0, 50.0}, 6.0, {61.0, 66.0}, 5.0, paint(4.2, 16.0));
    drawLimb(surface, {61.0, 66.0}, 4.6, {70.0, 58.0}, 3.4, paint(4.3, 17.0));
    drawBall(surface, {71.0, 57.0}, 3.6, 3.6, paint(4.7, 18.0));
    drawLimb(surface, {71.0, 60.0}, 1.0, {71.0, 66.0}, 1.0, paint(3.4, 16.0));
    drawOutline(surface, {{71.0, 63.0}, {78.0, 70.0}, {64.0, 70.0}}, paint(4.2, 15.0));
    drawBox(surface, 66, 70, 77, 82, {.ramp = stone, .tone = 3.8, .height = 12.0, .bulge = 0.6});
    drawBox(surface, 64, 81, 79, 85, {.ramp = stone, .tone = 4.2, .height = 14.0, .bulge = 0.3});
    for (const int x : {68, 73}) {
        everyTexelIn(x, 72, x + 3, 80,
                     [&](int paneX, int paneY) { surface.at(paneX, paneY).tone = 1.6; });
    }
    // Hood and head; the face in shade under it
    drawBall(surface, {41.5, 24.0}, 13.0, 15.5, paint(4.5, 12.0));
    drawOutline(surface, {{29.0, 28.0}, {54.0, 28.0}, {57.0, 46.0}, {41.5, 52.0}, {26.0, 46.0}},
                {.ramp = stone, .tone = 4.4, .height = 20.0});
    drawBall(surface, {41.5, 27.0}, 8.0, 10.5,
             {.ramp = stone, .tone = 2.0, .height = 20.0, .bulge = 0.0});
    drawBall(surface, {41.5, 28.0}, 6.4, 8.6,
             {.ramp = stone, .tone = 4.6, .height = 20.0, .bulge = 0.6});
    // Eyes in the shade of the brows
    for (const int x : {36, 43}) {
        everyTexelIn(x, 25, x + 4, 28, [&](int eyeX, int eyeY) {
            surface.at(eyeX, eyeY).tone -= eyeY == 25 ? 1.8 : 0.9;
        });
    }
    drawOutline(surface, {{41.0, 26.0}, {43.0, 26.0}, {43.5, 31.5}, {40.0, 31.5}},
                {.ramp = stone, .tone = 5.4, .height = 26.0});
    drawOutline(surface, {{36.0, 32.0}, {47.0, 32.0}, {45.0, 42.0}, {41.5, 46.0}, {38.0, 42.0}},
                {.ramp = stone, .tone = 4.4, .height = 25.0});
    // Weather: streaks from above, and moss where water stays
    everyTexelIn(0, 0, surface.width, surface.height, [&](int x, int y) {
        Texel& texel = surface.at(x, y);
        if (texel.alpha == 0) {
            return;
        }
        texel.tone += 1.1 * (fractalNoise(x / 16.0, y / 16.0, 8, 16, 3, kStatueSeed + 1U) - 0.5) -
                      (valueNoise(x / 3.0, y / 40.0, 64, 8, kStatueSeed + 2U) > 0.78 ? 0.5 : 0.0);
        const double moss = fractalNoise(x / 8.0, y / 8.0, 16, 32, 3, kStatueSeed + 3U) +
                            (y > 128 && y < 144 ? 0.1 : 0.0);
        if (moss > 0.74 && y > 66) {
            texel.ramp = &kMossRamp;
            texel.tone = 2.4 + 2.0 * (moss - 0.74);
        }
    });
    return spriteOf(surface, {.gain = 0.4,
                              .lightest = 1.1,
                              .darkest = 1.7,
                              .shadowReach = 4,
                              .shadowSlope = 0.8,
                              .shadowDepth = 0.9,
                              .hollowDepth = 0.06});
}

}  // namespace slicecast::textures
