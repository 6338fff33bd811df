#include "marks.h"

#include <algorithm>
#include <cmath>

#include "noise.h"

namespace slicecast::textures {

void drawCrack(Surface& surface, const Crack& crack) {
    Random random(crack.seed);
    int x = crack.x;
    int y = crack.y;
    int lean = random.fraction() < 0.5 ? -1 : 1;
    for (int step = 0; step < crack.length; ++step) {
        surface.at(x, y).height -= crack.depth;
        surface.at(x, y).tone -= crack.darkening;
        const double turn = random.fraction();
        if (turn < 0.12) {
            lean = -lean;
        }
        if (turn < 0.55) {
            y += crack.fall;
        }
        if (turn > 0.35) {
            x += lean;
        }
    }
}

void drawStud(Surface& surface, const Stud& stud) {
    const int reach = static_cast<int>(std::floor(stud.radius)) + 1;
    const int middleX = static_cast<int>(std::floor(stud.x));
    const int middleY = static_cast<int>(std::floor(stud.y));
    everyTexelIn(middleX - reach, middleY - reach, middleX + reach + 1, middleY + reach + 1,
                 [&](int x, int y) {
                     const double dx = x + 0.5 - stud.x;
                     const double dy = y + 0.5 - stud.y;
                     const double rest = stud.radius * stud.radius - dx * dx - dy * dy;
                     if (rest >= 0.0) {
                         Texel& texel = surface.at(x, y);
                         texel.height += stud.height * std::sqrt(rest) / stud.radius;
                         texel.tone = stud.tone;
                         texel.ramp = stud.ramp;
                         texel.alpha = 255;
                     }
                 });
}

void drawPits(Surface& surface, int rarity, double depth, std::uint32_t seed) {
    everyTexel([&](int x, int y) {
        if (hashOf(x, y, seed) % static_cast<std::uint32_t>(rarity) == 0U) {
            const bool wide = hashOf(x, y, seed + 1U) % 2U == 0U;
            surface.at(x, y).height -= depth;
            surface.at(x, y).tone -= 0.5;
            if (wide) {
                surface.at(x + 1, y).height -= depth;
                surface.at(x + 1, y).tone -= 0.5;
            }
        }
    });
}

void drawSlab(Surface& surface, const Slab& slab) {
    everyTexelIn(slab.left, slab.top, slab.right, slab.bottom, [&](int x, int y) {
        const int inside =
            std::min({x - slab.left, slab.right - 1 - x, y - slab.top, slab.bottom - 1 - y});
        Texel& texel = surface.at(x, y);
        texel.height = slab.height * std::min(1.0, (inside + 1.0) / slab.bevel);
        texel.tone = slab.tone;
        texel.ramp = slab.ramp;
        texel.alpha = 255;
    });
}

double woodGrain(double along, double across, std::uint32_t seed) {
    const double bend = 7.0 * valueNoise(along / 32.0, across / 16.0, 4, 8, seed);
    const double streak = valueNoise(along * 3.0 / kSide, (across + bend) / 2.0, 3, 64, seed + 1U);
    const double broad = valueNoise(along / 32.0, (across + bend) / 8.0, 4, 16, seed + 2U);
    double tone = 0.9 * (broad - 0.5);
    tone -= streak < 0.25 ? 0.7 : 0.0;
    tone += streak > 0.8 ? 0.4 : 0.0;
    return tone;
}

}  // namespace slicecast::textures
