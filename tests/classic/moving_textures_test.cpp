// The textures of what moves go with it.
#include "render/scenes.h"

#include "classic/draw_classic.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicecast::known {
namespace {

// Sixteen rows, each of its own colour.
Texture rowsTexture(std::uint8_t alpha) {
    Image image(16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x)
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(10 + 15 * y), 40, 0, alpha});
    }
    return makeTexture("rows", std::move(image));
}

constexpr int kSize = 120;

// Rows of the middle column that show the block, seen from two units before its middle.
std::vector<Pixel> blockRows(double offset, std::uint8_t alpha, bool classic) {
    World world = emptyWorld(7, 7, 4, plain("floor", kMagenta));
    const BlueprintId block = addBlock(world, addTexture(world, rowsTexture(alpha)));
    markSeeThrough(world);
    // Its far side is not seen.
    const TextureId hole = addTexture(world, plain("hole", {0, 0, 0, 0}, 16));
    if (alpha < 255) world.blueprints[block].faces[1].texture = hole;
    world.blueprints[block].motion = 0;
    world.blueprints[block].name = "block";
    world.motions.push_back(
        {.name = "lift", .from = toCoordinate(offset), .to = toCoordinate(offset)});
    world.maps[0].setCell(4, 3, 1, block);
    EXPECT_TRUE(makeMovers(world).empty());
    const Eye eye = eyeAt(2.0, 3.5, 1.53125 + offset, 0.0);
    const RenderOptions options = {.fovDegrees = 60.0, .detail = false};
    Image image(kSize, kSize);
    if (classic) {
        const Picture picture{image.pixels.data(), kSize, kSize, kSize};
        LitMaps lit;
        EXPECT_TRUE(drawClassic(world, eye, options, {}, lit, picture));
    } else {
        image = draw(world, eye, kSize, kSize, options);
    }
    std::vector<Pixel> rows;
    for (int row = 0; row < kSize; ++row) {
        const Pixel pixel = image.at(kSize / 2, row);
        if (pixel != toPixel(kMagenta)) rows.push_back(pixel);
    }
    return rows;
}

TEST(MovingTextures, GoWithTheBlock) {
    for (const bool classic : {false, true}) {
        for (const int alpha : {255, 200}) {
            const auto byte = static_cast<std::uint8_t>(alpha);
            const std::vector<Pixel> still = blockRows(0.0, byte, classic);
            // About 60 * sqrt(3) / 2 rows.
            ASSERT_GE(still.size(), 50u);
            for (const double offset : {0.4375, 1.25, -0.5625, -1.0})
                EXPECT_EQ(blockRows(offset, byte, classic), still) << offset << " " << alpha;
        }
    }
}

}  // namespace
}  // namespace slicecast::known
