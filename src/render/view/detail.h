// Levels of detail: which level of a texture a depth shows. Level m is the number of thresholds T
// (by default 1, 2, 4 ...) with t * N > T * d.
#pragma once

#include "base/bits.h"
#include "render/options.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

struct Detail {
    bool textures = true;
    bool levels = true;
    bool smooth = false;
    double firstThreshold = 1.0;  // times d, in pixels
    double pixelReach = 1.0;      // d: texels at most this deep, times N, are larger than a pixel

    Detail() = default;
    Detail(const RenderOptions& options, double projectionDistance)
        : textures(options.textures),
          levels(options.detail),
          smooth(options.smooth),
          firstThreshold(options.detailThreshold * projectionDistance),
          pixelReach(projectionDistance) {}

    // Whether texels at a depth, of which a level of detail is shown, are blended.
    bool isSmooth(int level, double depth, int size) const {
        return smooth && level == 0 && depth * size <= pixelReach;
    }

    // `size` is the texture's, in texels a side; `last` its last level.
    // #region level-of-detail
    int levelAt(double depth, int size, int last) const {
        if (!textures) return last;
        if (!levels) return 0;
        // The difference of the exponents, rounded up. Exponent bits precede the fraction bits of a
        // double, so one integer subtraction gives it. Exact, because thresholds double and N is a
        // power of two.
        const double reach = depth * size;
        const std::int64_t over =
            bitCast<std::int64_t>(reach) - bitCast<std::int64_t>(firstThreshold);
        constexpr std::int64_t kOne = std::int64_t{1} << 52;
        return static_cast<int>(std::clamp<std::int64_t>((over + kOne - 1) >> 52, 0, last));
    }
    // #endregion
};

}  // namespace slicecast
