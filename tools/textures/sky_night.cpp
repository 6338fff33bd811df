#include <algorithm>
#include <array>
#include <cmath>

#include "noise.h"
#include "panorama.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kSkyNightSeed = 3400;
constexpr double kMoonAcross = 0.70 * kAround;
constexpr double kMoonUp = 0.42;
constexpr double kMoonRadius = 0.062;

constexpr Ramp kNightAir{{kHazeNight, blend(kSea0, kSlate0, 100), blend(kSea0, kNight, 110), kNight,
                          blend(kNight, kInk, 128)},
                         5};

// How deep in the milky way, 0 to 1: a band that climbs and falls once around the sky, parted by a
// dark lane.
double milkyWay(int x, int y) {
    const double middle = 0.52 + 0.42 * wave(static_cast<double>(x) / kSkyWidth + 0.05);
    const double off = (upOf(y) - middle) / 0.20;
    const double cloud =
        fractalNoise(x / 32.0, y / 16.0, kSkyWidth / 32, kSkyHeight / 16, 4, kSkyNightSeed + 1U);
    const double lane = std::abs(off + 1.2 * (cloud - 0.5));
    return std::max(0.0, 1.0 - off * off) * smoothStep(0.32, 0.7, cloud) *
           (0.45 + 0.55 * smoothStep(0.02, 0.25, lane));
}

void drawStars(Picture& sky) {
    static constexpr std::array<Colour, 4> kStarColours = {kSea4, kCream, kSand1, kSea3};
    for (int y = 0; y < kSkyHeight; ++y) {
        for (int x = 0; x < kSkyWidth; ++x) {
            const auto rarity = static_cast<std::uint32_t>(milkyWay(x, y) > 0.25 ? 70 : 190);
            if (hashOf(x, y, kSkyNightSeed + 2U) % rarity != 0U) {
                continue;
            }
            const double size = randomAt(x, y, kSkyNightSeed + 3U);
            const Colour colour =
                kStarColours[hashOf(x, y, kSkyNightSeed + 4U) % kStarColours.size()];
            const int share = size < 0.6 ? 60 : (size < 0.9 ? 120 : 220);
            sky.at(x, y) = blend(sky.at(x, y), colour, share);
            if (size > 0.9) {
                // A texel is wider than tall: two of them make a round star
                sky.at(x, y - 1) = blend(sky.at(x, y - 1), colour, share);
            }
            if (size > 0.985) {
                // The brightest have rays
                sky.at(x, y) = kCream;
                for (const int step : {-1, 1}) {
                    sky.at(x + step, y) = blend(sky.at(x + step, y), colour, 110);
                    sky.at(x, y + step) = blend(sky.at(x, y + step), colour, 110);
                    sky.at(x, y + 2 * step) = blend(sky.at(x, y + 2 * step), colour, 40);
                }
            }
        }
    }
}

void drawMoon(Picture& sky) {
    struct Sea {
        double x, y, radius;
    };
    static constexpr std::array<Sea, 6> kSeas = {{{-0.3, 0.35, 0.34},
                                                  {0.25, 0.30, 0.26},
                                                  {-0.45, -0.1, 0.24},
                                                  {0.38, -0.12, 0.2},
                                                  {-0.1, -0.5, 0.16},
                                                  {0.12, 0.62, 0.14}}};
    for (int y = 0; y < kSkyHeight; ++y) {
        for (int x = 0; x < kSkyWidth; ++x) {
            const double dx = aroundFrom(kMoonAcross, acrossOf(x)) / kMoonRadius;
            const double dy = (upOf(y) - kMoonUp) / kMoonRadius;
            const double distance = std::sqrt(dx * dx + dy * dy);
            if (distance > 1.0) {
                // Rings of light around it
                const double glow =
                    distance < 1.4
                        ? 0.30
                        : (distance < 2.1
                               ? 0.19
                               : (distance < 3.2 ? 0.11 : (distance < 5.0 ? 0.05 : 0.0)));
                sky.at(x, y) = blend(sky.at(x, y), kSea2, static_cast<int>(glow * 256.0));
                continue;
            }
            Colour colour = distance > 0.9 ? kStone6 : kCream;
            for (const Sea& sea : kSeas) {
                const double seaX = dx - sea.x;
                const double seaY = dy - sea.y;
                if (seaX * seaX + seaY * seaY < sea.radius * sea.radius) {
                    colour = kSlate5;
                }
            }
            if (dx - dy > 0.95) {
                colour = blend(colour, kSlate4, 128);
            }
            sky.at(x, y) = colour;
        }
    }
}

}  // namespace

Picture paintSkyNight() {
    Picture sky(kSkyWidth, kSkyHeight);
    for (int y = 0; y < kSkyHeight; ++y) {
        const double up = upOf(y);
        for (int x = 0; x < kSkyWidth; ++x) {
            const Colour air = softColourAt(kNightAir, 5.0 * up / (up + 0.32));
            const double way = milkyWay(x, y);
            const Colour veil = way > 0.55 ? blend(kSea1, kSlate4, 110) : blend(kViolet, kSea1, 96);
            const int share =
                way > 0.55 ? 70 : (way > 0.35 ? 92 : (way > 0.18 ? 56 : (way > 0.06 ? 26 : 0)));
            sky.at(x, y) = blend(air, veil, share);
        }
    }
    drawStars(sky);
    drawZenith(sky, 20, kSkyNightSeed + 10U);
    drawMoon(sky);
    drawRidge(sky, {.low = 0.03,
                    .high = 0.21,
                    .peaks = 22,
                    .sharpness = 0.95,
                    .lit = blend(kSlate1, kSea1, 60),
                    .shaded = blend(kSlate0, kSea0, 128),
                    .mist = kHazeNight,
                    .mistHeight = 0.09,
                    .snowLine = 0.135,
                    .snow = blend(kSlate2, kSlate3, 100),
                    .seed = kSkyNightSeed + 20U});
    drawRidge(sky, {.low = 0.01,
                    .high = 0.11,
                    .peaks = 24,
                    .sharpness = 0.6,
                    .lit = blend(kNight, kSea0, 150),
                    .shaded = blend(kNight, kSea0, 60),
                    .mist = kHazeNight,
                    .mistHeight = 0.05,
                    .snowLine = 2.0,
                    .snow = blend(kSlate2, kSlate3, 100),
                    .seed = kSkyNightSeed + 31U});
    drawHaze(sky, kHazeNight, 4);
    return sky;
}

}  // namespace slicecast::textures
