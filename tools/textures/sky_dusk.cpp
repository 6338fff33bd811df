#include <algorithm>
#include <cmath>

#include "noise.h"
#include "panorama.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kSkyDuskSeed = 3200;
constexpr double kSunAcross = kAround / 2.0;  // in the west
constexpr double kSunUp = 0.125;

constexpr Ramp kDuskAir{{blend(kNight, kSea0, 128), blend(kSea0, kViolet, 128), kViolet, kPlum,
                         blend(kPlum, kCoral, 150), kCoral, kSand0, blend(kBrass2, kSand2, 128)},
                        8};

// How near to the sun, 0 to 1; glows are wider than tall.
double nearSun(double across, double up, double reach) {
    const double dx = aroundFrom(kSunAcross, across) / reach;
    const double dy = (up - kSunUp) / (0.6 * reach);
    return 1.0 / (1.0 + dx * dx + dy * dy);
}

double airTone(double across, double up) {
    return 4.9 - 5.4 * up / (up + 0.45) + 2.2 * nearSun(across, up, 0.9) * (1.0 - 0.5 * up) -
           0.5 * (1.0 - nearSun(across, up, 2.2));
}

// Long flat clouds as a ceiling that recedes: rows near the horizon lie closer together.
void drawStreaks(Picture& sky) {
    for (int y = 0; y < kSkyHeight; ++y) {
        const double up = upOf(y);
        const double depth = 9.0 / (up + 0.2);
        for (int x = 0; x < kSkyWidth; ++x) {
            const double across = acrossOf(x);
            const double bend =
                0.8 * valueNoise(x / 42.666666666666664, depth, 24, 64, kSkyDuskSeed + 1U);
            const double mass =
                fractalNoise(x / 42.666666666666664, depth + bend, 24, 64, 4, kSkyDuskSeed + 2U);
            const double edge = mass - (0.54 + 0.09 * up);
            if (edge < 0.0 || up < 0.04) {
                continue;
            }
            const double glow = nearSun(across, up, 1.1);
            // The rims towards the sun burn, the bodies are dark
            const double rim = fractalNoise(x / 42.666666666666664, depth + bend + 0.16, 24, 64, 4,
                                            kSkyDuskSeed + 2U) -
                               (0.54 + 0.09 * up);
            const bool burning = rim < 0.02;
            const double tone = burning ? airTone(across, up) + 0.8 + 1.4 * glow
                                        : airTone(across, up) - 0.9 + 0.5 * glow;
            sky.at(x, y) = burning ? colourAt(kDuskAir, tone) : softColourAt(kDuskAir, tone);
        }
    }
}

}  // namespace

Picture paintSkyDusk() {
    Picture sky(kSkyWidth, kSkyHeight);
    for (int y = 0; y < kSkyHeight; ++y) {
        for (int x = 0; x < kSkyWidth; ++x) {
            const double across = acrossOf(x);
            const double up = upOf(y);
            sky.at(x, y) = softColourAt(kDuskAir, airTone(across, up));
            // First stars where it is darkest
            if (airTone(across, up) < 1.6 && hashOf(x, y, kSkyDuskSeed + 9U) % 900U == 0U) {
                sky.at(x, y) = blend(sky.at(x, y), kSea4, 150);
            }
        }
    }
    drawStreaks(sky);
    drawZenith(sky, 20, kSkyDuskSeed + 10U);
    // The sun, half down
    for (int y = 0; y < kSkyHeight; ++y) {
        for (int x = 0; x < kSkyWidth; ++x) {
            const double dx = aroundFrom(kSunAcross, acrossOf(x));
            const double dy = upOf(y) - kSunUp;
            const double distance = std::sqrt(dx * dx + dy * dy);
            if (distance < 0.052) {
                sky.at(x, y) = distance < 0.045 ? kSand2 : kBrass2;
            }
        }
    }
    drawRidge(sky, {.low = 0.025,
                    .high = 0.17,
                    .peaks = 22,
                    .sharpness = 0.9,
                    .lit = blend(kPlum, kCoral, 60),
                    .shaded = blend(kPlum, kViolet, 80),
                    .mist = kHazeDusk,
                    .mistHeight = 0.11,
                    .snowLine = 2.0,
                    .snow = kCoral,
                    .seed = kSkyDuskSeed + 20U});
    drawRidge(sky, {.low = 0.015,
                    .high = 0.12,
                    .peaks = 18,
                    .sharpness = 0.7,
                    .lit = blend(kViolet, kPlum, 96),
                    .shaded = blend(kViolet, kNight, 60),
                    .mist = kHazeDusk,
                    .mistHeight = 0.07,
                    .snowLine = 2.0,
                    .snow = kCoral,
                    .seed = kSkyDuskSeed + 31U});
    drawRidge(sky, {.low = 0.004,
                    .high = 0.07,
                    .peaks = 30,
                    .sharpness = 0.1,
                    .lit = blend(kNight, kViolet, 128),
                    .shaded = blend(kNight, kViolet, 70),
                    .mist = kHazeDusk,
                    .mistHeight = 0.034,
                    .snowLine = 2.0,
                    .snow = kCoral,
                    .seed = kSkyDuskSeed + 42U});
    drawHaze(sky, kHazeDusk, 4);
    return sky;
}

}  // namespace slicecast::textures
