// Finds which levels the rays of some rows pass.
#pragma once

#include "base/bits.h"
#include "render/view/projection.h"
#include "world/map.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

// The heights between which the rays of open rows run.
class OpenSlopes {
public:
    // For the rows [first, last). The rays run above the height `low`, units.
    OpenSlopes(const Projection& projection, int first, int last, double eyeHeight, double low)
        : low_(low - kSlack),
          highestEye_(eyeHeight + kSlack),
          lowestEye_(eyeHeight - kSlack),
          upper_(projection.horizon - first),
          lower_(projection.horizon - last) {}

    // A bit for each level that the rays pass in a tile.
    __attribute__((always_inline)) std::uint32_t levelsReached(double entered, double left) const {
        const double highest = highestEye_ + upper_ * (upper_ > 0.0 ? left : entered);
        const double lowest = std::max(low_, lowestEye_ + lower_ * (lower_ < 0.0 ? left : entered));
        if (highest < 0.0 || lowest >= kMaxLevels) return 0;
        // Rounded down. The slack moves heights exactly on a level's edge to its outer side.
        const int top = highest >= kMaxLevels
                            ? kMaxLevels - 1
                            : std::max(0, static_cast<int>(nearestInteger(highest - 0.5)));
        const int bottom = lowest <= 0.5 ? 0 : static_cast<int>(nearestInteger(lowest - 0.5));
        return static_cast<std::uint32_t>((std::uint64_t{2} << top) - (std::uint64_t{1} << bottom));
    }

private:
    static constexpr double kSlack = 1.0 / 65536.0;  // units; far more than rounding errors

    double low_;
    double highestEye_;
    double lowestEye_;
    double upper_;
    double lower_;
};

}  // namespace slicecast
