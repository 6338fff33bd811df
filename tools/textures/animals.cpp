#include "animals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cutout.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr Lighting kFurLight = {.gain = 0.4,
                                .lightest = 1.0,
                                .darkest = 1.5,
                                .shadowReach = 2,
                                .shadowSlope = 1.0,
                                .shadowDepth = 0.6,
                                .hollowDepth = 0.0};

constexpr double kGround = 56.0;

// A cat's leg: it swings about its upper end; the paw stands while it goes back.
void drawCatLeg(Surface& surface, Place upper, double phase, double tone, double height,
                bool hind) {
    const double swing = 8.5 * wave(phase);
    const double lift = 5.0 * std::max(0.0, wave(phase + 0.25));
    const Place paw = {upper.x + swing, kGround - 2.2 - lift};
    const double bend = hind ? -3.5 : 2.0;
    const Place knee = {0.5 * (upper.x + paw.x) + bend - 0.3 * lift,
                        0.5 * (upper.y + paw.y) - 0.2 * lift};
    const Paint fur = {.ramp = &kClayRamp, .tone = tone, .height = height};
    drawLimb(surface, upper, hind ? 5.2 : 4.0, knee, 3.0, fur);
    drawLimb(surface, knee, 3.0, paw, 2.2, fur);
    drawBall(surface, {paw.x + 1.4, paw.y + 0.1}, 3.3, 2.2,
             {.ramp = &kStoneRamp, .tone = tone > 3.5 ? 6.0 : 4.6, .height = height + 1.0});
}

}  // namespace

// A ginger cat trotting to the right, tail up.
Picture paintCat() {
    std::vector<Picture> frames;
    for (int frame = 0; frame < kCatFrames; ++frame) {
        const double phase = static_cast<double>(frame) / kCatFrames;
        const double bob = 1.0 * wave(2.0 * phase);
        Surface surface = Surface::empty(92, static_cast<int>(kGround));
        // The far legs, darker
        drawCatLeg(surface, {31.0, 34.0 + bob}, phase + 0.5, 3.0, 0.0, true);
        drawCatLeg(surface, {57.0, 35.0 + bob}, phase, 3.0, 0.0, false);
        // The tail, a chain that curls
        Place from = {25.0, 27.0 + bob};
        for (int joint = 0; joint < 7; ++joint) {
            const double curl = 0.55 * wave(phase + 0.07 * joint);
            const Place to = {from.x - 3.6 + 1.15 * joint + curl, from.y - 3.6 + 0.12 * joint};
            const bool tip = joint == 6;
            drawLimb(surface, from, 2.9 - 0.12 * joint, to, 2.8 - 0.12 * joint,
                     {.ramp = tip ? &kStoneRamp : &kClayRamp,
                      .tone = tip ? 6.0 : (joint % 2 == 0 ? 4.0 : 3.4),
                      .height = 1.0});
            from = to;
        }
        // Body: haunch, belly, breast
        drawBall(surface, {33.0, 30.0 + bob}, 11.0, 10.0,
                 {.ramp = &kClayRamp, .tone = 4.0, .height = 3.0});
        drawLimb(surface, {34.0, 30.0 + bob}, 9.4, {57.0, 29.0 + bob}, 9.0,
                 {.ramp = &kClayRamp, .tone = 4.0, .height = 3.5});
        drawBall(surface, {62.0, 31.0 + bob}, 5.5, 7.0,
                 {.ramp = &kStoneRamp, .tone = 5.9, .height = 6.0});
        // Stripes across the back
        everyTexelOn(surface, 24.0, 18.0, 62.0, 34.0, [&](int x, int y) {
            Texel& texel = surface.at(x, y);
            const double down = y - 20.0 - bob;
            if (texel.alpha > 0 && texel.ramp == &kClayRamp &&
                wrap(x + static_cast<int>(0.25 * down), 7) < 2 &&
                down < 9.0 + 3.0 * randomAt(x / 7, 1, 4001U)) {
                texel.tone -= 0.9;
            }
        });
        drawCatLeg(surface, {33.0, 34.0 + bob}, phase, 4.0, 9.0, true);
        drawCatLeg(surface, {59.0, 35.0 + bob}, phase + 0.5, 4.0, 8.0, false);
        // Head, held forward: ears, muzzle, eye, whiskers' pad
        const double nod = 0.7 * wave(2.0 * phase + 0.2);
        const auto at = [&](double x, double y) { return Place{x, y + bob + nod}; };
        drawLimb(surface, at(58.0, 26.0), 7.0, at(68.0, 20.0), 6.0,
                 {.ramp = &kClayRamp, .tone = 4.0, .height = 7.0});
        drawOutline(surface, {at(62.5, 14.0), at(63.5, 4.0), at(70.5, 11.0)},
                    {.ramp = &kClayRamp, .tone = 3.4, .height = 9.0});
        drawBall(surface, at(70.5, 18.0), 9.0, 8.2,
                 {.ramp = &kClayRamp, .tone = 4.1, .height = 9.0});
        drawOutline(surface, {at(69.0, 12.0), at(73.5, 3.0), at(77.5, 13.0)},
                    {.ramp = &kClayRamp, .tone = 4.2, .height = 16.0});
        drawOutline(surface, {at(71.5, 11.5), at(73.6, 6.5), at(75.5, 12.0)},
                    {.ramp = &kBlossomRamp, .tone = 2.2, .height = 16.5});
        drawBall(surface, at(76.5, 21.5), 4.8, 3.8,
                 {.ramp = &kStoneRamp, .tone = 6.0, .height = 14.0});
        drawBall(surface, at(80.3, 20.0), 1.4, 1.2,
                 {.ramp = &kBlossomRamp, .tone = 1.4, .height = 18.0});
        drawBall(surface, at(74.0, 16.6), 1.9, 2.1,
                 {.ramp = &kMossRamp, .tone = 5.4, .height = 17.0, .bulge = 0.2});
        drawBox(surface, 74, static_cast<int>(15.4 + bob + nod), 75,
                static_cast<int>(18.8 + bob + nod),
                {.ramp = &kOakRamp, .tone = 0.2, .height = 19.0, .bulge = 0.0});
        for (const double x : {66.0, 69.0}) {
            drawLimb(surface, at(x, 10.5), 0.8, at(x + 0.5, 14.0), 0.8,
                     {.ramp = &kClayRamp, .tone = 3.0, .height = 17.0, .bulge = 0.0});
        }
        frames.push_back(spriteOf(surface, kFurLight));
    }
    return inARow(frames);
}

// A gull in flight, seen from before and below the side.
Picture paintBird() {
    // Height of the wing's joint and of its tip above the shoulder
    struct Beat {
        double joint;
        double tip;
        double reach;  // how far out the tip is
    };
    static constexpr std::array<Beat, kBirdFrames> kBeats = {{{13.0, 24.0, 27.0},
                                                              {10.0, 12.0, 33.0},
                                                              {3.0, -3.0, 34.0},
                                                              {-5.0, -14.0, 28.0},
                                                              {-2.0, -12.0, 25.0},
                                                              {8.0, 6.0, 27.0}}};
    std::vector<Picture> frames;
    for (const Beat& beat : kBeats) {
        Surface surface = Surface::empty(84, 64);
        const double lift = -0.22 * beat.tip;  // the body sinks as the wings rise
        const double y = 36.0 - lift * 0.5;
        const auto wing = [&](double side, double tone, double height) {
            const Place shoulder = {42.0 + side * 4.0, y - 2.0};
            const Place joint = {42.0 + side * 18.0, y - 2.0 - beat.joint};
            const Place tip = {42.0 + side * (6.0 + beat.reach), y - 2.0 - beat.tip};
            // Behind the arm of the wing its feathers: white, grey above, black at the tip
            drawOutline(surface,
                        {shoulder,
                         joint,
                         tip,
                         {0.6 * tip.x + 0.4 * joint.x, 0.6 * tip.y + 0.4 * joint.y + 7.0},
                         {joint.x - side * 2.0, joint.y + 11.5},
                         {shoulder.x, shoulder.y + 10.0}},
                        {.ramp = &kSlateRamp, .tone = tone, .height = height});
            drawLimb(
                surface, shoulder, 3.4, joint, 2.6,
                {.ramp = &kSlateRamp, .tone = tone + 0.9, .height = height + 1.0, .bulge = 0.6});
            drawLimb(
                surface, joint, 2.6, tip, 1.2,
                {.ramp = &kSlateRamp, .tone = tone + 0.6, .height = height + 1.0, .bulge = 0.6});
            const Place dark = {joint.x + 0.68 * (tip.x - joint.x),
                                joint.y + 0.68 * (tip.y - joint.y)};
            drawLimb(surface, dark, 2.0, tip, 1.3,
                     {.ramp = &kSlateRamp, .tone = 1.2, .height = height + 2.0, .bulge = 0.4});
        };
        wing(1.0, 4.6, 1.0);
        // Tail, body, head, beak
        drawOutline(surface, {{46.0, y}, {51.0, y + 2.0}, {57.0, y + 8.0}, {50.0, y + 9.0}},
                    {.ramp = &kStoneRamp, .tone = 5.4, .height = 2.0});
        wing(-1.0, 5.2, 3.0);
        drawLimb(surface, {47.0, y + 3.0}, 4.4, {38.5, y + 0.5}, 5.6,
                 {.ramp = &kStoneRamp, .tone = 6.3, .height = 5.0});
        drawBall(surface, {33.5, y - 2.6}, 4.5, 4.2,
                 {.ramp = &kStoneRamp, .tone = 6.6, .height = 9.0});
        drawOutline(surface, {{31.0, y - 4.2}, {31.5, y - 0.4}, {24.0, y + 0.4}, {24.0, y - 1.4}},
                    {.ramp = &kBrassRamp, .tone = 3.7, .height = 10.0});
        drawBall(surface, {32.0, y - 3.6}, 1.0, 1.0,
                 {.ramp = &kOakRamp, .tone = 0.2, .height = 15.0, .bulge = 0.0});
        frames.push_back(spriteOf(surface, kFurLight));
    }
    return inARow(frames);
}

}  // namespace slicecast::textures
