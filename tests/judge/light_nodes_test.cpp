// The nodes of every face, as the renderer keeps them, against those that the definition says.
#include "base/random.h"
#include "light_tracer.h"
#include "random_scene.h"
#include "render/light/lit_maps.h"
#include "sanitized.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace slicecast::judge {
namespace {

constexpr std::int64_t kFacesCompared = kSanitized ? 3'000 : 20'000;

struct Counts {
    std::int64_t faces = 0;
    std::int64_t rising = 0;  // slopes and cuts
    std::int64_t wrong = 0;
    int mapsBelowFloor = 0;  // where a slope dips below the floor
};

std::string nodesText(const LitFace& face, const LightTracer::Nodes& wanted,
                      const FaceNodes& found) {
    std::string text = "face " + std::to_string(face.kind) + " at " + std::to_string(face.x) +
                       ", " + std::to_string(face.y) + ", level " + std::to_string(face.level) +
                       ":";
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Colour node = toColour(found.nodes[i]);
        text += " " + std::to_string(wanted[i][0]) + "/" + std::to_string(node.r);
    }
    return text;
}

void compareFace(LightTracer& tracer, LitMap& lit, const LitFace& face, Counts& counts) {
    const FaceNodes* const found =
        lit.nodesOf({face.x, face.y, face.level, static_cast<slicecast::LitFace>(face.kind)});
    ASSERT_EQ(found != nullptr, tracer.hasFace(face));
    if (found == nullptr) return;
    ++counts.faces;
    if (tracer.isRising(face)) ++counts.rising;
    const LightTracer::Nodes& wanted = tracer.nodesOf(face);
    bool same = true;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Colour node = toColour(found->nodes[i]);
        same = same && wanted[i] == Rgb{node.r, node.g, node.b};
    }
    if (same) return;
    if (++counts.wrong < 4) ADD_FAILURE() << nodesText(face, wanted, *found);
}

void compareMap(const World& world, const Map& map, LitMap& lit, Counts& counts) {
    LightTracer tracer(world, map);
    lit.beginFrame(world, map);
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            for (int level = 0; level < map.levels; ++level) {
                if (!map.isOccupied(x, y, level)) continue;
                for (int kind = 0; kind < kFaces; ++kind)
                    compareFace(tracer, lit, {x, y, level, kind}, counts);
            }
            for (int kind = LitFace::kFloor; kind <= LitFace::kCeilingAbove; ++kind)
                compareFace(tracer, lit, {x, y, 0, kind}, counts);
        }
    }
    if (tracer.sawBelowFloor) ++counts.mapsBelowFloor;
}

TEST(LightNodes, AreThoseOfTheDefinition) {
    Counts counts;
    for (std::uint64_t seed = 1; counts.faces < kFacesCompared; ++seed) {
        const Scene scene = seed % 2 == 0 ? tieScene(seed, 16, 16) : randomScene(seed, 16, 16);
        for (const Map& map : scene.world.maps) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            LitMap lit;
            if (map.baked.on) compareMap(scene.world, map, lit, counts);
        }
    }
    EXPECT_EQ(counts.wrong, 0);
    EXPECT_GT(counts.rising, kFacesCompared / 60);
    EXPECT_GE(counts.mapsBelowFloor, kSanitized ? 0 : 5);
}

// A slope that has moved far, low in a map with a see-through ceiling: the plane through it meets
// the beginning of its tile in the cell below.
TEST(LightNodes, AreThoseOfTheDefinitionWhereASlopeHasMoved) {
    const Scene scene = randomScene(3408, 160, 100);
    Counts counts;
    for (const Map& map : scene.world.maps) {
        LitMap lit;
        if (map.baked.on) compareMap(scene.world, map, lit, counts);
    }
    EXPECT_GT(counts.rising, 0);
    EXPECT_EQ(counts.wrong, 0);
}

// More lamps than light one place: the nearest ones count, and of equally near ones the first.
TEST(LightNodes, AreThoseOfTheDefinitionUnderManyLamps) {
    Counts counts;
    int maps = 0;
    for (std::uint64_t seed = 1; maps < (kSanitized ? 1 : 4); ++seed) {
        Scene scene = seed % 2 == 0 ? tieScene(seed, 16, 16) : randomScene(seed, 16, 16);
        Random random(seed);
        for (Map& map : scene.world.maps) {
            if (!map.baked.on) continue;
            ++maps;
            SCOPED_TRACE("seed " + std::to_string(seed));
            for (int i = 0; i < 200; ++i) {
                const auto quarter = [&](int units) {
                    return Coordinate{static_cast<std::int32_t>(random.below(4 * units)) << 14};
                };
                const Coordinate x = quarter(std::min(map.width, 8));
                const Coordinate y = quarter(std::min(map.depth, 8));
                const Coordinate z = quarter(map.levels);
                map.baked.lamps.push_back(
                    {x, y, z, {.strength = 0.05, .radius = tileEdge(1 + random.below(6))}});
            }
            LitMap lit;
            lit.beginFrame(scene.world, map);
            compareMap(scene.world, map, lit, counts);
        }
    }
    EXPECT_EQ(counts.wrong, 0);
    EXPECT_GT(counts.faces, kSanitized ? 50 : 300);
}

// However high the ceiling, it hides no lamp that hangs below it.
TEST(LightNodes, AreTheSameUnderAnyCeiling) {
    Counts counts;
    for (int height = 5; height <= 1000; height += height < 80 ? 5 : 77) {
        Scene scene = randomScene(11, 16, 16);
        Map& map = scene.world.maps[0];
        map.ceiling.tiles.assign(static_cast<std::size_t>(map.width) * map.depth, 0);
        map.ceiling.height = tileEdge(height);
        map.baked = {.on = true,
                     .sun = {200, 200, 200, 255},
                     .altitude = 30.0,
                     .lamps = {{toCoordinate(1.5),
                                toCoordinate(1.5),
                                toCoordinate(0.7),
                                {.radius = tileEdge(16)}}}};
        for (int i = 0; i < 12; ++i) {
            LightTracer tracer(scene.world, map);
            LitMap lit;
            lit.beginFrame(scene.world, map);
            compareFace(tracer, lit, {i % 4, i / 4, 0, LitFace::kFloor}, counts);
        }
    }
    EXPECT_EQ(counts.wrong, 0);
}

// A gate whose sheet is opaque while it is shut and clear when it is open, in the sun: what comes
// through has the tint of the frame that it shows, not of the first one.
TEST(LightNodes, AreThoseOfTheDefinitionWhileAGateOpens) {
    WorldBuilder make;
    make.texture("grey", {200, 200, 200, 255});
    Image frames(4 * 8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 4 * 8; ++x)
            frames.at(x, y) = toPixel({240, 40, 40, static_cast<std::uint8_t>(255 - x / 8 * 80)});
    }
    make.world.textures.push_back(makeTexture("gate", frames, 4));
    make.world.gateKinds.push_back({.steps = 8});
    make.block('|', {.name = "gate", .texture = 1}).gate = 0;
    Map& map = make.map("yard", 5, 5, 1);
    make.put('|', 2, 2);
    map.baked = {.on = true,
                 .sun = {255, 255, 255, 255},
                 .azimuth = 90.0,
                 .altitude = 45.0,
                 .ambient = {64, 64, 64, 255},
                 .lamps = {}};
    ASSERT_TRUE(makeGates(make.world).empty());
    makeGateFrames(make.world);
    markSeeThrough(make.world);
    // A node of the floor in its shadow
    LitMap lit;
    const auto behindGate = [&] {
        lit.beginFrame(make.world, map);
        return toColour(lit.nodesOf({2, 1, 0, slicecast::LitFace::floor})->nodes[15]);
    };
    const Colour shut = behindGate();
    Colour before = shut;
    const GateAsk ask = {.wish = GateAsk::Wish::open,
                         .x = toCoordinate(2.5),
                         .y = toCoordinate(1.5),
                         .z = toCoordinate(0.5)};
    for (int step = 0; step <= 8; ++step) {
        stepGates(make.world, {}, ask);
        SCOPED_TRACE("step " + std::to_string(step));
        Counts counts;
        compareMap(make.world, map, lit, counts);
        EXPECT_EQ(counts.wrong, 0);
        const Colour now = behindGate();
        EXPECT_GE(now.r, before.r);
        before = now;
    }
    EXPECT_GT(before.r, shut.r + 20);
    EXPECT_GT(before.r, before.g);
}

}  // namespace
}  // namespace slicecast::judge
