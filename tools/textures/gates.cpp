#include "gates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cutout.h"
#include "marks.h"
#include "noise.h"
#include "shapes.h"
#include "surface.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kGatesSeed = 3000;

constexpr Lighting kGateLight = {.gain = 0.55,
                                 .lightest = 1.1,
                                 .darkest = 1.4,
                                 .shadowReach = 4,
                                 .shadowSlope = 0.7,
                                 .shadowDepth = 1.0};

// One texel of a closed leaf, `across` from its hinge and `down` from its upper edge: boards,
// straps, studs.
Texel leafTexel(int across, int down, int width, int height) {
    constexpr int kBoard = 14;
    const int board = across / kBoard;
    const int inside = std::min(across % kBoard, kBoard - 1 - across % kBoard);
    const auto seed = kGatesSeed + 20U + 10U * static_cast<std::uint32_t>(board);
    Texel texel = {.height = std::min(1.2, 0.7 * inside),
                   .tone = 2.9 + 0.7 * (randomAt(board, 2, kGatesSeed + 12U) - 0.5) +
                           0.9 * woodGrain(down, across, seed) - (inside == 0 ? 1.3 : 0.0),
                   .ramp = &kTimberRamp};
    // A rail of iron around the leaf, and two straps from the hinge
    const int border = std::min({across, width - 1 - across, down, height - 1 - down});
    const int fromStrap = std::min(std::abs(down - 28), std::abs(down - (height - 28)));
    if (border < 3) {
        return {.height = 1.6 - (border == 0 ? 0.8 : 0.0),
                .tone = 2.1 + 0.3 * border,
                .ramp = &kSlateRamp};
    }
    if (fromStrap < 5 && across < width - 8 - 2 * fromStrap) {
        const bool stud = across % 12 >= 5 && across % 12 < 8 && fromStrap < 2;
        return {.height = 2.0 + (stud ? 1.4 : 0.0) - (fromStrap == 4 ? 0.8 : 0.0),
                .tone = stud ? 3.6 : 2.4,
                .ramp = &kSlateRamp};
    }
    // A ring to pull
    const double dx = across + 0.5 - (width - 12.0);
    const double dy = down + 0.5 - 64.0;
    const double off = std::abs(std::sqrt(dx * dx + dy * dy) - 5.0);
    if (off < 1.4) {
        return {.height = 3.0 - off, .tone = 3.4, .ramp = &kBrassRamp};
    }
    return texel;
}

}  // namespace

// A grating of oak shod with iron rises into its slot. It fills the tile, so that wide gates are a
// row of them.
Picture paintPortcullis() {
    constexpr int kSpacing = 32;
    constexpr int kTip = 14;       // length of the spikes
    constexpr double kRise = 116;  // what is left at the end are the spikes
    std::vector<Picture> frames;
    for (int frame = 0; frame < kGateFrames; ++frame) {
        const int risen = static_cast<int>(kRise * frame / (kGateFrames - 1) + 0.5);
        Surface surface = Surface::empty();
        const int foot = kSide - risen;
        everyTexelIn(0, 0, kSide, foot, [&](int x, int y) {
            const int gateY = y + risen;  // the place on the gate, which hangs from above
            const double upright = std::abs(x % kSpacing + 0.5 - kSpacing / 2.0);
            const double level = std::abs(wrap(gateY + 21, 36) + 0.5 - 18.0);
            const int toTip = foot - 1 - y;
            if (toTip < kTip) {
                // Spikes of iron
                if (upright < 0.6 + 5.4 * toTip / kTip) {
                    surface.at(x, y) = {
                        .height = 5.0 - 1.1 * upright, .tone = 3.0, .ramp = &kSlateRamp};
                }
                return;
            }
            if (level < 5.0) {
                surface.at(x, y) = {.height = std::min(2.0, 5.4 - level),
                                    .tone = 2.4 + 0.8 * woodGrain(x, gateY, kGatesSeed + 1U),
                                    .ramp = &kOakRamp};
            }
            if (upright < 6.0) {
                surface.at(x, y) = {.height = 2.0 + std::min(2.0, 6.4 - upright),
                                    .tone = 2.9 + 0.8 * woodGrain(gateY, x, kGatesSeed + 2U),
                                    .ramp = &kOakRamp};
                if (level < 5.0) {
                    // Iron plates where beams cross, with a bolt
                    surface.at(x, y).ramp = &kSlateRamp;
                    surface.at(x, y).tone = 2.5;
                    surface.at(x, y).height += 0.6;
                    if (upright * upright + level * level < 6.5) {
                        surface.at(x, y).height += 1.2;
                        surface.at(x, y).tone = 3.4;
                    }
                }
            }
        });
        frames.push_back(holesFilled(lit(surface, kGateLight), Border::Ends));
    }
    return inARow(frames);
}

// Two leaves in a frame of oak swing away from the viewer.
Picture paintDoubleDoor() {
    // Cosine and sine of the turn in each frame: 0, 13, 26, 39, 52, 65, 77 and 88 degrees
    static constexpr std::array<std::array<double, 2>, kGateFrames> kTurns = {{{1.0, 0.0},
                                                                               {0.9744, 0.2250},
                                                                               {0.8988, 0.4384},
                                                                               {0.7771, 0.6293},
                                                                               {0.6157, 0.7880},
                                                                               {0.4226, 0.9063},
                                                                               {0.2250, 0.9744},
                                                                               {0.0349, 0.9994}}};
    constexpr int kPost = 7;
    constexpr int kLintel = 9;
    constexpr int kWidth = kSide / 2 - kPost;
    constexpr int kHeight = kSide - kLintel;
    constexpr double kDistance =
        260.0;  // of the eye, in texels, for the perspective of a turned leaf
    std::vector<Picture> frames;
    for (const std::array<double, 2>& turn : kTurns) {
        const double cosine = turn[0];
        const double sine = turn[1];
        Surface surface = Surface::empty();
        everyTexelIn(kPost, kLintel, kSide - kPost, kSide, [&](int x, int y) {
            const bool right = x >= kSide / 2;
            const double fromHinge = right ? kSide - kPost - x - 0.5 : x + 0.5 - kPost;
            // Where the line of sight meets the turned leaf; the eye is level with the middle of
            // the door
            const double hingeOff = kSide / 2.0 - kPost;
            const double sight = hingeOff - fromHinge;
            const double denominator = cosine * kDistance + sine * sight;
            const double across = (hingeOff - sight) * kDistance / denominator;
            const double away = 1.0 + across * sine / kDistance;
            const double down = (y + 0.5 - kSide / 2.0) * away + kSide / 2.0 - kLintel;
            if (across < 0.0 || across >= kWidth || down < 0.0 || down >= kHeight) {
                return;
            }
            Texel texel =
                leafTexel(static_cast<int>(across), static_cast<int>(down), kWidth, kHeight);
            // A leaf in the shade of the doorway; the right one keeps more of the light from the
            // left
            texel.tone -= (right ? 0.9 : 1.6) * sine * sine;
            texel.height -= 4.0;
            surface.at(x, y) = texel;
        });
        everyTexel([&](int x, int y) {
            const int side = std::min(x, kSide - 1 - x);
            if (side >= kPost && y >= kLintel) {
                return;
            }
            const bool lintel = y < kLintel;
            const int inside = lintel ? std::min(y + 1, kLintel - 1 - y) : kPost - 1 - side;
            surface.at(x, y) = {.height = std::min(2.0, 0.8 + 0.7 * inside),
                                .tone = 2.6 + 0.9 * (lintel ? woodGrain(x, y, kGatesSeed + 30U)
                                                            : woodGrain(y, x, kGatesSeed + 31U)),
                                .ramp = &kOakRamp};
        });
        for (const int x : {3, kSide - 4}) {
            drawStud(surface, {.x = x + 0.5,
                               .y = 4.5,
                               .radius = 1.8,
                               .height = 1.2,
                               .tone = 3.6,
                               .ramp = &kOakRamp});
        }
        frames.push_back(holesFilled(lit(surface, kGateLight), Border::Ends));
    }
    return inARow(frames);
}

}  // namespace slicecast::textures
