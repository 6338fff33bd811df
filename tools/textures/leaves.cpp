#include "leaves.h"

#include <cmath>

namespace slicecast::textures {

void drawLeaf(Surface& surface, const Leaf& leaf) {
    const int reach = static_cast<int>(leaf.length) + 1;
    const int fromX = static_cast<int>(std::floor(leaf.x));
    const int fromY = static_cast<int>(std::floor(leaf.y));
    everyTexelIn(
        fromX - reach, fromY - reach, fromX + reach + 1, fromY + reach + 1, [&](int x, int y) {
            if (leaf.cutOff && (x < 0 || y < 0 || x >= surface.width || y >= surface.height)) {
                return;
            }
            const double dx = x + 0.5 - leaf.x;
            const double dy = y + 0.5 - leaf.y;
            const double along = dx * leaf.direction.x + dy * leaf.direction.y;
            const double across = dy * leaf.direction.x - dx * leaf.direction.y;
            const double share = along / leaf.length;
            if (share < 0.0 || share > 1.0) {
                return;
            }
            const double half =
                leaf.width * 2.0 * std::sqrt(share * (1.0 - share)) * (1.15 - 0.45 * share);
            if (std::abs(across) > half) {
                return;
            }
            const bool towardsLight = leaf.direction.x >= 0.0 ? across < 0.0 : across > 0.0;
            surface.at(x, y) = {.height = leaf.height,
                                .tone = leaf.tone + (towardsLight ? 0.5 : -0.5),
                                .ramp = leaf.ramp};
        });
}

}  // namespace slicecast::textures
