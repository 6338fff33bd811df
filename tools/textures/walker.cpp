#include "walker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cutout.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr int kWalkerWidth = 60;
constexpr int kWalkerHeight = 116;

// Where a leg or an arm is in its swing: `ahead` from -1 (behind) to 1 (before the body), `lift`
// how far the foot is off the ground.
struct Swing {
    double ahead;
    double lift;
};

Swing swingAt(double phase) {
    // While a foot goes back it stands; while it comes forward it is lifted
    const double forward = wave(phase + 0.25);
    return {wave(phase), std::max(0.0, forward)};
}

// A foot that is ahead is larger, and lower in the picture.
double toeOf(const Swing& swing) {
    return 4.6 + 1.1 * swing.ahead;
}

double soleOf(const Swing& swing) {
    return 3.0 * swing.ahead - 6.5 * swing.lift;
}

// One leg as seen from the front. `ground` is where the sole of a standing foot would be between
// its two ends.
void drawLeg(Surface& surface, double side, const Swing& swing, double bob, double ground) {
    const double hipX = 30.0 + side * 6.0;
    const double footX = 30.0 + side * (7.0 + 0.8 * swing.ahead);
    const double footY = ground + soleOf(swing) - toeOf(swing);
    const double kneeX = 0.5 * (hipX + footX) + side * 1.0;
    const double kneeY = 87.0 + bob - 5.0 * swing.lift + 1.5 * swing.ahead;
    const double dark = 0.55 * std::max(0.0, -swing.ahead);
    const double base = 4.0 + 2.0 * swing.ahead;
    const Paint cloth = {.ramp = &kTimberRamp, .tone = 2.3 - dark, .height = base};
    const Paint leather = {.ramp = &kOakRamp, .tone = 2.7 - dark, .height = base + 1.0};
    drawLimb(surface, {hipX, 70.0 + bob}, 6.2, {kneeX, kneeY}, 5.2, cloth);
    drawLimb(surface, {kneeX, kneeY}, 5.0, {footX, footY - 5.0}, 4.2, cloth);
    // The boot: shaft with a turned top, then the foot pointing to the viewer
    drawLimb(surface, {0.35 * kneeX + 0.65 * footX, 0.35 * kneeY + 0.65 * footY}, 5.2,
             {footX, footY - 3.0}, 4.8, leather);
    drawBall(surface, {footX + side * 1.0, footY}, 5.6 + 0.6 * swing.ahead, toeOf(swing),
             {.ramp = &kOakRamp, .tone = 2.5 - dark, .height = base + 2.0});
}

void drawArm(Surface& surface, double side, double ahead, double bob, bool before) {
    const double shoulderX = 30.0 + side * 13.0;
    const double shoulderY = 40.0 + bob;
    const double elbowX = 30.0 + side * (17.5 - 0.8 * ahead);
    const double elbowY = 55.0 + bob - 1.5 * ahead;
    const double handX = 30.0 + side * (16.5 - 4.0 * std::max(0.0, ahead));
    const double handY = 70.0 + bob - 6.0 * std::max(0.0, ahead) - 2.0 * std::max(0.0, -ahead);
    const double base = before ? 16.0 : 2.0;
    const double dark = before ? 0.0 : 0.6;
    drawBall(surface, {handX, handY}, 3.6, 4.0,
             {.ramp = &kSkinRamp, .tone = 4.2 - dark, .height = base});
    drawLimb(surface, {shoulderX, shoulderY}, 5.6, {elbowX, elbowY}, 4.8,
             {.ramp = &kStoneRamp, .tone = 5.0 - dark, .height = base + 1.0});
    drawLimb(surface, {elbowX, elbowY}, 4.8, {handX, handY - 4.0}, 4.0,
             {.ramp = &kStoneRamp, .tone = 5.0 - dark, .height = base + 1.0});
}

// A hem that swings with the step.
void drawTunic(Surface& surface, double sway, double bob) {
    const auto at = [bob](double x, double y) { return Place{30.0 + x, y + bob}; };
    drawOutline(surface,
                {at(-13.0, 36.0), at(-7.0, 33.0), at(7.0, 33.0), at(13.0, 36.0), at(12.0, 58.0),
                 at(14.5 + sway, 82.0), at(5.0 + sway, 84.0), at(-5.0 + sway, 84.0),
                 at(-14.5 + sway, 82.0), at(-12.0, 58.0)},
                {.ramp = &kSeaRamp, .tone = 2.0, .height = 8.0});
    everyTexelOn(surface, 0.0, 30.0, kWalkerWidth, 90.0, [&](int x, int y) {
        Texel& texel = surface.at(x, y);
        if (texel.alpha == 0 || texel.ramp != &kSeaRamp) {
            return;
        }
        const double down = y - bob;
        const double off =
            (x + 0.5 - 30.0 - (down > 58.0 ? sway * (down - 58.0) / 25.0 : 0.0)) / 14.5;
        texel.height += 7.0 * std::sqrt(std::max(0.0, 1.0 - off * off));
        if (down > 62.0) {
            // Folds of the skirt
            texel.height += 0.9 * wave(off * 1.7 + 0.1);
            texel.tone += 0.3 * wave(off * 1.7 + 0.1);
        }
        if (down > 79.5) {
            texel.ramp = &kBrassRamp;
            texel.tone = 2.9;
        }
    });
}

}  // namespace

// Seen from the front, as a figure that always turns to the viewer should be: blue tunic, straw
// hat, a bag across the shoulder.
Picture paintWalker() {
    std::vector<Picture> frames;
    for (int frame = 0; frame < kWalkFrames; ++frame) {
        const double phase = static_cast<double>(frame) / kWalkFrames;
        const Swing left = swingAt(phase);
        const Swing right = swingAt(phase + 0.5);
        const double bob = 1.6 * (1.0 - std::abs(left.ahead)) * -1.0 + 1.0;
        const double sway = 1.6 * left.ahead;
        // Whichever foot is lower stands on the lowest row
        const double ground = kWalkerHeight + 0.4 - std::max(soleOf(left), soleOf(right));
        Surface surface = Surface::empty(kWalkerWidth, kWalkerHeight);
        // What is behind comes first: the arm that swings back, the leg that stands behind
        if (left.ahead > 0.0) {
            drawArm(surface, -1.0, -left.ahead, bob, false);
        }
        if (right.ahead > 0.0) {
            drawArm(surface, 1.0, -right.ahead, bob, false);
        }
        if (left.ahead < right.ahead) {
            drawLeg(surface, -1.0, left, bob, ground);
            drawLeg(surface, 1.0, right, bob, ground);
        } else {
            drawLeg(surface, 1.0, right, bob, ground);
            drawLeg(surface, -1.0, left, bob, ground);
        }
        drawTunic(surface, sway, bob);
        // Belt, and the strap of the bag
        const auto at = [bob](double x, double y) { return Place{x, y + bob}; };
        drawLimb(surface, at(21.0, 36.0), 1.8, at(41.0, 60.0), 1.8,
                 {.ramp = &kOakRamp, .tone = 3.0, .height = 17.0, .bulge = 0.4});
        drawLimb(surface, at(18.5, 61.0), 2.2, at(41.5, 61.0), 2.2,
                 {.ramp = &kOakRamp, .tone = 2.4, .height = 16.5, .bulge = 0.5});
        drawBall(surface, at(30.0, 61.0), 2.8, 2.6,
                 {.ramp = &kBrassRamp, .tone = 3.6, .height = 18.0, .bulge = 0.4});
        const double swing = 0.8 * wave(phase + 0.1);
        drawLimb(surface, at(42.0 + swing, 62.0), 6.0, at(42.5 + swing, 69.0), 6.4,
                 {.ramp = &kTimberRamp, .tone = 3.2, .height = 15.0, .bulge = 0.6});
        drawLimb(surface, at(37.5 + swing, 61.0), 2.2, at(47.0 + swing, 61.0), 2.2,
                 {.ramp = &kTimberRamp, .tone = 2.4, .height = 18.0, .bulge = 0.4});
        if (left.ahead <= 0.0) {
            drawArm(surface, -1.0, -left.ahead, bob, true);
        }
        if (right.ahead <= 0.0) {
            drawArm(surface, 1.0, -right.ahead, bob, true);
        }
        // Neckerchief, head, hair, hat
        drawBall(surface, at(30.0, 33.5), 7.5, 4.6,
                 {.ramp = &kCrimsonRamp, .tone = 3.2, .height = 16.0});
        drawOutline(surface, {at(26.5, 35.0), at(33.5, 35.0), at(30.0, 43.0)},
                    {.ramp = &kCrimsonRamp, .tone = 3.0, .height = 19.0});
        drawBall(surface, at(30.0, 21.5), 9.6, 10.4,
                 {.ramp = &kOakRamp, .tone = 2.4, .height = 14.0});
        drawBall(surface, at(30.0, 22.5), 8.0, 9.6,
                 {.ramp = &kSkinRamp, .tone = 4.3, .height = 18.0, .bulge = 0.7});
        for (const double side : {-1.0, 1.0}) {
            drawBox(surface, static_cast<int>(30.0 + side * 3.5 - 1.0),
                    static_cast<int>(21.5 + bob), static_cast<int>(30.0 + side * 3.5 + 1.0),
                    static_cast<int>(23.6 + bob),
                    {.ramp = &kOakRamp, .tone = 0.4, .height = 25.0, .bulge = 0.0});
        }
        drawBall(surface, at(30.0, 25.6), 1.7, 2.0,
                 {.ramp = &kSkinRamp, .tone = 4.6, .height = 24.5});
        drawLimb(surface, at(28.2, 29.3), 0.7, at(31.8, 29.3), 0.7,
                 {.ramp = &kSkinRamp, .tone = 1.8, .height = 24.0, .bulge = 0.0});
        drawBall(surface, at(30.0, 11.0), 9.4, 9.0,
                 {.ramp = &kSandRamp, .tone = 3.4, .height = 22.0});
        drawBall(surface, at(30.0, 15.0), 16.5, 4.4,
                 {.ramp = &kSandRamp, .tone = 3.2, .height = 28.0, .bulge = 0.9});
        drawBall(surface, at(30.0, 10.5), 8.8, 6.4,
                 {.ramp = &kSandRamp, .tone = 3.6, .height = 31.0, .bulge = 0.8});
        drawLimb(surface, at(21.8, 13.4), 1.2, at(38.2, 13.4), 1.2,
                 {.ramp = &kCrimsonRamp, .tone = 2.8, .height = 34.0, .bulge = 0.0});
        frames.push_back(spriteOf(surface, {.gain = 0.4,
                                            .lightest = 1.0,
                                            .darkest = 1.5,
                                            .shadowReach = 3,
                                            .shadowSlope = 1.0,
                                            .shadowDepth = 0.8,
                                            .hollowDepth = 0.0}));
    }
    return inARow(frames);
}

}  // namespace slicecast::textures
