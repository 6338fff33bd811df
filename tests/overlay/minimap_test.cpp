#include "overlay/minimap.h"

#include "canvas.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A map of 40 x 30 x 3 with, about the eye at (20.5, 15.5): a whole block two tiles north, a low
// one two tiles east, a higher one two tiles south, and a block on level 1 two tiles west; four
// tiles north the upper half of a block in the air.
World smallWorld() {
    WorldBuilder make;
    make.block('#');
    make.block('_', {.top = 0.25});
    make.block('-', {.top = 0.75});
    make.block('^', {.bottom = 0.5});
    make.map("map", 40, 30, 3, kNoTexture);
    make.put('#', 20, 13);
    make.put('_', 22, 15);
    make.put('-', 20, 17);
    make.put('#', 18, 15, 1);
    make.put('^', 20, 11);
    return std::move(make.world);
}

Eye eyeAt(double x, double y, double z, double heading) {
    return {.map = 0,
            .x = toCoordinate(x),
            .y = toCoordinate(y),
            .z = toCoordinate(z),
            .headingDegrees = heading};
}

struct Seen {
    Canvas canvas;
    MinimapLayout layout;

    Seen(const World& world, const Eye& eye, const MinimapOptions& options = {}, int width = 640,
         int height = 400)
        : canvas(width, height), layout(layoutMinimap(width, height)) {
        Minimap().draw(world, eye, options, canvas.picture);
    }

    // The colour in the middle of the tile that is so many tiles east and south of an eye in the
    // middle of a tile.
    Colour tile(int east, int south) const {
        const int middle = layout.side / 2;
        return toColour(canvas.at(layout.left + middle + east * layout.pixelsPerTile,
                                  layout.top + middle + south * layout.pixelsPerTile));
    }
};

int brightness(Colour colour) {
    return colour.r + colour.g + colour.b;
}

TEST(Minimap, TakesAThirdOfThePictureAndMoreOfASmallOne) {
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {160, 100}, {640, 400}, {320, 900}, {60, 45}, {8192, 8192}}) {
        const MinimapLayout layout = layoutMinimap(width, height);
        const int shorter = std::min(width, height);
        EXPECT_LE(layout.side, shorter < 288 ? shorter * 2 / 5 : shorter / 3);
        EXPECT_GE(layout.side, std::min(width, height) / 3 - 1);
        EXPECT_LE(layout.left + layout.side, width);
        EXPECT_LE(layout.top + layout.side, height);
        EXPECT_GE(layout.pixelsPerTile, 2);
    }
    EXPECT_EQ(layoutMinimap(1280, 30).side, 0);
    EXPECT_EQ(layoutMinimap(7, 3).side, 0);
}

TEST(Minimap, DrawsInItsSquareOnly) {
    const World world = smallWorld();
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {160, 100}, {60, 45}, {7, 3}, {1, 1}}) {
        const Seen seen(world, eyeAt(20.5, 15.5, 0.5, 10.0), {}, width, height);
        EXPECT_TRUE(seen.canvas.borderUntouched());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool inside = x >= seen.layout.left && y >= seen.layout.top &&
                                    x < seen.layout.left + seen.layout.side &&
                                    y < seen.layout.top + seen.layout.side;
                ASSERT_TRUE(inside || !seen.canvas.touched(x, y)) << x << ", " << y;
                ASSERT_EQ(toColour(seen.canvas.at(x, y)).a, 255);
            }
        }
        EXPECT_EQ(seen.canvas.touchedPixels() > 0, seen.layout.side > 0);
    }
    const Seen nowhere(world,
                       {.map = 1, .x = {}, .y = {}, .z = {1}, .headingDegrees = 0.0, .look = 0.0});
    EXPECT_EQ(nowhere.canvas.touchedPixels(), 0);
}

TEST(Minimap, ShowsHeightsByColourWithNorthUp) {
    const Seen seen(smallWorld(), eyeAt(20.5, 15.5, 0.5, 225.0));
    const Colour ground = seen.tile(3, 3);
    const Colour whole = seen.tile(0, -2);
    const Colour low = seen.tile(2, 0);
    const Colour high = seen.tile(0, 2);
    EXPECT_GT(whole.b, whole.r + 20) << "blue";
    EXPECT_GT(low.r, low.b + 20) << "red";
    EXPECT_GT(high.r, high.b + 20);
    EXPECT_GT(brightness(high), brightness(low) + 40);
    EXPECT_LT(brightness(ground), brightness(whole) - 40);
    EXPECT_EQ(seen.tile(1, 3), ground);
    EXPECT_NEAR(brightness(seen.tile(0, -4)), (brightness(whole) + brightness(ground)) / 2, 4)
        << "in the air";
}

TEST(Minimap, ShowsTheLevelOfTheEyeOrTheChosenOne) {
    const World world = smallWorld();
    const Map& map = world.maps[0];
    EXPECT_EQ(minimapLevel(map, eyeAt(1, 1, 0.5, 0), {}), 0);
    EXPECT_EQ(minimapLevel(map, eyeAt(1, 1, 1.0, 0), {}), 1);
    EXPECT_EQ(minimapLevel(map, eyeAt(1, 1, 100.0, 0), {}), 2);
    EXPECT_EQ(minimapLevel(map, eyeAt(1, 1, -5.0, 0), {}), 0);
    EXPECT_EQ(minimapLevel(map, eyeAt(1, 1, 0.5, 0), {.level = 1}), 1);
    EXPECT_EQ(minimapLevel(map, eyeAt(1, 1, 0.5, 0), {.level = 31}), 2);
    const Seen seen(world, eyeAt(20.5, 15.5, 1.5, 45.0));
    EXPECT_GT(seen.tile(-2, 0).b, seen.tile(-2, 0).r + 20) << "the block of level 1";
    EXPECT_GT(brightness(seen.tile(0, -2)), brightness(seen.tile(3, -3)) + 10)
        << "ground at the level's base is lighter than the floor further down";
    const Seen chosen(world, eyeAt(20.5, 15.5, 0.5, 45.0), {.level = 1});
    for (int y = -6; y <= 6; ++y) {
        for (int x = -6; x <= 6; ++x) EXPECT_EQ(chosen.tile(x, y), seen.tile(x, y));
    }
}

TEST(Minimap, ScrollsWithTheEyeAndEndsAtTheGrid) {
    const World world = smallWorld();
    const Seen here(world, eyeAt(20.5, 15.5, 0.5, 225.0));
    const Seen there(world, eyeAt(23.5, 15.5, 0.5, 225.0));
    EXPECT_EQ(here.tile(0, 2), there.tile(-3, 2));
    EXPECT_NE(here.tile(0, 2), there.tile(0, 2));
    const Seen corner(world, eyeAt(0.5, 0.5, 0.5, 45.0));
    EXPECT_NE(corner.tile(-2, 0), corner.tile(0, 3));
    EXPECT_EQ(corner.tile(-2, 0), corner.tile(-5, -5)) << "nothing outside the grid";
    // Far outside, where nothing at all is seen
    const Seen outside(world, eyeAt(-30'000.0, 30'000.0, 0.5, 45.0));
    EXPECT_EQ(outside.tile(-2, 0), corner.tile(-2, 0));
}

TEST(Minimap, TheFieldOfViewPointsWhereTheEyeLooks) {
    const World world = smallWorld();
    const auto yellow = [](Colour colour) { return colour.r + colour.g - 2 * colour.b; };
    for (int heading = 0; heading < 360; heading += 90) {
        const Seen seen(world, eyeAt(20.5, 15.5, 0.5, heading));
        const int east[] = {1, 0, -1, 0};
        const int south[] = {0, 1, 0, -1};
        for (int side = 0; side < 4; ++side) {
            const int shade = yellow(seen.tile(3 * east[side], 3 * south[side]));
            if (side * 90 == heading) {
                EXPECT_GT(shade, 60) << heading;
            } else {
                EXPECT_LT(shade, 20) << heading << ", " << side;
            }
        }
        EXPECT_GT(yellow(seen.tile(0, 0)), 200) << "the eye itself";
    }
    // A wider field shows more.
    EXPECT_LT(
        yellow(
            Seen(world, eyeAt(20.5, 15.5, 0.5, 0.0), {.level = -1, .fovDegrees = 60.0}).tile(1, 1)),
        20);
    EXPECT_GT(yellow(Seen(world, eyeAt(20.5, 15.5, 0.5, 0.0), {.level = -1, .fovDegrees = 110.0})
                         .tile(1, 1)),
              40);
}

TEST(Minimap, TurnsWithTheViewWhenAsked) {
    const World world = smallWorld();
    const Seen north(world, eyeAt(20.5, 15.5, 0.5, 225.0));
    // What lies ahead is up: two tiles ahead, to the right, behind and to the left, by the heading.
    const int ahead[4][2] = {{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const Seen turned(world, eyeAt(20.5, 15.5, 0.5, 90.0 * quarter),
                          {.fovDegrees = 10.0, .turns = true});
        const auto tileAt = [&](int side) {
            return north.tile(ahead[(quarter + side) % 4][0], ahead[(quarter + side) % 4][1]);
        };
        EXPECT_EQ(turned.tile(2, 0), tileAt(1)) << quarter;
        EXPECT_EQ(turned.tile(0, 2), tileAt(2)) << quarter;
        EXPECT_EQ(turned.tile(-2, 0), tileAt(3)) << quarter;
    }
    // At any heading the field of view is up.
    const Seen slanted(world, eyeAt(20.5, 15.5, 0.5, 77.0), {.turns = true});
    const Colour before = slanted.tile(0, -3);
    EXPECT_GT(before.r + before.g - 2 * before.b, 60);
}

TEST(Minimap, MarksNorthWhenTurned) {
    const World world = smallWorld();
    // Heading east, north is on the left.
    Canvas canvas(640, 400);
    Minimap().draw(world, eyeAt(20.5, 15.5, 0.5, 0.0), {.turns = true}, canvas.picture);
    const MinimapLayout layout = layoutMinimap(640, 400);
    int bright = 0;
    for (int y = -6; y <= 6; ++y) {
        for (int x = 2; x <= 14; ++x)
            bright +=
                brightness(toColour(canvas.at(layout.left + x, layout.top + layout.side / 2 + y))) >
                700;
    }
    EXPECT_GT(bright, 12) << "the letter";
}

TEST(Minimap, RaysEndAtTheFirstBlockAtTheEyesHeight) {
    const World world = smallWorld();
    const auto differs = [&](double height, int east, int south) {
        const Eye eye = eyeAt(20.5, 15.5, height, 90.0);
        const Seen with(world, eye, {.rays = true});
        const Seen without(world, eye);
        return with.tile(east, south) != without.tile(east, south);
    };
    // Towards the block of 0.75 that stands two tiles south
    EXPECT_TRUE(differs(0.5, 0, 1));
    EXPECT_FALSE(differs(0.5, 0, 3)) << "behind the block";
    EXPECT_TRUE(differs(0.9, 0, 3)) << "over it";
    EXPECT_FALSE(differs(0.5, 0, -1)) << "behind the eye";
}

TEST(Minimap, RaysOnAnotherLevelEndAtItsBlocks) {
    const World world = smallWorld();
    for (const double height : {0.5, 2.5}) {
        const Eye eye = eyeAt(20.5, 15.5, height, 180.0);
        const Seen with(world, eye, {.level = 1, .rays = true});
        const Seen without(world, eye, {.level = 1});
        EXPECT_NE(with.tile(-1, 0), without.tile(-1, 0)) << height;
        EXPECT_EQ(with.tile(-4, 0), without.tile(-4, 0))
            << height << ": behind the block two tiles west";
    }
}

TEST(Minimap, TheCircleHasTheRadiusOfTheReach) {
    const World world = smallWorld();
    const Eye eye = eyeAt(20.5, 15.5, 0.5, 225.0);
    const Seen without(world, eye);
    const Seen small(world, eye, {.reach = 1.5});
    const Seen large(world, eye, {.reach = 4.5});
    EXPECT_NE(small.tile(1, 0), without.tile(1, 0));
    EXPECT_EQ(small.tile(2, 0), without.tile(2, 0));
    EXPECT_NE(large.tile(4, 0), without.tile(4, 0));
    EXPECT_EQ(large.tile(4, 4), without.tile(4, 4)) << "it is round";
    // Its rim, a radius away to every side
    const int middle = small.layout.side / 2;
    const int radius = small.layout.pixelsPerTile * 3 / 2;
    for (const auto& [x, y] : {std::pair{radius, 0}, {-radius, 0}, {0, radius}, {0, -radius}}) {
        const Colour rim = toColour(
            small.canvas.at(small.layout.left + middle + x, small.layout.top + middle + y));
        EXPECT_GT(brightness(rim), brightness(without.tile(1, 0)) + 150);
    }
}

// An object in the middle of the tile that is so many tiles east and south of (20, 15).
Object objectAt(int east, int south, double z, double height) {
    Object object;
    object.x = toCoordinate(20.5 + east);
    object.y = toCoordinate(15.5 + south);
    object.z = toCoordinate(z);
    object.width = toCoordinate(0.5);
    object.height = toCoordinate(height);
    return object;
}

TEST(Minimap, ShowsObjectsThatReachIntoTheLevelBrightlyAndThoseBelowFaintly) {
    World world = smallWorld();
    const Eye eye = eyeAt(20.5, 15.5, 1.5, 225.0);
    const Colour ground = Seen(world, eye).tile(3, 3);
    world.maps[0].objects = {objectAt(3, 3, 1.0, 0.5), objectAt(4, 3, 0.0, 1.25),
                             objectAt(5, 3, 0.0, 1.0), objectAt(3, 4, 2.0, 1.0)};
    const Seen seen(world, eye);
    EXPECT_GT(brightness(seen.tile(3, 3)), brightness(ground) + 300);
    EXPECT_EQ(seen.tile(4, 3), seen.tile(3, 3));
    EXPECT_GT(brightness(seen.tile(5, 3)), brightness(ground) + 50);
    EXPECT_LT(brightness(seen.tile(5, 3)), brightness(seen.tile(3, 3)) - 150);
    EXPECT_EQ(seen.tile(3, 4), ground) << "above the level";
    EXPECT_EQ(seen.tile(4, 4), ground);
}

TEST(Minimap, ShowsWhereObjectsGo) {
    World world = smallWorld();
    world.maps[0].objects = {objectAt(3, 3, 0.0, 0.5), objectAt(-4, 3, 0.0, 0.5)};
    ObjectMotion motion;
    motion.object = 1;
    motion.speed = 2.0;
    motion.headingDegrees = 90.0;
    world.movingObjects.motions.push_back(motion);
    const Eye eye = eyeAt(20.5, 15.5, 0.5, 225.0);
    const Seen seen(world, eye);
    const auto magenta = [](Colour colour) { return colour.r + colour.b - 2 * colour.g; };
    EXPECT_LT(magenta(seen.tile(3, 3)), 60);
    EXPECT_GT(magenta(seen.tile(-4, 3)), 200);
    const auto ahead = [&](int east, int south, double tiles) {
        const int middle = seen.layout.side / 2;
        const int size = seen.layout.pixelsPerTile;
        const int off = static_cast<int>(tiles * size);
        return magenta(toColour(seen.canvas.at(seen.layout.left + middle - 4 * size + east * off,
                                               seen.layout.top + middle + 3 * size + south * off)));
    };
    EXPECT_GT(ahead(0, 1, 0.8), 40) << "a line to the south";
    EXPECT_LT(ahead(0, -1, 0.8), 20);
    EXPECT_LT(ahead(1, 0, 0.8), 20);
    EXPECT_LT(ahead(0, 1, 1.5), 20) << "no longer than that";
}

TEST(Minimap, ShowsPortals) {
    World world = smallWorld();
    Map& map = world.maps[0];
    world.blueprints.push_back(world.blueprints[1]);
    const auto leading = static_cast<BlueprintId>(world.blueprints.size() - 1);
    world.blueprints[leading].faces[static_cast<std::size_t>(Face::north)].portal = 0;
    world.blueprints.push_back(world.blueprints[1]);
    const auto shaft = static_cast<BlueprintId>(world.blueprints.size() - 1);
    world.blueprints[shaft].faces[static_cast<std::size_t>(Face::top)].portal = 0;
    map.setCell(24, 18, 0, leading);
    map.setCell(16, 18, 0, shaft);
    map.tilePortals.assign(map.occupied.size(), kNoPortal);
    map.tilePortals[map.tileIndex(20, 19)] = 0;
    const auto turquoise = [](Colour colour) { return colour.g + colour.b - 2 * colour.r; };
    const Eye eye = eyeAt(20.5, 15.5, 0.5, 225.0);
    const Seen seen(world, eye);
    const int whole = turquoise(seen.tile(0, -2));
    EXPECT_GT(turquoise(seen.tile(0, 4)), whole + 40) << "a tile";
    EXPECT_GT(turquoise(seen.tile(-4, 3)), whole + 40) << "a block's top";
    EXPECT_LT(turquoise(seen.tile(4, 3)), whole + 20) << "not the block's middle";
    const int half = seen.layout.pixelsPerTile / 2;
    const auto edge = [&](int east, int south) {
        const int middle = seen.layout.side / 2;
        const int size = seen.layout.pixelsPerTile;
        return turquoise(toColour(seen.canvas.at(seen.layout.left + middle + 4 * size + east,
                                                 seen.layout.top + middle + 3 * size + south)));
    };
    EXPECT_GT(edge(0, -half + 1), 200) << "its north side";
    EXPECT_LT(edge(0, half - 1), 120);
    EXPECT_LT(edge(-half + 1, 0), 120);
    EXPECT_LT(edge(half - 1, 0), 120);
}

TEST(Minimap, MarksNorthWhenItIsUpToo) {
    const Seen seen(smallWorld(), eyeAt(20.5, 15.5, 0.5, 0.0));
    int bright = 0;
    for (int y = 2; y <= 14; ++y) {
        for (int x = -6; x <= 6; ++x)
            bright += brightness(toColour(seen.canvas.at(
                          seen.layout.left + seen.layout.side / 2 + x, seen.layout.top + y))) > 700;
    }
    EXPECT_GT(bright, 12) << "the letter";
}

TEST(Minimap, DistinguishesGatesMoversWaterAndBlocksAbove) {
    World world = smallWorld();
    Map& map = world.maps[0];
    const auto add = [&](CellBlueprint block) {
        world.blueprints.push_back(block);
        return static_cast<BlueprintId>(world.blueprints.size() - 1);
    };
    CellBlueprint shut;
    shut.gate = 0;
    CellBlueprint open = shut;
    open.passable = true;
    CellBlueprint lift;
    lift.motion = 0;
    CellBlueprint pool;
    pool.isWater = true;
    pool.waterColour = {60, 60, 60, 255};  // murky
    map.setCell(23, 18, 1, add(shut));
    map.setCell(17, 18, 1, add(open));
    map.setCell(23, 12, 1, add(lift));
    map.setCell(17, 12, 0, add(pool));
    map.setCell(20, 18, 2, 1);
    // Larger than what the small world's other tests draw, to see the edges
    const Seen seen(world, eyeAt(20.5, 15.5, 1.5, 90.0), {}, 1600, 1200);
    const Seen without(smallWorld(), eyeAt(20.5, 15.5, 1.5, 90.0), {}, 1600, 1200);
    const auto golden = [](Colour colour) { return colour.r + colour.g - 2 * colour.b; };
    const int size = seen.layout.pixelsPerTile;
    const auto at = [&](const Seen& drawn, int east, int south, int right, int down) {
        const int middle = drawn.layout.side / 2;
        return toColour(drawn.canvas.at(drawn.layout.left + middle + east * size + right,
                                        drawn.layout.top + middle + south * size + down));
    };
    EXPECT_GT(golden(at(seen, 3, 3, 0, 0)), 200) << "a shut gate";
    EXPECT_LT(golden(at(seen, -3, 3, 0, 0)), 60) << "one goes through an open one";
    EXPECT_GT(golden(at(seen, -3, 3, size / 2 - 2, 0)), 200) << "its frame";
    int stripes = 0;
    int block = 0;
    for (int x = -size / 4; x < size / 4; ++x) {
        const Colour colour = at(seen, 3, -3, x, 0);
        (colour.r > 180 && colour.b > 230 ? stripes : block) += 1;
    }
    EXPECT_GT(stripes, size / 10) << "a block that moves";
    EXPECT_GT(block, size / 10);
    const Colour water = at(seen, -3, -3, 0, 0);
    EXPECT_GT(water.b, water.r + 30);
    EXPECT_GT(water.g, water.r + 20);
    int ripples = 0;
    for (int y = -size / 2 + 4; y < size / 2 - 4; ++y) {
        for (int x = -size / 2 + 4; x < size / 2 - 4; ++x)
            ripples += at(seen, -3, -3, x, y) != water;
    }
    EXPECT_GT(ripples, size / 4);
    EXPECT_LT(ripples, size * size / 8);
    EXPECT_EQ(at(seen, 0, 3, 0, 0), at(without, 0, 3, 0, 0)) << "one looks past what is above";
    int dashes = 0;
    for (int x = -size / 2 + 2; x < size / 2 - 2; ++x)
        dashes += at(seen, 0, 3, x, -size / 2) != at(without, 0, 3, x, -size / 2);
    EXPECT_GT(dashes, size / 4) << "its edge";
    EXPECT_LT(dashes, size * 3 / 4) << "dashed";
}

TEST(Minimap, AStackOfBarsShowsTheLevels) {
    const World world = smallWorld();
    const auto corner = [&](int level) {
        const Seen seen(world, eyeAt(20.5, 15.5, 0.5, 0.0), {.level = level});
        std::vector<Pixel> pixels;
        for (int y = -20; y < -2; ++y) {
            for (int x = 2; x < 24; ++x)
                pixels.push_back(
                    seen.canvas.at(seen.layout.left + x, seen.layout.top + seen.layout.side + y));
        }
        return pixels;
    };
    EXPECT_NE(corner(0), corner(1));
    EXPECT_NE(corner(1), corner(2));
    EXPECT_NE(corner(0), corner(2));
}

}  // namespace
}  // namespace slicecast
