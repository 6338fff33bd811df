#include "metalwork.h"

#include <algorithm>
#include <cmath>

#include "marks.h"
#include "noise.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kMetalworkSeed = 1400;
constexpr int kPlate = 64;
constexpr int kRivetInset = 7;

constexpr Lighting kIronLight = {.gain = 0.55,
                                 .lightest = 1.4,
                                 .darkest = 1.4,
                                 .shadowReach = 2,
                                 .shadowSlope = 0.5,
                                 .shadowDepth = 0.9};

Surface plateSurface() {
    Surface surface;
    everyTexel([&](int x, int y) {
        const int plate = x / kPlate + 2 * (y / kPlate);
        const int localX = x % kPlate;
        const int localY = y % kPlate;
        const int inside = std::min({localX, kPlate - 1 - localX, localY, kPlate - 1 - localY});
        const double brushed = valueNoise(x / 16.0, y / 1.0, 8, 128,
                                          kMetalworkSeed + static_cast<std::uint32_t>(plate)) -
                               0.5;
        const double cloud = fractalNoise(x / 32.0, y / 32.0, 4, 4, 2, kMetalworkSeed + 9U) - 0.5;
        // A sheen falls across each plate from the upper left
        const double sheen = 0.7 - 1.4 * smoothStep(10.0, 110.0, localX + localY * 1.2);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kSlateRamp;
        texel.height = std::min(1.6, inside * 0.8);
        texel.tone = 3.8 + 0.6 * sheen + 0.5 * brushed + 0.7 * cloud +
                     0.4 * (randomAt(plate, 1, kMetalworkSeed) - 0.5);
        if (inside == 0) {
            texel.tone = 1.0;
        }
        // The field inside the row of rivets lies a little deeper
        if (inside >= 13) {
            texel.height -= 0.9;
        }
    });
    return surface;
}

template <typename Draw>
void everyRivet(Draw draw) {
    for (int plateY = 0; plateY < kSide; plateY += kPlate) {
        for (int plateX = 0; plateX < kSide; plateX += kPlate) {
            for (int place = 0; place < 5; ++place) {
                const double along = kRivetInset + place * (kPlate - 2.0 * kRivetInset) / 4.0;
                draw(plateX + along, plateY + kRivetInset + 0.0);
                draw(plateX + along, plateY + kPlate - kRivetInset + 0.0);
                if (place > 0 && place < 4) {
                    draw(plateX + kRivetInset + 0.0, plateY + along);
                    draw(plateX + kPlate - kRivetInset + 0.0, plateY + along);
                }
            }
        }
    }
}

void drawRivets(Surface& surface) {
    everyRivet([&](double x, double y) {
        drawStud(surface,
                 {.x = x, .y = y, .radius = 2.4, .height = 2.6, .tone = 3.7, .ramp = &kSlateRamp});
    });
}

}  // namespace

Picture paintMetalPlates() {
    Surface surface = plateSurface();
    drawRivets(surface);
    return lit(surface, kIronLight);
}

Picture paintMetalRusty() {
    Surface surface = plateSurface();
    drawRivets(surface);
    // Rust spreads from the seams and runs down from the rivets
    std::vector<double> rust(static_cast<std::size_t>(kSide) * kSide, 0.0);
    const auto rustAt = [&](int x, int y) -> double& {
        return rust[static_cast<std::size_t>(wrap(y, kSide)) * kSide +
                    static_cast<std::size_t>(wrap(x, kSide))];
    };
    everyTexel([&](int x, int y) {
        const int inside =
            std::min({x % kPlate, kPlate - 1 - x % kPlate, y % kPlate, kPlate - 1 - y % kPlate});
        rustAt(x, y) =
            1.5 * (fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kMetalworkSeed + 20U) - 0.5) +
            std::max(0.0, 0.32 - 0.05 * inside);
    });
    everyRivet([&](double atX, double atY) {
        const int x = static_cast<int>(atX);
        const int y = static_cast<int>(atY);
        const int length = static_cast<int>(8.0 + 22.0 * randomAt(x, y, kMetalworkSeed + 21U));
        for (int step = -1; step < length; ++step) {
            const double fade = 0.5 * (1.0 - static_cast<double>(step) / length);
            rustAt(x - 1, y + step) += fade;
            rustAt(x, y + step) += fade;
            rustAt(x - 2, y + step) += 0.4 * fade;
            rustAt(x + 1, y + step) += 0.4 * fade;
        }
    });
    everyTexel([&](int x, int y) {
        const double amount = rustAt(x, y);
        const double crust = fractalNoise(x / 4.0, y / 4.0, 32, 32, 2, kMetalworkSeed + 22U) - 0.5;
        Texel& texel = surface.at(x, y);
        const bool seam = texel.tone < 1.5;
        if (seam || amount < 0.16) {
            texel.tone -= 0.4;
            return;
        }
        const double tone = texel.tone;
        texel.ramp = &kRustRamp;
        texel.tone =
            tone - 1.0 + 1.4 * crust + (amount < 0.26 ? -0.8 : 0.0) + (amount > 0.55 ? -0.5 : 0.0);
        texel.height += 1.0 * crust;
    });
    return lit(surface, kIronLight);
}

// Floor plate with raised lozenges.
Picture paintMetalTread() {
    constexpr int kCell = 16;
    Surface surface;
    everyTexel([&](int x, int y) {
        const int cellX = x / kCell;
        const int cellY = y / kCell;
        const bool rising = (cellX + cellY) % 2 == 0;
        const double dx = x % kCell + 0.5 - kCell / 2.0;
        const double dy = y % kCell + 0.5 - kCell / 2.0;
        const double along = (rising ? dx - dy : dx + dy) * 0.7071;
        const double across = (rising ? dx + dy : dx - dy) * 0.7071;
        const double bar = 1.0 - (along * along) / 52.0 - (across * across) / 5.5;
        const double cloud = fractalNoise(x / 32.0, y / 32.0, 4, 4, 3, kMetalworkSeed + 40U) - 0.5;
        const double scratch =
            valueNoise((x + y) / 2.0, (x - y + kSide) / 64.0, 128, 4, kMetalworkSeed + 41U);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kSlateRamp;
        texel.height = bar > 0.0 ? 3.2 * std::min(1.0, bar * 2.2) : 0.0;
        texel.tone = 2.5 + 0.9 * cloud + (scratch > 0.86 ? 0.4 : 0.0) + (bar > 0.0 ? 0.9 : 0.0);
    });
    return lit(surface, kIronLight);
}

}  // namespace slicecast::textures
