#include "fountain.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cutout.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kFountainSeed = 4200;
constexpr int kFountainWidth = 120;
constexpr int kFountainHeight = 132;
constexpr double kFountainMiddle = kFountainWidth / 2.0;
constexpr double kNozzle = kFountainHeight - 12.0;
constexpr double kPool = kFountainHeight - 6.0;

// A stream leaves the nozzle, rises and falls: its place at an age from 0 to 1.
struct Stream {
    double reach;   // sideways, in texels
    double height;  // of its top above the nozzle
};

Place placeOn(const Stream& stream, double age) {
    const double up = 4.0 * stream.height * age * (1.0 - age);
    return {kFountainMiddle + stream.reach * age, kNozzle - up + (kPool - kNozzle) * age};
}

}  // namespace

Picture paintFountain() {
    constexpr Stream kStreams[] = {{-50.0, 66.0},  {50.0, 66.0},  {-33.0, 88.0}, {33.0, 88.0},
                                   {-15.0, 100.0}, {15.0, 100.0}, {-3.0, 108.0}};
    constexpr int kDrops =
        9;  // along one stream at a time; each moves on to the place of the next in a loop
    std::vector<Picture> frames;
    for (int frame = 0; frame < kFountainFrames; ++frame) {
        const double time = static_cast<double>(frame) / kFountainFrames;
        Surface surface = Surface::empty(kFountainWidth, kFountainHeight);
        // Where it falls into the pool: foam and rings
        drawBall(surface, {kFountainMiddle, kPool + 1.0}, 57.0, 6.5,
                 {.ramp = &kSeaRamp, .tone = 3.2, .bulge = 0.0, .alpha = 150});
        for (int ring = 0; ring < 3; ++ring) {
            const double spread = (ring + time) / 3.0;
            everyTexelOn(surface, 0.0, kPool - 8.0, kFountainWidth, kFountainHeight,
                         [&](int x, int y) {
                             const double dx = (x + 0.5 - kFountainMiddle) / 55.0;
                             const double dy = (y + 0.5 - kPool - 1.0) / 6.0;
                             const double off = std::sqrt(dx * dx + dy * dy) - spread;
                             if (std::abs(off) < 0.05 && surface.at(x, y).alpha > 0) {
                                 surface.at(x, y).tone = 4.6;
                                 surface.at(x, y).alpha = 190;
                             }
                         });
        }
        // A veil of fine drops inside the streams
        everyTexelOn(surface, 0.0, 0.0, kFountainWidth, kPool, [&](int x, int y) {
            const double off = std::abs(x + 0.5 - kFountainMiddle) / 44.0;
            const double up = (kNozzle - y) / 104.0;
            if (off < 1.0 && up < 1.0 - off * off) {
                const double fall =
                    valueNoise(x / 2.0, (y - time * 64.0) / 8.0, 64, 8, kFountainSeed) *
                    (1.0 - 0.5 * off);
                if (fall > 0.55) {
                    surface.at(x, y) = {
                        .height = 0.0,
                        .tone = 4.6,
                        .ramp = &kSeaRamp,
                        .alpha = static_cast<std::uint8_t>(46.0 + 120.0 * (fall - 0.55))};
                }
            }
        });
        for (const Stream& stream : kStreams) {
            // The stream itself: whole at the nozzle, thinner and torn where it falls
            constexpr int kParts = 48;
            for (int part = 0; part < kParts; ++part) {
                const double age = static_cast<double>(part) / kParts;
                const double next = static_cast<double>(part + 1) / kParts;
                const double radius = 2.2 - 0.5 * age;
                drawLimb(surface, placeOn(stream, age), radius, placeOn(stream, next), radius,
                         {.ramp = &kSeaRamp,
                          .tone = 4.3 - 0.6 * age,
                          .height = 1.0,
                          .bulge = 0.4,
                          .alpha = static_cast<std::uint8_t>(190.0 - 60.0 * age)});
            }
            for (int drop = 0; drop < kDrops; ++drop) {
                const double age = (drop + time) / kDrops;
                const double wide = 1.3 + 0.8 * age;
                const double later = std::min(1.0, age + 0.06 - 0.02 * age);
                drawLimb(surface, placeOn(stream, age), wide, placeOn(stream, later), wide * 0.8,
                         {.ramp = &kSeaRamp,
                          .tone = 5.5 - 0.6 * age,
                          .height = 2.0,
                          .bulge = 0.5,
                          .alpha = 215});
                // Drops torn off to either side
                const double aside =
                    5.0 * age *
                    (randomAt(drop % 3, static_cast<int>(stream.reach), kFountainSeed + 1U) - 0.5) *
                    2.0;
                const Place place = placeOn(stream, std::min(1.0, age + 0.02));
                if (age > 0.4) {
                    drawBall(surface, {place.x + aside, place.y - 2.0}, 1.3, 1.5,
                             {.ramp = &kSeaRamp,
                              .tone = 5.4,
                              .height = 3.0,
                              .bulge = 0.4,
                              .alpha = 210});
                }
            }
        }
        for (const Stream& stream : kStreams) {
            const double splash =
                wave(time + randomAt(static_cast<int>(stream.reach), 2, kFountainSeed + 2U));
            drawBall(surface, {kFountainMiddle + stream.reach, kPool}, 5.5 + 0.8 * splash,
                     2.6 + 0.5 * splash,
                     {.ramp = &kSeaRamp, .tone = 5.6, .height = 2.0, .bulge = 0.5, .alpha = 215});
        }
        frames.push_back(spriteOf(
            surface,
            {.gain = 0.25, .lightest = 0.6, .darkest = 0.6, .shadowReach = 0, .hollowDepth = 0.0}));
    }
    return inARow(frames);
}

}  // namespace slicecast::textures
