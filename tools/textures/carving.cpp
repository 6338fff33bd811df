#include "carving.h"

#include <array>
#include <cmath>
#include <string_view>

#include "marks.h"
#include "noise.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kCarvingSeed = 2200;

}  // namespace

// Mouldings, a meander, and a row of rosettes, cut in pale stone.
Picture paintFrieze() {
    constexpr int kStep = 4;
    static constexpr std::array<std::string_view, 8> kMeander = {
        "################", "................", "#######.#######.", "#.....#.#.....#.",
        "#.###.#.#.###.#.", "#.#...#.#.#...#.", "#.#####.#.#####.", "................"};
    static constexpr std::array<std::array<double, 2>, 8> kPetals = {{{1.0, 0.0},
                                                                      {0.7071, 0.7071},
                                                                      {0.0, 1.0},
                                                                      {-0.7071, 0.7071},
                                                                      {-1.0, 0.0},
                                                                      {-0.7071, -0.7071},
                                                                      {0.0, -1.0},
                                                                      {0.7071, -0.7071}}};
    Surface surface;
    everyTexel([&](int x, int y) {
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kCarvingSeed + 30U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kStoneRamp;
        texel.tone = 4.4 + 0.8 * blotch;
        if (y < 8) {
            texel.height = 7.0 - 0.3 * std::abs(y - 3);
        } else if (y < 14) {
            texel.height = 5.5 - 0.5 * (y - 8);
        } else if (y >= 18 && y < 50) {
            const bool raised = kMeander[static_cast<std::size_t>((y - 18) / kStep)]
                                        [static_cast<std::size_t>(x / kStep % 16)] == '#';
            texel.height = raised ? 2.0 : 0.0;
            texel.tone -= raised ? 0.0 : 0.7;
        } else if (y >= 50 && y < 56) {
            texel.height = 3.0;
        } else if (y >= 108 && y < 114) {
            texel.height = 3.0;
        } else if (y >= 114) {
            texel.height = 4.0 + 0.25 * (y - 114);
        } else if (y >= 56) {
            texel.tone -= 0.9;
        } else {
            texel.height = 2.0;
        }
    });
    for (const double middleX : {32.0, 96.0}) {
        constexpr double kMiddleY = 82.0;
        everyTexelIn(static_cast<int>(middleX) - 25, 57, static_cast<int>(middleX) + 26, 108,
                     [&](int x, int y) {
                         const double dx = x + 0.5 - middleX;
                         const double dy = y + 0.5 - kMiddleY;
                         const double ring = std::abs(std::sqrt(dx * dx + dy * dy) - 22.5);
                         if (ring < 2.4) {
                             surface.at(x, y).height = 2.5 - ring * 0.6;
                             surface.at(x, y).tone += 0.4;
                         }
                     });
        for (const auto& petal : kPetals) {
            drawStud(surface, {.x = middleX + 12.0 * petal[0],
                               .y = kMiddleY + 12.0 * petal[1],
                               .radius = 5.2,
                               .height = 4.0,
                               .tone = 4.4,
                               .ramp = &kStoneRamp});
        }
        drawStud(surface, {.x = middleX,
                           .y = kMiddleY,
                           .radius = 5.5,
                           .height = 5.0,
                           .tone = 4.6,
                           .ramp = &kStoneRamp});
        // Between the rosettes a standing leaf
        for (int leaf = 0; leaf < 3; ++leaf) {
            const double lean = 7.0 * (leaf - 1);
            for (int step = 0; step < 5; ++step) {
                drawStud(surface, {.x = middleX + 32.0 + lean * step / 5.0,
                                   .y = 102.0 - 8.0 * step + 0.6 * std::abs(lean) * step / 5.0,
                                   .radius = 3.4 - 0.45 * step,
                                   .height = 2.4,
                                   .tone = 4.4,
                                   .ramp = &kStoneRamp});
            }
        }
    }
    return lit(surface, {.gain = 0.5,
                         .lightest = 0.9,
                         .darkest = 1.4,
                         .shadowReach = 4,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.9,
                         .hollowDepth = 0.1});
}

}  // namespace slicecast::textures
