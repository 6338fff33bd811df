#include "panorama.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "noise.h"

namespace slicecast::textures {

namespace {

double ridgeHeight(const Ridge& ridge, double column) {
    const double place = column * ridge.peaks / kSkyWidth;
    const double round = fractalNoise(place, 0.0, ridge.peaks, 1, 5, ridge.seed);
    const double bent = valueNoise(place, 0.0, ridge.peaks, 1, ridge.seed + 50U);
    const double pointed =
        0.72 * (1.0 - std::abs(2.0 * bent - 1.0)) +
        0.28 * fractalNoise(place * 4.0, 0.0, ridge.peaks * 4, 1, 3, ridge.seed + 60U);
    const double broad = 0.55 + 0.45 * valueNoise(place / 4.0, 0.0, std::max(1, ridge.peaks / 4), 1,
                                                  ridge.seed + 70U);
    const double height = round * (1.0 - ridge.sharpness) + pointed * broad * ridge.sharpness;
    return ridge.low + (ridge.high - ridge.low) * height;
}

}  // namespace

double aroundFrom(double from, double to) {
    const double difference = to - from;
    return difference - kAround * std::floor(difference / kAround + 0.5);
}

void drawRidge(Picture& sky, const Ridge& ridge) {
    for (int x = 0; x < kSkyWidth; ++x) {
        const double top = ridgeHeight(ridge, x);
        for (int y = 0; y < kSkyHeight; ++y) {
            const double up = upOf(y);
            if (up > top) {
                continue;
            }
            // Spurs run down from the peaks to the right; their left sides take the light
            const double below = (top - up) * kSkyHeight;
            const double from = x - 0.9 * below;
            const double wobble = 14.0 * fractalNoise(x / 32.0, y / 16.0, kSkyWidth / 32,
                                                      kSkyHeight / 16, 3, ridge.seed + 80U);
            const bool inLight =
                ridgeHeight(ridge, from + wobble - 3.0) > ridgeHeight(ridge, from + wobble - 11.0);
            Colour colour = inLight ? ridge.lit : ridge.shaded;
            if (up + 0.004 * (wobble - 7.0) > ridge.snowLine) {
                colour = inLight ? ridge.snow : blend(ridge.snow, ridge.shaded, 128);
            }
            const double mist = 1.0 - smoothStep(0.0, ridge.mistHeight, up);
            sky.at(x, y) = blend(colour, ridge.mist, static_cast<int>(16.0 * mist) * 16);
        }
    }
}

void drawHaze(Picture& sky, Colour haze, int rows) {
    for (int row = 0; row < rows; ++row) {
        const int share = 256 * (rows - row) / rows;
        for (int x = 0; x < kSkyWidth; ++x) {
            Colour& colour = sky.at(x, kSkyHeight - 1 - row);
            colour = blend(colour, haze, share);
        }
    }
}

void drawZenith(Picture& sky, int rows, std::uint32_t seed) {
    std::map<Pixel, int> counts;
    for (int x = 0; x < kSkyWidth; ++x) ++counts[toPixel(sky.at(x, 0))];
    const auto commonest =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const Colour zenith = toColour(commonest->first);
    // Pixel by pixel, so that no further colours arise
    for (int y = 0; y < rows; ++y) {
        const auto share = static_cast<std::uint32_t>(256 * (rows - y) / rows);
        for (int x = 0; x < kSkyWidth; ++x)
            if (hashOf(x, y, seed) % 256U < share) sky.at(x, y) = zenith;
    }
}

}  // namespace slicecast::textures
