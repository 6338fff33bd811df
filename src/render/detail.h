// Levels of detail: which level of a texture is shown at a depth. Level m is the number of thresholds T (by default 1, 2, 4 ...) with t * N > T * d.
#pragma once

#include "render/options.h"
#include "world/texture.h"

namespace slicecast {

struct Detail {
    bool textures = true;
    bool levels = true;
    double firstThreshold = 1.0;  // times d, pixels

    Detail() = default;
    Detail(const RenderOptions& options, double projectionDistance)
        : textures(options.textures), levels(options.detail), firstThreshold(options.detailThreshold * projectionDistance) {}

    int levelAt(double depth, const Texture& texture) const {
        const int last = static_cast<int>(texture.levels.size()) - 1;
        if (!textures) return last;
        if (!levels) return 0;
        const double reach = depth * texture.size();
        double threshold = firstThreshold;
        int level = 0;
        while (level < last && reach > threshold) {
            ++level;
            threshold *= 2.0;
        }
        return level;
    }
};

}  // namespace slicecast
