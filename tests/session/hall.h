// A hall for the tests that compare what is told of a picture with the picture.
#pragma once

#include "world_builder.h"

namespace slicecast {

// A texel tells which one it is, and of which texture. `hole` makes a chess board of holes.
inline Image numbered(int size, int blue, int alpha = 255, bool hole = false) {
    Image image(size, size);
    const auto share = [size](int i) { return static_cast<std::uint8_t>(i * 255 / (size - 1)); };
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const bool isHole = hole && (x / 4 + y / 4) % 2 == 0;
            image.at(x, y) = toPixel({share(x), share(y), static_cast<std::uint8_t>(blue),
                                      static_cast<std::uint8_t>(isHole ? 0 : alpha)});
        }
    }
    return image;
}

// Blocks of several heights, a pane that can be seen through, a ceiling over one half, a lamp, a
// portal in the north to a garden.
inline World hall(const char* pane, Image paneImage, Image lampImage) {
    WorldBuilder make;
    make.texture("stone", numbered(32, 60));
    make.texture(pane, std::move(paneImage));
    make.texture("ground", numbered(64, 130));
    make.world.sprites.push_back(makeSprite("lamp", std::move(lampImage)));
    make.block('#', {.name = "wall"});
    make.block('-', {.name = "bench", .top = 0.375});
    make.block('=', {.name = "beam", .bottom = 0.5, .top = 0.75});
    make.block('o', {.name = pane, .bottom = 0.25, .texture = 1});
    make.map("hall", 3, R"(
............#.
............#.
............#.
............#.
......-.....#.
.......o....#.
............#.
........-...#.
............#.
............#.
##############
)",
             2);
    for (int x = 0; x < 14; ++x) make.put('#', x, 10, 1);
    make.put('=', 9, 5, 1);
    make.put('=', 5, 7, 2);
    make.ceiling(2.0, 0, 5, 11);
    make.object(5.5, 4.5, 0.25, 0.5, 0.5);
    make.map("garden", 9, 9, 2, 2);
    make.put('#', 4, 3);
    make.tilePortal(
        {.fromMap = 0, .fromX = 6, .fromY = 1, .toMap = 1, .toX = 4, .toY = 7, .turn = 3});
    markPortals(make.world);
    markSeeThrough(make.world);
    make.start(2.3, 5.2);
    return std::move(make.world);
}

}  // namespace slicecast
