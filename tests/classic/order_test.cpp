// What was drawn at all, and what over what: what each old way shows wrongly.
#include "classic_scenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicecast::known {
namespace {

// Ten walls behind one another, and a picture of two pixels at the height of the eye, both of which
// look along one row of tiles.
TEST(Classic, PaintersOrderPaintsEverythingOverAndOver) {
    World world = emptyWorld(20, 41, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, plain("wall", kWhite)));
    for (int x = 4; x < 14; ++x) world.maps[0].setCell(x, 20, 0, block);
    const Eye eye = eyeAt(3.5, 20.5, 0.5, 0.0);
    const Drawn nearest = drawOld(world, eye, 2, 1, {}, {.fovDegrees = 10.0});
    const Drawn painted = drawOld(world, eye, 2, 1, {.paintersOrder = true}, {.fovDegrees = 10.0});
    EXPECT_EQ(nearest.image.pixels, painted.image.pixels);
    EXPECT_EQ(nearest.report.rowsFilled, 2);
    EXPECT_EQ(painted.report.rowsFilled, 2 * (1 + 10)) << "what lies behind, and each wall";
}

TEST(Classic, PaintersOrderIsWrongWhereBlocksInterlock) {
    // From high above, the middle of a far full block is nearer than that of a low slab before it,
    // and so its side is painted over the slab's roof.
    World world = emptyWorld(12, 9, 1, plain("floor", kBlack));
    const BlueprintId slab =
        addBlock(world, addTexture(world, plain("slab", kRed)), {}, toCoordinate(0.2));
    const BlueprintId full = addBlock(world, addTexture(world, plain("block", kWhite)));
    for (int y = 0; y < 9; ++y) {
        world.maps[0].setCell(4, y, 0, slab);
        world.maps[0].setCell(5, y, 0, full);
    }
    const Eye above = eyeAt(3.9, 4.5, 5.0, 0.0, -4.0);
    const Image right = drawOld(world, above, 100, 100, {}).image;
    const Image painted = drawOld(world, above, 100, 100, {.paintersOrder = true}).image;
    EXPECT_GT(count(right, kRed), 1000);
    EXPECT_GT(count(right, kRed) - count(painted, kRed), 100);

    // A ceiling that pierces a block: its part inside, which nobody can see, is painted over the
    // block's side.
    World pierced = emptyWorld(12, 9, 2, plain("floor", kBlack));
    const BlueprintId wall = addBlock(pierced, addTexture(pierced, plain("wall", kWhite)));
    const TextureId plaster = addTexture(pierced, plain("plaster", kGreen));
    Map& map = pierced.maps[0];
    for (int y = 0; y < 9; ++y) {
        map.setCell(6, y, 0, wall);
        map.setCell(6, y, 1, wall);
    }
    map.ceiling = {.height = toCoordinate(1.3),
                   .tiles = std::vector<TextureId>(12 * 9, kNoTexture)};
    for (int y = 0; y < 9; ++y) map.ceiling.tiles[map.tileIndex(6, y)] = plaster;
    const Eye below = eyeAt(3.5, 4.5, 0.5, 0.0);
    EXPECT_EQ(count(drawOld(pierced, below, 100, 100, {}).image, kGreen), 0);
    EXPECT_GT(count(drawOld(pierced, below, 100, 100, {.paintersOrder = true}).image, kGreen), 100);
}

TEST(Classic, OneLevelHidesBlocksAboveAndBehind) {
    World world = emptyWorld(20, 21, 3, plain("floor", kBlack));
    const BlueprintId tower = addBlock(world, addTexture(world, plain("tower", kWhite)));
    const BlueprintId low =
        addBlock(world, addTexture(world, plain("low", kRed)), {}, toCoordinate(0.25));
    const BlueprintId upper = addBlock(world, addTexture(world, plain("upper", kGreen)));
    Map& map = world.maps[0];
    for (int y = 0; y < 21; ++y) {
        if (y < 10) map.setCell(7, y, 1, upper);
        map.setCell(8, y, 0, low);
        map.setCell(12, y, 0, tower);
        map.setCell(12, y, 1, upper);
        map.setCell(12, y, 2, tower);
    }
    const Eye eye = eyeAt(4.5, 10.5, 0.5, 0.0);
    const Image full = drawOld(world, eye, 100, 100, {}).image;
    EXPECT_GT(count(full, kWhite), 0);
    EXPECT_GT(count(full, kGreen), 0);
    const Image flat = drawOld(world, eye, 100, 100, {.oneLevel = true}).image;
    EXPECT_EQ(count(flat, kWhite), 0) << "behind the first block";
    EXPECT_EQ(count(flat, kGreen), 0) << "above the level";
    // A unit at depth 3.5 with d = 86.6 is 24.7 rows, whatever the block's own height.
    EXPECT_NEAR(count(flat, kRed) / 100.0, 24.7, 1.0);

    // From the level above, that one alone is seen, and stands on the floor.
    const Image above =
        drawOld(world, eyeAt(4.5, 10.5, 1.5, 0.0), 100, 100, {.oneLevel = true}).image;
    EXPECT_EQ(count(above, kWhite) + count(above, kRed), 0);
    const auto greenRows = [&](int column) {
        int rows = 0;
        for (int y = 0; y < 100; ++y) rows += above.at(column, y) == toPixel(kGreen) ? 1 : 0;
        return rows;
    };
    EXPECT_NEAR(greenRows(10), 86.6 / 2.5, 1.0);
    EXPECT_NEAR(greenRows(90), 86.6 / 7.5, 1.0);
    EXPECT_EQ(above.at(50, 99), toPixel(kBlack));
}

// A low wall, a high one behind it, and a beam that floats before both.
TEST(Classic, OneHitPerLevelHidesBlocksBehind) {
    World world = emptyWorld(20, 21, 2, plain("floor", kBlack));
    const BlueprintId low =
        addBlock(world, addTexture(world, plain("low", kRed)), {}, toCoordinate(0.25));
    const BlueprintId high = addBlock(world, addTexture(world, plain("high", kWhite)));
    const BlueprintId beam =
        addBlock(world, addTexture(world, plain("beam", kGreen)), toCoordinate(0.8));
    Map& map = world.maps[0];
    for (int y = 0; y < 21; ++y) {
        map.setCell(8, y, 0, low);
        map.setCell(12, y, 0, high);
        map.setCell(12, y, 1, high);
    }
    const Eye eye = eyeAt(4.5, 10.5, 0.5, 0.0);
    const auto whiteRows = [&](bool firstHits) {
        const Image image = drawOld(world, eye, 100, 100, {.firstHits = firstHits}).image;
        return count(image, kWhite) / 100.0;
    };
    // A unit at depth 7.5 with d = 86.6 is 11.5 rows; the low wall covers 0.15 of the lower one.
    EXPECT_NEAR(whiteRows(false), 23.1 - 0.3, 2.0);
    EXPECT_NEAR(whiteRows(true), 11.5, 1.0) << "the upper block hangs in the air";
    for (int y = 0; y < 21; ++y) world.maps[0].setCell(9, y, 1, beam);
    EXPECT_GT(whiteRows(false), 15.0);
    EXPECT_EQ(whiteRows(true), 0.0) << "the beam's level has shown its first block, too";
}

// On a block, under a ceiling.
TEST(Classic, TheOwnCellIsMissing) {
    World world = emptyWorld(9, 9, 1, plain("floor", kBlack));
    const BlueprintId block =
        addBlock(world, addTexture(world, plain("block", kWhite)), {}, toCoordinate(0.5));
    Map& map = world.maps[0];
    map.setCell(4, 4, 0, block);
    map.ceiling = {.height = toCoordinate(2.0), .tiles = std::vector<TextureId>(81, kNoTexture)};
    map.ceiling.tiles[map.tileIndex(4, 4)] = addTexture(world, plain("ceiling", kGreen));
    const auto seen = [&](double look, Colour colour, bool missing) {
        return count(
            drawOld(world, eyeAt(4.5, 4.5, 1.0, 0.0, look), 100, 100, {.noOwnCell = missing}).image,
            colour);
    };
    EXPECT_GT(seen(-1.0, kWhite, false), 5000);
    EXPECT_EQ(seen(-1.0, kWhite, true), 0);
    EXPECT_GT(seen(-1.0, kBlack, true), 5000) << "the floor shows instead";
    EXPECT_GT(seen(2.0, kGreen, false), 5000);
    EXPECT_EQ(seen(2.0, kGreen, true), 0);
}

// Level looks: only the height changes. At the scene's start the horizon is in the middle.
TEST(Classic, TheHorizonDriftsWhenFlying) {
    const World world = emptyWorld(9, 9, 1, plain("floor", kBlack));
    const auto horizon = [&](double z, bool drifting) {
        return firstRow(
            drawOld(world, eyeAt(4.5, 4.5, z, 0.0), 20, 100, {.driftingHorizon = drifting}).image,
            10, kBlack);
    };
    for (const double z : {0.25, 0.5, 0.75}) {
        EXPECT_EQ(horizon(z, false), 50);
        EXPECT_EQ(horizon(z, true), 25 + static_cast<int>(100 * (z - 0.25)));
    }
    EXPECT_EQ(horizon(1.5, true), 100) << "the sky alone";
}

}  // namespace
}  // namespace slicecast::known
