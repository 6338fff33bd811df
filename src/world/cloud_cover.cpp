#include "world/cloud_cover.h"

#include "base/angle.h"
#include "base/random.h"
#include "world/sky.h"

#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

constexpr int kOctaves = 4;

int corner(std::uint32_t seed, int x, int y) {
    const auto part = [](int number) { return static_cast<std::uint64_t>(number & 0xffff); };
    return static_cast<int>(Random(seed | part(x) << 32 | part(y) << 48).next() >> 56);
}

}  // namespace

int cloudNoise(std::uint32_t seed, int x, int y) {
    const auto weight = [](int at) {
        const int f = at & 255;
        return f * f * (768 - 2 * f) >> 16;
    };
    const int w = weight(x);
    const auto across = [&](int row) {
        const int left = corner(seed, x >> 8, row);
        return (left << 8) + (corner(seed, (x >> 8) + 1, row) - left) * w;
    };
    const int upper = across(y >> 8);
    return ((upper << 8) + (across((y >> 8) + 1) - upper) * weight(y)) >> 16;
}

std::shared_ptr<const CloudCover> makeCloudCover(std::uint32_t seed, double size) {
    auto cover = std::make_shared<CloudCover>();
    cover->density.resize(static_cast<std::size_t>(kCloudColumns) * kCloudRows);
    std::uint8_t* out = cover->density.data();
    for (int column = 0; column < kCloudColumns; ++column) {
        const SineCosine way = sineCosineDegrees((column + 0.5) * 360.0 / kCloudColumns);
        for (int row = 0; row < kCloudRows; ++row) {
            // The clouds hang in one plane, which bends down to the horizon
            const double slope = (2 * row + 1) / static_cast<double>(kSkyRowsPerSlope) + 0.15;
            const double scale = 512.0 / size / slope;
            const auto x = static_cast<int>(std::floor(way.cosine * scale));
            const auto y = static_cast<int>(std::floor(way.sine * scale));
            int sum = 0;
            for (int octave = 0; octave < kOctaves; ++octave) {
                sum +=
                    cloudNoise(seed + static_cast<std::uint32_t>(octave), x << octave, y << octave)
                    << (kOctaves - 1 - octave);
            }
            *out++ = static_cast<std::uint8_t>(sum / 15);
        }
    }
    return cover;
}

}  // namespace slicecast
