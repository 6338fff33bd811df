#include "figures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cutout.h"
#include "noise.h"
#include "shapes.h"

namespace slicecast::textures {

namespace {

constexpr int kPersonWidth = 56;
constexpr int kPersonHeight = 108;
constexpr double kFigureMiddle = 28.0;
constexpr Lighting kFigureLight = {.gain = 0.4,
                                   .lightest = 1.0,
                                   .darkest = 1.5,
                                   .shadowReach = 3,
                                   .shadowSlope = 1.0,
                                   .shadowDepth = 0.7,
                                   .hollowDepth = 0.0};

enum class Side { Front, Right, Back };

struct Clothes {
    const Ramp* coat;
    double coatTone;
    const Ramp* trim;
    double trimTone;
    const Ramp* legs;
    double legTone;
    bool isArmed;  // helmet and spear, instead of white hair and an apron
};

constexpr Clothes kKeeperClothes = {&kCrimsonRamp, 2.2, &kStoneRamp, 5.6, &kTimberRamp, 1.8, false};
constexpr Clothes kGuardClothes = {&kSeaRamp, 1.9, &kBrassRamp, 3.0, &kSlateRamp, 1.8, true};

Picture mirrored(const Picture& picture) {
    Picture result = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            result.at(x, y) = picture.at(picture.width - 1 - x, y);
    return result;
}

Picture stacked(const std::vector<Picture>& rows) {
    const int height = rows.front().height;
    Picture all(rows.front().width, height * static_cast<int>(rows.size()));
    for (int y = 0; y < all.height; ++y)
        for (int x = 0; x < all.width; ++x)
            all.at(x, y) = rows[static_cast<std::size_t>(y / height)].at(x, y % height);
    return all;
}

// A foot's place in a step: `ahead` from -1 to 1, `lift` off the ground.
struct FigureSwing {
    double ahead;
    double lift;
};

FigureSwing swingAt(double phase, double strength) {
    return {strength * wave(phase), strength * std::max(0.0, wave(phase + 0.25))};
}

// ---- People

void drawPersonLeg(Surface& surface, const Clothes& clothes, Side side, double where,
                   const FigureSwing& swing, double dark) {
    const bool isAside = side == Side::Right;
    const double toViewer = side == Side::Back ? -1.0 : 1.0;
    const double hip = kFigureMiddle + (isAside ? 0.0 : where * 5.0);
    const double foot = kFigureMiddle + (isAside ? 11.0 * swing.ahead : where * 6.0);
    const double down = isAside ? 0.0 : 2.2 * toViewer * swing.ahead;
    const double ground = kPersonHeight - 3.6 - 5.0 * swing.lift + std::min(0.0, down);
    const double knee = isAside ? 0.5 * (hip + foot) + 2.4 * swing.lift + 1.0 : foot;
    const Paint cloth = {.ramp = clothes.legs, .tone = clothes.legTone - dark, .height = 4.0};
    const Paint leather = {.ramp = &kOakRamp, .tone = 2.2 - dark, .height = 6.0};
    drawLimb(surface, {hip, 66.0}, 6.0, {knee, 84.0 - 2.0 * swing.lift}, 5.0, cloth);
    drawLimb(surface, {knee, 84.0 - 2.0 * swing.lift}, 5.0, {foot, ground - 5.0}, 4.2, leather);
    drawBall(surface, {foot + (isAside ? 3.0 : 0.0), ground}, isAside ? 6.4 : 5.2, 4.0, leather);
}

void drawPersonArm(Surface& surface, const Clothes& clothes, Side side, double where, double ahead,
                   double dark, double height) {
    const bool isAside = side == Side::Right;
    const double shoulder = kFigureMiddle + (isAside ? 0.0 : where * 11.0);
    const double elbow = shoulder + (isAside ? 4.0 * ahead - 1.5 : where * 3.6);
    const double hand = shoulder + (isAside ? 10.0 * ahead + 1.0 : where * 3.0);
    const double rise = 3.0 * std::abs(ahead);
    drawBall(surface, {hand, 68.0 - rise}, 3.4, 3.8,
             {.ramp = &kSkinRamp, .tone = 4.0 - dark, .height = height});
    const Paint sleeve = {
        .ramp = clothes.coat, .tone = clothes.coatTone + 0.5 - dark, .height = height + 1.0};
    drawLimb(surface, {shoulder, 39.0}, 5.4, {elbow, 53.0}, 4.6, sleeve);
    drawLimb(surface, {elbow, 53.0}, 4.6, {hand, 64.0 - rise}, 3.8, sleeve);
}

void drawCoat(Surface& surface, const Clothes& clothes, Side side, double sway) {
    const double wide = side == Side::Right ? 0.74 : 1.0;
    const auto at = [wide](double x, double y) { return Place{kFigureMiddle + wide * x, y}; };
    drawOutline(
        surface,
        {at(-11.0, 35.0), at(-5.0, 31.0), at(5.0, 31.0), at(11.0, 35.0), at(10.0, 56.0),
         at(13.0 + sway, 80.0), at(0.0 + sway, 82.0), at(-13.0 + sway, 80.0), at(-10.0, 56.0)},
        {.ramp = clothes.coat, .tone = clothes.coatTone, .height = 8.0});
    everyTexelOn(surface, 0.0, 28.0, kPersonWidth, 84.0, [&](int x, int y) {
        Texel& texel = surface.at(x, y);
        if (texel.alpha == 0 || texel.ramp != clothes.coat) return;
        const double off = (x + 0.5 - kFigureMiddle) / (13.5 * wide);
        texel.height += 7.0 * std::sqrt(std::max(0.0, 1.0 - off * off));
        if (y > 60) texel.tone += 0.3 * wave(off * 1.6 + 0.15);
        if (y >= 77) {
            texel.ramp = clothes.trim;
            texel.tone = clothes.trimTone;
        }
    });
    drawLimb(surface, at(-9.0, 57.0), 2.0, at(9.0, 57.0), 2.0,
             {.ramp = &kOakRamp, .tone = 2.6, .height = 17.0, .bulge = 0.5});
    if (clothes.isArmed || side == Side::Back) return;
    // An apron
    const double front = side == Side::Right ? 5.0 : 0.0;
    const double half = side == Side::Right ? 4.0 : 7.5;
    drawOutline(surface,
                {{kFigureMiddle + front - half, 59.0},
                 {kFigureMiddle + front + half, 59.0},
                 {kFigureMiddle + front + half + 1.0 + sway, 76.0},
                 {kFigureMiddle + front - half - 1.0 + sway, 76.0}},
                {.ramp = clothes.trim, .tone = clothes.trimTone, .height = 16.5});
}

void drawFace(Surface& surface, Side side) {
    if (side == Side::Back) return;
    const double face = side == Side::Right ? kFigureMiddle + 2.8 : kFigureMiddle;
    drawBall(surface, {face, 21.5}, side == Side::Right ? 6.6 : 7.6, 9.0,
             {.ramp = &kSkinRamp, .tone = 4.3, .height = 18.0, .bulge = 0.7});
    const Paint ink = {.ramp = &kOakRamp, .tone = 0.4, .height = 26.0, .bulge = 0.0};
    if (side == Side::Right) {
        drawBall(surface, {kFigureMiddle + 9.2, 23.6}, 2.2, 1.8,
                 {.ramp = &kSkinRamp, .tone = 4.5, .height = 20.0});
        drawBox(surface, 33, 19, 35, 22, ink);
        return;
    }
    drawBox(surface, 23, 20, 25, 23, ink);
    drawBox(surface, 31, 20, 33, 23, ink);
    drawBall(surface, {kFigureMiddle, 24.6}, 1.6, 2.0,
             {.ramp = &kSkinRamp, .tone = 4.7, .height = 25.0});
    drawLimb(surface, {26.4, 27.8}, 0.7, {29.6, 27.8}, 0.7,
             {.ramp = &kSkinRamp, .tone = 1.8, .height = 25.0, .bulge = 0.0});
}

void drawHead(Surface& surface, const Clothes& clothes, Side side) {
    drawBall(surface, {kFigureMiddle, 31.5}, 6.6, 4.2,
             {.ramp = clothes.trim, .tone = clothes.trimTone, .height = 15.0});
    const Ramp* hair = clothes.isArmed ? &kOakRamp : &kStoneRamp;
    drawBall(surface, {kFigureMiddle - (side == Side::Right ? 1.6 : 0.0), 20.0}, 9.0, 10.0,
             {.ramp = hair, .tone = clothes.isArmed ? 2.2 : 5.8, .height = 14.0});
    drawFace(surface, side);
    if (clothes.isArmed) {
        drawBall(surface, {kFigureMiddle, 13.0}, 9.6, 7.6,
                 {.ramp = &kSlateRamp, .tone = 5.0, .height = 25.0});
        drawLimb(surface, {kFigureMiddle - 10.0, 16.5}, 1.7, {kFigureMiddle + 10.0, 16.5}, 1.7,
                 {.ramp = &kBrassRamp, .tone = 3.2, .height = 30.0, .bulge = 0.5});
        drawLimb(surface, {kFigureMiddle, 4.0}, 1.8, {kFigureMiddle, 8.0}, 2.6,
                 {.ramp = &kCrimsonRamp, .tone = 3.4, .height = 28.0});
    } else {
        const double forward = side == Side::Right ? 2.5 : 0.0;
        drawBall(surface, {kFigureMiddle + forward, 13.2}, 12.0, 3.4,
                 {.ramp = &kTimberRamp, .tone = 2.0, .height = 26.0});
        drawBall(surface, {kFigureMiddle, 10.0}, 7.8, 5.4,
                 {.ramp = &kTimberRamp, .tone = 2.4, .height = 29.0});
    }
}

void drawSpear(Surface& surface, double x, double lean, double height) {
    drawLimb(surface, {x + lean, 8.0}, 1.5, {x, 104.0}, 1.6,
             {.ramp = &kTimberRamp, .tone = 3.6, .height = height, .bulge = 0.8});
    drawOutline(surface,
                {{x + lean - 3.4, 12.0}, {x + lean, 1.5}, {x + lean + 3.4, 12.0}, {x + lean, 16.0}},
                {.ramp = &kSlateRamp, .tone = 5.6, .height = height + 1.0});
}

// `strength` is 0 for one who stands.
Picture paintPerson(const Clothes& clothes, Side side, double phase, double strength, bool alert) {
    const FigureSwing left = swingAt(phase, strength);
    const FigureSwing right = swingAt(phase + 0.5, strength);
    const double sway = side == Side::Right ? 1.4 * left.ahead : 1.2 * left.ahead;
    Surface surface = Surface::empty(kPersonWidth, kPersonHeight);
    const double spear = side == Side::Right ? 8.0 : side == Side::Back ? 17.0 : -17.0;
    const double lean = alert ? (side == Side::Right ? 9.0 : 0.0) : 0.0;
    if (side == Side::Right) {
        drawPersonArm(surface, clothes, side, 1.0, -left.ahead, 0.7, 1.0);
        drawPersonLeg(surface, clothes, side, -1.0, left, 0.6);
        drawPersonLeg(surface, clothes, side, 1.0, right, 0.0);
        drawCoat(surface, clothes, side, sway);
        drawHead(surface, clothes, side);
        if (clothes.isArmed) drawSpear(surface, kFigureMiddle + spear, lean, 30.0);
        const double ahead = clothes.isArmed ? 0.6 : -right.ahead;
        drawPersonArm(surface, clothes, side, 1.0, ahead, 0.0, 32.0);
    } else {
        const bool leftBehind = (left.ahead < right.ahead) == (side == Side::Front);
        drawPersonLeg(surface, clothes, side, leftBehind ? -1.0 : 1.0, leftBehind ? left : right,
                      0.4 * strength);
        drawPersonLeg(surface, clothes, side, leftBehind ? 1.0 : -1.0, leftBehind ? right : left,
                      0.0);
        drawPersonArm(surface, clothes, side, 1.0, left.ahead, 0.0, 5.0);
        drawCoat(surface, clothes, side, sway);
        drawHead(surface, clothes, side);
        if (clothes.isArmed) drawSpear(surface, kFigureMiddle + spear, lean, 20.0);
        drawPersonArm(surface, clothes, side, -1.0, right.ahead, 0.0, 22.0);
        drawPersonArm(surface, clothes, side, 1.0, left.ahead, 0.0, 22.0);
    }
    return spriteOf(surface, kFigureLight);
}

// The four rows of a figure; paint(side, phase) paints one frame.
template <typename Paint>
Picture fromFourSides(int frames, Paint paint) {
    const auto rowOf = [&](Side side, bool isMirrored) {
        std::vector<Picture> row;
        for (int frame = 0; frame < frames; ++frame) {
            const Picture picture = paint(side, static_cast<double>(frame) / frames);
            row.push_back(isMirrored ? mirrored(picture) : picture);
        }
        return inARow(row);
    };
    return stacked({rowOf(Side::Front, false), rowOf(Side::Right, false), rowOf(Side::Back, false),
                    rowOf(Side::Right, true)});
}

Picture personStanding(const Clothes& clothes, bool alert) {
    return fromFourSides(
        1, [&](Side side, double phase) { return paintPerson(clothes, side, phase, 0.0, alert); });
}

Picture personWalking(const Clothes& clothes) {
    return fromFourSides(kFigureFrames, [&](Side side, double phase) {
        return paintPerson(clothes, side, phase, 1.0, false);
    });
}

// ---- Animals

constexpr int kAnimalWidth = 76;
constexpr int kAnimalHeight = 60;

struct Coat {
    const Ramp* ramp;
    double tone;
    const Ramp* face;
    double faceTone;
    const Ramp* legs;
    double legTone;
    double body;    // radius
    bool isWoolly;  // and with hanging ears; else with pointed ones and a bushy tail
};

constexpr Coat kLambCoat = {&kStoneRamp, 6.2, &kStoneRamp, 2.2, &kStoneRamp, 1.6, 11.5, true};
constexpr Coat kFoxCoat = {&kClayRamp, 3.6, &kClayRamp, 4.0, &kOakRamp, 1.4, 9.0, false};

void drawAnimalLeg(Surface& surface, const Coat& coat, Place upper, const FigureSwing& swing,
                   double stride, double dark, double height) {
    const double foot = upper.x + stride * swing.ahead;
    const double ground = kAnimalHeight - 2.4 - 4.0 * swing.lift;
    drawLimb(surface, upper, coat.body * 0.34, {foot, ground - 1.0}, 2.6,
             {.ramp = coat.legs, .tone = coat.legTone - dark, .height = height});
    drawBall(surface, {foot + 0.6, ground}, 3.2, 2.4,
             {.ramp = &kOakRamp, .tone = 0.9, .height = height + 1.0});
}

// Tufts along an ellipse make wool.
void drawWool(Surface& surface, const Coat& coat, Place middle, double wide, double high,
              double height) {
    drawBall(surface, middle, wide, high, {.ramp = coat.ramp, .tone = coat.tone, .height = height});
    if (!coat.isWoolly) return;
    for (int tuft = 0; tuft < 22; ++tuft) {
        const double round = tuft / 11.0;
        const double out = tuft < 11 ? 0.86 : 0.5;
        drawBall(surface,
                 {middle.x + out * wide * wave(0.5 * round + 0.02 * (tuft % 3)),
                  middle.y + out * high * wave(0.5 * round + 0.25)},
                 0.3 * wide, 0.3 * high,
                 {.ramp = coat.ramp,
                  .tone = coat.tone - 0.35 * (tuft % 2),
                  .height = height + 5.0 * (1.0 - out) + 3.0,
                  .bulge = 0.8});
    }
}

void drawAnimalHead(Surface& surface, const Coat& coat, Side side, Place at, double height) {
    const Paint face = {.ramp = coat.face, .tone = coat.faceTone, .height = height};
    const Paint ink = {.ramp = &kOakRamp, .tone = 0.2, .height = height + 9.0, .bulge = 0.2};
    const Paint ear = {.ramp = coat.face, .tone = coat.faceTone - 0.6, .height = height + 1.0};
    const double ears = side == Side::Right ? 3.0 : 7.0;
    for (const double sign : {-1.0, 1.0}) {
        if (side == Side::Right && sign > 0.0) continue;
        const double x = at.x + (side == Side::Right ? -ears : sign * ears);
        if (coat.isWoolly) {
            drawLimb(surface, {x, at.y - 3.0}, 2.8,
                     {x + (side == Side::Right ? -4.0 : sign * 4.5), at.y + 1.5}, 2.2, ear);
        } else {
            drawOutline(surface, {{x - 3.4, at.y - 3.0}, {x, at.y - 13.0}, {x + 3.4, at.y - 3.0}},
                        ear);
        }
    }
    if (side == Side::Right) {
        drawBall(surface, at, 7.0, 7.0, face);
        drawLimb(surface, at, 5.4, {at.x + 8.0, at.y + 3.0}, 3.0, face);
        drawBall(surface, {at.x + 10.6, at.y + 2.6}, 1.5, 1.3, ink);
        drawBall(surface, {at.x + 3.0, at.y - 1.6}, 1.4, 1.7, ink);
    } else {
        drawBall(surface, at, 7.2, 7.6, face);
        if (side == Side::Front) {
            drawBall(
                surface, {at.x, at.y + 4.6}, 4.0, 4.4,
                {.ramp = &kStoneRamp, .tone = coat.isWoolly ? 3.0 : 6.4, .height = height + 4.0});
            drawBall(surface, {at.x, at.y + 4.0}, 1.6, 1.3, ink);
            for (const double sign : {-1.0, 1.0})
                drawBall(surface, {at.x + sign * 3.8, at.y - 1.2}, 1.4, 1.7, ink);
        }
    }
    if (coat.isWoolly && side != Side::Right)
        drawWool(surface, coat, {at.x, at.y - 6.0}, 5.0, 3.4, height + 6.0);
    if (coat.isWoolly && side == Side::Right)
        drawWool(surface, coat, {at.x - 2.0, at.y - 5.6}, 4.6, 3.2, height + 6.0);
}

void drawBrush(Surface& surface, const Coat& coat, Side side, double sway) {
    if (coat.isWoolly) {
        if (side == Side::Back)
            drawLimb(surface, {38.0, 24.0}, 3.4, {38.0 + sway, 34.0}, 2.6,
                     {.ramp = coat.ramp, .tone = coat.tone, .height = 20.0});
        return;
    }
    const Place root = side == Side::Right ? Place{20.0, 33.0} : Place{38.0, 32.0};
    const Place tip =
        side == Side::Right ? Place{5.0, 29.0 + sway} : Place{38.0 + 5.0 * sway, 46.0};
    const double height = side == Side::Back ? 20.0 : 1.0;
    if (side == Side::Front) return;
    drawLimb(surface, root, 4.0, {0.4 * root.x + 0.6 * tip.x, 0.4 * root.y + 0.6 * tip.y}, 5.4,
             {.ramp = coat.ramp, .tone = coat.tone, .height = height});
    drawLimb(surface, {0.4 * root.x + 0.6 * tip.x, 0.4 * root.y + 0.6 * tip.y}, 5.2, tip, 2.2,
             {.ramp = &kStoneRamp, .tone = 6.2, .height = height + 1.0});
}

Picture paintAnimal(const Coat& coat, Side side, double phase, double strength) {
    const FigureSwing a = swingAt(phase, strength);
    const FigureSwing b = swingAt(phase + 0.5, strength);
    const double bob = strength * 0.9 * wave(2.0 * phase);
    Surface surface = Surface::empty(kAnimalWidth, kAnimalHeight);
    const double back = 32.0 + bob;
    if (side == Side::Right) {
        drawBrush(surface, coat, side, 1.5 * a.ahead);
        drawAnimalLeg(surface, coat, {27.0, back + 4.0}, b, 7.0, 0.6, 0.0);
        drawAnimalLeg(surface, coat, {49.0, back + 4.0}, a, 7.0, 0.6, 0.0);
        drawAnimalLeg(surface, coat, {25.0, back + 4.0}, a, 7.0, 0.0, 4.0);
        drawAnimalLeg(surface, coat, {47.0, back + 4.0}, b, 7.0, 0.0, 4.0);
        drawWool(surface, coat, {37.0, back}, 19.0, coat.body, 6.0);
        drawAnimalHead(surface, coat, side, {58.0, 20.0 + 1.4 * bob}, 12.0);
        return spriteOf(surface, kFigureLight);
    }
    const bool isFront = side == Side::Front;
    for (const double sign : {-1.0, 1.0}) {
        drawAnimalLeg(surface, coat, {38.0 + sign * 6.0, back + 6.0}, sign > 0.0 ? b : a, 0.8, 0.6,
                      0.0);
        drawAnimalLeg(surface, coat, {38.0 + sign * 5.0, back + 6.0}, sign > 0.0 ? a : b, 0.8, 0.0,
                      3.0);
    }
    if (!isFront) drawAnimalHead(surface, coat, side, {38.0, 18.0 + bob}, 2.0);
    drawWool(surface, coat, {38.0, back}, coat.body + 1.0, coat.body, 6.0);
    if (isFront) {
        if (!coat.isWoolly)
            drawBall(surface, {38.0, back + 3.0}, 5.4, 6.4,
                     {.ramp = &kStoneRamp, .tone = 6.2, .height = 14.0});
        drawAnimalHead(surface, coat, side, {38.0, 21.0 + bob}, 18.0);
    } else {
        drawBrush(surface, coat, side, 0.5 * a.ahead);
    }
    return spriteOf(surface, kFigureLight);
}

Picture animal(const Coat& coat, int frames) {
    return fromFourSides(frames, [&](Side side, double phase) {
        return paintAnimal(coat, side, phase, frames > 1 ? 1.0 : 0.0);
    });
}

}  // namespace

Picture paintKeeper() {
    return personStanding(kKeeperClothes, false);
}

Picture paintKeeperWalking() {
    return personWalking(kKeeperClothes);
}

Picture paintGuard() {
    return personStanding(kGuardClothes, false);
}

Picture paintGuardWalking() {
    return personWalking(kGuardClothes);
}

Picture paintGuardAlert() {
    return personStanding(kGuardClothes, true);
}

Picture paintLamb() {
    return animal(kLambCoat, 1);
}

Picture paintLambWalking() {
    return animal(kLambCoat, kFigureFrames);
}

Picture paintFox() {
    return animal(kFoxCoat, 1);
}

Picture paintFoxRunning() {
    return animal(kFoxCoat, kFigureFrames);
}

}  // namespace slicecast::textures
