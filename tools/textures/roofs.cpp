#include "roofs.h"

#include <algorithm>
#include <cmath>

#include "noise.h"
#include "pieces.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kRoofsSeed = 1000;

struct TilePlace {
    int course;
    int column;
    double across;  // -1 at the left edge of the tile, 1 at the right
    double down;    // texels below the upper edge of its visible part
    double above;   // texels above its lower edge
};

}  // namespace

// Beaver-tail tiles: round lower ends, each course covers the joints of the one below.
Picture paintRoofClay() {
    constexpr int kWidth = 16;
    constexpr int kStep = 16;
    constexpr double kRound = 7.0;
    const auto placeOf = [](int x, int y, int course) {
        const int shift = wrap(course, 2) == 0 ? 0 : kWidth / 2;
        const int along = wrap(x - shift, kSide);
        TilePlace place{};
        place.course = wrap(course, kSide / kStep);
        place.column = along / kWidth;
        place.across = (along % kWidth + 0.5 - kWidth / 2.0) / (kWidth / 2.0);
        const double lowerEdge =
            (course + 1) * kStep +
            kRound * std::sqrt(std::max(0.0, 1.0 - place.across * place.across)) - kRound * 0.6;
        place.above = lowerEdge - (y + 0.5);
        place.down = y + 0.5 - course * kStep;
        return place;
    };
    Surface surface;
    everyTexel([&](int x, int y) {
        // The uppermost tile that reaches down to here lies on top
        TilePlace place = placeOf(x, y, y / kStep - 1);
        if (place.above < 0.0) {
            place = placeOf(x, y, y / kStep);
        }
        const int tile = place.course * 16 + place.column;
        const double blotch = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, kRoofsSeed) - 0.5;
        const double cover = std::min(place.above, 20.0);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kBurntRamp;
        texel.height = 5.0 - 0.22 * cover - 1.2 * place.across * place.across;
        texel.tone = 2.7 + 1.0 * (randomAt(tile, 1, kRoofsSeed + 1U) - 0.5) + 0.7 * blotch;
        texel.tone += cover < 2.0 ? 0.6 : 0.0;
        if (std::abs(place.across) > 0.9 && cover > 3.0) {
            texel.height -= 1.6;
            texel.tone -= 0.9;
        }
    });
    return lit(surface, {.gain = 0.5,
                         .lightest = 0.7,
                         .darkest = 1.2,
                         .shadowReach = 5,
                         .shadowSlope = 0.45,
                         .shadowDepth = 1.2,
                         .hollowDepth = 0.2});
}

Picture paintRoofSlate() {
    constexpr int kStep = 16;
    static const Pieces slates(coursed({{kStep, 3, {22, 20, 24, 18, 22, 22}},
                                        {kStep, 14, {20, 24, 20, 22, 18, 24}},
                                        {kStep, 5, {24, 18, 22, 22, 20, 22}},
                                        {kStep, 17, {18, 24, 22, 20, 22, 22}},
                                        {kStep, 2, {22, 22, 20, 24, 18, 22}},
                                        {kStep, 12, {24, 20, 18, 22, 24, 20}},
                                        {kStep, 6, {20, 22, 24, 20, 20, 22}},
                                        {kStep, 16, {22, 18, 22, 24, 20, 22}}}),
                               0.0, kRoofsSeed + 20U);
    Surface surface;
    everyTexel([&](int x, int y) {
        const int down = y % kStep;
        const int piece = slates.pieceAt(x, y);
        const bool seam =
            slates.pieceAt(x + 1, y) != piece && slates.pieceAt(x + 1, y) / 16 == piece / 16;
        const bool chipped =
            down == kStep - 1 && valueNoise(x / 3.2, y / 16.0, 40, 8, kRoofsSeed + 21U) > 0.62;
        const double grain = valueNoise(x / 2.0, y / 16.0, 64, 8, kRoofsSeed + 22U) - 0.5;
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 2, kRoofsSeed + 23U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kSlateRamp;
        texel.height = 1.0 + 0.2 * down + 0.8 * randomAt(piece, 3, kRoofsSeed + 24U);
        texel.tone =
            2.5 + 1.1 * (randomAt(piece, 1, kRoofsSeed + 24U) - 0.5) + 0.6 * grain + 0.6 * blotch;
        texel.tone += down >= kStep - 2 ? 0.5 : 0.0;
        if (seam || chipped) {
            texel.tone = 0.8;
            texel.height = 0.6;
        }
    });
    return lit(surface, {.gain = 0.35,
                         .lightest = 0.4,
                         .darkest = 0.9,
                         .shadowReach = 4,
                         .shadowSlope = 0.6,
                         .shadowDepth = 1.2,
                         .hollowDepth = 0.1});
}

// Straw in four thick layers with ragged lower ends.
Picture paintRoofThatch() {
    constexpr int kStep = 32;
    Surface surface;
    everyTexel([&](int x, int y) {
        const double ragged =
            7.0 * valueNoise(
                      x / 4.0, 0.0, 32, 1,
                      kRoofsSeed + 40U + static_cast<std::uint32_t>(wrap(y + 4, kSide) / kStep)) +
            3.0 * valueNoise(x / 2.0, 1.0, 64, 2, kRoofsSeed + 41U);
        const double down = wrap(y - static_cast<int>(ragged), kSide) % kStep;
        const double straw = valueNoise(x / 1.0, y / 16.0, 128, 8, kRoofsSeed + 42U);
        const double bundle = valueNoise(x / 8.0, y / 32.0, 16, 4, kRoofsSeed + 43U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kTimberRamp;
        texel.height = 0.16 * down;
        texel.tone = 2.2 + 0.03 * down + 1.5 * (straw - 0.5) + 0.8 * bundle;
        texel.tone += down > kStep - 4 ? 0.6 : 0.0;
    });
    return lit(surface, {.gain = 0.3,
                         .lightest = 0.4,
                         .darkest = 0.8,
                         .shadowReach = 6,
                         .shadowSlope = 0.6,
                         .shadowDepth = 1.1,
                         .hollowDepth = 0.1});
}

}  // namespace slicecast::textures
