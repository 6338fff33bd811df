// Blocks that touch and have no faces between them.
#include "render/scenes.h"

#include "classic/draw_classic.h"

#include <gtest/gtest.h>

#include <utility>

namespace slicecast::known {
namespace {

// Half black: two of its faces, one behind the other, are darker than one.
constexpr Colour kPane = {0, 0, 0, 128};

Image drawBy(bool classic, const World& world, const Eye& eye, int size, double fovDegrees) {
    if (!classic) return draw(world, eye, size, size, {.fovDegrees = fovDegrees});
    Image image(size, size);
    LitMaps lit;
    EXPECT_TRUE(drawClassic(world, eye, {.fovDegrees = fovDegrees}, {}, lit,
                            {image.pixels.data(), size, size, size}));
    return image;
}

Image drawEast(const World& world, const Eye& eye, bool classic = false) {
    return drawBy(classic, world, eye, 81, 60.0);
}

int differences(const Image& a, const Image& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i];
    return count;
}

// Four panes in a row, or one upon another; the third one has a portal on its north face, whose
// texture is a hole.
TEST(Joins, APaneWithAPortalIsAPaneLikeTheOthers) {
    for (const auto& [stacked, classic] :
         {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
        World world = emptyWorld(9, 5, 4, plain("floor", kWhite));
        const BlueprintId pane = addBlock(world, addTexture(world, plain("pane", kPane)));
        world.blueprints[pane].faces[static_cast<std::size_t>(Face::north)].texture =
            addTexture(world, plain("hole", {0, 0, 0, 0}));
        markSeeThrough(world);
        Map& map = world.maps[0];
        for (int i = 0; i < 4; ++i) map.setCell(stacked ? 4 : 3 + i, 2, stacked ? i : 0, pane);
        const Eye eye = stacked ? eyeAt(1.3, 2.6, 1.4, 0.0) : eyeAt(1.3, 2.6, 0.4, 3.0);
        const Image before = drawEast(world, eye, classic);
        world.portals.push_back({.fromX = 5, .fromY = 2, .toX = 1, .toY = 1});
        CellBlueprint withPortal = instanceOf(world, pane);
        withPortal.faces[static_cast<std::size_t>(Face::north)].portal = 0;
        world.blueprints.push_back(withPortal);
        markPortals(world);
        map.setCell(stacked ? 4 : 5, 2, stacked ? 2 : 0, static_cast<BlueprintId>(pane + 1));
        EXPECT_EQ(differences(before, drawEast(world, eye, classic)), 0) << stacked;
        // The faces between show where it says so.
        world.blueprints.back().join = false;
        EXPECT_GT(differences(before, drawEast(world, eye, classic)), 0) << stacked;
    }
}

// Beside a lower pane of its kind, what stands above that keeps its side.
TEST(Joins, OnlyWhereTheyTouch) {
    World world = emptyWorld(9, 5, 2, plain("floor", kWhite));
    const BlueprintId pane = addBlock(world, addTexture(world, plain("pane", kPane)));
    markSeeThrough(world);
    CellBlueprint low = instanceOf(world, pane);
    low.top = toCoordinate(0.5);
    world.blueprints.push_back(low);
    world.maps[0].setCell(4, 2, 0, pane);
    world.maps[0].setCell(5, 2, 0, static_cast<BlueprintId>(pane + 1));
    world.maps[0].sky.low = kWhite;
    const Image image = draw(world, eyeAt(2.0, 2.5, 0.5, 0.0), 90, 90, {.fovDegrees = 90.0});
    // Three units away a row is 1/15 unit: above the eye's height two sides, below the low one's
    // top and before its far side two, too.
    const Pixel twice = toPixel({63, 63, 63, 255});
    EXPECT_EQ(image.at(45, 42), twice);
    EXPECT_EQ(image.at(45, 47), twice);
}

// A block of three tenths that moves from level 0 to level 1, and stands half in either.
World movingBlock(Colour colour, bool join) {
    World world = emptyWorld(7, 7, 3, plain("floor", kWhite));
    const BlueprintId block = addBlock(world, addTexture(world, plain("block", colour)),
                                       toCoordinate(0.1), toCoordinate(0.9));
    world.blueprints[block].motion = 0;
    world.blueprints[block].join = join;
    world.blueprints[block].name = "block";
    world.motions.push_back({.name = "lift", .from = toCoordinate(0.5), .to = toCoordinate(0.5)});
    world.maps[0].setCell(3, 3, 0, block);
    markSeeThrough(world);
    return world;
}

TEST(Joins, MoversHaveNoInnerFaces) {
    for (const bool classic : {true, false}) {
        World world = movingBlock(kPane, false);
        World still = movingBlock(kPane, true);
        EXPECT_TRUE(makeMovers(world).empty());
        EXPECT_TRUE(makeMovers(still).empty());
        // The faces of a block that joins are known to be its own.
        for (const Eye& eye : {eyeAt(1.2, 3.4, 2.2, 5.0, -0.4), eyeAt(1.2, 3.4, 0.2, 5.0, 0.4)})
            EXPECT_EQ(differences(drawEast(world, eye, classic), drawEast(still, eye, classic)), 0)
                << classic;
    }
}

// A pane, or two beside each other, that moves east by half a tile.
World slidingPanes(int count, bool join) {
    World world = emptyWorld(7, 7, 2, plain("floor", kWhite));
    const BlueprintId pane = addBlock(world, addTexture(world, plain("pane", kPane)),
                                      toCoordinate(0.1), toCoordinate(0.9));
    world.blueprints[pane].motion = 0;
    world.blueprints[pane].join = join;
    world.blueprints[pane].name = "pane";
    world.motions.push_back(
        {.name = "slide", .axis = Axis::x, .from = toCoordinate(0.5), .to = toCoordinate(0.5)});
    for (int i = 0; i < count; ++i) world.maps[0].setCell(3, 3 + i, 0, pane);
    markSeeThrough(world);
    EXPECT_TRUE(makeMovers(world).empty());
    markPlans(world);
    return world;
}

// Along its way it is one block, whatever `join` says; beside each other they are two.
TEST(Joins, SlidersHaveNoFacesAlongTheirWay) {
    const Eye along = eyeAt(1.2, 3.4, 0.4, 5.0);
    const Eye across = eyeAt(3.8, 1.2, 0.4, 85.0);
    for (const bool classic : {true, false}) {
        const auto apart = [&](int count, const Eye& eye) {
            return differences(drawEast(slidingPanes(count, false), eye, classic),
                               drawEast(slidingPanes(count, true), eye, classic));
        };
        EXPECT_EQ(apart(1, along), 0) << classic;
        EXPECT_EQ(apart(1, across), 0) << classic;
        EXPECT_GT(apart(2, across), 0) << classic;
    }
}

// From inside an opaque block one sees its far faces, and nothing at the border between levels.
TEST(Joins, MoversAreHollowFromInside) {
    constexpr Colour kUpper = {200, 0, 0, 255};
    constexpr Colour kLower = {0, 0, 200, 255};
    World world = movingBlock({10, 200, 10, 255}, true);
    const TextureId upper = addTexture(world, plain("upper", kUpper));
    const TextureId lower = addTexture(world, plain("lower", kLower));
    CellBlueprint& block = world.blueprints[1];
    block.faces[static_cast<std::size_t>(Face::top)].texture = upper;
    block.faces[static_cast<std::size_t>(Face::bottom)].texture = lower;
    EXPECT_TRUE(makeMovers(world).empty());
    // It lies between 0.6 and 1.4. Seen from 0.3 before its east side at a height of 0.8, that side
    // reaches up to twice the picture's slope of one.
    for (const int i : {0, 1, 2, 3}) {
        const double height = i % 2 == 0 ? 0.8 : 1.2;
        const auto looking = [&](double look) {
            return drawBy(i / 2 == 1, world, eyeAt(3.3, 3.5, height, 0.0, look), 80, 90.0);
        };
        const Image level = looking(0.0);
        const Image up = looking(1.6);
        const Image down = looking(-1.6);
        int side = 0;
        for (int row = 0; row < 80; ++row) side += level.at(40, row) == toPixel({10, 200, 10, 255});
        // 40 rows are 0.7 units at the side: 0.8 are 45.7.
        EXPECT_GE(side, 44) << height;
        EXPECT_EQ(up.at(40, 0), toPixel(kUpper)) << height;
        EXPECT_EQ(down.at(40, 79), toPixel(kLower)) << height;
    }
}

}  // namespace
}  // namespace slicecast::known
