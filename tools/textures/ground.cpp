#include "ground.h"

#include <algorithm>
#include <cmath>

#include "marks.h"
#include "noise.h"
#include "pieces.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kGroundSeed = 800;

// Tufts of grass seen from above: three or five blades that spread from a foot, dark at the foot,
// light at the tips.
void drawTufts(Surface& surface, int count, double tone, std::uint32_t seed) {
    Random random(seed);
    for (int tuft = 0; tuft < count; ++tuft) {
        const int x = random.below(kSide);
        const int y = random.below(kSide);
        const double meadow = fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kGroundSeed + 1U) - 0.5;
        const double own = tone + 1.5 * meadow + random.between(-0.3, 0.3);
        const int blades = 3 + 2 * random.below(2);
        for (int blade = 0; blade < blades; ++blade) {
            const double lean = (blade - (blades - 1) / 2.0) * random.between(0.35, 0.6);
            const int length = 3 + random.below(4);
            for (int step = 0; step <= length; ++step) {
                const int bladeX = x + static_cast<int>(std::floor(lean * step + 0.5));
                const double share = static_cast<double>(step) / length;
                surface.at(bladeX, y - step).tone = own - 0.7 + 1.5 * share;
            }
        }
        // The foot stands in its own shade, to the lower right
        surface.at(x + 1, y + 1).tone = own - 1.3;
        surface.at(x + 2, y + 1).tone = own - 1.0;
        surface.at(x, y + 1).tone = own - 1.1;
    }
}

Surface grassSurface() {
    Surface surface;
    everyTexel([&](int x, int y) {
        const double meadow = fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kGroundSeed + 1U) - 0.5;
        const double blade = valueNoise(x / 2.0, y / 4.0, 64, 32, kGroundSeed + 2U);
        surface.at(x, y) = {
            .height = 0.0, .tone = 3.1 + 1.3 * meadow + 0.9 * (blade - 0.5), .ramp = &kMossRamp};
    });
    drawTufts(surface, 420, 3.4, kGroundSeed + 3U);
    return surface;
}

// Soil in layers, with stones of all sizes and some roots.
Surface earthSurface() {
    Surface surface;
    everyTexel([&](int x, int y) {
        const double bend =
            10.0 * (fractalNoise(x / 32.0, y / 32.0, 4, 4, 2, kGroundSeed + 80U) - 0.5);
        const double layer = valueNoise(x / 64.0, (y + bend) / 8.0, 2, 16, kGroundSeed + 81U) - 0.5;
        const double clod = fractalNoise(x / 8.0, y / 8.0, 16, 16, 3, kGroundSeed + 82U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kEarthRamp;
        texel.tone = 2.4 + 1.1 * layer + 0.9 * clod;
        texel.height = 3.5 * clod + 1.0 * layer;
    });
    Random random(kGroundSeed + 83U);
    for (int stone = 0; stone < 30; ++stone) {
        const double x = random.between(0.0, kSide);
        const double y = random.between(0.0, kSide);
        const double radius = 1.2 + 3.6 * random.fraction() * random.fraction();
        const double tone = random.between(1.3, 2.5);
        const Ramp* ramp = random.fraction() < 0.6 ? &kStoneRamp : &kEarthRamp;
        // Two rounds that overlap make a longish stone
        drawStud(
            surface,
            {.x = x, .y = y, .radius = radius, .height = 0.5 * radius, .tone = tone, .ramp = ramp});
        drawStud(surface, {.x = x + 0.9 * radius,
                           .y = y + random.between(-0.3, 0.3) * radius,
                           .radius = 0.8 * radius,
                           .height = 0.5 * radius,
                           .tone = tone,
                           .ramp = ramp});
    }
    for (int root = 0; root < 7; ++root) {
        drawCrack(surface, {.x = random.below(kSide),
                            .y = random.below(kSide),
                            .length = 14 + random.below(16),
                            .depth = 0.8,
                            .darkening = 0.9,
                            .seed = kGroundSeed + 84U + static_cast<std::uint32_t>(root)});
    }
    return surface;
}

constexpr Lighting kEarthLight = {.gain = 0.5,
                                  .lightest = 0.9,
                                  .darkest = 1.1,
                                  .shadowReach = 2,
                                  .shadowSlope = 0.6,
                                  .shadowDepth = 0.8};

constexpr Lighting kFlatLight = {.gain = 0.0,
                                 .lightest = 0.0,
                                 .darkest = 0.0,
                                 .shadowReach = 0,
                                 .shadowSlope = 1.0,
                                 .shadowDepth = 0.0,
                                 .hollowDepth = 0.0};

}  // namespace

Picture paintGrass() {
    return lit(grassSurface(), kFlatLight);
}

Picture paintGrassMeadow() {
    Surface surface = grassSurface();
    // Flowers in small companies; four petals and an eye
    Random random(kGroundSeed + 10U);
    for (int flower = 0; flower < 44; ++flower) {
        const int x = random.below(kSide);
        const int y = random.below(kSide);
        const double company = valueNoise(x / 16.0, y / 16.0, 8, 8, kGroundSeed + 11U);
        const double kind = valueNoise(x / 32.0, y / 32.0, 4, 4, kGroundSeed + 12U);
        if (company < 0.35) {
            continue;
        }
        const Ramp* petals = kind < 0.42 ? &kStoneRamp : (kind < 0.6 ? &kBrassRamp : &kCrimsonRamp);
        const double light = kind < 0.42 ? 7.0 : (kind < 0.6 ? 4.0 : 5.0);
        const bool large = random.fraction() < 0.6;
        surface.at(x + 1, y + 2).tone = 1.5;
        surface.at(x + 2, y + 1).tone = 1.5;
        surface.at(x - 1, y) = {.height = 0.0, .tone = light, .ramp = petals};
        surface.at(x, y - 1) = {.height = 0.0, .tone = light, .ramp = petals};
        if (large) {
            surface.at(x + 1, y) = {.height = 0.0, .tone = light - 0.5, .ramp = petals};
            surface.at(x, y + 1) = {.height = 0.0, .tone = light - 1.0, .ramp = petals};
        }
        surface.at(x, y) = {.height = 0.0, .tone = kind < 0.42 ? 4.0 : 3.0, .ramp = &kBrassRamp};
    }
    return lit(surface, kFlatLight);
}

Picture paintMoss() {
    static const Pieces cushions(nearest(spreadPoints(70, 1.0, kGroundSeed + 20U), 1.0), 2.5,
                                 kGroundSeed + 21U);
    Surface surface;
    everyTexel([&](int x, int y) {
        const int piece = cushions.pieceAt(x, y);
        const double inside = cushions.edgeAt(x, y);
        const double fuzz = valueNoise(x / 2.0, y / 2.0, 64, 64, kGroundSeed + 22U) - 0.5;
        const double broad = fractalNoise(x / 32.0, y / 32.0, 4, 4, 2, kGroundSeed + 23U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kMossRamp;
        texel.height = 4.0 * (1.0 - 1.0 / (1.0 + 0.35 * inside)) *
                           (0.7 + 0.6 * randomAt(piece, 1, kGroundSeed + 24U)) +
                       1.0 * fuzz;
        texel.tone = 2.3 + 0.22 * std::min(inside, 5.0) + 0.8 * broad +
                     0.6 * (randomAt(piece, 2, kGroundSeed + 24U) - 0.5);
    });
    return lit(surface, {.gain = 0.75,
                         .lightest = 1.0,
                         .darkest = 1.0,
                         .shadowReach = 2,
                         .shadowSlope = 0.8,
                         .shadowDepth = 0.4});
}

Picture paintPath() {
    Surface surface;
    everyTexel([&](int x, int y) {
        const double broad = fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kGroundSeed + 30U) - 0.5;
        const double fine = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kGroundSeed + 31U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kEarthRamp;
        texel.tone = 3.3 + 1.1 * broad + 0.9 * fine;
        texel.height = 2.2 * fine + 2.0 * broad;
    });
    Random random(kGroundSeed + 32U);
    for (int pebble = 0; pebble < 60; ++pebble) {
        const double x = random.between(0.0, kSide);
        const double y = random.between(0.0, kSide);
        const double radius = 1.0 + 2.2 * random.fraction() * random.fraction();
        const Ramp* ramp = random.fraction() < 0.6 ? &kStoneRamp : &kFlintRamp;
        drawStud(surface, {.x = x,
                           .y = y,
                           .radius = radius,
                           .height = 0.9 * radius,
                           .tone = random.between(2.6, 3.8),
                           .ramp = ramp});
    }
    return lit(surface, {.gain = 0.5,
                         .lightest = 0.9,
                         .darkest = 1.0,
                         .shadowReach = 2,
                         .shadowSlope = 0.6,
                         .shadowDepth = 0.8});
}

Picture paintSand() {
    Surface surface;
    everyTexel([&](int x, int y) {
        // Ripples run a little downhill and wander; their lee is steeper
        const double wander =
            9.0 * (fractalNoise(x / 32.0, y / 32.0, 4, 4, 2, kGroundSeed + 40U) - 0.5);
        const double phase = (y + wander + x / 8.0) / 16.0;
        const double part = phase - std::floor(phase);
        const double strength =
            0.35 + 0.65 * smoothStep(0.3, 0.7,
                                     fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kGroundSeed + 41U));
        const double ripple = part < 0.65 ? part / 0.65 : (1.0 - part) / 0.35;
        const double dune = fractalNoise(x / 64.0, y / 64.0, 2, 2, 2, kGroundSeed + 42U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kSandRamp;
        texel.height = 2.6 * strength * ripple;
        texel.tone = 3.9 + 0.7 * dune + 0.25 * strength * (ripple - 0.5);
        texel.tone += hashOf(x, y, kGroundSeed + 43U) % 90U == 0U ? 0.5 : 0.0;
        texel.tone -= hashOf(x, y, kGroundSeed + 44U) % 140U == 0U ? 0.6 : 0.0;
    });
    return lit(surface, {.gain = 1.5,
                         .lightest = 0.7,
                         .darkest = 0.8,
                         .shadowReach = 0,
                         .shadowSlope = 1.0,
                         .shadowDepth = 0.0,
                         .hollowDepth = 0.0});
}

Picture paintCobbles() {
    static const Pieces stones(nearest(spreadPoints(52, 1.15, kGroundSeed + 50U), 1.15), 1.0,
                               kGroundSeed + 51U, kFine);
    Surface surface(kFineSide, kFineSide);
    everyFineTexel([&](int fineX, int fineY) {
        const double x = fineX / 2.0;
        const double y = fineY / 2.0;
        const int piece = stones.pieceAt(fineX, fineY);
        const double chipped =
            1.1 * std::max(0.0, valueNoise(x / 3.2, y / 3.2, 40, 40, kGroundSeed + 54U) - 0.6);
        const double inside = stones.edgeAt(fineX, fineY) - 1.2 - chipped;
        const double rough = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kGroundSeed + 52U) - 0.5;
        const double skin = valueNoise(x / 2.0, y / 2.0, 64, 64, kGroundSeed + 55U) - 0.5;
        const double grain = randomAt(fineX, fineY, kGroundSeed + 56U);
        Texel& texel = surface.at(fineX, fineY);
        if (inside <= 0.0) {
            // Sand between the stones, here and there with moss
            const bool grown =
                valueNoise(x / 16.0, y / 16.0, 8, 8, kGroundSeed + 57U) > 0.76 && skin > -0.1;
            texel = {.height = grain > 0.8 ? 0.9 : 0.0,
                     .tone = (grown ? 1.4 : 0.5) + 1.2 * rough + (grain > 0.8 ? 0.8 : 0.0),
                     .ramp = grown ? &kMossRamp : &kStoneRamp};
            return;
        }
        const bool warm = hashOf(piece, 1, kGroundSeed + 53U) % 5U < 2U;
        texel.ramp = warm ? &kStoneRamp : &kFlintRamp;
        texel.tone = (warm ? 2.1 : 3.1) + 0.8 * (randomAt(piece, 2, kGroundSeed + 53U) - 0.5) +
                     0.8 * rough + 0.4 * skin;
        // Crystals that glint, and dark ones
        texel.tone += grain > 0.985 ? 0.8 : (grain < 0.02 ? -0.7 : 0.0);
        texel.height = 9.0 * (1.0 - 1.0 / (1.0 + 0.4 * inside)) + 1.6 * rough + 1.0 * skin;
    });
    drawPits(surface, 420, 1.4, kGroundSeed + 58U);
    for (const Crack& crack :
         {Crack{.x = 40, .y = 52, .length = 26, .depth = 1.2, .darkening = 0.8, .seed = 31},
          Crack{.x = 178, .y = 118, .length = 30, .depth = 1.2, .darkening = 0.8, .seed = 32},
          Crack{.x = 96, .y = 200, .length = 24, .depth = 1.2, .darkening = 0.8, .seed = 33}}) {
        drawCrack(surface, crack);
    }
    return lit(surface, {.gain = 0.6,
                         .lightest = 0.9,
                         .darkest = 1.2,
                         .shadowReach = 4,
                         .shadowSlope = 0.8,
                         .shadowDepth = 0.6});
}

Picture paintFlagstones() {
    static const Pieces flags(lettered({"AABBBCCC", "AABBBCCC", "DDDEECCC", "DDDEEFFG", "HHIEEFFG",
                                        "HHIJJJKG", "LLIJJJKM", "LLIJJJKM"}),
                              1.0, kGroundSeed + 60U);
    Surface surface;
    everyTexel([&](int x, int y) {
        const int piece = flags.pieceAt(x, y);
        const double chipped =
            1.6 * std::max(0.0, valueNoise(x / 4.0, y / 4.0, 32, 32, kGroundSeed + 61U) - 0.6);
        const double inside = flags.edgeAt(x, y) - 1.0 - chipped;
        const double rough = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kGroundSeed + 62U) - 0.5;
        Texel& texel = surface.at(x, y);
        if (inside <= 0.0) {
            const bool grown = valueNoise(x / 16.0, y / 16.0, 8, 8, kGroundSeed + 63U) > 0.66;
            texel = {.height = 0.0,
                     .tone = grown ? 2.2 + rough : 0.6,
                     .ramp = grown ? &kMossRamp : &kStoneRamp};
            return;
        }
        const bool cool = piece == 'B' || piece == 'H' || piece == 'F' || piece == 'K';
        texel.ramp = cool ? &kFlintRamp : &kStoneRamp;
        texel.tone =
            (cool ? 3.5 : 2.8) + 0.8 * (randomAt(piece, 1, kGroundSeed + 64U) - 0.5) + 1.1 * rough;
        texel.height = std::min(inside * 0.8, 1.8) + 1.2 * rough;
    });
    drawCrack(surface,
              {.x = 100, .y = 4, .length = 40, .depth = 1.0, .darkening = 0.9, .seed = 21});
    drawCrack(surface,
              {.x = 66, .y = 84, .length = 44, .depth = 1.0, .darkening = 0.9, .seed = 22});
    return lit(surface, {.gain = 0.5,
                         .lightest = 0.7,
                         .darkest = 1.0,
                         .shadowReach = 2,
                         .shadowSlope = 0.6,
                         .shadowDepth = 0.6});
}

// Calm water: long swells, and a net of light that comes and goes.
Picture paintWater() {
    static const Pieces net(nearest(spreadPoints(26, 1.7, kGroundSeed + 70U), 1.7), 5.0,
                            kGroundSeed + 71U);
    Surface surface;
    everyTexel([&](int x, int y) {
        const double swell = fractalNoise(x / 32.0, y / 16.0, 4, 8, 3, kGroundSeed + 72U) - 0.5;
        const double bright =
            3.2 * (fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kGroundSeed + 73U) - 0.42);
        const double inside = net.edgeAt(x, y);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kSeaRamp;
        texel.tone = 1.9 + 1.1 * swell;
        texel.tone += inside < bright + 1.2 ? 0.5 : 0.0;
        texel.tone += inside < bright ? 0.6 : 0.0;
        texel.tone += inside < bright - 0.8 ? 0.7 : 0.0;
    });
    return lit(surface, kFlatLight);
}

Picture paintEarth() {
    return lit(earthSurface(), kEarthLight);
}

Picture paintTurf() {
    const Surface earth = earthSurface();
    Surface surface = earth;
    // Blades hang over the edge in tufts of different length; the nearer ones are lighter
    for (int layer = 0; layer < 3; ++layer) {
        for (int x = 0; x < kSide; ++x) {
            const auto seed = kGroundSeed + 90U + static_cast<std::uint32_t>(layer);
            const double tuft = valueNoise(x / 8.0, 0.0, 16, 1, seed);
            const double blade = randomAt(x, layer, kGroundSeed + 95U);
            const int length =
                static_cast<int>((34.0 - 9.0 * layer) * (0.15 + 0.85 * tuft) * (0.5 + 0.5 * blade));
            for (int y = 0; y < length; ++y) {
                const double share = static_cast<double>(y) / length;
                surface.at(x, y) = {.height = 2.5 + layer,
                                    .tone = 3.0 + 0.7 * layer + 0.9 * (blade - 0.5) - 1.0 * share,
                                    .ramp = &kMossRamp};
            }
        }
    }
    Lighting lighting = kEarthLight;
    lighting.gain = 0.25;
    lighting.shadowReach = 4;
    return litOver(earth, kEarthLight, surface, lighting);
}

}  // namespace slicecast::textures
