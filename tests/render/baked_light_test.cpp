// Baked light where the judge does not look: what is kept from frame to frame, and what light is
// for.
#include "render/light/lit_maps.h"
#include "render/renderer.h"
#include "world/world_step.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace slicecast {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;

Image draw(Renderer& renderer, const World& world, const RenderOptions& options = {}, int map = 0) {
    Image image(kWidth, kHeight);
    Eye eye;
    eye.map = map;
    eye.x = toCoordinate(1.3);
    eye.y = toCoordinate(4.4);
    eye.z = toCoordinate(1.7);
    eye.headingDegrees = 335.0;
    eye.look = -0.1;
    EXPECT_TRUE(renderer.draw(world, eye, options, {image.pixels.data(), kWidth, kHeight, kWidth}));
    return image;
}

// A yard with a wall and a lift in it, in the sun.
struct Yard : WorldBuilder {
    Yard() {
        texture("grey", {200, 200, 200, 255});
        block('#');
        world.motions.push_back({.name = "lift", .to = toCoordinate(1.5), .periodSteps = 360});
        CellBlueprint& lift = block('L', {.name = "lift", .top = 0.5});
        lift.motion = 0;
        Map& yard = map("yard", 3, R"(
########
#......#
#..LL..#
#......#
#......#
#......#
########
)");
        yard.baked = {.on = true,
                      .sun = {200, 190, 160, 255},
                      .azimuth = 200.0,
                      .altitude = 35.0,
                      .ambient = {70, 80, 100, 255},
                      .lamps = {{toCoordinate(5.0), toCoordinate(4.0), toCoordinate(0.8), {}}}};
        start(1.3, 4.4);
        EXPECT_TRUE(makeMovers(world).empty());
    }
};

// Light of faces that a lift shades is worked out anew when it moves.
TEST(BakedLight, WhatIsKeptIsWhatAFreshRendererDraws) {
    Yard yard;
    Renderer kept;
    int changes = 0;
    Image before;
    for (int step = 0; step < 360; ++step) {
        stepWorld(yard.world, {}, {});
        if (step % 12 != 0) continue;
        Renderer fresh;
        const Image image = draw(kept, yard.world);
        ASSERT_EQ(image.pixels, draw(fresh, yard.world).pixels) << "step " << step;
        changes += image.pixels != before.pixels ? 1 : 0;
        before = image;
    }
    EXPECT_GT(changes, 5);
}

// A map that no frame shows takes no part in it.
TEST(BakedLight, FollowsWhatMovesWhileAnotherMapIsSeen) {
    Yard yard;
    yard.map("elsewhere", 8, 7, 1);
    Renderer kept;
    const Image before = draw(kept, yard.world);
    for (int step = 0; step < 100; ++step) {
        stepWorld(yard.world, {}, {});
        draw(kept, yard.world, {}, 1);
    }
    Renderer fresh;
    const Image after = draw(kept, yard.world);
    EXPECT_EQ(after.pixels, draw(fresh, yard.world).pixels);
    EXPECT_NE(after.pixels, before.pixels);
}

TEST(BakedLight, FollowsEditsOfBlocks) {
    Yard yard;
    Renderer kept;
    const Image before = draw(kept, yard.world);
    yard.world.maps[0].setCell(4, 4, 0, 1);
    Renderer fresh;
    const Image after = draw(kept, yard.world);
    EXPECT_EQ(after.pixels, draw(fresh, yard.world).pixels);
    EXPECT_NE(after.pixels, before.pixels);
}

TEST(BakedLight, CanBeLeftOut) {
    Yard yard;
    Renderer renderer;
    const Image lit = draw(renderer, yard.world);
    const Image plain = draw(renderer, yard.world, {.baked = false});
    EXPECT_NE(lit.pixels, plain.pixels);
    EXPECT_EQ(lit.pixels, draw(renderer, yard.world).pixels) << "on again";
    yard.world.maps[0].baked.on = false;
    EXPECT_EQ(draw(renderer, yard.world).pixels, plain.pixels);
}

// The mean brightness of a face's nodes.
int lightOn(LitMap& lit, const LitFaceAt& face) {
    const FaceNodes* nodes = lit.nodesOf(face);
    if (nodes == nullptr) return -1;
    int sum = 0;
    for (const Pixel node : nodes->nodes) sum += toColour(node).r;
    return sum / 16;
}

// A closed room in the sun, with a lamp outside.
struct Room : WorldBuilder {
    Room() {
        texture("grey", {200, 200, 200, 255});
        Image glass = imageOf({0, 0, 255, 100});
        texture("glass", glass);
        block('#');
        block('o', {.name = "window", .texture = 1});
        Map& room = map("room", 2, R"(
.........
.###.###.
.#.#.#.#.
.###.#o#.
.........
)");
        for (int x = 1; x < 8; ++x) {
            if (x != 4) room.setCell(x, 2, 1, 1);
        }
        markSeeThrough(world);
        room.baked = {
            .on = true,
            .sun = {255, 255, 255, 255},
            .azimuth = 90.0,
            .altitude = 30.0,
            .ambient = {60, 60, 60, 255},
            .lamps = {
                {toCoordinate(0.5), toCoordinate(2.5), toCoordinate(0.5), {.strength = 4.0}}}};
    }
};

TEST(BakedLight, DoesNotLeakIntoAClosedRoom) {
    const Room room;
    LitMap lit;
    lit.beginFrame(room.world, room.world.maps[0]);
    EXPECT_EQ(lightOn(lit, {2, 2, 0, LitFace::floor}), 20) << "a third of the ambient light";
    EXPECT_GT(lightOn(lit, {0, 2, 0, LitFace::floor}), 150) << "in the sun";
    EXPECT_EQ(lightOn(lit, {2, 2, 0, LitFace::top}), -1) << "there is no such block";
}

TEST(BakedLight, ComesThroughAWindowInItsColour) {
    const Room room;
    LitMap lit;
    lit.beginFrame(room.world, room.world.maps[0]);
    const FaceNodes* nodes = lit.nodesOf({6, 2, 0, LitFace::floor});
    ASSERT_NE(nodes, nullptr);
    int red = 0;
    int blue = 0;
    for (const Pixel node : nodes->nodes) {
        red += toColour(node).r;
        blue += toColour(node).b;
    }
    EXPECT_GT(red, 16 * 20) << "more than the least";
    EXPECT_GT(blue, red + 16 * 10);
}

TEST(BakedLight, KeepsTheColourOfStrongLight) {
    Yard yard;
    BakedLight& light = yard.world.maps[0].baked;
    light.sun = light.ambient = {0, 0, 0, 255};
    light.lamps[0].kind = {.colour = {200, 120, 40, 255}, .strength = 6.0};
    LitMap lit;
    lit.beginFrame(yard.world, yard.world.maps[0]);
    const FaceNodes* nodes = lit.nodesOf({4, 4, 0, LitFace::floor});
    ASSERT_NE(nodes, nullptr);
    const Colour node = toColour(nodes->nodes[0]);
    EXPECT_EQ(node.r, 255);
    EXPECT_NEAR(node.g, 255 * 120 / 200, 2);
    EXPECT_NEAR(node.b, 255 * 40 / 200, 2);
}

// Beside the same light, tiles that touch agree where they touch.
TEST(BakedLight, HasNoStepBetweenTiles) {
    Yard yard;
    LitMap lit;
    lit.beginFrame(yard.world, yard.world.maps[0]);
    for (int x = 1; x < 6; ++x) {
        const FaceNodes west = *lit.nodesOf({x, 4, 0, LitFace::floor});
        const FaceNodes east = *lit.nodesOf({x + 1, 4, 0, LitFace::floor});
        for (int square = 0; square < 2; ++square) {
            for (int node = 0; node < 2; ++node) {
                EXPECT_EQ(west.nodes[FaceNodes::index(1, square, 1, node)],
                          east.nodes[FaceNodes::index(0, square, 0, node)])
                    << "at x " << x + 1;
            }
        }
    }
}

TEST(BakedLight, TakesFewBytesForAFace) {
    Yard yard;
    LitMap lit;
    lit.beginFrame(yard.world, yard.world.maps[0]);
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 8; ++x) {
            lit.nodesOf({x, y, 0, LitFace::floor});
            for (int face = 0; face < kFaces; ++face)
                lit.nodesOf({x, y, 0, static_cast<LitFace>(face)});
        }
    }
    EXPECT_GT(lit.faces(), 150u);
    EXPECT_LT(lit.bytes(), lit.faces() * 80);
}

// A hall with 2,178 lamps that all reach far, and a block that moves under them.
struct ManyLamps : WorldBuilder {
    ManyLamps() {
        texture("grey", {200, 200, 200, 255});
        block('#');
        world.motions.push_back({.name = "lift", .to = toCoordinate(0.5), .periodSteps = 360});
        block('L', {.name = "lift", .top = 0.5}).motion = 0;
        std::string rows = "\n";
        for (int y = 0; y < 33; ++y)
            rows += (y == 3 ? "#......L........................#"
                            : "#...............................#") +
                    std::string("\n");
        Map& hall = map("hall", 2, rows);
        hall.baked.on = true;
        hall.baked.ambient = {30, 30, 30, 255};
        for (int i = 0; i < 33 * 66; ++i) {
            hall.baked.lamps.push_back({toCoordinate(i % 33 + 0.5),
                                        toCoordinate(i / 66 + 0.5),
                                        toCoordinate(i / 33 % 2 == 0 ? 0.1 : 1.1),
                                        {.strength = 0.05, .radius = tileEdge(16)}});
        }
        start(1.3, 4.4);
        EXPECT_TRUE(makeMovers(world).empty());
    }
};

// Work counts cells, so it is the same on every machine. Without a most per place, this picture
// would need 34 times as much.
TEST(BakedLight, CostsNoMoreWithMoreLamps) {
    ManyLamps hall;
    Renderer renderer;
    draw(renderer, hall.world);
    EXPECT_LT(renderer.report().lightWork, 5'000'000);
    EXPECT_GT(renderer.report().lightWork, 100'000);
    for (int step = 0; step < 40; ++step) stepWorld(hall.world, {}, {});
    draw(renderer, hall.world);
    EXPECT_GT(renderer.report().lightWork, 1'000) << "the block has moved";
}

// What a picture has no time for comes with the next ones: then all is as if drawn at once.
TEST(BakedLight, ComesLateWhereAPictureHasNoTimeForIt) {
    ManyLamps hall;
    Renderer whole;
    Renderer hasty;
    constexpr LightWork kAllowed = 100'000;
    constexpr LightWork kMostOfAFace = 50'000;
    int pictures = 0;
    int unlike = 0;
    for (int round = 0; round < 3; ++round) {
        const Image wanted = draw(whole, hall.world);
        Image shown;
        do {
            shown = draw(hasty, hall.world, {.lightWork = kAllowed});
            EXPECT_LT(hasty.report().lightWork, kAllowed + kMostOfAFace);
            ++pictures;
            ASSERT_LT(pictures, 200);
            unlike += shown.pixels != wanted.pixels ? 1 : 0;
        } while (hasty.report().lateLight > 0);
        EXPECT_EQ(shown.pixels, wanted.pixels) << "round " << round;
        for (int step = 0; step < 40; ++step) stepWorld(hall.world, {}, {});
    }
    EXPECT_GT(pictures, 6);
    EXPECT_GT(unlike, 3);
}

TEST(BakedLight, CanBeDrawnInParts) {
    ManyLamps hall;
    Renderer whole;
    Renderer parts;
    constexpr int kWide = 200;
    Eye eye;
    eye.x = toCoordinate(1.3);
    eye.y = toCoordinate(4.4);
    eye.z = toCoordinate(1.7);
    eye.headingDegrees = 40.0;
    Image wanted(kWide, kHeight);
    Image image(kWide, kHeight);
    whole.draw(hall.world, eye, {}, {wanted.pixels.data(), kWide, kHeight, kWide});
    int calls = 0;
    LightWork work = 0;
    for (int column = 0; column < kWide; ++calls) {
        ASSERT_LT(calls, 1000);
        const int next = parts.drawSome(hall.world, eye, {.lightWork = 50'000},
                                        {image.pixels.data(), kWide, kHeight, kWide}, column);
        ASSERT_GE(next, column);
        ASSERT_LE(next, column + 64);
        column = next;
        work += parts.report().lightWork;
    }
    EXPECT_GE(work, whole.report().lightWork) << "of all calls, whole or not";
    EXPECT_GT(calls, 10);
    EXPECT_EQ(image.pixels, wanted.pixels);
    EXPECT_EQ(parts.report().rowsFilled, whole.report().rowsFilled) << "counted once";
    eye.z = toCoordinate(-1.0);
    EXPECT_EQ(parts.drawSome(hall.world, eye, {}, {image.pixels.data(), kWide, kHeight, kWide}, 0),
              -1);
}

// Many maps, of which all light is asked for: what is kept stays within its bound.
TEST(BakedLight, KeepsToItsMemory) {
    WorldBuilder builder;
    builder.texture("grey", {200, 200, 200, 255});
    builder.block('#');
    constexpr int kMaps = 20;
    constexpr int kTiles = 32;  // a side
    for (int i = 0; i < kMaps; ++i) {
        Map& map = builder.map(("map" + std::to_string(i)).c_str(), kTiles, kTiles, 1);
        map.baked.on = true;
        map.baked.ambient = {60, 60, 60, 255};
    }
    LitMaps maps;
    std::size_t most = 0;
    std::size_t faces = 0;
    maps.beginFrame(builder.world, {});
    for (int i = 0; i < kMaps; ++i) {
        for (int tile = 0; tile < kTiles * kTiles; ++tile) {
            if (tile % 100 == 0) maps.beginStrip();
            maps.of(i)->linesOf({tile % kTiles, tile / kTiles, 0, LitFace::floor}, 6, kOutside);
            ++faces;
        }
        most = std::max(most, maps.bytes());
        if (i % 10 == 9) maps.beginFrame(builder.world, {});
    }
    EXPECT_GT(faces * 128 * sizeof(LightLine), kMostLightKept) << "or nothing is given back";
    EXPECT_LT(most, kMostLightKept + (1u << 20));
    EXPECT_GT(most, kMostLightKept / 2);
}

}  // namespace
}  // namespace slicecast
