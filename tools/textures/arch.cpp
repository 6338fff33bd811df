#include "arch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cutout.h"
#include "noise.h"
#include "stonework.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kArchSeed = 1800;
constexpr double kArchMiddle = 63.5;
constexpr double kArchSpring = 54.0;  // where the arch begins
constexpr double kArchRadius = 37.0;
constexpr double kArchRing = 12.0;

// Joints of the arch's wedges: directions every 22.5 degrees, upwards half
constexpr std::array<std::array<double, 2>, 9> kJoints = {{{-1.0, 0.0},
                                                           {-0.9239, -0.3827},
                                                           {-0.7071, -0.7071},
                                                           {-0.3827, -0.9239},
                                                           {0.0, -1.0},
                                                           {0.3827, -0.9239},
                                                           {0.7071, -0.7071},
                                                           {0.9239, -0.3827},
                                                           {1.0, 0.0}}};

}  // namespace

double outsideArch(int x, int y) {
    const double dx = x - kArchMiddle;
    const double dy = y - kArchSpring;
    return (dy < 0.0 ? std::sqrt(dx * dx + dy * dy) : std::abs(dx)) - kArchRadius;
}

void drawArch(Surface& surface) {
    everyTexel([&](int x, int y) {
        const double dx = x - kArchMiddle;
        const double dy = y - kArchSpring;
        const double outside = outsideArch(x, y);
        if (outside <= 0.0 || outside > kArchRing) {
            return;
        }
        double joint = 9.0;
        int stone = 0;
        if (dy < 0.0) {
            // Shifted by half a wedge, so that a keystone stands in the middle
            for (std::size_t index = 0; index + 1 < kJoints.size(); ++index) {
                const double x0 = kJoints[index][0] + kJoints[index + 1][0];
                const double y0 = kJoints[index][1] + kJoints[index + 1][1];
                const double length = std::sqrt(x0 * x0 + y0 * y0);
                const double side = (x0 * dy - y0 * dx) / length;
                joint = std::min(joint, std::abs(side) + 0.4);
                stone += side > 0.0 ? 1 : 0;
            }
        } else {
            const int down = y - static_cast<int>(kArchSpring);
            const int local = down % 18;
            joint = std::min(local, 17 - local) + 0.5;
            stone = 20 + down / 18 + (dx > 0.0 ? 10 : 0);
        }
        const double inside = std::min({joint, outside, kArchRing - outside});
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kArchSeed + 10U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kStoneRamp;
        texel.height = std::clamp((inside - 0.4) * 0.9, 0.0, 2.2) + 1.5;
        texel.tone = inside < 0.8
                         ? 1.6
                         : 4.4 + 0.8 * (randomAt(stone, 1, kArchSeed + 11U) - 0.5) + 0.9 * blotch;
    });
}

Picture paintArchway() {
    const Surface wall = ashlarSurface();
    Surface surface = wall;
    everyTexel([&](int x, int y) {
        if (outsideArch(x, y) <= 0.0) {
            surface.at(x, y) = {.height = 0.0, .tone = 2.0, .ramp = &kStoneRamp, .alpha = 0};
        }
    });
    drawArch(surface);
    return holesFilled(litOver(wall, ashlarLighting(), surface,
                               {.gain = 0.5,
                                .lightest = 0.9,
                                .darkest = 1.3,
                                .shadowReach = 5,
                                .shadowSlope = 0.7,
                                .shadowDepth = 1.0,
                                .hollowDepth = 0.06}),
                       Border::Repeats);
}

}  // namespace slicecast::textures
