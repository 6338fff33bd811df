// Scenes whose picture is known on paper.
#include "scenes.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace slicecast::known {
namespace {

// At a field of view of 90 degrees the projection plane is half a picture's width away: 100 pixels
// here. A block of height 1 at depth t is 100 / t rows high, and with the eye at half its height it
// lies evenly about the middle.
TEST(KnownAnswers, WallHeightsToThePixel) {
    struct Case {
        double depth;
        int first;  // the first row whose centre lies below 100 - 50 / t
        int rows;
    };
    // 50 / t: 0.5 -> 100, 1 -> 50, 1.25 -> 40, 1.6 -> 31.25, 2 -> 25, 3 -> 16.67, 7.5 -> 6.67, 10
    // -> 5
    const Case cases[] = {{0.5, 0, 200}, {1.0, 50, 100}, {1.25, 60, 80}, {1.6, 69, 62},
                          {2.0, 75, 50}, {3.0, 83, 34},  {7.5, 93, 14},  {10.0, 95, 10}};
    World world = emptyWorld(20, 21, 1, plain("floor", {0, 0, 0, 255}));
    const BlueprintId wall = addBlock(world, addTexture(world, plain("wall", kWhite)));
    for (int y = 0; y < 21; ++y) world.maps[0].setCell(15, y, 0, wall);
    for (const Case& c : cases) {
        const Image image =
            draw(world, eyeAt(15.0 - c.depth, 10.5, 0.5, 0.0), 200, 200, {.fovDegrees = 90.0});
        ASSERT_FALSE(image.empty());
        for (const int column : {60, 100, 139}) {
            int first = -1;
            int rows = 0;
            for (int y = 0; y < 200; ++y) {
                if (image.at(column, y) != toPixel(kWhite)) continue;
                if (first < 0) first = y;
                ++rows;
            }
            EXPECT_EQ(first, c.first) << "at depth " << c.depth << ", column " << column;
            EXPECT_EQ(rows, c.rows) << "at depth " << c.depth << ", column " << column;
        }
    }
}

// Where the light is off, the map's or the viewer's, colours are as they are: a limit on what light
// gives darkens nothing.
TEST(KnownAnswers, UnlitIsUnlit) {
    World world = emptyWorld(9, 9, 1, plain("floor", {200, 100, 50, 255}));
    world.maps[0].light = {.on = true, .darkest = 0.1, .brightest = 0.5};
    const auto floorSeen = [&](bool light) {
        return draw(world, eyeAt(4.5, 4.5, 0.5, 30.0), 20, 20, {.light = light}).at(10, 18);
    };
    EXPECT_EQ(floorSeen(true), toPixel({100, 50, 25, 255}));
    EXPECT_EQ(floorSeen(false), toPixel({200, 100, 50, 255}));
    world.maps[0].light.on = false;
    EXPECT_EQ(floorSeen(true), toPixel({200, 100, 50, 255}));
}

// An edge that meets the centres of a row exactly: at depth 4 the upper edge is at row 87.5. A
// border that is crossed eastward counts as a little nearer, so the edge lies a little higher and
// row 87 is wall; crossed westward it counts as a little farther and row 87 is not. The lower edge
// goes the same way.
TEST(KnownAnswers, AnEdgeOnARowsCentre) {
    World world = emptyWorld(21, 5, 1, plain("floor", {0, 0, 0, 255}));
    const BlueprintId wall = addBlock(world, addTexture(world, plain("wall", kWhite)));
    for (int y = 0; y < 5; ++y) {
        world.maps[0].setCell(15, y, 0, wall);
        world.maps[0].setCell(6, y, 0, wall);
    }
    const RenderOptions options = {.fovDegrees = 90.0};
    const Image east = draw(world, eyeAt(11.0, 2.5, 0.5, 0.0), 200, 200, options);
    EXPECT_EQ(east.at(100, 87), toPixel(kWhite));
    EXPECT_EQ(east.at(100, 86), toPixel(kMagenta));
    EXPECT_EQ(east.at(100, 112), toPixel(kWhite));
    EXPECT_EQ(east.at(100, 113), toPixel({0, 0, 0, 255}));
    const Image west = draw(world, eyeAt(11.0, 2.5, 0.5, 180.0), 200, 200, options);
    EXPECT_EQ(west.at(100, 87), toPixel(kMagenta));
    EXPECT_EQ(west.at(100, 88), toPixel(kWhite));
    EXPECT_EQ(west.at(100, 111), toPixel(kWhite));
    EXPECT_EQ(west.at(100, 112), toPixel({0, 0, 0, 255}));
}

// A closed room of white blocks, seen from everywhere, without light: a crack anywhere would show
// another colour.
TEST(KnownAnswers, WhiteRoomWithoutACrack) {
    World world = emptyWorld(9, 9, 4, plain("white", kWhite));
    const BlueprintId full = addBlock(world, 0);
    const BlueprintId low = addBlock(world, 0, {}, toCoordinate(0.3));
    const BlueprintId high = addBlock(world, 0, toCoordinate(0.62), tileEdge(1));
    const BlueprintId thin = addBlock(world, 0, toCoordinate(0.4), toCoordinate(0.45));
    Map& map = world.maps[0];
    Random random(11);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 9; ++x) {
            for (int level = 0; level < 4; ++level) {
                const bool shell = x == 0 || y == 0 || x == 8 || y == 8 || level == 3;
                const BlueprintId inner[] = {low, high, thin, full};
                if (shell)
                    map.setCell(x, y, level, full);
                else if (random.oneIn(4))
                    map.setCell(x, y, level, inner[random.below(4)]);
            }
        }
    }
    for (int i = 0; i < 150; ++i) {
        const Eye eye =
            eyeAt(random.between(1.0, 8.0), random.between(1.0, 8.0), random.between(0.01, 3.0),
                  random.between(0.0, 360.0), random.between(-2.0, 2.0));
        const Image image = draw(world, eye, 161, 97, {.fovDegrees = random.between(30.0, 120.0)});
        ASSERT_FALSE(image.empty());
        for (const Pixel pixel : image.pixels) ASSERT_EQ(pixel, toPixel(kWhite)) << "eye " << i;
    }
}

// A world mirrored east to west and an eye mirrored with it give the mirrored picture.
TEST(KnownAnswers, MirroredRooms) {
    const auto room = [](bool mirrored) {
        World world = emptyWorld(11, 8, 3, plain("floor", {60, 90, 60, 255}));
        BlueprintId blocks[4];
        for (int i = 0; i < 4; ++i) {
            CellBlueprint blueprint;
            blueprint.bottom = toCoordinate(i == 2 ? 0.5 : 0.0);
            blueprint.top = toCoordinate(i == 1 ? 0.35 : 1.0);
            for (int f = 0; f < kFaces; ++f) {
                Face face = static_cast<Face>(f);
                if (mirrored && face == Face::east)
                    face = Face::west;
                else if (mirrored && face == Face::west)
                    face = Face::east;
                const auto shade = static_cast<std::uint8_t>(40 + 50 * i);
                blueprint.faces[static_cast<std::size_t>(face)].texture =
                    addTexture(world, plain("face", {shade, static_cast<std::uint8_t>(30 * f + 20),
                                                     static_cast<std::uint8_t>(255 - shade), 255}));
            }
            world.blueprints.push_back(blueprint);
            blocks[i] = static_cast<BlueprintId>(world.blueprints.size() - 1);
        }
        Random random(5);
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 11; ++x) {
                for (int level = 0; level < 3; ++level) {
                    if (random.oneIn(5))
                        world.maps[0].setCell(mirrored ? 10 - x : x, y, level,
                                              blocks[random.below(4)]);
                }
            }
        }
        return world;
    };
    const World left = room(false);
    const World right = room(true);
    Random random(6);
    for (int i = 0; i < 60; ++i) {
        const double x = random.between(0.1, 10.9);
        const double heading = random.between(0.0, 360.0);
        Eye eye = eyeAt(x, random.between(0.1, 7.9), random.between(0.1, 3.4), heading,
                        random.between(-0.5, 0.5));
        const Image one = draw(left, eye, 160, 101);
        eye.x = tileEdge(11) - eye.x;
        eye.headingDegrees = 180.0 - heading;
        const Image other = draw(right, eye, 160, 101);
        ASSERT_FALSE(one.empty() || other.empty());
        int different = 0;
        for (int py = 0; py < 101; ++py) {
            for (int px = 0; px < 160; ++px) different += one.at(px, py) != other.at(159 - px, py);
        }
        EXPECT_EQ(different, 0) << "eye " << i;
    }
}

// The letter F, which no mirror leaves alone, on all six faces: upright and readable wherever it is
// seen from outside.
constexpr const char* kLetter[8] = {"........", ".#####..", ".#......", ".####...",
                                    ".#......", ".#......", ".#......", "........"};

Texture letter() {
    Image image(8, 8);
    for (int v = 0; v < 8; ++v) {
        for (int u = 0; u < 8; ++u)
            image.at(u, v) = toPixel(kLetter[v][u] == '#' ? kWhite : Colour{10, 10, 60, 255});
    }
    return makeTexture("letter", std::move(image));
}

struct Point {
    double column;
    double row;
};

// Where a point of the world appears in a picture of 200 x 200 pixels at 90 degrees, by the
// definition.
Point project(const Eye& eye, double x, double y, double z) {
    const double dx = x - eye.x.value();
    const double dy = y - eye.y.value();
    const int quarter = static_cast<int>(eye.headingDegrees) / 90;
    const double ahead = quarter == 0 ? dx : quarter == 1 ? dy : quarter == 2 ? -dx : -dy;
    const double aside = quarter == 0 ? dy : quarter == 1 ? -dx : quarter == 2 ? -dy : dx;
    return {100.0 + 100.0 * aside / ahead,
            100.0 + 200.0 * eye.look - 100.0 * (z - eye.z.value()) / ahead};
}

TEST(KnownAnswers, LetteringOnAllSixFaces) {
    World world = emptyWorld(7, 7, 3, plain("floor", {90, 60, 30, 255}));
    const BlueprintId block = addBlock(world, addTexture(world, letter()));
    world.maps[0].setCell(3, 3, 1, block);
    struct Case {
        const char* name;
        Eye eye;
        // The world point at which texel (u, v), in fractions of the face, has to be for the letter
        // to be upright as seen by this eye.
        double (*x)(double u, double v);
        double (*y)(double u, double v);
        double (*z)(double u, double v);
    };
    const Case cases[] = {
        {"south, seen northward", eyeAt(3.5, 5.3, 1.5, 270.0),
         [](double u, double) { return 3 + u; }, [](double, double) { return 4.0; },
         [](double, double v) { return 2 - v; }},
        {"north, seen southward", eyeAt(3.5, 1.7, 1.5, 90.0),
         [](double u, double) { return 4 - u; }, [](double, double) { return 3.0; },
         [](double, double v) { return 2 - v; }},
        {"west, seen eastward", eyeAt(1.7, 3.5, 1.5, 0.0), [](double, double) { return 3.0; },
         [](double u, double) { return 3 + u; }, [](double, double v) { return 2 - v; }},
        {"east, seen westward", eyeAt(5.3, 3.5, 1.5, 180.0), [](double, double) { return 4.0; },
         [](double u, double) { return 4 - u; }, [](double, double v) { return 2 - v; }},
        {"top, seen northward from above", eyeAt(3.5, 5.0, 3.2, 270.0, -0.4),
         [](double u, double) { return 3 + u; }, [](double, double v) { return 3 + v; },
         [](double, double) { return 2.0; }},
        {"bottom, seen northward from below", eyeAt(3.5, 5.0, 0.1, 270.0, 0.3),
         [](double u, double) { return 3 + u; }, [](double, double v) { return 4 - v; },
         [](double, double) { return 1.0; }},
    };
    for (const Case& c : cases) {
        const Image image = draw(world, c.eye, 200, 200, {.fovDegrees = 90.0, .detail = false});
        ASSERT_FALSE(image.empty());
        for (int v = 0; v < 8; ++v) {
            std::string seen;
            for (int u = 0; u < 8; ++u) {
                const double fu = (u + 0.5) / 8;
                const double fv = (v + 0.5) / 8;
                const Point p = project(c.eye, c.x(fu, fv), c.y(fu, fv), c.z(fu, fv));
                ASSERT_TRUE(p.column > 0 && p.column < 200 && p.row > 0 && p.row < 200) << c.name;
                seen +=
                    image.at(static_cast<int>(p.column), static_cast<int>(p.row)) == toPixel(kWhite)
                        ? '#'
                        : '.';
            }
            EXPECT_EQ(seen, kLetter[v]) << c.name << ", row " << v;
        }
    }
}

// What cannot be drawn is refused, and the picture is left alone.
TEST(KnownAnswers, RefusesInvalidViews) {
    const World world = emptyWorld(3, 3, 1, plain("floor", kWhite));
    const Eye good = eyeAt(1.5, 1.5, 0.5, 0.0);
    EXPECT_FALSE(draw(world, good, 4, 4).empty());
    EXPECT_TRUE(draw(world, eyeAt(1.5, 1.5, 0.0, 0.0), 4, 4).empty()) << "an eye on the floor";
    EXPECT_TRUE(draw(world, eyeAt(1.5, 1.5, -1.0, 0.0), 4, 4).empty()) << "an eye below the floor";
    Eye elsewhere = good;
    elsewhere.map = 1;
    EXPECT_TRUE(draw(world, elsewhere, 4, 4).empty()) << "a map that does not exist";
    const double nan = 0.0 * std::numeric_limits<double>::infinity();
    for (const double fov : {0.0, 9.9, 151.0, nan})
        EXPECT_TRUE(draw(world, good, 4, 4, {.fovDegrees = fov}).empty()) << fov;
    for (const double look : {-4.1, 4.1, nan})
        EXPECT_TRUE(draw(world, eyeAt(1.5, 1.5, 0.5, 0.0, look), 4, 4).empty()) << look;
    Image image(2, 2);
    image.at(0, 0) = 7;
    Renderer renderer;
    EXPECT_FALSE(
        renderer.draw(world, eyeAt(1.5, 1.5, 0.0, 0.0), {}, {image.pixels.data(), 2, 2, 2}));
    EXPECT_FALSE(renderer.draw(world, good, {}, {image.pixels.data(), 2, 2, 1}))
        << "rows that overlap";
    EXPECT_EQ(image.at(0, 0), 7u);
}

// Rows may be padded; what lies between them is not touched.
TEST(KnownAnswers, LeavesThePaddingAlone) {
    const World world = emptyWorld(3, 3, 1, plain("floor", kWhite));
    const Eye eye = eyeAt(1.5, 1.5, 0.5, 30.0);
    std::vector<Pixel> padded(40 * 20, 12345);
    Renderer renderer;
    ASSERT_TRUE(renderer.draw(world, eye, {}, {padded.data(), 33, 20, 40}));
    const Image tight = draw(world, eye, 33, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 33; ++x)
            ASSERT_EQ(padded[static_cast<std::size_t>(y * 40 + x)], tight.at(x, y));
        for (int x = 33; x < 40; ++x)
            ASSERT_EQ(padded[static_cast<std::size_t>(y * 40 + x)], 12345u);
    }
}

// The trace of a column tells the rows that the picture shows.
TEST(KnownAnswers, TheTraceOfAWall) {
    World world = emptyWorld(20, 5, 1, plain("floor", {0, 0, 0, 255}));
    const BlueprintId wall = addBlock(world, addTexture(world, plain("wall", kWhite)));
    for (int y = 0; y < 5; ++y) world.maps[0].setCell(15, y, 0, wall);
    Renderer renderer;
    const SliceTrace trace =
        renderer.trace(world, eyeAt(13.0, 2.5, 0.5, 0.0), {.fovDegrees = 90.0}, {201, 200, 100});
    ASSERT_EQ(trace.hits.size(), 1u);
    const Hit& hit = trace.hits[0];
    EXPECT_EQ(hit.tileX, 15);
    EXPECT_EQ(hit.tileY, 2);
    EXPECT_EQ(hit.face, Face::west);
    EXPECT_DOUBLE_EQ(hit.x, 15.0);
    EXPECT_DOUBLE_EQ(hit.y, 2.5);
    EXPECT_DOUBLE_EQ(hit.depth, 2.0);
    EXPECT_DOUBLE_EQ(hit.rawDepth, 2.0);
    EXPECT_DOUBLE_EQ(hit.backDepth, 3.0);
    EXPECT_DOUBLE_EQ(hit.topFrontRow, 100.0 - 0.5 * 100.5 / 2.0);
    EXPECT_DOUBLE_EQ(hit.bottomBackRow, 100.0 + 0.5 * 100.5 / 3.0);
    ASSERT_EQ(hit.filled.size(), 1u);
    EXPECT_EQ(hit.filled[0].first, 75);
    EXPECT_EQ(hit.filled[0].last, 125);
    EXPECT_EQ(trace.tiles.size(), 3u)
        << "behind the wall the open rows are above everything, so the walk ends";
    ASSERT_EQ(trace.planes.size(), 2u);
    EXPECT_EQ(trace.planes[0].what, FilledRows::What::floor);
    EXPECT_EQ(trace.planes[1].what, FilledRows::What::sky);
}

// Faces whose rows begin together are told in one order by every compiler: by where their rows end.
// The far side is drawn in two runs, above and below the eye.
TEST(KnownAnswers, TheTraceOfAPaneAcrossThePicture) {
    World world = emptyWorld(9, 5, 1, plain("floor", {0, 0, 0, 255}));
    world.maps[0].setCell(5, 2, 0,
                          addBlock(world, addTexture(world, plain("glass", {200, 220, 255, 90}))));
    markSeeThrough(world);
    Renderer renderer;
    const SliceTrace trace =
        renderer.trace(world, eyeAt(4.875, 2.5, 0.5, 0.0), {.fovDegrees = 90.0}, {201, 60, 100});
    ASSERT_EQ(trace.hits.size(), 1u);
    const std::vector<FilledRows>& filled = trace.hits[0].filled;
    ASSERT_EQ(filled.size(), 3u);
    EXPECT_EQ(std::tuple(filled[0].first, filled[0].last, filled[0].face),
              std::tuple(0, 30, Face::east));
    EXPECT_EQ(std::tuple(filled[1].first, filled[1].last, filled[1].face),
              std::tuple(0, 60, Face::west));
    EXPECT_EQ(std::tuple(filled[2].first, filled[2].last, filled[2].face),
              std::tuple(30, 60, Face::east));
}

}  // namespace
}  // namespace slicecast::known
