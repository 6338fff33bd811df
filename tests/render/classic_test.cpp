// The old ways: drawn without any of them the picture is the renderer's; each of them shows its
// known defect.
#include "render/classic/draw_classic.h"

#include "base/random.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <vector>

namespace slicecast::known {
namespace {

constexpr Colour kBlack = {0, 0, 0, 255};
constexpr Colour kRed = {255, 0, 0, 255};
constexpr Colour kGreen = {0, 255, 0, 255};

struct Drawn {
    Image image;
    ClassicReport report;
};

Drawn drawOld(const World& world, const Eye& eye, int width, int height,
              const ClassicOptions& classic, const RenderOptions& options = {}) {
    Drawn drawn{Image(width, height), {}};
    if (!drawClassic(world, eye, options, classic,
                     {drawn.image.pixels.data(), width, height, width}, &drawn.report))
        drawn.image = {};
    return drawn;
}

// The first row of a colour in a column, or the picture's height.
int firstRow(const Image& image, int column, Colour colour) {
    for (int y = 0; y < image.height; ++y) {
        if (image.at(column, y) == toPixel(colour)) return y;
    }
    return image.height;
}

int count(const Image& image, Colour colour) {
    return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), toPixel(colour)));
}

bool columnsAreEqual(const Image& image, int a, int b) {
    for (int y = 0; y < image.height; ++y) {
        if (image.at(a, y) != image.at(b, y)) return false;
    }
    return true;
}

// Squares in as many colours, so that a wrong texel shows.
Texture squares(const std::string& name, std::uint8_t blue) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x)
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(120 + 17 * x),
                                      static_cast<std::uint8_t>(120 + 17 * y), blue, 255});
    }
    return makeTexture(name, std::move(image));
}

// Squares again, some of them holes and some of them half there.
Texture lattice(const std::string& name) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const std::uint8_t alpha = (x + y) % 3 == 0 ? 255 : (x + y) % 3 == 1 ? 90 : 0;
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(120 + 17 * x), 60,
                                      static_cast<std::uint8_t>(120 + 17 * y), alpha});
        }
    }
    return makeTexture(name, std::move(image));
}

// Two frames of squares, three a second.
Texture flicker(const std::string& name) {
    Image image(16, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x)
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(120 + 8 * x),
                                      static_cast<std::uint8_t>(120 + 17 * y), 200, 255});
    }
    return makeTexture(name, std::move(image), 2, 3.0);
}

// The upper half of one colour, the lower of another.
Texture halves(const std::string& name, Colour upper, Colour lower) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) image.at(x, y) = toPixel(y < 4 ? upper : lower);
    }
    return makeTexture(name, std::move(image));
}

// The left half of one colour, the right of another.
Texture sides(const std::string& name, Colour left, Colour right) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) image.at(x, y) = toPixel(x < 4 ? left : right);
    }
    return makeTexture(name, std::move(image));
}

// Black floor, magenta sky, a white wall of full blocks across the map at x = 10.
World wallWorld(Texture wall) {
    World world = emptyWorld(20, 41, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, std::move(wall)));
    for (int y = 0; y < 41; ++y) world.maps[0].setCell(10, y, 0, block);
    return world;
}

// Blocks of all kinds on several levels, some glowing or flickering, in every other world some
// see-through; ceilings over some tiles, light, fog, a gradient for a sky.
World mixedWorld(std::uint64_t seed) {
    Random random(seed);
    World world = emptyWorld(10, 9, 4, squares("floor", 10));
    std::vector<BlueprintId> blocks;
    for (int i = 0; i < 6; ++i) {
        const bool seeThrough = seed % 2 == 1 && i % 2 == 1;
        const TextureId texture =
            addTexture(world, seeThrough ? lattice("lattice")
                              : i == 4   ? flicker("flicker")
                                         : squares("wall", static_cast<std::uint8_t>(60 + 30 * i)));
        const int bottom = i < 2 ? 0 : random.between(0, 40000);
        const int top = i < 2 ? 65536 : random.between(bottom + 1, 65536);
        blocks.push_back(addBlock(world, texture, {bottom}, {top}));
        for (FaceBlueprint& face : world.blueprints.back().faces) {
            face.light = random.between(0.5, 1.0);
            face.glow = random.oneIn(8);
            if (seeThrough && random.oneIn(4)) face.texture = 0;
        }
        world.blueprints.back().join = !random.oneIn(3);
    }
    markSeeThrough(world);
    Map& map = world.maps[0];
    map.ceiling.height = {random.between(65536, 5 * 65536)};
    map.ceiling.tiles.assign(90, kNoTexture);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 10; ++x) {
            if (random.oneIn(6))
                map.ceiling.tiles[map.tileIndex(x, y)] =
                    static_cast<TextureId>(random.between(1, 2));
            for (int level = 0; level < 4; ++level) {
                if (random.oneIn(4)) map.setCell(x, y, level, blocks[random.below(6)]);
            }
        }
    }
    world.seconds = 0.2 * static_cast<double>(seed);
    map.light.on = random.oneIn(2);
    map.fog = {.on = random.oneIn(2), .start = 1.0, .end = 20.0};
    map.sky = {
        .kind = Sky::Kind::gradient, .low = kRed, .high = kGreen, .slope = 0.5, .panorama = {}};
    map.far = random.oneIn(2) ? 30.0 : kDefaultFar;
    return world;
}

// Glass and lattices that touch each other and solid blocks, on a floor with holes.
World glassWorld(std::uint64_t seed) {
    Random random(seed);
    World world = emptyWorld(6, 6, 3, lattice("floor"));
    const TextureId pane = addTexture(world, lattice("pane"));
    const BlueprintId blocks[] = {
        addBlock(world, pane), addBlock(world, pane, {}, toCoordinate(0.5)), addBlock(world, pane),
        addBlock(world, addTexture(world, squares("solid", 60)))};
    world.blueprints[blocks[2]].join = false;
    markSeeThrough(world);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 6; ++x) {
            for (int level = 0; level < 3; ++level) {
                if (random.oneIn(2)) world.maps[0].setCell(x, y, level, blocks[random.below(4)]);
            }
        }
    }
    return world;
}

// How many of a number of views' pixels are not the renderer's.
template <typename MakeWorld>
void expectTheRenderersPictures(std::uint64_t seed, MakeWorld&& makeWorld) {
    Random random(seed);
    std::int64_t pixels = 0;
    std::int64_t different = 0;
    std::set<Pixel> colours;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const World world = makeWorld(i);
        const Map& map = world.maps[0];
        const Eye eye = {.map = 0,
                         .x = {random.between(-3 * 65536, (map.width + 3) * 65536)},
                         .y = {random.between(-3 * 65536, (map.depth + 3) * 65536)},
                         .z = {random.between(1, (map.levels + 2) * 65536)},
                         .headingDegrees = random.between(0.0, 360.0),
                         .look = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0)};
        const RenderOptions options = {.fovDegrees = random.between(30.0, 120.0),
                                       .detail = false,
                                       .textures = !random.oneIn(8),
                                       .fog = !random.oneIn(4)};
        const Image exact = draw(world, eye, 97, 61, options);
        const Drawn old = drawOld(world, eye, 97, 61, {}, options);
        ASSERT_FALSE(exact.empty());
        ASSERT_EQ(exact.pixels.size(), old.image.pixels.size());
        EXPECT_EQ(old.report.pixelsPainted, 97 * 61);
        for (std::size_t p = 0; p < exact.pixels.size(); ++p) {
            const Colour a = toColour(exact.pixels[p]);
            const Colour b = toColour(old.image.pixels[p]);
            ++pixels;
            if (std::abs(a.r - b.r) > 1 || std::abs(a.g - b.g) > 1 || std::abs(a.b - b.b) > 1 ||
                b.a != 255)
                ++different;
            colours.insert(exact.pixels[p]);
        }
    }
    EXPECT_GT(colours.size(), 2000u) << "there was something to see";
    // Where a ray meets an edge within a rounding.
    EXPECT_LE(different, pixels / 10000) << different << " of " << pixels;
}

TEST(Classic, DrawsTheRenderersPictureWithoutAnOldWay) {
    expectTheRenderersPictures(7, mixedWorld);
}

TEST(Classic, SeesThroughGlassAsTheRenderer) {
    expectTheRenderersPictures(8, glassWorld);
}

// Two blocks that touch in a corner: nothing is seen between them, and the eastern one comes first.
TEST(Classic, ThroughACornerAsTheRenderer) {
    World world = emptyWorld(9, 9, 1, plain("floor", kBlack));
    const BlueprintId east = addBlock(world, addTexture(world, plain("east", kRed)));
    const BlueprintId south = addBlock(world, addTexture(world, plain("south", kGreen)));
    world.maps[0].setCell(5, 4, 0, east);
    world.maps[0].setCell(4, 5, 0, south);
    const Eye eye = eyeAt(2.5, 2.5, 0.5, 45.0);
    EXPECT_EQ(draw(world, eye, 1, 1).at(0, 0), toPixel(kRed));
    EXPECT_EQ(drawOld(world, eye, 1, 1, {}).image.at(0, 0), toPixel(kRed));
}

// With the notes' step, a thousandth, the defect is hard to see; coarse steps spoil the picture.
TEST(Classic, MarchingIsAsGoodAsItsStep) {
    const auto different = [](double step) {
        int pixels = 0;
        for (std::uint64_t i = 0; i < 8; ++i) {
            const World world = mixedWorld(i);
            const Eye eye = eyeAt(-2.0, 4.3, 2.6, -10.0);
            const Image exact = drawOld(world, eye, 160, 100, {}).image;
            const Image marched =
                drawOld(world, eye, 160, 100, {.march = true, .stepSize = step}).image;
            for (std::size_t p = 0; p < exact.pixels.size(); ++p)
                pixels += exact.pixels[p] != marched.pixels[p] ? 1 : 0;
        }
        return pixels / (8 * 160.0 * 100.0);
    };
    EXPECT_LT(different(0.001), 0.03);
    EXPECT_GT(different(0.2), 0.2);
}

TEST(Classic, MarchingFindsWallsTooLateAndRagged) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(8.1, 20.5, 0.5, 0.0);
    const RenderOptions options = {.fovDegrees = 90.0};
    const Image exact = drawOld(world, eye, 200, 200, {}, options).image;
    const Image fine =
        drawOld(world, eye, 200, 200, {.march = true, .stepSize = 0.001}, options).image;
    const Image coarse =
        drawOld(world, eye, 200, 200, {.march = true, .stepSize = 0.4}, options).image;
    int turns = 0;  // of the coarse wall's upper edge
    int way = 0;
    for (int x = 0; x < 200; ++x) {
        ASSERT_EQ(firstRow(exact, x, kWhite), firstRow(exact, 0, kWhite));
        EXPECT_LE(firstRow(fine, x, kWhite) - firstRow(exact, x, kWhite), 1);
        EXPECT_GE(firstRow(coarse, x, kWhite), firstRow(exact, x, kWhite))
            << "never nearer than it is";
        const int step = x > 0 ? firstRow(coarse, x, kWhite) - firstRow(coarse, x - 1, kWhite) : 0;
        if (step != 0 && (step > 0) != (way > 0)) ++turns;
        if (step != 0) way = step;
    }
    EXPECT_GT(turns, 4) << "a saw's edge";
    EXPECT_LT(count(coarse, kWhite), count(exact, kWhite) * 95 / 100);
}

TEST(Classic, MarchingMissesThinCornersAndGivesUp) {
    // A lone block whose corner is all that some columns meet.
    World world = emptyWorld(60, 9, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, plain("wall", kWhite)));
    world.maps[0].setCell(5, 4, 0, block);
    const Eye eye = eyeAt(1.3, 1.2, 0.5, 40.0);
    const auto columnsWithWall = [&](const ClassicOptions& classic) {
        const Image image = drawOld(world, eye, 400, 20, classic).image;
        int columns = 0;
        for (int x = 0; x < 400; ++x) columns += firstRow(image, x, kWhite) < 20 ? 1 : 0;
        return columns;
    };
    const int exact = columnsWithWall({});
    EXPECT_GT(exact, 50);
    EXPECT_LE(std::abs(columnsWithWall({.march = true, .stepSize = 0.001}) - exact), 1);
    EXPECT_LT(columnsWithWall({.march = true, .stepSize = 0.5}), exact - 3);
    EXPECT_EQ(columnsWithWall({.march = true, .stepSize = 0.001, .reach = 3.0}), 0)
        << "it gives up before the block";

    // The walk looks at as many places as there are tiles, the march at one every step.
    EXPECT_LT(drawOld(world, eye, 10, 10, {}).report.samples, 10 * 70);
    EXPECT_GT(drawOld(world, eye, 10, 10, {.march = true}).report.samples, 10 * 1000);
}

// A wall that is faced: its upper edge is a straight line, but at the distance along the ray it
// sinks to both sides.
TEST(Classic, EqualAnglesAloneAreAFishEye) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(8.0, 20.5, 0.5, 0.0);
    const RenderOptions options = {.fovDegrees = 90.0};
    const auto edge = [&](ClassicProjection projection, int column) {
        return firstRow(drawOld(world, eye, 200, 200, {.projection = projection}, options).image,
                        column, kWhite);
    };
    for (const int column : {0, 50, 100, 150, 199}) {
        EXPECT_EQ(edge(ClassicProjection::plane, column), 75) << column;  // 100 - 0.5 * 100 / 2
        EXPECT_EQ(edge(ClassicProjection::equalAnglesCorrected, column), 75) << column;
    }
    // At 45 degrees the way to the wall is longer by the square root of two: 100 - 25 / 1.414
    // = 82.3; at 22.5 degrees 100 - 25 * 0.924 = 76.9.
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 100), 75);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 50), 77);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 150), 77);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 0), 82);
    EXPECT_EQ(edge(ClassicProjection::equalAngles, 199), 82);
}

TEST(Classic, EqualAnglesBendSlantingWallsEvenWithTheCosine) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(9.0, 20.5, 0.5, 35.0);
    const RenderOptions options = {.fovDegrees = 90.0};
    const auto bend = [&](ClassicProjection projection) {
        const Image image =
            drawOld(world, eye, 800, 800, {.projection = projection}, options).image;
        // How far the upper edge lies off the straight line between its ends.
        const int left = firstRow(image, 40, kWhite);
        const int right = firstRow(image, 760, kWhite);
        int furthest = 0;
        for (int x = 40; x <= 760; ++x) {
            furthest = std::max(furthest, std::abs(firstRow(image, x, kWhite) * 720 -
                                                   (left * (760 - x) + right * (x - 40))) /
                                              720);
        }
        return furthest;
    };
    EXPECT_LE(bend(ClassicProjection::plane), 1);
    EXPECT_GE(bend(ClassicProjection::equalAnglesCorrected), 6);
}

TEST(Classic, EqualAnglesMakeTexturesUnevenlyWide) {
    const World world = wallWorld(sides("wall", kWhite, kGreen));
    const Eye eye = eyeAt(8.0, 20.5, 0.5, 0.0);
    const auto widths = [&](ClassicProjection projection) {
        const Image image =
            drawOld(world, eye, 400, 20, {.projection = projection}, {.fovDegrees = 90.0}).image;
        std::vector<int> runs = {1};
        for (int x = 1; x < 400; ++x) {
            if (image.at(x, 10) == image.at(x - 1, 10))
                ++runs.back();
            else
                runs.push_back(1);
        }
        return runs;
    };
    // Half a unit at depth 2 with d = 200: 50 pixels everywhere. At equal angles it is 400 / 90 *
    // atan(1 / 4) = 62.4 in the middle, 400 / 90 * (45 - atan(3 / 4)) = 36.1 at the border.
    EXPECT_EQ(widths(ClassicProjection::plane), std::vector<int>(8, 50));
    const std::vector<int> uneven = widths(ClassicProjection::equalAnglesCorrected);
    ASSERT_EQ(uneven.size(), 8u);
    EXPECT_NEAR(uneven[3], 62, 1);
    EXPECT_NEAR(uneven[4], 62, 1);
    EXPECT_NEAR(uneven[0], 36, 1);
    EXPECT_NEAR(uneven[7], 36, 1);
}

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
    EXPECT_EQ(nearest.report.pixelsPainted, 2);
    EXPECT_EQ(painted.report.pixelsPainted, 2 * (1 + 10)) << "what lies behind, and each wall";
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

TEST(Classic, OneLevelHidesWhatIsAboveAndBehind) {
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

TEST(Classic, CoarseSineTablesMakeColumnsAndTurnsJump) {
    const World world = wallWorld(squares("wall", 40));
    const RenderOptions options = {.fovDegrees = 60.0};
    const auto differentColumns = [&](int steps) {
        const Image image =
            drawOld(world, eyeAt(7.3, 20.4, 0.5, 20.0), 480, 60,
                    {.projection = ClassicProjection::equalAnglesCorrected, .sineSteps = steps},
                    options)
                .image;
        int different = 1;
        for (int x = 1; x < 480; ++x) different += columnsAreEqual(image, x - 1, x) ? 0 : 1;
        return different;
    };
    // A step of a degree is 8 columns; all that lies within one looks the same way.
    EXPECT_LE(differentColumns(360), 61);
    EXPECT_GT(differentColumns(360), 20);
    EXPECT_GT(differentColumns(360'000), differentColumns(360));
    EXPECT_EQ(differentColumns(360'000), differentColumns(0))
        << "the notes' finer table was fine enough for this";

    const auto turned = [&](double heading, int steps) {
        return drawOld(world, eyeAt(7.3, 20.4, 0.5, heading), 120, 60, {.sineSteps = steps},
                       options)
            .image.pixels;
    };
    EXPECT_EQ(turned(20.0, 360), turned(20.9, 360));
    EXPECT_NE(turned(20.0, 360), turned(21.0, 360));
    EXPECT_NE(turned(20.0, 0), turned(20.9, 0));
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
    EXPECT_EQ(coarse.report.pixelsPainted, 40 * 30);

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

TEST(Classic, RefusesWhatCannotBeDrawn) {
    const World world = wallWorld(plain("wall", kWhite));
    const Eye eye = eyeAt(8.0, 20.5, 0.5, 0.0);
    EXPECT_FALSE(drawOld(world, eye, 8, 8, {}).image.empty());
    for (const ClassicOptions& wrong :
         std::vector<ClassicOptions>{{.stepSize = 0.0},
                                     {.stepSize = -0.1},
                                     {.stepSize = 1.1},
                                     {.reach = 0.5},
                                     {.reach = 101.0},
                                     {.sineSteps = -1},
                                     {.sineSteps = kMostSineSteps + 1},
                                     {.pixelSize = 0},
                                     {.pixelSize = kMostPixelSize + 1}}) {
        EXPECT_TRUE(drawOld(world, eye, 8, 8, wrong).image.empty());
    }
    EXPECT_TRUE(drawOld(world, eyeAt(8.0, 20.5, 0.0, 0.0), 8, 8, {}).image.empty());
    EXPECT_TRUE(drawOld(world, eyeAt(8.0, 20.5, 0.5, 0.0, 4.1), 8, 8, {}).image.empty());
    EXPECT_TRUE(drawOld(world, eye, 8, 8, {}, {.fovDegrees = 151.0}).image.empty());
    Eye nowhere = eye;
    nowhere.map = 1;
    EXPECT_TRUE(drawOld(world, nowhere, 8, 8, {}).image.empty());
    EXPECT_FALSE(drawClassic(world, eye, {}, {}, {nullptr, 8, 8, 8}));
}

// All at once, at the least of steps and the widest of views: nothing is divided by zero, nothing
// looked up beside a texture.
TEST(Classic, AnyMixtureCanBeDrawn) {
    Random random(5);
    for (std::uint64_t i = 0; i < 60; ++i) {
        const World world = mixedWorld(i);
        const ClassicOptions classic = {
            .projection = static_cast<ClassicProjection>(random.below(3)),
            .march = random.oneIn(2),
            .stepSize = random.oneIn(2) ? 0.01 : random.between(0.02, 1.0),
            .reach = random.between(1.0, 100.0),
            .stretched = random.oneIn(2),
            .paintersOrder = random.oneIn(2),
            .oneLevel = random.oneIn(3),
            .sineSteps = random.oneIn(2) ? 0 : random.between(1, 400),
            .pixelSize = random.between(1, 9)};
        const Eye eye = {
            .map = 0,
            .x = {random.oneIn(4) ? 5 * 65536 : random.between(-3 * 65536, 13 * 65536)},
            .y = {random.oneIn(4) ? 4 * 65536 : random.between(-3 * 65536, 12 * 65536)},
            .z = {random.oneIn(4) ? 65536 : random.between(1, 6 * 65536)},
            .headingDegrees =
                random.oneIn(3) ? 90.0 * random.between(-4, 4) : random.between(-400.0, 400.0),
            .look = random.between(-4.0, 4.0)};
        const Image image =
            drawOld(world, eye, 64, 48, classic,
                    {.fovDegrees = random.oneIn(2) ? 150.0 : random.between(10.0, 150.0)})
                .image;
        ASSERT_FALSE(image.empty());
        for (const Pixel pixel : image.pixels) ASSERT_EQ(toColour(pixel).a, 255);
    }
}

}  // namespace
}  // namespace slicecast::known
