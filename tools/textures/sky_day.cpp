#include <algorithm>
#include <cmath>

#include "clouds.h"
#include "noise.h"
#include "panorama.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kSkyDaySeed = 3000;

constexpr Ramp kDayAir{{kHazeDay, kSea4, kSea3, blend(kSea2, kSea3, 96), blend(kSea1, kSea2, 128)},
                       5};
constexpr Ramp kCumulus{{blend(kSea2, kSlate3, 128), blend(kSea2, kSlate4, 170),
                         blend(kSea3, kSlate5, 128), blend(kSea4, kCream, 110), kCream},
                        5};

// A row of clouds around the sky, evenly placed but for some chance.
struct CloudRow {
    int count;
    double base;
    double width;
    double height;
    int hazeShare;
};

void drawRow(Picture& sky, const CloudRow& row, std::uint32_t seed) {
    Random random(seed);
    for (int number = 0; number < row.count; ++number) {
        const double size = random.between(0.65, 1.25);
        const double across = (number + random.between(0.0, 0.7)) * kAround / row.count;
        drawCloud(sky, {.across = across,
                        .base = row.base * random.between(0.85, 1.15),
                        .width = row.width * size,
                        .height = row.height * size * random.between(0.8, 1.2),
                        .ramp = &kCumulus,
                        .haze = kHazeDay,
                        .hazeShare = row.hazeShare,
                        .seed = seed + 1U + static_cast<std::uint32_t>(number)});
    }
}

}  // namespace

Picture paintSkyDay() {
    Picture sky(kSkyWidth, kSkyHeight);
    for (int y = 0; y < kSkyHeight; ++y) {
        const double up = upOf(y);
        const Colour air = softColourAt(kDayAir, 4.6 * up / (up + 0.18) + 0.2 * up);
        for (int x = 0; x < kSkyWidth; ++x) {
            sky.at(x, y) = air;
        }
    }
    // From the farthest and lowest to the nearest
    drawRow(sky, {.count = 15, .base = 0.085, .width = 0.34, .height = 0.055, .hazeShare = 130},
            kSkyDaySeed);
    drawRow(sky, {.count = 9, .base = 0.17, .width = 0.62, .height = 0.13, .hazeShare = 70},
            kSkyDaySeed + 100U);
    drawRow(sky, {.count = 5, .base = 0.40, .width = 0.95, .height = 0.27, .hazeShare = 16},
            kSkyDaySeed + 200U);
    drawRidge(sky, {.low = 0.02,
                    .high = 0.165,
                    .peaks = 26,
                    .sharpness = 0.9,
                    .lit = blend(kSea3, kSlate4, 100),
                    .shaded = blend(kSea2, kSlate3, 96),
                    .mist = kHazeDay,
                    .mistHeight = 0.09,
                    .snowLine = 0.103,
                    .snow = blend(kSea4, kCream, 120),
                    .seed = kSkyDaySeed + 300U});
    drawRidge(sky, {.low = 0.012,
                    .high = 0.10,
                    .peaks = 20,
                    .sharpness = 0.1,
                    .lit = blend(kMoss4, kSea3, 130),
                    .shaded = blend(kMoss3, kSea2, 128),
                    .mist = kHazeDay,
                    .mistHeight = 0.06,
                    .snowLine = 2.0,
                    .snow = kCream,
                    .seed = kSkyDaySeed + 310U});
    drawRidge(sky, {.low = 0.002,
                    .high = 0.055,
                    .peaks = 28,
                    .sharpness = 0.0,
                    .lit = blend(kMoss4, kSea3, 60),
                    .shaded = blend(kMoss3, kSea2, 64),
                    .mist = kHazeDay,
                    .mistHeight = 0.032,
                    .snowLine = 2.0,
                    .snow = kCream,
                    .seed = kSkyDaySeed + 320U});
    drawHaze(sky, kHazeDay, 4);
    return sky;
}

}  // namespace slicecast::textures
