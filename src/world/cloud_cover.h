// The shape of clouds all around a sky: how dense they are at each of its points, from noise made
// of whole numbers. See web/docs/picture.md, "Layers of the sky".
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

inline constexpr int kCloudColumns = 1024;    // around the full circle
inline constexpr int kCloudRows = 256;        // upward from the horizon, each two of the sky's
inline constexpr double kMinCloudSize = 0.1;  // the largest clouds, as a share of their height
inline constexpr double kMaxCloudSize = 10.0;

struct CloudCover {
    std::vector<std::uint8_t> density;  // [column * kCloudRows + row], column 0 in the east
};

// Noise of value 0 to 255 at a point, in 1/256 of a cell.
int cloudNoise(std::uint32_t seed, int x, int y);

// Throws nothing; takes some milliseconds.
std::shared_ptr<const CloudCover> makeCloudCover(std::uint32_t seed, double size);

}  // namespace slicecast
