#include "clouds.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "noise.h"
#include "panorama.h"

namespace slicecast::textures {

namespace {

// Places relative to the middle of the cloud's base.
struct Puff {
    double x;
    double y;
    double z;  // towards the viewer
    double radius;
};

// A random way out of a ball that shows on its front: never to the back, seldom down.
Puff outward(Random& random) {
    for (;;) {
        const double x = random.between(-1.0, 1.0);
        const double y = random.between(-0.35, 1.0);
        const double z = random.between(-0.1, 1.0);
        const double length = std::sqrt(x * x + y * y + z * z);
        if (length > 0.2 && length < 1.0) {
            return {x / length, y / length, z / length, 1.0};
        }
    }
}

// Smaller puffs all over the front of a puff, and still smaller ones on those.
void addPuffs(std::vector<Puff>& puffs, const Puff& puff, int depth, Random& random) {
    puffs.push_back(puff);
    if (depth == 0) {
        return;
    }
    const int count = 6 + random.below(3);
    for (int number = 0; number < count; ++number) {
        const Puff way = outward(random);
        const double reach = 0.8 * puff.radius;
        addPuffs(puffs,
                 {puff.x + reach * way.x, puff.y + reach * way.y, puff.z + reach * way.z,
                  puff.radius * random.between(0.34, 0.56)},
                 depth - 1, random);
    }
}

std::vector<Puff> puffsOf(const Cloud& cloud) {
    Random random(cloud.seed);
    std::vector<Puff> puffs;
    constexpr int kHeaps = 11;
    const double summit = random.between(-0.4, 0.4);
    for (int heap = 0; heap < kHeaps; ++heap) {
        const double place = (heap + random.between(0.1, 0.9)) / kHeaps * 2.0 - 1.0;
        const double fromSummit = (place - summit) / (1.0 + std::abs(summit));
        const double dome = 1.0 - fromSummit * fromSummit;
        const double radius = cloud.height * (0.11 + 0.30 * dome * random.between(0.5, 1.1));
        const double rise = cloud.height * 0.5 * dome * random.between(0.15, 1.1);
        addPuffs(
            puffs,
            {place * 0.5 * cloud.width, rise, cloud.height * random.between(-0.4, 0.4), radius}, 2,
            random);
    }
    return puffs;
}

}  // namespace

void drawCloud(Picture& sky, const Cloud& cloud) {
    struct Sample {
        double z = -1.0e9;
        double light = 0.0;
    };
    std::vector<Sample> samples(static_cast<std::size_t>(kSkyWidth) * kSkyHeight);
    const double texelAcross = kAround / kSkyWidth;

    // Which puff is nearest to the viewer, and how it faces the light
    for (const Puff& puff : puffsOf(cloud)) {
        const int left =
            static_cast<int>(std::floor((cloud.across + puff.x - puff.radius) / texelAcross));
        const int right =
            static_cast<int>(std::floor((cloud.across + puff.x + puff.radius) / texelAcross)) + 1;
        for (int y = 0; y < kSkyHeight; ++y) {
            const double dy = (upOf(y) - cloud.base - puff.y) / puff.radius;
            if (dy * dy >= 1.0) {
                continue;
            }
            for (int x = left; x <= right; ++x) {
                const double dx = (acrossOf(x) - cloud.across - puff.x) / puff.radius;
                const double rest = 1.0 - dx * dx - dy * dy;
                if (rest <= 0.0) {
                    continue;
                }
                const double depth = std::sqrt(rest);
                Sample& sample = samples[static_cast<std::size_t>(y) * kSkyWidth +
                                         static_cast<std::size_t>(wrap(x, kSkyWidth))];
                if (puff.z + puff.radius * depth > sample.z) {
                    sample.z = puff.z + puff.radius * depth;
                    sample.light = -0.5 * dx + 0.72 * dy + 0.3 * depth;
                }
            }
        }
    }

    // Colours: the puffs' own light, the shade of the whole cloud towards its base and its right
    for (int y = 0; y < kSkyHeight; ++y) {
        const double rise = (upOf(y) - cloud.base) / cloud.height;
        for (int x = 0; x < kSkyWidth; ++x) {
            const Sample& sample =
                samples[static_cast<std::size_t>(y) * kSkyWidth + static_cast<std::size_t>(x)];
            const double ragged = 0.10 * (fractalNoise(x / 16.0, y / 8.0, kSkyWidth / 16,
                                                       kSkyHeight / 8, 3, cloud.seed) -
                                          0.5);
            if (sample.z < -1.0e8 || rise + ragged < 0.0) {
                continue;
            }
            const double side = aroundFrom(cloud.across, acrossOf(x)) / cloud.width;
            const double body = smoothStep(-0.1, 0.75, rise + 2.0 * ragged) - 0.5 * side;
            const double tone = 1.3 + 1.15 * sample.light + 1.9 * body;
            sky.at(x, y) = blend(colourAt(*cloud.ramp, tone), cloud.haze, cloud.hazeShare);
        }
    }
}

}  // namespace slicecast::textures
