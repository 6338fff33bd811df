// What walls and roofs were covered with: what each old way shows wrongly.
#include "classic_scenes.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace slicecast::known {
namespace {

TEST(Classic, StretchedTexturesGrowWithTheStack) {
    World world = emptyWorld(20, 9, 4, plain("floor", kBlack));
    const TextureId texture = addTexture(world, halves("wall", kWhite, kGreen));
    const BlueprintId full = addBlock(world, texture);
    const BlueprintId half = addBlock(world, texture, {}, toCoordinate(0.5));
    for (const BlueprintId block : {full, half}) {
        world.blueprints[block].faces[static_cast<std::size_t>(Face::top)].texture = 0;
        world.blueprints[block].faces[static_cast<std::size_t>(Face::bottom)].texture = 0;
    }
    Map& map = world.maps[0];
    for (int y = 0; y < 9; ++y) {
        for (int level = 0; level < 3; ++level) map.setCell(10, y, level, full);
        map.setCell(10, y, 3, half);
    }
    const auto runs = [&](const ClassicOptions& classic) {
        const Image image = drawOld(world, eyeAt(6.0, 4.5, 0.5, 0.0, 0.2), 200, 200, classic).image;
        std::vector<int> lengths;
        for (int y = 0; y < 200; ++y) {
            const Pixel pixel = image.at(100, y);
            if (pixel != toPixel(kWhite) && pixel != toPixel(kGreen)) continue;
            if (y > 0 && pixel == image.at(100, y - 1))
                ++lengths.back();
            else
                lengths.push_back(1);
        }
        return lengths;
    };
    // A unit at depth 4 with d = 173 is 43.3 rows. Three and a half tiles, the half one showing its
    // lower half; or one over 3.5 units, 75.8 rows each half.
    const std::vector<int> tiled = runs({});
    ASSERT_EQ(tiled.size(), 7u);
    for (const int length : tiled) EXPECT_NEAR(length, 21.7, 1.0);
    const std::vector<int> stretched = runs({.stretched = true});
    ASSERT_EQ(stretched.size(), 2u);
    for (const int length : stretched) EXPECT_NEAR(length, 75.8, 1.0);

    // Blocks that do not touch are stacks of their own: a gap below a level's edge, then one above
    // it.
    const auto expectStacks = [&](double upperUnits, double lowerUnits) {
        const std::vector<int> lengths = runs({.stretched = true});
        ASSERT_EQ(lengths.size(), 4u);
        for (const std::size_t run : {0u, 1u})
            EXPECT_NEAR(lengths[run], upperUnits / 2.0 * 43.3, 1.0);
        for (const std::size_t run : {2u, 3u})
            EXPECT_NEAR(lengths[run], lowerUnits / 2.0 * 43.3, 1.0);
    };
    for (int y = 0; y < 9; ++y) map.setCell(10, y, 0, half);
    expectStacks(2.5, 0.5);
    const BlueprintId raised = addBlock(world, texture, toCoordinate(0.5));
    world.blueprints[raised].faces[static_cast<std::size_t>(Face::bottom)].texture = 0;
    for (int y = 0; y < 9; ++y) {
        world.maps[0].setCell(10, y, 0, full);
        world.maps[0].setCell(10, y, 1, raised);
    }
    expectStacks(2.0, 1.0);
}

// It is the picture of a smaller screen, enlarged.
TEST(Classic, CoarsePixelsAreBlocksOfOneColour) {
    const World world = mixedWorld(3);
    const Eye eye = eyeAt(5.3, 4.6, 2.4, 33.0, 0.125);
    const Image small = drawOld(world, eye, 40, 30, {}).image;
    const Drawn coarse = drawOld(world, eye, 160, 120, {.pixelSize = 4});
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x)
            ASSERT_EQ(coarse.image.at(x, y), small.at(x / 4, y / 4)) << x << ", " << y;
    }
    EXPECT_EQ(coarse.report.rowsFilled, 40 * 30);

    // The last ones may be cut off.
    const Image cut = drawOld(world, eye, 15, 13, {.pixelSize = 8}).image;
    EXPECT_TRUE(columnsAreEqual(cut, 8, 14));
    EXPECT_EQ(cut.at(14, 8), cut.at(14, 12));
}

TEST(Classic, WithoutTexturesAndLightCornersVanish) {
    // Two walls that meet in a corner, by the same texture.
    World world = emptyWorld(12, 12, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, squares("wall", 90)));
    for (int i = 0; i < 12; ++i) {
        world.maps[0].setCell(11, i, 0, block);
        world.maps[0].setCell(i, 11, 0, block);
    }
    world.maps[0].light = {.on = true, .intensity = 0.5, .multiplier = 5.0};
    const auto wallColours = [&](const RenderOptions& options) {
        const Image image = drawOld(world, eyeAt(6.5, 8.5, 0.5, 45.0), 200, 100, {}, options).image;
        return std::set<Pixel>(image.pixels.begin() + 50 * 200, image.pixels.begin() + 51 * 200)
            .size();
    };
    EXPECT_EQ(wallColours({.textures = false, .light = false}), 1u)
        << "one colour all along, around the corner too";
    EXPECT_GT(wallColours({.textures = false}), 10u) << "light tells near from far";
    EXPECT_EQ(wallColours({.light = false}), 8u)
        << "the texels of one row, as bright far away as near";
    EXPECT_GT(wallColours({}), 30u);
}

// A block whose texture is white on the left: seen from the north and the east, old programs showed
// it on the right.
TEST(Classic, TexturesAreMirroredOnTwoFaces) {
    World world = emptyWorld(9, 9, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, sides("sign", kWhite, kGreen)));
    world.maps[0].setCell(4, 4, 0, block);
    const auto left = [&](double x, double y, double heading, bool mirrored) {
        const Image image = drawOld(world, eyeAt(x, y, 0.5, heading), 100, 20,
                                    {.mirroredTextures = mirrored}, {.fovDegrees = 20.0})
                                .image;
        EXPECT_NE(image.at(20, 10), image.at(80, 10));
        return image.at(20, 10);
    };
    const Pixel white = toPixel(kWhite);
    const Pixel green = toPixel(kGreen);
    for (const bool mirrored : {false, true}) {
        EXPECT_EQ(left(4.5, 7.5, 270.0, mirrored), white) << "south";
        EXPECT_EQ(left(1.5, 4.5, 0.0, mirrored), white) << "west";
        EXPECT_EQ(left(4.5, 1.5, 90.0, mirrored), mirrored ? green : white) << "north";
        EXPECT_EQ(left(7.5, 4.5, 180.0, mirrored), mirrored ? green : white) << "east";
    }
}

// From above, over a wall with squares on its roof.
TEST(Classic, RoofsAreFlatOrMissing) {
    World world = emptyWorld(20, 9, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, plain("wall", kWhite)));
    world.blueprints[block].faces[static_cast<std::size_t>(Face::top)].texture =
        addTexture(world, halves("roof", kRed, kGreen));
    for (int y = 0; y < 9; ++y) world.maps[0].setCell(10, y, 0, block);
    const auto roof = [&](ClassicRoofs roofs) {
        const Image image =
            drawOld(world, eyeAt(6.0, 4.5, 2.5, 0.0), 100, 100, {.roofs = roofs}).image;
        std::set<Pixel> colours(image.pixels.begin(), image.pixels.end());
        colours.erase(toPixel(kBlack));
        colours.erase(toPixel(kWhite));
        colours.erase(toPixel(kMagenta));
        return colours;
    };
    EXPECT_EQ(roof(ClassicRoofs::textured), (std::set<Pixel>{toPixel(kRed), toPixel(kGreen)}));
    EXPECT_EQ(roof(ClassicRoofs::flat), (std::set<Pixel>{toPixel({128, 128, 0, 255})}))
        << "their average";
    EXPECT_EQ(roof(ClassicRoofs::missing), std::set<Pixel>{}) << "the floor behind shows";
}

// Three blocks on one another: a line of the roof's colour lies under each but the lowest, and the
// picture's edges show something else than the wall that fills it.
TEST(Classic, SeamsLieBetweenStackedBlocks) {
    World world = emptyWorld(20, 9, 3, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, plain("wall", kWhite)));
    for (const Face plane : {Face::top, Face::bottom})
        world.blueprints[block].faces[static_cast<std::size_t>(plane)].texture =
            addTexture(world, plain("plane", plane == Face::top ? kGreen : kRed));
    for (int y = 0; y < 9; ++y) {
        for (int level = 0; level < 3; ++level) world.maps[0].setCell(10, y, level, block);
    }
    const auto column = [&](double x, double z, bool seams) {
        const Image image = drawOld(world, eyeAt(x, 4.5, z, 0.0), 90, 100, {.seams = seams}).image;
        std::vector<int> white;  // runs of it
        int lines = 0;           // of a row between them
        for (int y = 0; y < 100; ++y) {
            const bool isWall = image.at(45, y) == toPixel(kWhite);
            if (isWall && (y == 0 || image.at(45, y - 1) != toPixel(kWhite))) white.push_back(0);
            if (isWall) ++white.back();
            if (!isWall && y > 0 && y < 99 && image.at(45, y - 1) == toPixel(kWhite) &&
                image.at(45, y + 1) == toPixel(kWhite))
                ++lines;
        }
        return std::pair(white.size(), lines);
    };
    EXPECT_EQ(column(6.0, 0.5, false), std::pair(std::size_t{1}, 0));
    EXPECT_EQ(column(6.0, 0.5, true), std::pair(std::size_t{3}, 2)) << "seen from below";
    EXPECT_EQ(column(6.0, 2.9, true), std::pair(std::size_t{3}, 2)) << "seen from above";
    const Image filled = drawOld(world, eyeAt(9.9, 4.5, 1.5, 0.0), 90, 100, {.seams = true}).image;
    EXPECT_NE(filled.at(45, 0), toPixel(kWhite));
    EXPECT_EQ(filled.at(45, 50), toPixel(kWhite));
    EXPECT_NE(filled.at(45, 99), toPixel(kWhite));
}

}  // namespace
}  // namespace slicecast::known
