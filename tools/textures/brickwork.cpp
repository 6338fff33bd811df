#include "brickwork.h"

#include <algorithm>
#include <cmath>

#include "marks.h"
#include "noise.h"
#include "pieces.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kBrickworkSeed = 11;

const Pieces& bricks() {
    static const Pieces pieces(
        [] {
            std::vector<Course> courses;
            for (int course = 0; course < kSide / kBrickHeight; ++course) {
                const int offset = course % 2 == 0 ? 0 : kBrickWidth / 2;
                courses.push_back(
                    {kBrickHeight, offset, std::vector<int>(kSide / kBrickWidth, kBrickWidth)});
            }
            return coursed(courses);
        }(),
        0.0, kBrickworkSeed);
    return pieces;
}

double brickVariation(int piece) {
    const double spread = randomAt(piece, 1, kBrickworkSeed) - 0.5;
    return spread * 1.3;
}

bool isBurnt(int piece) {
    return hashOf(piece, 2, kBrickworkSeed) % 7U == 0U;
}

bool isBrick(const Surface& surface, int x, int y) {
    return surface.at(x, y).height > 0.6;
}

}  // namespace

Lighting brickLighting() {
    return {.gain = 0.55,
            .lightest = 0.8,
            .darkest = 1.4,
            .shadowReach = 2,
            .shadowSlope = 0.5,
            .shadowDepth = 1.2};
}

Surface brickSurface() {
    Surface surface;
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        const int piece = bricks().pieceAt(x, y);
        const double ragged =
            0.7 * (valueNoise(x / 4.0, y / 4.0, 32, 32, kBrickworkSeed + 3U) - 0.35);
        const double inside = bricks().edgeAt(x, y) - 0.6 - std::max(0.0, ragged);
        texel.height = std::clamp(inside, 0.0, 1.6);
        if (inside <= 0.0) {
            texel.ramp = &kStoneRamp;
            texel.tone =
                3.1 + 0.8 * (valueNoise(x / 8.0, y / 8.0, 16, 16, kBrickworkSeed + 4U) - 0.5);
            return;
        }
        const double blotch = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kBrickworkSeed + 5U) - 0.5;
        texel.ramp = isBurnt(piece) ? &kBurntRamp : &kClayRamp;
        texel.tone = (isBurnt(piece) ? 3.4 : 3.25) + brickVariation(piece) + 1.1 * blotch;
    });
    drawPits(surface, 420, 0.9, kBrickworkSeed + 6U);
    return surface;
}

Picture paintBrick() {
    return lit(brickSurface(), brickLighting());
}

Picture paintBrickWeathered() {
    Surface surface = brickSurface();
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        const int piece = bricks().pieceAt(x, y);
        const double rough = fractalNoise(x / 8.0, y / 8.0, 16, 16, 3, kBrickworkSeed + 20U);
        const double inside = bricks().edgeAt(x, y);
        // Faces burst by frost
        if (isBrick(surface, x, y) && hashOf(piece, 9, kBrickworkSeed) % 4U == 0U && rough > 0.44 &&
            inside > 2.0) {
            texel.height = 0.5 + 0.6 * valueNoise(x / 4.0, y / 4.0, 32, 32, kBrickworkSeed + 21U);
            texel.tone += 0.6;
            return;
        }
        // Edges worn round, mortar washed out
        if (isBrick(surface, x, y)) {
            texel.height = std::clamp((inside - 0.8) * 0.55 - 0.6 * (rough - 0.4), 0.2, 1.6);
            texel.tone += 0.25 + 0.9 * (rough - 0.5);
        } else {
            texel.height -= 0.8;
            texel.tone -= 0.8;
        }
        // Lime bloom running down from the joints
        const double bloom =
            valueNoise(x / 4.0, y / 32.0, 32, 4, kBrickworkSeed + 22U) *
            smoothStep(0.45, 0.75, valueNoise(x / 32.0, y / 32.0, 4, 4, kBrickworkSeed + 23U));
        if (isBrick(surface, x, y) && bloom > 0.5) {
            texel.ramp = &kStoneRamp;
            texel.tone = 3.2 + 1.2 * (rough - 0.5);
        }
    });
    drawCrack(surface, {.x = 84, .y = 12, .length = 64, .depth = 1.4, .darkening = 1.6, .seed = 5});
    drawCrack(surface, {.x = 22, .y = 86, .length = 34, .depth = 1.4, .darkening = 1.4, .seed = 9});
    return lit(surface, brickLighting());
}

Picture paintBrickMossy() {
    Surface surface = brickSurface();
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        // Moss starts on the ledges between courses and hangs down over the bricks
        const int belowJoint = y % kBrickHeight;
        const double patch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kBrickworkSeed + 30U);
        const double tuft = valueNoise(x / 3.2, y / 6.4, 40, 20, kBrickworkSeed + 31U);
        const double hang = (patch - 0.42) * 38.0 * (0.35 + 0.9 * tuft);
        const bool onLedge = belowJoint >= kBrickHeight - 3 && patch > 0.42;
        if (belowJoint < hang || (onLedge && tuft > 0.3)) {
            const double leaf = valueNoise(x / 2.0, y / 2.0, 64, 64, kBrickworkSeed + 32U);
            texel.ramp = &kMossRamp;
            texel.tone = 3.0 + 1.2 * (leaf - 0.5) + 0.8 * (patch - 0.5);
            texel.height = 1.6 + 1.6 * leaf;
        } else if (belowJoint < hang + 4.0) {
            texel.tone -= 0.6;
        }
    });
    return lit(surface, brickLighting());
}

}  // namespace slicecast::textures
