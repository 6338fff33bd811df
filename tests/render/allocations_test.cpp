// A renderer that draws the same pictures again takes no more memory, whatever they show and in
// whatever order they come.
#include "../count_allocations.h"
#include "render/renderer.h"
#include "world/world.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace slicecast {
namespace {

constexpr int kCountedWidth = 320;
constexpr int kCountedHeight = 180;
constexpr int kSide = 24;  // tiles

// A picture of many colours. With `holes` above 0 it has holes and half-transparent columns, one in
// so many texels.
Image pattern(int width, int height, int holes) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto alpha = holes > 0 && (x + y) % holes == 0 ? 0
                               : holes > 0 && x % holes == 1     ? 120
                                                                 : 255;
            image.at(x, y) =
                toPixel({static_cast<std::uint8_t>(x * 15), static_cast<std::uint8_t>(y * 15), 90,
                         static_cast<std::uint8_t>(alpha)});
        }
    }
    return image;
}

// Fills cells on all levels with blocks of random blueprints.
void addBlocks(World& world, Random& random, Map& map) {
    const int shapes = static_cast<int>(world.blueprints.size());
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            for (int level = 0; level < map.levels; ++level) {
                if (random.oneIn(7 + 3 * level))
                    map.setCell(x, y, level,
                                static_cast<BlueprintId>(random.between(1, shapes - 1)));
            }
        }
    }
}

void addPortals(World& world, Random& random, int from) {
    Map& map = world.maps[static_cast<std::size_t>(from)];
    map.tilePortals.assign(map.occupied.size(), kNoPortal);
    for (int i = 0; i < 40; ++i) {
        const int x = random.below(map.width);
        const int y = random.below(map.depth);
        const auto portal = static_cast<PortalId>(world.portals.size());
        world.portals.push_back({.fromMap = from,
                                 .fromX = x,
                                 .fromY = y,
                                 .toMap = random.below(static_cast<int>(world.maps.size())),
                                 .toX = random.below(kSide),
                                 .toY = random.below(kSide),
                                 .turn = random.below(4),
                                 .levels = random.between(-1, 1)});
        const BlueprintId block = map.cell(x, y, 0);
        if (block == kEmptyCell) {
            map.tilePortals[map.tileIndex(x, y)] = portal;
            continue;
        }
        CellBlueprint instance = world.blueprints[block];
        for (FaceBlueprint& face : instance.faces) face.portal = portal;
        world.blueprints.push_back(instance);
        map.setCell(x, y, 0, static_cast<BlueprintId>(world.blueprints.size() - 1));
    }
}

void addObjects(Random& random, Map& map) {
    for (int i = 0; i < 200; ++i) {
        map.objects.push_back({.sprite = 0,
                               .x = toCoordinate(random.between(0.0, 1.0 * kSide)),
                               .y = toCoordinate(random.between(0.0, 1.0 * kSide)),
                               .z = toCoordinate(random.between(0.0, 1.5)),
                               .width = toCoordinate(random.between(0.2, 1.0)),
                               .height = toCoordinate(random.between(0.2, 1.5))});
    }
}

World mixedWorld() {
    Random random(7);
    World world;
    for (const int holes : {0, 0, 3, 5})
        world.textures.push_back(makeTexture("pattern", pattern(16, 16, holes)));
    world.sprites.push_back(makeSprite("figure", pattern(12, 16, 4)));
    for (int i = 0; i < 12; ++i) {
        CellBlueprint block;
        block.bottom = toCoordinate(i % 3 == 0 ? 0.25 : 0.0);
        block.top = toCoordinate(i % 4 == 0 ? 0.75 : 1.0);
        block.join = i % 2 == 0;
        for (FaceBlueprint& face : block.faces) face.texture = static_cast<TextureId>(i % 4);
        if (i % 3 == 1) block.faces[static_cast<std::size_t>(Face::top)].mirror = 140;
        world.blueprints.push_back(block);
    }
    for (int m = 0; m < 3; ++m) {
        Map map = makeMap("map", kSide, kSide, 3, 1);
        addBlocks(world, random, map);
        addObjects(random, map);
        map.floor.mirror = static_cast<std::uint8_t>(m == 1 ? 0 : 100);
        map.fog = {.on = m != 2, .start = 2.0, .end = 30.0};
        map.sky.kind = static_cast<Sky::Kind>(m);
        map.sky.panorama = pattern(64, 16, 0);
        if (m == 1) {
            map.ceiling.height = tileEdge(3);
            map.ceiling.tiles.assign(map.occupied.size(), 2);
        }
        world.maps.push_back(std::move(map));
    }
    for (int m = 0; m < 3; ++m) addPortals(world, random, m);
    markSeeThrough(world);
    markPortals(world);
    return world;
}

// Eyes on a way through all maps, at many heights, looking everywhere.
std::vector<Eye> way(int pictures) {
    std::vector<Eye> eyes;
    for (int i = 0; i < pictures; ++i) {
        const double part = static_cast<double>(i) / pictures;
        eyes.push_back({.map = i * 3 / pictures,
                        .x = toCoordinate(2.0 + 20.0 * part),
                        .y = toCoordinate(12.3 + 9.0 * (i % 20) / 20.0),
                        .z = toCoordinate(0.3 + 0.11 * (i % 30)),
                        .headingDegrees = 37.0 * i,
                        .look = -0.4 + 0.1 * (i % 9)});
    }
    return eyes;
}

TEST(RendererAllocations, NoneOnARepeatedWay) {
    World world = mixedWorld();
    Renderer renderer;
    Image image(kCountedWidth, kCountedHeight);
    const Picture picture = {image.pixels.data(), kCountedWidth, kCountedHeight, kCountedWidth};
    std::vector<Eye> eyes = way(60);
    FrameReport most;
    const auto go = [&] {
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            world.steps = 12 * static_cast<std::int64_t>(i);
            ASSERT_TRUE(renderer.draw(world, eyes[i], {}, picture));
            const FrameReport& report = renderer.report();
            most.deepestPortal = std::max(most.deepestPortal, report.deepestPortal);
            most.mirroredRows = std::max(most.mirroredRows, report.mirroredRows);
            most.layers = std::max(most.layers, report.layers);
            most.objectSlices = std::max(most.objectSlices, report.objectSlices);
        }
    };
    go();
    EXPECT_EQ(most.deepestPortal, world.portalLimit);
    EXPECT_GT(most.mirroredRows, kCountedWidth * 10);
    EXPECT_GT(most.layers, 1000);
    EXPECT_GT(most.objectSlices, 500);
    const long before = allocations;
    go();
    EXPECT_EQ(allocations, before);
    std::reverse(eyes.begin(), eyes.end());
    go();
    EXPECT_EQ(allocations, before) << "the other way round";
    ::operator delete(::operator new(1));
    EXPECT_EQ(allocations, before + 1) << "they are counted";
}

}  // namespace
}  // namespace slicecast
