// Objects, mirrors and portals as they were first drawn: what each old way shows wrongly.
#include "classic_scenes.h"

#include <gtest/gtest.h>

namespace slicecast::known {
namespace {

// A white figure two units high, on a black floor.
World figureWorld(double x) {
    World world = emptyWorld(20, 9, 2, plain("floor", kBlack));
    Image image(8, 8);
    std::fill(image.pixels.begin(), image.pixels.end(), toPixel(kWhite));
    world.sprites.push_back(makeSprite("figure", image));
    addObject(world, 0, x, 4.5, 0.0, 1.0, 2.0);
    return world;
}

int lastRow(const Image& image, int column, Colour colour) {
    for (int y = image.height; y-- > 0;) {
        if (image.at(column, y) == toPixel(colour)) return y;
    }
    return -1;
}

TEST(Classic, OneDepthPerColumnHidesObjectsBehindLowWalls) {
    World world = figureWorld(8.0);
    const BlueprintId low =
        addBlock(world, addTexture(world, plain("low", kRed)), {}, toCoordinate(0.25));
    for (int y = 0; y < 9; ++y) world.maps[0].setCell(6, y, 0, low);
    const Eye eye = eyeAt(3.0, 4.5, 0.5, 0.0);
    const auto figure = [&](bool columnDepth) {
        return count(drawOld(world, eye, 100, 100, {.columnDepth = columnDepth}).image, kWhite);
    };
    EXPECT_GT(figure(false), 300) << "it stands out above the wall";
    EXPECT_EQ(figure(true), 0);
    world.maps[0].objects[0].x = toCoordinate(5.0);
    EXPECT_EQ(figure(true), figure(false)) << "before the wall all is well";
    EXPECT_GT(figure(true), 300);
}

// At depth 4, by a picture of 200 x 100: d = 173.2, so two units are 86.6 rows, and the feet
// 21.65 below the horizon. By the picture's height they are 50 and 12.5.
TEST(Classic, ObjectsInAWrongScaleAreSmallAndFloat) {
    const World world = figureWorld(7.0);
    const Eye eye = eyeAt(3.0, 4.5, 0.5, 0.0);
    const auto drawn = [&](bool wrong) {
        return drawOld(world, eye, 200, 100, {.wrongScale = wrong}).image;
    };
    const Image right = drawn(false);
    EXPECT_EQ(lastRow(right, 100, kWhite), 71);
    EXPECT_EQ(firstRow(right, 100, kWhite), 0);
    EXPECT_EQ(firstRow(right, 120, kWhite), 0) << "43.3 columns wide";
    const Image wrong = drawn(true);
    EXPECT_EQ(lastRow(wrong, 100, kWhite), 61) << "above the ground";
    EXPECT_EQ(firstRow(wrong, 100, kWhite), 12);
    EXPECT_EQ(firstRow(wrong, 111, kWhite), 12) << "25 columns wide";
    EXPECT_EQ(firstRow(wrong, 114, kWhite), 100);
}

// Water before a low quay, a tower further back, a post in the water.
TEST(Classic, AFlippedReflectionIsNotAMirror) {
    World world = emptyWorld(30, 9, 3, plain("floor", kBlack));
    const BlueprintId quay =
        addBlock(world, addTexture(world, plain("quay", kRed)), {}, toCoordinate(0.5));
    const BlueprintId tower = addBlock(world, addTexture(world, plain("tower", kGreen)));
    Map& map = world.maps[0];
    map.floor.mirror = 255;
    for (int y = 0; y < 9; ++y) {
        map.setCell(8, y, 0, quay);
        for (int level = 0; level < 3; ++level) map.setCell(20, y, level, tower);
    }
    const Eye eye = eyeAt(3.0, 4.5, 1.0, 0.0);
    const Image mirror = drawOld(world, eye, 100, 200, {}).image;
    const Image flipped = drawOld(world, eye, 100, 200, {.flippedMirrors = true}).image;
    // With d = 86.6: the quay's foot is at 100 + 86.6 / 5 = 117.3, its edge at 108.7.
    const int foot = lastRow(mirror, 50, kRed);
    for (int row = 0; row < 117; ++row)
        ASSERT_EQ(mirror.at(50, row), flipped.at(50, row)) << "what is no floor is the same";
    for (int row = 117; row < 200; ++row)
        EXPECT_EQ(flipped.at(50, row), flipped.at(50, 233 - row)) << row;
    EXPECT_NE(mirror.pixels, flipped.pixels);
    EXPECT_EQ(foot, 125) << "0.5 below the floor, at 100 + 1.5 * 86.6 / 5";
    // In a mirror the tower stands behind the quay: 0.5 of it is hidden at most. By flipping, as
    // much of it as the picture shows above the quay's roof.
    EXPECT_NE(lastRow(mirror, 50, kGreen), lastRow(flipped, 50, kGreen));
    EXPECT_EQ(lastRow(flipped, 50, kGreen), 233 - firstRow(flipped, 50, kGreen));
}

// A window of bars, or a beam, before a portal: what is behind it covers them, but at its ends.
TEST(Classic, PortalsAreDrawnOverThingsInFront) {
    World world = emptyWorld(20, 9, 1, plain("floor", kBlack));
    const BlueprintId gate = addBlock(world, addTexture(world, plain("gate", kRed)));
    const BlueprintId beam = addBlock(world, addTexture(world, plain("beam", kWhite)),
                                      toCoordinate(0.4), toCoordinate(0.6));
    const BlueprintId lintel =
        addBlock(world, addTexture(world, plain("lintel", kGreen)), toCoordinate(0.8));
    world.portals.push_back(
        {.fromMap = 0, .fromX = 8, .fromY = 4, .toMap = 1, .toX = 2, .toY = 2, .turn = 0});
    world.maps.push_back(makeMap("beyond", 5, 5, 1, 0));
    world.maps[1].sky.low = {0, 0, 255, 255};
    world.maps[1].light.on = false;
    world.blueprints[gate].faces[static_cast<std::size_t>(Face::west)].portal = 0;
    markPortals(world);
    Map& map = world.maps[0];
    map.setCell(8, 4, 0, gate);
    const Eye eye = eyeAt(5.0, 4.5, 0.5, 0.0);
    const auto drawn = [&](bool overdrawn) {
        return drawOld(world, eye, 60, 200, {.portalsOverdrawn = overdrawn}).image;
    };
    map.setCell(6, 4, 0, beam);
    EXPECT_GT(count(drawn(false), kWhite), 500);
    const Image over = drawn(true);
    for (int row = 0; row < 200; ++row) EXPECT_NE(over.at(30, row), toPixel(kWhite)) << row;
    EXPECT_GT(count(over, {0, 0, 255, 255}), count(drawn(false), {0, 0, 255, 255}));

    map.setCell(6, 4, 0, lintel);
    EXPECT_EQ(drawn(true).pixels, drawn(false).pixels) << "at its upper end it is seen";
    EXPECT_GT(count(drawn(true), kGreen), 100);

    // What is see-through is covered to the ends.
    Image bars(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x)
            bars.at(x, y) = toPixel(y % 2 == 0 ? kWhite : Colour{0, 0, 0, 0});
    }
    const BlueprintId window = addBlock(world, addTexture(world, makeTexture("bars", bars)));
    markSeeThrough(world);
    map.setCell(6, 4, 0, window);
    EXPECT_GT(count(drawn(false), kWhite), 500);
    const Image uncovered = drawn(true);
    const int first = firstRow(uncovered, 30, {0, 0, 255, 255});
    for (int row = first; row < 100; ++row)
        EXPECT_EQ(uncovered.at(30, row), toPixel({0, 0, 255, 255})) << row;
    // An object is drawn last of all.
    map.setCell(6, 4, 0, kEmptyCell);
    world.sprites.push_back(makeSprite("figure", [] {
        Image image(8, 8);
        std::fill(image.pixels.begin(), image.pixels.end(), toPixel(kWhite));
        return image;
    }()));
    addObject(world, 0, 6.5, 4.5, 0.4, 0.2, 0.2);
    EXPECT_EQ(drawn(true).pixels, drawn(false).pixels);
    EXPECT_GT(count(drawn(true), kWhite), 30);
}

}  // namespace
}  // namespace slicecast::known
