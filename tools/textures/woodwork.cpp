#include "woodwork.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "marks.h"
#include "noise.h"
#include "pieces.h"
#include "plaster.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kWoodworkSeed = 400;

// A knot: the grain makes way for a dark eye.
void drawKnot(Surface& surface, int middleX, int middleY, bool upright) {
    everyTexelIn(middleX - 6, middleY - 6, middleX + 7, middleY + 7, [&](int x, int y) {
        const double along = (upright ? y - middleY : x - middleX) / 2.0;
        const double across = upright ? x - middleX : y - middleY;
        const double distance = std::sqrt(along * along + across * across);
        if (distance < 1.2) {
            surface.at(x, y).tone = 1.0;
        } else if (distance < 2.3) {
            surface.at(x, y).tone -= 0.2;
        } else if (distance < 3.1) {
            surface.at(x, y).tone -= 0.8;
        }
    });
}

void drawNail(Surface& surface, int x, int y) {
    surface.at(x, y).tone = 0.0;
    surface.at(x + 1, y).tone = 0.5;
    surface.at(x, y + 1).tone = 0.5;
    surface.at(x + 1, y + 1).tone += 0.6;
}

// A squared timber lying along x or y, laid on top of what is there.
struct Beam {
    int left;
    int top;
    int right;
    int bottom;
    bool upright;
    double height;
    std::uint32_t seed;
};

void drawBeam(Surface& surface, const Beam& beam) {
    everyTexelIn(beam.left, beam.top, beam.right, beam.bottom, [&](int x, int y) {
        const int across = beam.upright ? std::min(x - beam.left, beam.right - 1 - x)
                                        : std::min(y - beam.top, beam.bottom - 1 - y);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kOakRamp;
        texel.height = beam.height * std::min(1.0, (across + 1.0) / 2.0);
        texel.tone =
            2.9 + 0.9 * (beam.upright ? woodGrain(y, x, beam.seed) : woodGrain(x, y, beam.seed));
    });
}

// Wooden pegs where beams meet.
void drawPeg(Surface& surface, int x, int y) {
    drawStud(
        surface,
        {.x = x + 0.0, .y = y + 0.0, .radius = 1.8, .height = 1.2, .tone = 3.6, .ramp = &kOakRamp});
}

}  // namespace

Lighting timberLighting() {
    return {.gain = 0.4,
            .lightest = 0.8,
            .darkest = 1.4,
            .shadowReach = 4,
            .shadowSlope = 0.8,
            .shadowDepth = 1.1};
}

Picture paintPlanksFloor() {
    constexpr int kBoard = 16;
    static const Pieces boards(coursed({{kBoard, 22, {128}},
                                        {kBoard, 86, {128}},
                                        {kBoard, 50, {128}},
                                        {kBoard, 118, {128}},
                                        {kBoard, 6, {128}},
                                        {kBoard, 70, {128}},
                                        {kBoard, 38, {128}},
                                        {kBoard, 102, {128}}}),
                               0.0, kWoodworkSeed);
    static constexpr std::array<int, 8> kBoardEnds = {22, 86, 50, 118, 6, 70, 38, 102};
    Surface surface;
    everyTexel([&](int x, int y) {
        Texel& texel = surface.at(x, y);
        const int board = y / kBoard;
        const int fromJoint = wrap(x - kBoardEnds[static_cast<std::size_t>(board)], kSide);
        const double gap =
            std::min({boards.edgeAt(x, y), fromJoint + 0.5, kSide - fromJoint - 0.5});
        const auto seed = kWoodworkSeed + 10U * static_cast<std::uint32_t>(board);
        texel.ramp = &kTimberRamp;
        texel.height = std::clamp(gap * 0.7 - 0.35, 0.0, 1.0);
        texel.tone = 2.7 + 0.9 * (randomAt(board, 1, kWoodworkSeed) - 0.5) + woodGrain(x, y, seed);
        if (gap < 0.8) {
            texel.tone = y % kBoard == kBoard - 1 || fromJoint == kSide - 1 ? 0.4 : texel.tone;
        }
    });
    for (int board = 0; board < 8; ++board) {
        const int joint = kBoardEnds[static_cast<std::size_t>(board)];
        for (const int across : {4, 11}) {
            drawNail(surface, joint + 3, board * kBoard + across);
            drawNail(surface, joint - 5, board * kBoard + across);
        }
    }
    drawKnot(surface, 60, 8, false);
    drawKnot(surface, 14, 39, false);
    drawKnot(surface, 92, 71, false);
    drawKnot(surface, 40, 120, false);
    return lit(surface, {.gain = 0.5,
                         .lightest = 0.6,
                         .darkest = 1.0,
                         .shadowReach = 1,
                         .shadowSlope = 0.6,
                         .shadowDepth = 0.4});
}

Picture paintPlanksWall() {
    static constexpr std::array<int, 7> kEdges = {0, 20, 43, 62, 86, 106, 128};
    Surface surface;
    everyTexel([&](int x, int y) {
        int board = 0;
        while (x >= kEdges[static_cast<std::size_t>(board) + 1]) {
            ++board;
        }
        const int left = x - kEdges[static_cast<std::size_t>(board)];
        const int right = kEdges[static_cast<std::size_t>(board) + 1] - 1 - x;
        const auto seed = kWoodworkSeed + 100U + 10U * static_cast<std::uint32_t>(board);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kTimberRamp;
        texel.height = std::min({(left + 0.4) * 0.9, (right + 0.4) * 0.9, 2.0});
        texel.tone =
            3.8 + 0.9 * (randomAt(board, 2, kWoodworkSeed) - 0.5) + 1.1 * woodGrain(y, x, seed);
        if (right == 0) {
            texel.tone = 0.8;
        }
    });
    for (int board = 0; board < 6; ++board) {
        const int middle = (kEdges[static_cast<std::size_t>(board)] +
                            kEdges[static_cast<std::size_t>(board) + 1]) /
                           2;
        for (const int y : {12, 76}) {
            drawNail(surface, middle - 5, y);
            drawNail(surface, middle + 4, y);
        }
    }
    drawKnot(surface, 31, 40, true);
    drawKnot(surface, 74, 104, true);
    drawKnot(surface, 96, 28, true);
    drawKnot(surface, 10, 92, true);
    drawKnot(surface, 117, 60, true);
    return lit(surface, {.gain = 0.45,
                         .lightest = 0.7,
                         .darkest = 1.2,
                         .shadowReach = 2,
                         .shadowSlope = 0.7,
                         .shadowDepth = 0.7});
}

Surface timberFrameSurface() {
    Surface surface = whitewashSurface();
    // Posts and rails straddle the borders, so that neighbours share them
    drawBeam(surface, {.left = 0,
                       .top = -8,
                       .right = kSide,
                       .bottom = 8,
                       .upright = false,
                       .height = 3.0,
                       .seed = kWoodworkSeed + 200U});
    drawBeam(surface, {.left = -9,
                       .top = 8,
                       .right = 9,
                       .bottom = kSide - 8,
                       .upright = true,
                       .height = 3.0,
                       .seed = kWoodworkSeed + 210U});
    drawPeg(surface, -4, 3);
    drawPeg(surface, 5, -3);
    return surface;
}

Picture paintTimberFrame() {
    Surface surface = timberFrameSurface();
    drawBeam(surface, {.left = 57,
                       .top = 8,
                       .right = 71,
                       .bottom = kSide - 8,
                       .upright = true,
                       .height = 3.0,
                       .seed = kWoodworkSeed + 220U});
    drawPeg(surface, 61, 3);
    drawPeg(surface, 67, -3);
    return lit(surface, timberLighting());
}

Picture paintTimberFrameBrace() {
    Surface surface = timberFrameSurface();
    // A brace from the upper left to the lower right corner, slightly bowed
    everyTexelIn(9, 8, kSide - 9, kSide - 8, [&](int x, int y) {
        const double along = (x + y - kSide) / 110.0;
        const double across = (y - x) * 0.7071 + 9.0 * (1.0 - along * along) - 4.5;
        if (across > -8.0 && across < 8.0) {
            Texel& texel = surface.at(x, y);
            texel.ramp = &kOakRamp;
            texel.height = 2.6 * std::min(1.0, (8.0 - std::abs(across)) / 2.0);
            texel.tone = 3.1 + 0.9 * woodGrain((x + y) * 0.5, across + 40.0, kWoodworkSeed + 230U);
        }
    });
    return lit(surface, timberLighting());
}

Picture paintCeilingBeams() {
    Surface surface;
    everyTexel([&](int x, int y) {
        constexpr int kBoard = 16;
        const int board = x / kBoard;
        const int inside = std::min(x % kBoard, kBoard - 1 - x % kBoard);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kOakRamp;
        texel.height = std::min(1.0, inside * 0.6);
        texel.tone =
            2.5 + 0.6 * (randomAt(board, 3, kWoodworkSeed) - 0.5) +
            0.7 * woodGrain(y, x, kWoodworkSeed + 300U + static_cast<std::uint32_t>(board));
        texel.tone = x % kBoard == kBoard - 1 ? 0.5 : texel.tone;
    });
    for (const int top : {18, 82}) {
        drawBeam(surface, {.left = 0,
                           .top = top,
                           .right = kSide,
                           .bottom = top + 28,
                           .upright = false,
                           .height = 9.0,
                           .seed = kWoodworkSeed + 320U + static_cast<std::uint32_t>(top)});
        everyTexelIn(0, top, kSide, top + 28, [&](int x, int y) { surface.at(x, y).tone += 0.7; });
        everyTexelIn(0, top + 28, kSide, top + 33,
                     [&](int x, int y) { surface.at(x, y).tone -= 0.6; });
    }
    return lit(surface, {.gain = 0.35,
                         .lightest = 0.9,
                         .darkest = 1.3,
                         .shadowReach = 8,
                         .shadowSlope = 0.9,
                         .shadowDepth = 1.0});
}

Picture paintCrate() {
    constexpr int kFrame = 18;
    Surface surface;
    // Boards behind
    everyTexel([&](int x, int y) {
        const int board = x / 16;
        const int inside = std::min(x % 16, 15 - x % 16);
        Texel& texel = surface.at(x, y);
        texel.ramp = &kTimberRamp;
        texel.height = std::min(1.0, inside * 0.7);
        texel.tone = 2.7 + 0.8 * (randomAt(board, 4, kWoodworkSeed) - 0.5) +
                     woodGrain(y, x, kWoodworkSeed + 400U + static_cast<std::uint32_t>(board));
        texel.tone = inside == 0 ? texel.tone - 1.5 : texel.tone;
    });
    // The brace, then the frame around
    const auto frameTone = [](double grain) { return 3.7 + 0.9 * grain; };
    everyTexelIn(kFrame, kFrame, kSide - kFrame, kSide - kFrame, [&](int x, int y) {
        const double across = (x + y - kSide) * 0.7071;
        if (across > -9.0 && across < 9.0) {
            Texel& texel = surface.at(x, y);
            texel.height = 1.0 + 2.5 * std::min(1.0, (9.0 - std::abs(across)) / 2.0);
            texel.tone = frameTone(woodGrain((x - y) * 0.5, across + 30.0, kWoodworkSeed + 420U));
        }
    });
    everyTexel([&](int x, int y) {
        const int side = std::min(x, kSide - 1 - x);
        const int end = std::min(y, kSide - 1 - y);
        if (std::min(side, end) >= kFrame) {
            return;
        }
        const bool rail = end < kFrame;
        const int outer = rail ? std::min(side, end) : side;
        const int inner = rail ? kFrame - 1 - end : kFrame - 1 - side;
        Texel& texel = surface.at(x, y);
        texel.height = 4.5 * std::min({1.0, (outer + 1.0) / 2.5, (inner + 1.0) / 2.5});
        texel.tone = frameTone(rail ? woodGrain(x, y, kWoodworkSeed + 430U)
                                    : woodGrain(y, x, kWoodworkSeed + 440U));
        if (!rail && (y == kFrame || y == kSide - 1 - kFrame)) {
            texel.tone -= 1.4;
        }
    });
    for (const int x : {9, kSide - 9}) {
        for (const int y : {9, kSide - 9}) {
            drawStud(surface, {.x = x + 0.0,
                               .y = y + 0.0,
                               .radius = 2.6,
                               .height = 2.0,
                               .tone = 2.6,
                               .ramp = &kSlateRamp});
        }
    }
    for (const int middle : {9, kSide - 9}) {
        for (int board = 1; board < 7; ++board) {
            const int along = board * 16 + 8;
            drawStud(surface, {.x = along + 0.0,
                               .y = middle + 0.0,
                               .radius = 1.6,
                               .height = 1.2,
                               .tone = 2.2,
                               .ramp = &kSlateRamp});
        }
    }
    return lit(surface, {.gain = 0.4,
                         .lightest = 0.9,
                         .darkest = 1.4,
                         .shadowReach = 4,
                         .shadowSlope = 0.8,
                         .shadowDepth = 1.0});
}

}  // namespace slicecast::textures
