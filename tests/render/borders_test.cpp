// Rays that run along a border between tiles, but for a rounding: they show the tile that they are
// in.
#include "scenes.h"

#include <gtest/gtest.h>

namespace slicecast::known {
namespace {

// Sixteen columns, each of its own colour.
Colour columnColour(int x) {
    return {static_cast<std::uint8_t>(10 + 15 * x), 40, 0, 255};
}
Texture columnsTexture() {
    Image image(16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) image.at(x, y) = toPixel(columnColour(x));
    }
    return makeTexture("columns", std::move(image));
}

// The eye is on the border x = 5 and looks north, a trifle to the west or east. All that it sees,
// undersides or ceiling and floor, shows the texture's last column, or its first.
TEST(Borders, ARayAlongOneStaysInItsTile) {
    constexpr int kWidth = 31;
    constexpr int kHeight = 80;
    const RenderOptions options = {.fovDegrees = 60.0, .detail = false};
    for (const bool west : {false, true}) {
        const double heading = west ? 269.99999999999994 : 270.00000000000006;
        const Pixel shown = toPixel(columnColour(west ? 15 : 0));
        for (const bool blocks : {false, true}) {
            World world = emptyWorld(10, 10, 2, columnsTexture());
            world.maps[0].ceiling = {.height = tileEdge(1), .tiles = std::vector<TextureId>(100)};
            const BlueprintId block = addBlock(world, 0, toCoordinate(0.5));
            for (int tile = 0; blocks && tile < 100; ++tile)
                world.maps[0].setCell(tile % 10, tile / 10, 1, block);
            const Image image =
                draw(world, eyeAt(5.0, 9.3, 0.4, heading), kWidth, kHeight, options);
            int rows = 0;
            for (int row = 0; row < kHeight; ++row) {
                const Pixel pixel = image.at(kWidth / 2, row);
                if (pixel == toPixel(kMagenta)) continue;  // the sky beyond the grid
                ASSERT_EQ(pixel, shown) << west << " " << blocks << " " << row;
                ++rows;
            }
            EXPECT_GE(rows, kHeight * 3 / 4);
        }
    }
}

}  // namespace
}  // namespace slicecast::known
