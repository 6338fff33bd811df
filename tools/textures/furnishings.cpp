#include "furnishings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "marks.h"
#include "noise.h"
#include "stonework.h"

namespace slicecast::textures {

namespace {

constexpr std::uint32_t kSeed = 2000;

struct Binding {
    const Ramp* ramp;
    double tone;
};

constexpr std::array<Binding, 7> kBindings = {
    {{&kCrimsonRamp, 2.6}, {&kSeaRamp, 1.5}, {&kMossRamp, 2.6}, {&kTimberRamp, 2.6}, {&kSandRamp, 2.6}, {&kSlateRamp, 2.4}, {&kBurntRamp, 2.4}}};

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
    everyTexelIn(book.left, book.foot - book.height, book.left + book.width, book.foot, [&](int x, int y) {
        const double across = (x + 0.5 - book.left) / book.width;
        const int fromTop = y - (book.foot - book.height);
        const int fromFoot = book.foot - 1 - y;
        Texel& texel = surface.at(x, y);
        texel.ramp = book.binding.ramp;
        texel.height = 1.0;
        texel.tone = book.binding.tone + 0.9 - 5.0 * (across - 0.35) * (across - 0.35);
        texel.tone += fromTop == 0 ? 0.5 : 0.0;
        texel.tone -= x == book.left + book.width - 1 ? 0.6 : 0.0;
        const bool band = book.bands > 0 && (fromTop == 4 || fromFoot == 4 || (book.bands > 1 && (fromTop == 7 || fromFoot == 7)));
        const bool title = book.bands > 2 && fromTop > 10 && fromTop < 15 && x > book.left && x < book.left + book.width - 1;
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
        const Binding binding = kBindings[static_cast<std::size_t>(random.below(static_cast<int>(kBindings.size())))];
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
                const Binding flat = kBindings[static_cast<std::size_t>(random.below(static_cast<int>(kBindings.size())))];
                const int thick = 5 + random.below(3);
                const int wide = 19 + random.below(5);
                everyTexelIn(x, top - thick, x + wide, top, [&](int bookX, int bookY) {
                    const double across = (bookY + 0.5 - (top - thick)) / thick;
                    const bool gilt = bookX == x + 3 || bookX == x + wide - 4;
                    surface.at(bookX, bookY) = {
                        .height = 1.0, .tone = (gilt ? 3.2 : flat.tone + 0.8) - 4.0 * (across - 0.3) * (across - 0.3), .ramp = gilt ? &kBrassRamp : flat.ramp};
                });
                top -= thick;
            }
            x += 25;
            continue;
        }
        drawBook(surface, {.left = x, .width = width, .foot = foot, .height = height, .binding = binding, .bands = bands});
        x += width;
    }
}

struct Cloth {
    const Ramp* field;
    double tone;
};

Picture paintBannerOf(const Cloth& cloth) {
    constexpr int kLeft = 30;
    constexpr int kRight = 98;
    constexpr int kTop = 16;
    constexpr int kBottom = 118;
    constexpr double kMiddle = 63.5;
    static constexpr std::array<std::array<double, 2>, 8> kRays = {
        {{1.0, 0.0}, {0.7071, 0.7071}, {0.0, 1.0}, {-0.7071, 0.7071}, {-1.0, 0.0}, {-0.7071, -0.7071}, {0.0, -1.0}, {0.7071, -0.7071}}};
    const Surface wall = ashlarSurface();
    Surface surface = wall;
    everyTexelIn(kLeft, kTop, kRight, kBottom, [&](int x, int y) {
        // Swallow tail
        const double fromMiddle = std::abs(x - kMiddle);
        const double lowerEdge = kBottom - 22.0 + 22.0 * fromMiddle / 34.0;
        if (y > lowerEdge) {
            return;
        }
        const double inside = std::min({x - kLeft + 0.5, kRight - x - 0.5, (lowerEdge - y) * 0.8});
        const double fold = wave((x - kMiddle) / 26.0 + 0.1 + 0.004 * (y - kTop));
        Texel& texel = surface.at(x, y);
        texel.height = 4.0 + 1.1 * fold;
        texel.ramp = cloth.field;
        texel.tone = cloth.tone + 0.35 * fold;
        const auto gild = [&](double tone) {
            texel.ramp = &kBrassRamp;
            texel.tone = tone + 0.3 * fold;
        };
        if (inside > 3.0 && inside < 6.5) {
            gild(3.0);
        }
        // The sun over the sea
        const double dx = x - kMiddle;
        const double dy = y - 50.0;
        const double distance = std::sqrt(dx * dx + dy * dy);
        if (distance < 10.0) {
            gild(distance < 8.0 ? 3.8 - 0.06 * (dx + dy) : 2.2);
        } else if (distance > 11.5 && distance < 21.0) {
            for (const auto& ray : kRays) {
                const double along = dx * ray[0] + dy * ray[1];
                const double across = std::abs(dx * ray[1] - dy * ray[0]);
                if (along > 0.0 && across < (21.0 - along) * 0.3) {
                    gild(3.2);
                }
            }
        }
        for (int crest = 0; crest < 2; ++crest) {
            const double swell = 78.0 + 9.0 * crest + 2.6 * wave(dx / 17.0);
            if (std::abs(y - swell) < 2.0 && inside > 9.0) {
                texel.ramp = &kStoneRamp;
                texel.tone = 5.6 + 0.4 * fold;
            }
        }
    });
    // The rod, its knobs, and the loops that hold the cloth
    everyTexelIn(24, 12, 105, 17, [&](int x, int y) {
        const int across = std::min(y - 12, 16 - y);
        surface.at(x, y) = {.height = 5.0 + 0.8 * across, .tone = 2.6, .ramp = &kBrassRamp};
    });
    drawStud(surface, {.x = 23.0, .y = 14.5, .radius = 4.0, .height = 4.0, .tone = 3.0, .ramp = &kBrassRamp});
    drawStud(surface, {.x = 105.0, .y = 14.5, .radius = 4.0, .height = 4.0, .tone = 3.0, .ramp = &kBrassRamp});
    for (int loop = 0; loop < 5; ++loop) {
        const int left = kLeft + 2 + loop * 15;
        everyTexelIn(left, 11, left + 5, 18, [&](int x, int y) { surface.at(x, y) = {.height = 6.0, .tone = cloth.tone, .ramp = cloth.field}; });
    }
    return litOver(wall, ashlarLighting(), surface,
                   {.gain = 0.45, .lightest = 0.8, .darkest = 1.0, .shadowReach = 5, .shadowSlope = 0.8, .shadowDepth = 1.0, .hollowDepth = 0.04});
}

}  // namespace

Picture paintBookshelf() {
    Surface surface;
    everyTexel([&](int x, int y) { surface.at(x, y) = {.height = -4.0, .tone = 0.7, .ramp = &kOakRamp}; });
    for (int shelf = 0; shelf < 3; ++shelf) {
        const int foot = 41 + 42 * shelf;
        fillShelf(surface, 5, kSide - 5, foot, kSeed + 1U + static_cast<std::uint32_t>(shelf));
    }
    // Boards and posts
    everyTexel([&](int x, int y) {
        const int post = std::min(x, kSide - 1 - x);
        const int board = wrap(y + 1, 42);
        const bool lastRows = y >= kSide - 2;
        Texel& texel = surface.at(x, y);
        if (post < 5) {
            texel = {.height = 3.0 * std::min(1.0, (5.0 - post) / 2.0), .tone = 3.0 + 0.8 * woodGrain(y, x, kSeed + 10U), .ramp = &kOakRamp};
        } else if (board < 4 || lastRows || y < 3) {
            texel = {.height = 2.0, .tone = 3.3 + 0.8 * woodGrain(x, y, kSeed + 11U), .ramp = &kOakRamp};
        }
    });
    return lit(surface, {.gain = 0.3, .lightest = 0.6, .darkest = 0.9, .shadowReach = 5, .shadowSlope = 0.7, .shadowDepth = 1.1, .hollowDepth = 0.05});
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
                texel.tone = 2.4 + 0.8 * woodGrain(x, y, kSeed + 20U);
            }
        } else if (distance > 57.0) {
            texel = {.height = 4.0 - 0.4 * std::abs(distance - 59.5), .tone = 2.6, .ramp = &kSlateRamp};
        } else if (distance > 49.0) {
            // Ends of the staves; the sector from the slope of the line to the middle
            const double turn = dx / (std::abs(dx) + std::abs(dy) + 0.001);
            const double place = (dy < 0.0 ? turn : 4.0 - turn) * 5.0;
            const double part = place - std::floor(place);
            texel = {.height = 3.4, .tone = 3.7 + 0.7 * (randomAt(static_cast<int>(std::floor(place)), 1, kSeed + 21U) - 0.5), .ramp = &kTimberRamp};
            texel.tone -= part < 0.12 ? 1.6 : 0.0;
        } else {
            constexpr int kBoard = 16;
            const int board = x / kBoard;
            const int inside = std::min(x % kBoard, kBoard - 1 - x % kBoard);
            texel = {.height = std::min(1.0, 0.6 * inside),
                     .tone = 2.9 + 0.7 * (randomAt(board, 2, kSeed + 22U) - 0.5) + woodGrain(y, x, kSeed + 23U + static_cast<std::uint32_t>(board)),
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
            surface.at(x, y) = {
                .height = 1.0 + 2.0 * std::min(1.0, (across + 1.0) / 2.5), .tone = 3.5 + 0.9 * woodGrain(x, y, kSeed + 24U), .ramp = &kTimberRamp};
        }
    });
    drawStud(surface, {.x = 64.0, .y = 92.0, .radius = 6.0, .height = 3.5, .tone = 2.9, .ramp = &kBrassRamp});
    drawSlab(surface, {.left = 62, .top = 84, .right = 67, .bottom = 101, .height = 5.0, .bevel = 2.0, .tone = 3.0, .ramp = &kBrassRamp});
    drawSlab(surface, {.left = 57, .top = 82, .right = 72, .bottom = 87, .height = 6.0, .bevel = 2.0, .tone = 3.2, .ramp = &kBrassRamp});
    return lit(surface, {.gain = 0.4, .lightest = 0.8, .darkest = 1.3, .shadowReach = 6, .shadowSlope = 0.8, .shadowDepth = 1.1, .hollowDepth = 0.06});
}

Picture paintBanner() {
    return paintBannerOf({&kCrimsonRamp, 2.4});
}

Picture paintBannerSea() {
    return paintBannerOf({&kSeaRamp, 1.4});
}

// Mouldings, a meander, and a row of rosettes, cut in pale stone.
Picture paintFrieze() {
    constexpr int kStep = 4;
    static constexpr std::array<std::string_view, 8> kMeander = {"################", "................", "#######.#######.", "#.....#.#.....#.",
                                                                 "#.###.#.#.###.#.", "#.#...#.#.#...#.", "#.#####.#.#####.", "................"};
    static constexpr std::array<std::array<double, 2>, 8> kPetals = {
        {{1.0, 0.0}, {0.7071, 0.7071}, {0.0, 1.0}, {-0.7071, 0.7071}, {-1.0, 0.0}, {-0.7071, -0.7071}, {0.0, -1.0}, {0.7071, -0.7071}}};
    Surface surface;
    everyTexel([&](int x, int y) {
        const double blotch = fractalNoise(x / 16.0, y / 16.0, 8, 8, 3, kSeed + 30U) - 0.5;
        Texel& texel = surface.at(x, y);
        texel.ramp = &kStoneRamp;
        texel.tone = 4.4 + 0.8 * blotch;
        if (y < 8) {
            texel.height = 7.0 - 0.3 * std::abs(y - 3);
        } else if (y < 14) {
            texel.height = 5.5 - 0.5 * (y - 8);
        } else if (y >= 18 && y < 50) {
            const bool raised = kMeander[static_cast<std::size_t>((y - 18) / kStep)][static_cast<std::size_t>(x / kStep % 16)] == '#';
            texel.height = raised ? 2.0 : 0.0;
            texel.tone -= raised ? 0.0 : 0.7;
        } else if (y >= 50 && y < 56) {
            texel.height = 3.0;
        } else if (y >= 108 && y < 114) {
            texel.height = 3.0;
        } else if (y >= 114) {
            texel.height = 4.0 + 0.25 * (y - 114);
        } else if (y >= 56) {
            texel.tone -= 0.5;
        } else {
            texel.height = 2.0;
        }
    });
    for (const double middleX : {32.0, 96.0}) {
        constexpr double kMiddleY = 82.0;
        everyTexelIn(static_cast<int>(middleX) - 25, 57, static_cast<int>(middleX) + 26, 108, [&](int x, int y) {
            const double dx = x + 0.5 - middleX;
            const double dy = y + 0.5 - kMiddleY;
            const double ring = std::abs(std::sqrt(dx * dx + dy * dy) - 22.5);
            if (ring < 2.4) {
                surface.at(x, y).height = 2.5 - ring * 0.6;
                surface.at(x, y).tone += 0.4;
            }
        });
        for (const auto& petal : kPetals) {
            drawStud(surface,
                     {.x = middleX + 12.0 * petal[0], .y = kMiddleY + 12.0 * petal[1], .radius = 5.2, .height = 4.0, .tone = 4.4, .ramp = &kStoneRamp});
        }
        drawStud(surface, {.x = middleX, .y = kMiddleY, .radius = 5.5, .height = 5.0, .tone = 4.6, .ramp = &kStoneRamp});
        // Between the rosettes a standing leaf
        for (int leaf = 0; leaf < 3; ++leaf) {
            const double lean = 7.0 * (leaf - 1);
            for (int step = 0; step < 5; ++step) {
                drawStud(surface, {.x = middleX + 32.0 + lean * step / 5.0,
                                   .y = 102.0 - 8.0 * step + 0.6 * std::abs(lean) * step / 5.0,
                                   .radius = 3.4 - 0.45 * step,
                                   .height = 2.4,
                                   .tone = 4.4,
                                   .ramp = &kStoneRamp});
            }
        }
    }
    return lit(surface, {.gain = 0.5, .lightest = 0.9, .darkest = 1.4, .shadowReach = 4, .shadowSlope = 0.7, .shadowDepth = 0.9, .hollowDepth = 0.1});
}

}  // namespace slicecast::textures
