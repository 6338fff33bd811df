#include "lake.h"

#include <algorithm>
#include <cmath>

#include "crown.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kLakeSeed = 5600;

}  // namespace

// A broad boat under a slanting yard: a cream sail with stripes, a red pennant.
Picture paintSailingBoat() {
    constexpr int kWidth = 176;
    constexpr int kHeight = 200;
    Surface surface = Surface::empty(kWidth, kHeight);
    const Ramp* oak = &kOakRamp;
    drawLimb(surface, {84.0, 176.0}, 3.4, {88.0, 26.0}, 2.2,
             {.ramp = oak, .tone = 3.2, .height = 2.0});
    // The sail hangs from the yard and bellies out to the right
    everyTexelOn(surface, 20.0, 10.0, 166.0, 162.0, [&](int x, int y) {
        const double along = (x + 0.5 - 26.0) / (150.0 - 26.0);  // from the yard's foot to its top
        if (along < 0.0 || along > 1.0) {
            return;
        }
        const double upper = 138.0 - 122.0 * along;
        const double lower = 156.0 - 26.0 * along - 92.0 * std::max(0.0, along - 0.72) / 0.28 * 0.9;
        if (y + 0.5 < upper || y + 0.5 > lower) {
            return;
        }
        const double down = (y + 0.5 - upper) / std::max(1.0, lower - upper);
        const double across = (along - 0.5 * down) * 7.0;
        const double seam = std::abs(across - std::floor(across) - 0.5);
        const bool stripe = static_cast<int>(std::floor(across + 8.0)) % 3 == 0;
        surface.at(x, y) = {
            .height = 6.0 + 9.0 * std::sqrt(std::max(0.0, down * (1.0 - down))) -
                      (seam > 0.47 ? 0.8 : 0.0),
            .tone = (stripe ? 3.5 : 5.9) - 1.0 * down * along - (seam > 0.46 ? 0.4 : 0.0) +
                    0.5 * (fractalNoise(x / 16.0, y / 16.0, 16, 16, 2, kLakeSeed) - 0.5),
            .ramp = stripe ? &kClayRamp : &kStoneRamp,
            .alpha = 255};
    });
    drawLimb(surface, {22.0, 141.0}, 1.8, {156.0, 10.0}, 1.4,
             {.ramp = oak, .tone = 3.4, .height = 16.0});
    drawOutline(surface, {{88.0, 14.0}, {112.0, 19.0}, {88.0, 25.0}},
                {.ramp = &kCrimsonRamp, .tone = 3.6, .height = 4.0});
    drawLimb(surface, {88.0, 28.0}, 1.4, {88.0, 12.0}, 1.2,
             {.ramp = oak, .tone = 3.4, .height = 5.0});
    for (const double x : {30.0, 146.0}) {
        drawLimb(surface, {87.0, 40.0}, 0.7, {x, 168.0}, 0.7,
                 {.ramp = &kTimberRamp, .tone = 2.4, .height = 3.0});
    }
    // Somebody at the helm
    drawLimb(surface, {132.0, 170.0}, 6.5, {131.0, 154.0}, 5.0,
             {.ramp = &kSeaRamp, .tone = 2.2, .height = 8.0});
    drawBall(surface, {131.0, 145.0}, 4.6, 5.0, {.ramp = &kSkinRamp, .tone = 4.4, .height = 10.0});
    drawBall(surface, {131.0, 141.0}, 7.0, 2.4,
             {.ramp = &kSandRamp, .tone = 3.6, .height = 14.0, .bulge = 0.4});
    // The hull: its sheer rises to stem and stern
    everyTexelOn(surface, 6.0, 148.0, 172.0, kHeight, [&](int x, int y) {
        const double off = (x + 0.5 - 89.0) / 80.0;
        const double sheer = 173.0 - 19.0 * off * off * std::abs(off);
        const double depth = kHeight - sheer;
        if (y + 0.5 < sheer || std::abs(off) > 1.0 - 0.16 * (y + 0.5 - sheer) / depth) {
            return;
        }
        const double down = (y + 0.5 - sheer) / depth;
        const int plank = static_cast<int>(down * 5.0);
        const double within = down * 5.0 - plank;
        Texel& texel = surface.at(x, y);
        texel = {.height = 14.0 * std::sqrt(std::max(0.0, 1.0 - off * off)) + within,
                 .tone = 3.1 - 1.3 * down + 0.4 * (randomAt(plank, 1, kLakeSeed + 1U) - 0.5) -
                         (within < 0.16 ? 0.9 : 0.0),
                 .ramp = oak,
                 .alpha = 255};
        if (plank == 0) {
            texel.ramp = &kSeaRamp;
            texel.tone = 2.6 - 0.6 * off;
        } else if (plank == 1 && within < 0.5) {
            texel.ramp = &kBrassRamp;
            texel.tone = 3.4;
        }
    });
    return spriteOf(surface);
}

Picture paintSwan() {
    Surface surface = Surface::empty(104, 92);
    const Ramp* white = &kStoneRamp;
    const auto down = [white](double tone, double height) {
        return Paint{.ramp = white, .tone = tone, .height = height, .bulge = 0.7};
    };
    // Tail, body, then the folded wing in three rows of feathers
    drawOutline(surface, {{70.0, 66.0}, {102.0, 58.0}, {90.0, 80.0}}, down(5.4, 2.0));
    drawBall(surface, {56.0, 78.0}, 38.0, 19.0, down(5.8, 2.0));
    everyTexelOn(surface, 16.0, 88.0, 96.0, 92.0, [&](int x, int y) {
        surface.at(x, y).tone = surface.at(x, y).alpha > 0 ? 4.4 : surface.at(x, y).tone;
    });
    for (int row = 0; row < 3; ++row) {
        for (int feather = 0; feather < 7 - row; ++feather) {
            const double x = 38.0 + 7.0 * feather + 5.0 * row;
            const double y = 76.0 - 5.5 * row - 1.1 * feather;
            drawLimb(surface, {x, y}, 5.4, {x + 17.0 - 2.0 * row, y - 5.0}, 2.2,
                     down(6.5 - 0.35 * row - 0.12 * feather, 14.0 + 3.0 * row + 0.7 * feather));
        }
    }
    // The neck: an S, bend by bend
    constexpr Place kNeck[] = {{26.0, 74.0}, {20.0, 62.0}, {21.0, 50.0}, {27.0, 39.0},
                               {31.0, 28.0}, {29.0, 17.0}, {22.0, 12.0}};
    constexpr int kParts = 6;
    for (int part = 0; part < kParts; ++part) {
        const double thick = 9.5 - 0.85 * part;
        drawLimb(surface, kNeck[part], thick, kNeck[part + 1], thick - 0.85, down(6.2, 10.0));
    }
    drawBall(surface, {19.0, 13.0}, 8.0, 6.2, down(6.3, 14.0));
    drawOutline(surface, {{13.0, 10.0}, {1.5, 18.0}, {3.0, 20.5}, {15.0, 18.0}},
                {.ramp = &kClayRamp, .tone = 4.2, .height = 18.0});
    drawOutline(surface, {{17.0, 10.5}, {11.0, 11.0}, {9.5, 15.0}, {14.0, 15.5}},
                {.ramp = &kSlateRamp, .tone = 0.8, .height = 20.0});
    drawBall(surface, {18.0, 11.5}, 1.4, 1.4,
             {.ramp = &kSlateRamp, .tone = 0.4, .height = 22.0, .bulge = 0.2});
    return spriteOf(surface, {.gain = 0.3,
                              .lightest = 0.7,
                              .darkest = 1.4,
                              .shadowReach = 3,
                              .shadowSlope = 0.8,
                              .shadowDepth = 0.6});
}

Picture paintCypress() {
    constexpr double kMiddle = 36.0;
    Surface surface = Surface::empty(72, 252);
    drawLimb(surface, {kMiddle, 251.0}, 4.6, {kMiddle, 200.0}, 3.4,
             {.ramp = &kOakRamp, .tone = 2.8});
    addGrain(surface, &kOakRamp, 1.0, kLakeSeed + 30U);
    // A flame of leaves, thickest below its middle
    std::vector<Clump> clumps;
    constexpr int kClumps = 34;
    Random random(kLakeSeed + 31U);
    for (int number = 0; number < kClumps; ++number) {
        const double share = static_cast<double>(number) / (kClumps - 1);
        const double up = std::max(0.0, 1.0 - share);
        const double half =
            3.0 + 25.0 * share * (1.9 - share) * std::min(1.0, 2.6 * (1.06 - share));
        const double side = number % 3 == 0 ? 0.0 : (number % 3 == 1 ? -1.0 : 1.0);
        const double radius = 4.5 + 10.5 * std::min(1.0, 2.2 * share);
        clumps.push_back({kMiddle + side * std::max(0.0, half - radius) + random.between(-1.5, 1.5),
                          14.0 + 212.0 * (1.0 - up), radius});
    }
    drawLeafage(surface, clumps,
                {.ramp = &kPineRamp,
                 .tone = 3.0,
                 .contrast = 1.5,
                 .length = 6.0,
                 .width = 0.3,
                 .density = 0.9,
                 .seed = kLakeSeed + 32U});
    return spriteOf(surface, {.gain = 0.12,
                              .lightest = 0.5,
                              .darkest = 0.6,
                              .shadowReach = 3,
                              .shadowSlope = 0.8,
                              .shadowDepth = 0.5,
                              .hollowDepth = 0.04});
}

}  // namespace slicecast::textures
