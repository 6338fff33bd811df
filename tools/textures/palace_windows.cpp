#include "palace_windows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cutout.h"
#include "noise.h"
#include "plaster.h"
#include "surface.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kPalaceWindowsSeed = 5200;

// The whole window, in texels from the upper left corner of its head.
constexpr double kWindowMiddle = 64.0;
constexpr double kWindowHalf = 38.0;    // of the opening
constexpr double kWindowSpring = 82.0;  // where the arch begins
constexpr double kWindowSill = 226.0;   // where the opening ends
constexpr double kSurround = 10.0;      // of dressed stone
constexpr double kGlazingBar = 1.7;     // half the thickness of a bar

enum class PaneKind { Glass, Painted, None };

// How far a place lies inside the opening; negative outside it.
double insideOpening(double x, double y) {
    const double dx = std::abs(x - kWindowMiddle);
    if (y < kWindowSpring) {
        const double dy = kWindowSpring - y;
        return kWindowHalf - std::sqrt(dx * dx + dy * dy);
    }
    return std::min(kWindowHalf - dx, kWindowSill - y);
}

// How far it lies from the middle of the nearest bar.
double fromBar(double x, double y) {
    const double dx = x - kWindowMiddle;
    if (y < kWindowSpring - 2.0) {
        // A fan: a half ring and spokes
        const double dy = kWindowSpring - y;
        const double radius = std::sqrt(dx * dx + dy * dy);
        double nearest = std::abs(radius - 15.0);
        if (radius > 15.0) {
            constexpr std::array<std::array<double, 2>, 3> kSpokes = {
                {{0.0, 1.0}, {0.7071, 0.7071}, {-0.7071, 0.7071}}};
            for (const auto& spoke : kSpokes) {
                nearest = std::min(nearest, std::abs(dx * spoke[1] - dy * spoke[0]));
            }
        }
        return nearest;
    }
    const double row = std::fmod(y - kWindowSpring, 36.0);
    return std::min({std::abs(dx), std::abs(std::abs(dx) - 19.0) + 0.6, std::min(row, 36.0 - row)});
}

// The lake as a painter saw it at noon: sky, far mountains, a wooded cape, water, a sail, flowers
// on the sill.
Texel paintedView(double x, double y) {
    constexpr double kHorizon = 158.0;
    Texel texel = {.height = -1.0};
    const double brush = valueNoise(x / 5.0, y / 2.5, 64, 128, kPalaceWindowsSeed) - 0.5;
    if (y < kHorizon) {
        const double cloud = fractalNoise(x / 30.0, y / 13.0, 8, 32, 3, kPalaceWindowsSeed + 1U) -
                             0.0035 * std::abs(y - 92.0);
        texel.ramp = &kSeaRamp;
        texel.tone = 2.5 + 2.0 * y / kHorizon + 0.35 * brush;
        if (cloud > 0.5) {
            texel.tone = std::min(6.0, 4.7 + 7.0 * (cloud - 0.5) + 0.4 * brush);
        }
        const double peaks = kHorizon -
                             30.0 * valueNoise(x / 21.0, 0.5, 16, 2, kPalaceWindowsSeed + 2U) -
                             9.0 * valueNoise(x / 6.0, 0.5, 64, 2, kPalaceWindowsSeed + 3U) - 4.0;
        if (y > peaks) {
            texel.ramp = &kSlateRamp;
            texel.tone = y < peaks + 5.0 && peaks < kHorizon - 27.0
                             ? 6.4
                             : 4.3 + 0.03 * (y - peaks) + 1.2 * brush;
        }
        const double cape = kHorizon - 15.0 * smoothStep(70.0, 98.0, x) -
                            5.0 * valueNoise(x / 4.0, 0.5, 64, 2, kPalaceWindowsSeed + 4U) *
                                smoothStep(66.0, 84.0, x);
        if (x > 66.0 && y > cape) {
            texel.ramp = &kMossRamp;
            texel.tone = 2.6 + 1.2 * brush + (y < cape + 3.0 ? 0.9 : 0.0);
        }
    } else {
        const double near = (y - kHorizon) / (kWindowSill - kHorizon);
        const double ripple =
            valueNoise(x / (5.0 + 12.0 * near), (y - kHorizon) / (1.2 + 2.6 * near), 64, 128,
                       kPalaceWindowsSeed + 5U);
        texel.ramp = &kSeaRamp;
        texel.tone = 3.5 - 1.5 * near + (ripple > 0.66 ? 0.9 : (ripple < 0.25 ? -0.5 : 0.0));
        if (x > 72.0 && near < 0.3 && ripple < 0.7) {
            texel.ramp = &kMossRamp;
            texel.tone = 2.3 + brush;
        }
    }
    // A boat and, broken by the ripples, its reflection
    const double up = 170.0 - y;
    const double sail = 1.0 - up / 31.0;
    if (up > 3.0 && up < 31.0 && x > 47.0 - 11.0 * sail && x < 49.0) {
        texel = {.height = -1.0, .tone = 4.7 + 0.8 * brush, .ramp = &kBrassRamp};
    }
    if (up > 5.0 && up < 27.0 && x > 50.0 && x < 50.0 + 8.0 * (1.0 - up / 27.0)) {
        texel = {.height = -1.0, .tone = 3.6 + 0.8 * brush, .ramp = &kCrimsonRamp};
    }
    if (up > -1.0 && up <= 3.0 && std::abs(x - 48.0) < 10.0 + up) {
        texel = {.height = -1.0, .tone = 2.0, .ramp = &kOakRamp};
    }
    if (up <= -1.0 && up > -16.0 && std::abs(x - 46.5) < 6.0 && std::fmod(-up, 4.0) < 1.7) {
        texel = {.height = -1.0, .tone = 3.6, .ramp = &kBrassRamp};
    }
    // Flowers
    const double bed =
        kWindowSill - 9.0 - 7.0 * valueNoise(x / 6.0, 1.5, 64, 4, kPalaceWindowsSeed + 6U);
    if (y > bed) {
        const double leaf = valueNoise(x / 2.0, y / 2.0, 64, 128, kPalaceWindowsSeed + 7U);
        const double flower =
            randomAt(static_cast<int>(x) / 3, static_cast<int>(y) / 3, kPalaceWindowsSeed + 8U);
        texel = {.height = 0.0, .tone = 1.8 + 2.8 * leaf, .ramp = &kMossRamp};
        if (flower > 0.8) {
            texel = {.height = 0.6,
                     .tone = 3.8 + 1.4 * leaf,
                     .ramp = flower > 0.93 ? &kBrassRamp : &kCrimsonRamp};
        }
    }
    return texel;
}

// Clear glass with the light of the sky slanting over the whole window.
Texel palaceGlass(double x, double y) {
    const double slant = std::fmod(x + y + 20.0, 92.0);
    const bool broad = slant > 40.0 && slant < 54.0;
    const bool narrow = slant > 58.0 && slant < 62.0;
    return {.height = -1.0,
            .tone = broad || narrow ? 5.2 : 4.0,
            .ramp = &kSeaRamp,
            .alpha = static_cast<std::uint8_t>(broad ? 74 : (narrow ? 60 : 26))};
}

// The whole of it, so that no light breaks where foot and head meet.
Picture paintWindow(PaneKind panes) {
    const Surface whitewash = whitewashSurface();
    Surface wall(kSide, 2 * kSide);
    everyTexelIn(0, 0, kSide, 2 * kSide, [&](int x, int y) { wall.at(x, y) = whitewash.at(x, y); });
    Surface surface = wall;
    everyTexelIn(0, 0, kSide, 2 * kSide, [&](int column, int row) {
        const double x = column + 0.5;
        const double y = row + 0.5;
        const double inside = insideOpening(x, y);
        const bool sill = y >= kWindowSill && y < kWindowSill + 12.0 &&
                          std::abs(x - kWindowMiddle) < kWindowHalf + kSurround + 4.0;
        Texel& texel = surface.at(column, row);
        if (sill) {
            texel = {.height = 4.0, .tone = 4.6 - 0.06 * (y - kWindowSill), .ramp = &kSandRamp};
        } else if (inside > 0.0) {
            const double bar = fromBar(x, y);
            if (panes == PaneKind::None) {
                texel = {.height = -2.0, .alpha = 0};
            } else if (inside < 3.0 || bar < kGlazingBar) {
                texel = {.height = 1.0,
                         .tone = inside < 3.0 ? 3.1 : 3.3 - 0.5 * bar,
                         .ramp = &kBrassRamp};
            } else {
                texel = panes == PaneKind::Glass ? palaceGlass(x, y) : paintedView(x, y);
                // The surround's shadow: a painter paints it, too
                if (panes == PaneKind::Painted && (insideOpening(x - 5.0, y - 5.0) < 3.0)) {
                    texel.tone -= 0.8;
                }
            }
        } else if (inside > -kSurround && y < kWindowSill) {
            const double edge = std::min(-inside, kSurround + inside);
            const double grain =
                fractalNoise(x / 8.0, y / 8.0, 16, 32, 2, kPalaceWindowsSeed + 9U) - 0.5;
            // Blocks beside the opening, wedges around the arch
            double joint = std::fmod(y - kWindowSpring, 24.0);
            if (y < kWindowSpring) {
                const double dx = x - kWindowMiddle;
                const double dy = kWindowSpring - y;
                joint = 99.0;
                constexpr std::array<std::array<double, 2>, 5> kCrossings = {
                    {{0.9239, 0.3827}, {0.5, 0.866}, {-0.5, 0.866}, {-0.9239, 0.3827}, {1.0, 0.0}}};
                for (const auto& direction : kCrossings) {
                    joint = std::min(joint, std::abs(dx * direction[1] - dy * direction[0]));
                }
            }
            texel = {.height = 2.0 + std::min(1.5, edge),
                     .tone = joint < 0.8 ? 2.0 : 3.7 + 1.1 * grain,
                     .ramp = &kSandRamp};
            if (y < kWindowSpring && std::abs(x - kWindowMiddle) < 6.5) {
                texel = {.height = 5.0, .tone = 3.1 + grain, .ramp = &kBrassRamp};
            }
        }
    });
    const Picture picture = litOver(wall, plasterLighting(), surface,
                                    {.gain = 0.4,
                                     .lightest = 0.8,
                                     .darkest = 1.2,
                                     .shadowReach = 3,
                                     .shadowSlope = 0.8,
                                     .shadowDepth = 0.7,
                                     .hollowDepth = 0.0});
    return panes == PaneKind::Painted ? picture : holesFilled(picture, Border::Repeats);
}

Picture paintPart(int top, PaneKind panes) {
    const Picture window = paintWindow(panes);
    Picture part(kSide, kSide);
    everyTexel([&](int x, int y) { part.at(x, y) = window.at(x, top + y); });
    return part;
}

}  // namespace

Picture paintPalaceWindowFoot() {
    return paintPart(kSide, PaneKind::Glass);
}

Picture paintPalaceWindowHead() {
    return paintPart(0, PaneKind::Glass);
}

Picture paintPalaceOpeningFoot() {
    return paintPart(kSide, PaneKind::None);
}

Picture paintPalaceOpeningHead() {
    return paintPart(0, PaneKind::None);
}

Picture paintPaintedWindowFoot() {
    return paintPart(kSide, PaneKind::Painted);
}

Picture paintPaintedWindowHead() {
    return paintPart(0, PaneKind::Painted);
}

}  // namespace slicecast::textures
