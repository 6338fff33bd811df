#include "keepsakes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cutout.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr int kKeepsakeWidth = 56;
constexpr double kKeepsakeMiddle = 28.0;
constexpr double kReach = 26.0;  // of the glow, texels

// Lays a round glow behind a picture. It fades out before the edge.
Picture withGlow(const Picture& picture, Place middle, Colour colour, double strength) {
    Picture result = picture;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double dx = x + 0.5 - middle.x;
            const double dy = y + 0.5 - middle.y;
            const double off = std::sqrt(dx * dx + dy * dy) / kReach;
            const double fade = std::max(0.0, 1.0 - off);
            const double alpha = 235.0 * strength * fade * fade;
            Colour& own = result.at(x, y);
            // The picture over the glow
            const double over = own.a / 255.0;
            const double sum = own.a + alpha * (1.0 - over);
            if (sum < 1.0) continue;
            const double share = own.a / sum;
            own = blend(colour, own, static_cast<int>(256.0 * share + 0.5));
            own.a = static_cast<std::uint8_t>(std::min(255.0, sum));
        }
    }
    return holesFilled(result, Border::Ends);
}

// paint(surface, breath) paints a thing; breath goes from -1 to 1 and back.
template <typename Paint>
Picture glowing(Place middle, Colour colour, Paint paint) {
    std::vector<Picture> frames;
    for (int frame = 0; frame < kKeepsakeFrames; ++frame) {
        const double breath = wave(static_cast<double>(frame) / kKeepsakeFrames);
        Surface surface = Surface::empty(kKeepsakeWidth, kKeepsakeWidth);
        paint(surface, breath);
        frames.push_back(withGlow(spriteOf(surface), middle, colour, 0.75 + 0.25 * breath));
    }
    return inARow(frames);
}

}  // namespace

// A scallop, upright in the sand.
Picture paintShell() {
    return glowing({kKeepsakeMiddle, 36.0}, kSand2, [](Surface& surface, double breath) {
        const double y = 36.0 - 0.6 * breath;
        for (int rib = 0; rib < 7; ++rib) {
            const double turn = (rib - 3) / 14.0;  // of a full turn
            const double out = 15.0 - 0.5 * std::abs(rib - 3);
            drawLimb(
                surface, {kKeepsakeMiddle, y + 11.0}, 2.4,
                {kKeepsakeMiddle + out * wave(turn), y + 11.0 - (out + 5.0) * wave(turn + 0.25)},
                4.0,
                {.ramp = rib % 2 == 0 ? &kBlossomRamp : &kSandRamp,
                 .tone = rib % 2 == 0 ? 4.0 : 5.0,
                 .height = 4.0 + (rib % 2)});
        }
        drawLimb(surface, {kKeepsakeMiddle - 6.0, y + 13.5}, 3.0, {kKeepsakeMiddle + 6.0, y + 13.5},
                 3.0, {.ramp = &kBlossomRamp, .tone = 3.0, .height = 10.0});
        drawLimb(surface, {kKeepsakeMiddle - 4.0, 53.5}, 3.0, {kKeepsakeMiddle + 4.0, 53.5}, 3.0,
                 {.ramp = &kSandRamp, .tone = 3.0, .height = 3.0});
        drawBall(surface, {kKeepsakeMiddle, y + 14.0}, 3.0, 2.6,
                 {.ramp = &kBlossomRamp, .tone = 3.6, .height = 14.0});
        drawLimb(surface, {kKeepsakeMiddle, y + 14.0}, 2.4, {kKeepsakeMiddle, 54.0}, 2.4,
                 {.ramp = &kSandRamp, .tone = 3.4, .height = 2.0});
    });
}

// A white flower on a stalk that opens at night.
Picture paintMoonflower() {
    return glowing({kKeepsakeMiddle, 24.0}, kSea4, [](Surface& surface, double breath) {
        drawLimb(surface, {kKeepsakeMiddle, 26.0}, 1.7, {kKeepsakeMiddle - 2.0, 55.0}, 2.2,
                 {.ramp = &kMossRamp, .tone = 3.6, .height = 2.0});
        drawLimb(surface, {kKeepsakeMiddle - 1.0, 46.0}, 2.6, {kKeepsakeMiddle + 10.0, 38.0}, 1.2,
                 {.ramp = &kMossRamp, .tone = 4.2, .height = 3.0});
        drawLimb(surface, {kKeepsakeMiddle - 2.0, 50.0}, 2.6, {kKeepsakeMiddle - 12.0, 43.0}, 1.2,
                 {.ramp = &kMossRamp, .tone = 3.8, .height = 3.0});
        const double open = 11.0 + 0.9 * breath;
        for (int petal = 0; petal < 6; ++petal) {
            const double turn = petal / 6.0 + 0.04;
            drawLimb(surface, {kKeepsakeMiddle, 22.0}, 2.6,
                     {kKeepsakeMiddle + open * wave(turn), 22.0 + 0.92 * open * wave(turn + 0.25)},
                     4.4,
                     {.ramp = petal % 2 == 0 ? &kSeaRamp : &kStoneRamp,
                      .tone = petal % 2 == 0 ? 5.4 : 6.6,
                      .height = 6.0});
        }
        drawBall(surface, {kKeepsakeMiddle, 22.0}, 4.0, 4.0,
                 {.ramp = &kBrassRamp, .tone = 4.2, .height = 12.0});
    });
}

// Three crystals that grow from one foot.
Picture paintCrystal() {
    return glowing({kKeepsakeMiddle, 34.0}, kSea3, [](Surface& surface, double breath) {
        const auto shard = [&](double foot, double tip, double top, double half, double height) {
            const Place peak = {tip, top - 0.5 * breath};
            drawOutline(surface,
                        {{foot - half, 55.5},
                         {tip - half, top + 9.0},
                         peak,
                         {tip, top + 12.0},
                         {foot, 55.5}},
                        {.ramp = &kSeaRamp, .tone = 4.6 + 0.3 * breath, .height = height});
            drawOutline(surface,
                        {{foot, 55.5},
                         {tip, top + 12.0},
                         peak,
                         {tip + half, top + 9.0},
                         {foot + half, 55.5}},
                        {.ramp = &kSeaRamp, .tone = 3.0, .height = height});
            drawLimb(surface, {tip, top + 12.0}, 0.7, peak, 0.5,
                     {.ramp = &kSeaRamp, .tone = 6.0, .height = height + 1.0, .bulge = 0.0});
        };
        shard(kKeepsakeMiddle - 5.0, kKeepsakeMiddle - 14.0, 30.0, 5.0, 2.0);
        shard(kKeepsakeMiddle + 5.0, kKeepsakeMiddle + 13.0, 26.0, 5.0, 2.5);
        shard(kKeepsakeMiddle, kKeepsakeMiddle, 12.0, 6.6, 4.0);
    });
}

// A small lantern with a flame.
Picture paintLantern() {
    return glowing({kKeepsakeMiddle, 34.0}, kBrass2, [](Surface& surface, double breath) {
        drawBox(surface, 18, 50, 38, 56,
                {.ramp = &kBrassRamp, .tone = 2.6, .height = 4.0, .bulge = 0.6});
        drawBox(surface, 20, 26, 36, 50,
                {.ramp = &kFireRamp, .tone = 5.4, .height = 2.0, .bulge = 0.3});
        drawLimb(surface, {kKeepsakeMiddle, 47.0}, 4.2,
                 {kKeepsakeMiddle + 0.8 * breath, 33.0 - 1.6 * breath}, 1.2,
                 {.ramp = &kFireRamp, .tone = 7.0, .height = 5.0});
        for (const double x : {19.5, 27.5, 35.5})
            drawLimb(surface, {x, 26.0}, 1.1, {x, 50.0}, 1.1,
                     {.ramp = &kBrassRamp, .tone = 2.2, .height = 8.0});
        drawOutline(surface, {{16.0, 27.0}, {22.0, 19.0}, {34.0, 19.0}, {40.0, 27.0}},
                    {.ramp = &kBrassRamp, .tone = 3.2, .height = 8.0});
        drawBall(surface, {kKeepsakeMiddle, 17.5}, 3.0, 3.0,
                 {.ramp = &kBrassRamp, .tone = 3.6, .height = 9.0});
        drawLimb(surface, {22.0, 18.0}, 1.0, {23.0, 9.0}, 1.0,
                 {.ramp = &kOakRamp, .tone = 2.0, .height = 9.0});
        drawLimb(surface, {34.0, 18.0}, 1.0, {33.0, 9.0}, 1.0,
                 {.ramp = &kOakRamp, .tone = 2.0, .height = 9.0});
        drawLimb(surface, {23.0, 9.0}, 1.0, {33.0, 9.0}, 1.0,
                 {.ramp = &kOakRamp, .tone = 2.4, .height = 9.0});
    });
}

}  // namespace slicecast::textures
