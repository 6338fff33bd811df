// The minimap's map is drawn anew where something has changed, and only there.

#include "base/random.h"
#include "canvas.h"
#include "overlay/minimap.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <utility>

namespace slicecast {
namespace {

enum : BlueprintId { kEmpty, kWall, kGate, kMover, kWater };

World makeWorld() {
    WorldBuilder make;
    make.block('#');
    make.block('g').gate = 0;
    make.block('m', {.top = 0.25}).motion = 0;
    make.block('w', {.top = 0.25}).isWater = true;
    make.map("map", 40, 30, 3, kNoTexture);
    make.put('#', 20, 13);
    make.put('g', 22, 15);
    make.put('m', 18, 15);
    make.put('w', 20, 18);
    make.put('#', 16, 15, 1);
    return std::move(make.world);
}

Eye eyeAt(double x, double y, double heading = 20.0) {
    return {.map = 0,
            .x = toCoordinate(x),
            .y = toCoordinate(y),
            .z = toCoordinate(0.5),
            .headingDegrees = heading};
}

// A minimap that is kept; each picture is compared with one that begins anew.
struct Kept {
    World world = makeWorld();
    Minimap minimap;
    Eye eye = eyeAt(20.5, 15.5);
    MinimapOptions options;
    int width = 640;
    int height = 400;

    // How many tiles were drawn for the next picture.
    long draw() {
        Canvas canvas(width, height);
        Canvas anew(width, height);
        const long before = minimap.drawnTiles();
        minimap.draw(world, eye, options, canvas.picture);
        Minimap().draw(world, eye, options, anew.picture);
        EXPECT_EQ(canvas.image.pixels, anew.image.pixels);
        return minimap.drawnTiles() - before;
    }
};

// North up, the eye in the middle: what stands in the western half of a tile is drawn there.
TEST(MinimapMap, DrawsPlans) {
    Kept kept;
    kept.eye.headingDegrees = 270.0;
    const auto picture = [&] {
        Canvas canvas(kept.width, kept.height);
        Minimap().draw(kept.world, kept.eye, kept.options, canvas.picture);
        return canvas.image;
    };
    const Image whole = picture();
    kept.world.blueprints[kWall].plan.east = toCoordinate(0.5);
    const Image half = picture();
    kept.world.blueprints[kWall].plan = {};
    kept.world.maps[0].setCell(20, 13, 0, kEmpty);
    const Image none = picture();
    int asWhole = 0;
    int asNone = 0;
    int other = 0;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
        if (whole.pixels[i] == none.pixels[i]) continue;
        asWhole += half.pixels[i] == whole.pixels[i];
        asNone += half.pixels[i] == none.pixels[i];
        other += half.pixels[i] != whole.pixels[i] && half.pixels[i] != none.pixels[i];
    }
    EXPECT_GT(asWhole, 10);
    EXPECT_GT(asNone, asWhole / 2);
    EXPECT_LT(other, asWhole) << "edges of the tile";
    kept.draw();
    kept.world.blueprints[kWall].plan.east = toCoordinate(0.25);
    kept.draw();
}

// Of the four halves of a tile, two opposite ones share only the pixels along the cut.
TEST(MinimapMap, DrawsHalves) {
    Kept kept;
    kept.eye.headingDegrees = 270.0;
    const auto picture = [&](Half half) {
        kept.world.blueprints[kWall].plan.half = half;
        Canvas canvas(kept.width, kept.height);
        Minimap().draw(kept.world, kept.eye, kept.options, canvas.picture);
        return canvas.image;
    };
    const Image whole = picture(Half::none);
    const std::array<Image, 4> halves = {picture(Half::northEast), picture(Half::southEast),
                                         picture(Half::southWest), picture(Half::northWest)};
    kept.world.maps[0].setCell(20, 13, 0, kEmpty);
    const Image none = picture(Half::none);
    std::array<int, 4> count = {};
    int shared = 0;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
        const auto isIn = [&](std::size_t half) {
            return whole.pixels[i] != none.pixels[i] && halves[half].pixels[i] == whole.pixels[i];
        };
        for (std::size_t half = 0; half < 4; ++half) count[half] += isIn(half);
        shared += (isIn(0) && isIn(2)) || (isIn(1) && isIn(3));
    }
    for (const int pixels : count) EXPECT_GT(pixels, 5 * shared / 4);
    EXPECT_GT(shared, 0);
}

TEST(MinimapMap, RedrawsNothingWithoutAChange) {
    Kept kept;
    EXPECT_GT(kept.draw(), 400);
    EXPECT_EQ(kept.draw(), 0);
    kept.world.steps = 360;
    EXPECT_EQ(kept.draw(), 0);
    // Nor for what is drawn on top: the eye, its rays, objects
    kept.eye = eyeAt(20.6, 15.4, 200.0);
    kept.options = {.fovDegrees = 90.0, .rays = true, .turns = true, .reach = 3.0};
    EXPECT_EQ(kept.draw(), 0);
    kept.world.maps[0].objects.resize(5);
    EXPECT_EQ(kept.draw(), 0);
}

TEST(MinimapMap, AChangeRedrawsItsTileAndTheNeighbours) {
    Kept kept;
    kept.draw();
    const auto drawsFew = [&](const char* what) {
        const long drawn = kept.draw();
        EXPECT_GE(drawn, 1) << what;
        EXPECT_LE(drawn, 5) << what;
        EXPECT_EQ(kept.draw(), 0) << what;
    };
    kept.world.maps[0].setCell(21, 16, 0, kWall);
    drawsFew("a cell");
    kept.world.maps[0].setCell(23, 16, 1, kWall);
    drawsFew("a cell above");
    kept.world.blueprints[kGate].passable = true;
    drawsFew("a gate");
    kept.world.blueprints[kMover].top = toCoordinate(0.75);
    drawsFew("a mover");
    kept.world.maps[0].setCell(20, 18, 0, kEmpty);
    drawsFew("water");
}

TEST(MinimapMap, MovingDrawsOnlyNewTiles) {
    Kept kept;
    kept.draw();
    kept.eye = eyeAt(21.5, 15.5);
    const long across = kept.draw();
    EXPECT_GT(across, 10);
    EXPECT_LT(across, 60);
    kept.eye = eyeAt(23.5, 15.5);
    EXPECT_EQ(kept.draw(), 2 * across);
}

TEST(MinimapMap, AnotherSizeLevelOrMapRedrawsAll) {
    Kept kept;
    const long all = kept.draw();
    kept.width = 800;
    kept.height = 600;
    EXPECT_GT(kept.draw(), 400);
    EXPECT_EQ(kept.draw(), 0);
    kept.width = 640;
    kept.height = 400;
    EXPECT_EQ(kept.draw(), all);
    kept.options.level = 1;
    EXPECT_GT(kept.draw(), 400) << "each floor is a level further down";
    kept.world.maps.push_back(makeMap("other", 40, 30, 3, kNoTexture));
    kept.eye.map = 1;
    EXPECT_GT(kept.draw(), 1);
    EXPECT_EQ(kept.draw(), 0);
}

TEST(MinimapMap, EqualsAFreshOneAfterAnyChanges) {
    Kept kept;
    Random random(7);
    const auto below = [&](int count) { return random.below(count); };
    for (int i = 0; i < 300; ++i) {
        kept.world.maps[0].setCell(below(40), below(30), below(3),
                                   static_cast<BlueprintId>(below(5)));
        kept.world.blueprints[kGate].passable = below(2) == 0;
        kept.world.blueprints[kMover].top = Coordinate{below(65536)};
        kept.eye = eyeAt(below(400) * 0.1, below(300) * 0.1, below(360));
        kept.options.turns = below(2) == 0;
        kept.options.level = below(8) == 0 ? below(4) - 1 : kept.options.level;
        if (below(20) == 0) std::swap(kept.width, kept.height);
        kept.draw();
        ASSERT_FALSE(HasFailure()) << i;
    }
}

}  // namespace
}  // namespace slicecast
