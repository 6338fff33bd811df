#include "liquids.h"

#include <algorithm>
#include <cmath>

#include "cutout.h"
#include "loops.h"
#include "noise.h"
#include "pieces.h"
#include "surface.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kLiquidsSeed = 2800;
constexpr int kSprayWidth = 128;
constexpr int kSprayHeight = 64;
constexpr Lighting kLiquidLight = {.gain = 0.0, .lightest = 0.0, .darkest = 0.0, .shadowReach = 0};

template <typename PaintFrame>
Picture framesOf(PaintFrame paintFrame) {
    std::vector<Picture> frames;
    for (int frame = 0; frame < kLoopFrames; ++frame) {
        frames.push_back(paintFrame(static_cast<double>(frame) / kLoopFrames));
    }
    return inARow(frames);
}

int rounded(double value) {
    return static_cast<int>(std::floor(value + 0.5));
}

// The net of light on water, drawn like the still texture's, swaying and breathing.
Picture waterFrame(double time, bool clear) {
    static const Pieces net(nearest(spreadPoints(26, 1.7, kLiquidsSeed + 70U), 1.7), 5.0,
                            kLiquidsSeed + 71U);
    Surface surface;
    everyTexel([&](int x, int y) {
        const double swayX =
            9.0 * (loopNoise(x / 32.0, y / 32.0, 4, 4, time, 4, kLiquidsSeed + 74U) - 0.5);
        const double swayY =
            7.0 * (loopNoise(x / 32.0, y / 32.0, 4, 4, time, 4, kLiquidsSeed + 75U) - 0.5);
        const double swell = loopFractal((x + 1.5 * swayY) / 32.0, (y + 1.5 * swayX) / 16.0, 4, 8,
                                         time, 4, 3, kLiquidsSeed + 72U) -
                             0.5;
        const double bright =
            3.2 * (loopFractal(x / 16.0, y / 16.0, 8, 8, time, 4, 2, kLiquidsSeed + 73U) - 0.42);
        const double inside = net.edgeAt(x + rounded(swayX), y + rounded(swayY));
        Texel& texel = surface.at(x, y);
        texel.ramp = &kSeaRamp;
        texel.tone = 1.9 + 1.1 * swell;
        const int crest = (inside < bright + 1.2 ? 1 : 0) + (inside < bright ? 1 : 0) +
                          (inside < bright - 0.8 ? 1 : 0);
        texel.tone += crest == 0 ? 0.0 : 0.5 + 0.65 * (crest - 1);
        if (clear) {
            texel.alpha = static_cast<std::uint8_t>(
                std::clamp(164 + rounded(20.0 * swell) + 12 * crest, 160, 200));
        }
    });
    return lit(surface, kLiquidLight);
}

}  // namespace

// Dark crust drifting on a glow; the cracks between the plates open and close.
Picture paintLava() {
    static const Pieces plates(nearest(spreadPoints(15, 1.0, kLiquidsSeed + 1U), 1.0), 6.0,
                               kLiquidsSeed + 2U);
    return framesOf([](double time) {
        Surface surface;
        everyTexel([&](int x, int y) {
            const double driftX =
                10.0 * (loopNoise(x / 32.0, y / 32.0, 4, 4, time, 4, kLiquidsSeed + 3U) - 0.5);
            const double driftY =
                10.0 * (loopNoise(x / 32.0, y / 32.0, 4, 4, time, 4, kLiquidsSeed + 4U) - 0.5);
            const int fromX = x + rounded(driftX);
            const int fromY = y + rounded(driftY);
            const double inside = plates.edgeAt(fromX, fromY);
            const double heat =
                loopFractal(x / 32.0, y / 32.0, 4, 4, time, 4, 2, kLiquidsSeed + 5U);
            const double width = 1.2 + 6.0 * smoothStep(0.35, 0.75, heat);
            const double grain =
                fractalNoise(fromX / 8.0, fromY / 8.0, 16, 16, 3, kLiquidsSeed + 6U) - 0.5;
            const double churn =
                loopFractal(x / 8.0, y / 8.0, 16, 16, time, 4, 2, kLiquidsSeed + 7U) - 0.5;
            Texel& texel = surface.at(x, y);
            texel.ramp = &kFireRamp;
            if (inside < width) {
                // The melt: whitest in the middle of a crack
                texel.tone = 6.6 - 2.0 * inside / width + 1.3 * churn;
                texel.height = 0.0;
                return;
            }
            const double rim = smoothStep(5.0, 0.0, inside - width);
            texel.tone = 1.0 + 2.1 * rim * (0.5 + heat) + 1.5 * grain + 0.5 * (heat - 0.5);
            texel.height = std::min(3.0, 0.8 * (inside - width)) + 2.5 * grain;
        });
        return lit(
            surface,
            {.gain = 0.35, .lightest = 0.6, .darkest = 0.7, .shadowReach = 0, .hollowDepth = 0.0});
    });
}

Picture paintWaterSurface() {
    return framesOf([](double time) { return waterFrame(time, false); });
}

Picture paintWaterClear() {
    return framesOf([](double time) { return waterFrame(time, true); });
}

// Three layers that fall by whole textures in a loop, the nearer ones faster: a sheet of water in
// broad folds, strands before it, and gushes of foam whose lower edges are bright.
Picture paintWaterfall() {
    return framesOf([](double time) {
        Surface surface;
        const double slow = time * kSide;
        const double middle = 2.0 * time * kSide;
        const double fast = 3.0 * time * kSide;
        everyTexel([&](int x, int y) {
            // Folds stand nearly still; the water slides along them
            const double bend =
                4.0 * (loopNoise(x / 16.0, y / 64.0, 8, 2, time, 1, kLiquidsSeed + 20U) - 0.5);
            const double fold =
                fractalNoise((x + bend) / 16.0, (y - slow) / 128.0, 8, 1, 2, kLiquidsSeed + 21U);
            const double strand =
                valueNoise((x + bend) / 4.0, (y - middle) / 64.0, 32, 2, kLiquidsSeed + 22U);
            const double thread =
                valueNoise((x + bend) / 2.0, (y - fast) / 64.0, 64, 2, kLiquidsSeed + 23U);
            // Gushes of foam: threads that are brightest at their lower ends
            const auto gushAt = [&](double down) {
                return fractalNoise(8.0 * (x + bend) / kSide, 2.0 * (y - middle + down) / kSide, 8,
                                    2, 2, kLiquidsSeed + 24U);
            };
            const double gush = gushAt(0.0);
            const double head = std::max(0.0, gush - gushAt(8.0));
            const double tear =
                valueNoise((x + bend) / 2.0, (y - middle) / 16.0, 64, 8, kLiquidsSeed + 25U);
            const double foam =
                3.0 * (gush - 0.52) + 1.6 * head + 1.3 * (tear - 0.55) + 0.4 * (strand - 0.5);
            Texel& texel = surface.at(x, y);
            texel.ramp = &kSeaRamp;
            texel.tone = 2.3 + 1.8 * (fold - 0.5) + 1.6 * (strand - 0.5);
            texel.tone += thread > 0.74 ? 0.8 : thread < 0.22 ? -0.5 : 0.0;
            texel.tone += 3.2 * smoothStep(0.0, 1.1, foam);
            const double thick = smoothStep(0.25, 0.75, 0.5 * fold + 0.5 * strand);
            texel.alpha = static_cast<std::uint8_t>(
                176 + rounded(56.0 * thick + (79.0 - 56.0 * thick) * smoothStep(0.0, 0.5, foam)));
        });
        return lit(surface, kLiquidLight);
    });
}

// Foam and spray where a fall ends: boiling, and rising as mist.
Picture paintSpray() {
    return framesOf([](double time) {
        Surface surface = Surface::empty(kSprayWidth, kSprayHeight);
        const double risen = time * kSprayHeight;
        everyTexelIn(0, 0, kSprayWidth, kSprayHeight, [&](int x, int y) {
            const double up = (kSprayHeight - 1.0 - y) / kSprayHeight;
            const double aside = std::abs(2.0 * (x + 0.5) / kSprayWidth - 1.0);
            const double puff = fractalNoise(x / 16.0, (y + risen) / 16.0, 8, kSprayHeight / 16, 3,
                                             kLiquidsSeed + 30U);
            const double boil =
                loopFractal(x / 8.0, y / 8.0, 16, 8, time, 4, 2, kLiquidsSeed + 31U);
            const double thick = 1.15 - 1.5 * up - 0.8 * aside * aside * aside +
                                 1.5 * (puff - 0.5) + 0.5 * (boil - 0.5) -
                                 (0.5 + boil) * (1.0 - smoothStep(0.0, 0.18, up));
            if (thick <= 0.12) {
                return;
            }
            surface.at(x, y) = {
                .height = 0.0,
                .tone = 3.7 + 2.2 * smoothStep(0.1, 0.9, thick) + 1.2 * (boil - 0.5),
                .ramp = &kSeaRamp,
                .alpha = static_cast<std::uint8_t>(
                    std::clamp(rounded(215.0 * smoothStep(0.0, 0.95, thick)), 1, 255))};
        });
        return holesFilled(lit(surface, kLiquidLight), Border::Ends);
    });
}

}  // namespace slicecast::textures
