#include "furnishings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "marks.h"
#include "noise.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kFurnishingsSeed = 2000;

struct Binding {
    const Ramp* ramp;
    double tone;
};

constexpr std::array<Binding, 7> kBindings = {{{&kCrimsonRamp, 2.6},
                                               {&kSeaRamp, 1.5},
                                               {&kMossRamp, 2.6},
                                               {&kTimberRamp, 2.6},
                                               {&kSandRamp, 2.6},
                                               {&kSlateRamp, 2.4},
                                               {&kBurntRamp, 2.4}}};

struct Book {
    int left;
    int width;
    int foot;
    int height;
    Binding binding;
    int bands;
};

// A spine: round across, with gilded bands.
void drawBook(Surface& surface, const Book& book) {
    everyTexelIn(book.left, book.foot - book.height, book.left + book.width, book.foot,
                 [&](int x, int y) {
                     const double across = (x + 0.5 - book.left) / book.width;
                     const int fromTop = y - (book.foot - book.height);
                     const int fromFoot = book.foot - 1 - y;
                     Texel& texel = surface.at(x, y);
                     texel.ramp = book.binding.ramp;
                     texel.height = 1.0;
                     texel.tone = book.binding.tone + 0.9 - 5.0 * (across - 0.35) * (across - 0.35);
                     texel.tone += fromTop == 0 ? 0.5 : 0.0;
                     texel.tone -= x == book.left + book.width - 1 ? 0.6 : 0.0;
                     const bool band =
                         book.bands > 0 && (fromTop == 4 || fromFoot == 4 ||
                                            (book.bands > 1 && (fromTop == 7 || fromFoot == 7)));
                     const bool title = book.bands > 2 && fromTop > 10 && fromTop < 15 &&
                                        x > book.left && x < book.left + book.width - 1;
                     if (band || title) {
                         texel.ramp = &kBrassRamp;
                         texel.tone = 3.4 - 5.0 * (across - 0.35) * (across - 0.35);
                     }
                 });
}

void fillShelf(Surface& surface, int left, int right, int foot, std::uint32_t seed) {
    Random random(seed);
    int x = left;
    while (x < right - 3) {
        const int width = std::min(5 + random.below(6), right - x);
        const int height = 25 + random.below(9);
        const Binding binding =
            kBindings[static_cast<std::size_t>(random.below(static_cast<int>(kBindings.size())))];
        const int bands = random.below(4);
        // Now and then a gap, or a pile of flat books
        const double chance = random.fraction();
        if (chance < 0.07) {
            x += 4;
            continue;
        }
        if (chance < 0.16 && right - x > 26) {
            int top = foot;
            for (int book = 0; book < 3; ++book) {
                const Binding flat = kBindings[static_cast<std::size_t>(
                    random.below(static_cast<int>(kBindings.size())))];
                const int thick = 5 + random.below(3);
                const int wide = 19 + random.below(5);
                everyTexelIn(x, top - thick, x + wide, top, [&](int bookX, int bookY) {
                    const double across = (bookY + 0.5 - (top - thick)) / thick;
                    const bool gilt = bookX == x + 3 || bookX == x + wide - 4;
                    surface.at(bookX, bookY) = {.height = 1.0,
                                                .tone = (gilt ? 3.2 : flat.tone + 0.8) -
                                                        4.0 * (across - 0.3) * (across - 0.3),
                                                .ramp = gilt ? &kBrassRamp : flat.ramp};
                });
                top -= thick;
            }
            x += 25;
            continue;
        }
        drawBook(surface, {.left = x,
                           .width = width,
                           .foot = foot,
                           .height = height,
                           .binding = binding,
                           .bands = bands});
        x += width;
    }
}

}  // namespace

Picture paintBookshelf() {
    Surface surface;
    everyTexel(
        [&](int x, int y) { surface.at(x, y) = {.height = -4.0, .tone = 0.7, .ramp = &kOakRamp}; });
    for (int shelf = 0; shelf < 3; ++shelf) {
        const int foot = 41 + 42 * shelf;
        fillShelf(surface, 5, kSide - 5, foot,
                  kFurnishingsSeed + 1U + static_cast<std::uint32_t>(shelf));
    }
    // Boards and posts
    everyTexel([&](int x, int y) {
        const int post = std::min(x, kSide - 1 - x);
        const int board = wrap(y + 1, 42);
        const bool lastRows = y >= kSide - 2;
        Texel& texel = surface.at(x, y);
        if (post < 5) {
            texel = {.height = 3.0 * std::min(1.0, (5.0 - post) / 2.0),
                     .tone = 3.0 + 0.8 * woodGrain(y, x, kFurnishingsSeed + 10U),
                     .ramp = &kOakRamp};
        } else if (board < 4 || lastRows || y < 3) {
            texel = {.height = 2.0,
                     .tone = 3.3 + 0.8 * woodGrain(x, y, kFurnishingsSeed + 11U),
                     .ramp = &kOakRamp};
        }
    });
    return lit(surface, {.gain = 0.3,
                         .lightest = 0.6,
                         .darkest = 0.9,
                         .shadowReach = 5,
                         .shadowSlope = 0.7,
                         .shadowDepth = 1.1,
                         .hollowDepth = 0.05});
}

// The end of a cask on its rack.
Picture paintBarrel() {
    constexpr double kMiddle = 63.5;
    Surface surface;
    everyTexel([&](int x, int y) {
        const double dx = x - kMiddle;
        const double dy = y - kMiddle;
        const double distance = std::sqrt(dx * dx + dy * dy);
        Texel& texel = surface.at(x, y);
        if (distance > 62.0) {
            // The rack: a dark hollow, beams along the top and the bottom border
            const int fromBorder = std::min(y, kSide - 1 - y);
            texel = {.height = -4.0, .tone = 0.6, .ramp = &kOakRamp};
            if (fromBorder < 9) {
                texel.height = 2.0 * std::min(1.0, (9.0 - fromBorder) / 2.0);
                texel.tone = 2.4 + 0.8 * woodGrain(x, y, kFurnishingsSeed + 20U);
            }
        } else if (distance > 57.0) {
            texel = {
                .height = 4.0 - 0.4 * std::abs(distance - 59.5), .tone = 2.6, .ramp = &kSlateRamp};
        } else if (distance > 49.0) {
            // Ends of the staves; the sector from the slope of the line to the middle
            const double turn = dx / (std::abs(dx) + std::abs(dy) + 0.001);
            const double place = (dy < 0.0 ? turn : 4.0 - turn) * 5.0;
            const double part = place - std::floor(place);
            texel = {.height = 3.4,
                     .tone = 3.7 + 0.7 * (randomAt(static_cast<int>(std::floor(place)), 1,
                                                   kFurnishingsSeed + 21U) -
                                          0.5),
                     .ramp = &kTimberRamp};
            texel.tone -= part < 0.12 ? 1.6 : 0.0;
        } else {
            constexpr int kBoard = 16;
            const int board = x / kBoard;
            const int inside = std::min(x % kBoard, kBoard - 1 - x % kBoard);
            texel = {
                .height = std::min(1.0, 0.6 * inside),
                .tone = 2.9 + 0.7 * (randomAt(board, 2, kFurnishingsSeed + 22U) - 0.5) +
                        woodGrain(y, x, kFurnishingsSeed + 23U + static_cast<std::uint32_t>(board)),
                .ramp = &kTimberRamp};
            texel.tone = inside == 0 ? texel.tone - 1.3 : texel.tone;
        }
    });
    // A bar across the boards, the tap in the middle below
    everyTexelIn(18, 56, 110, 71, [&](int x, int y) {
        const double dx = x - kMiddle;
        const double dy = y - kMiddle;
        if (dx * dx + dy * dy < 49.0 * 49.0) {
            const int across = std::min(y - 56, 70 - y);
            surface.at(x, y) = {.height = 1.0 + 2.0 * std::min(1.0, (across + 1.0) / 2.5),
                                .tone = 3.5 + 0.9 * woodGrain(x, y, kFurnishingsSeed + 24U),
                                .ramp = &kTimberRamp};
        }
    });
    drawStud(
        surface,
        {.x = 64.0, .y = 92.0, .radius = 6.0, .height = 3.5, .tone = 2.9, .ramp = &kBrassRamp});
    drawSlab(surface, {.left = 62,
                       .top = 84,
                       .right = 67,
                       .bottom = 101,
                       .height = 5.0,
                       .bevel = 2.0,
                       .tone = 3.0,
                       .ramp = &kBrassRamp});
    drawSlab(surface, {.left = 57,
                       .top = 82,
                       .right = 72,
                       .bottom = 87,
                       .height = 6.0,
                       .bevel = 2.0,
                       .tone = 3.2,
                       .ramp = &kBrassRamp});
    return lit(surface, {.gain = 0.4,
                         .lightest = 0.8,
                         .darkest = 1.3,
                         .shadowReach = 6,
                         .shadowSlope = 0.8,
                         .shadowDepth = 1.1,
                         .hollowDepth = 0.06});
}

}  // namespace slicecast::textures
