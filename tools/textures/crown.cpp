#include "crown.h"

#include <algorithm>
#include <cmath>

#include "leaves.h"
#include "noise.h"

namespace slicecast::textures {

void drawLeafage(Surface& surface, const std::vector<Clump>& clumps, const Leafage& leafage) {
    constexpr int kLayers = 4;
    Random random(leafage.seed);
    double base = 0.0;
    for (const Clump& clump : clumps) {
        base += 2.0;  // the next clump stands before this one
        if (leafage.filled) {
            drawBall(surface, {clump.x, clump.y}, 0.9 * clump.radius, 0.82 * clump.radius,
                     {.ramp = leafage.ramp, .tone = 0.8, .height = base, .bulge = 0.0});
        }
        const int count = static_cast<int>(leafage.density * 9.0 * clump.radius * clump.radius /
                                           (leafage.length * leafage.length));
        for (int layer = 0; layer < kLayers; ++layer) {
            for (int number = 0; number < count; ++number) {
                // Evenly over the disc, by trying again outside it
                double u = 0.0;
                double v = 0.0;
                do {
                    u = random.between(-1.0, 1.0);
                    v = random.between(-1.0, 1.0);
                } while (u * u + v * v > 1.0);
                const double light = -0.45 * u - 0.8 * v;
                const double chance = random.fraction();
                const double length = leafage.length * random.between(0.75, 1.2);
                const int way = leafage.hanging ? 2 + random.below(3) : random.below(7);
                const double own = random.between(-0.35, 0.35);
                // The uppermost leaves are those that the light reaches
                if (layer == kLayers - 1 && light < chance - 0.35) {
                    continue;
                }
                drawLeaf(surface, {.x = clump.x + 0.95 * u * clump.radius,
                                   .y = clump.y + 0.88 * v * clump.radius - 0.3 * length,
                                   .direction = kHanging[static_cast<std::size_t>(way)],
                                   .length = length,
                                   .width = leafage.width * length,
                                   .height = base + 1.2 * (layer + 1),
                                   .tone = leafage.tone + leafage.contrast * light +
                                           0.45 * (layer - 2) + own,
                                   .ramp = leafage.ramp,
                                   .cutOff = true});
            }
        }
    }
}

}  // namespace slicecast::textures
