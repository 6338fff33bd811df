// What a player hears: known walks in small worlds.
#include "world/hearing.h"

#include "moving.h"
#include "world/material.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slicecast {
namespace {

// Floor textures by number: a world has one of each material, in the order of Material.
World groundOf(Material material, int width = 40, int depth = 3) {
    World world = emptyWorld(width, depth, 3);
    world.textures.clear();
    for (const Named<Material>& named : kMaterialNames) {
        world.textures.push_back(makeTexture(named.name, Image(8, 8)));
        world.textures.back().material = named.value;
    }
    Map& map = world.maps[0];
    map.floor.texture = static_cast<TextureId>(material);
    std::fill(map.floor.tiles.begin(), map.floor.tiles.end(), map.floor.texture);
    return world;
}

// Somebody with ears.
struct Listener : Walker {
    Hearing ears;
    std::vector<Sound> heard;  // once, all of it

    using Walker::Walker;

    void walk(int steps, const PlayerInput& input = kAhead, const GateAsk& ask = {}) {
        for (int i = 0; i < steps; ++i) {
            const Player before = player;
            stepBoth(world, player, input, i == 0 ? ask : GateAsk{});
            ears.step(world, before, player);
            for (const Sound& sound : ears.take(world, player)) {
                if (sound.kind < kFirstLasting) heard.push_back(sound);
            }
        }
    }
    std::vector<Sound> all(SoundKind kind) const {
        std::vector<Sound> found;
        std::copy_if(heard.begin(), heard.end(), std::back_inserter(found),
                     [kind](const Sound& sound) { return sound.kind == kind; });
        return found;
    }
    // The lasting sound of a kind; of gain 0 if there is none.
    Sound lasting(SoundKind kind) {
        for (const Sound& sound : ears.take(world, player)) {
            if (sound.kind == kind) return sound;
        }
        return {.kind = kind};
    }
};

// ---- Feet

TEST(Hearing, StepsByTheDistanceWalked) {
    Listener who(groundOf(Material::stone), 1.5, 1.5, 0.0);
    who.walk(10 * kSecond);
    const double length = kStride + kStrideBySpeed * kWalkingPace.move;
    const double walked = who.x() - 1.5;
    EXPECT_GT(walked, 25.0);
    EXPECT_NEAR(static_cast<double>(who.all(SoundKind::step).size()), walked / length, 1.5);
    EXPECT_EQ(who.heard.size(), who.all(SoundKind::step).size()) << "and nothing else";
}

TEST(Hearing, FasterStepsAreLongerAndLouder) {
    Listener slow(groundOf(Material::stone), 1.5, 1.5, 0.0);
    Listener fast(groundOf(Material::stone), 1.5, 1.5, 0.0);
    slow.walk(4 * kSecond, {.forward = 1.0, .slow = true});
    fast.walk(4 * kSecond, {.forward = 1.0, .fast = true});
    const std::vector<Sound> few = slow.all(SoundKind::step);
    const std::vector<Sound> many = fast.all(SoundKind::step);
    EXPECT_GT(many.size(), few.size());
    EXPECT_GT((fast.x() - 1.5) / static_cast<double>(many.size()),
              (slow.x() - 1.5) / static_cast<double>(few.size()));
    EXPECT_GT(many.back().gain, few.back().gain);
    EXPECT_LE(many.back().gain, 1.0);
}

TEST(Hearing, NothingOfFeetThatStandFlyOrPushAWall) {
    Listener who(groundOf(Material::stone, 5), 1.5, 1.5, 0.0);
    who.walk(2 * kSecond, kNothing);
    EXPECT_TRUE(who.heard.empty());
    who.walk(2 * kSecond);
    who.heard.clear();
    who.walk(2 * kSecond);  // against the outline of the grid
    EXPECT_TRUE(who.heard.empty());
    setFlying(who.world, who.player, true);
    who.walk(2 * kSecond, {.forward = -1.0});
    EXPECT_TRUE(who.heard.empty());
}

TEST(Hearing, StepsHaveTheMaterialUnderfoot) {
    for (const Named<Material>& named : kMaterialNames) {
        Listener who(groundOf(named.value), 1.5, 1.5, 0.0);
        who.walk(2 * kSecond);
        ASSERT_FALSE(who.heard.empty()) << named.name;
        for (const Sound& sound : who.heard) EXPECT_EQ(sound.material, named.value) << named.name;
    }
}

TEST(Hearing, BlocksAreTroddenOnTheirTops) {
    World world = groundOf(Material::grass);
    CellBlueprint& slab = world.blueprints.emplace_back();
    slab.top = 0.25_u;
    for (FaceBlueprint& face : slab.faces) face.texture = static_cast<TextureId>(Material::metal);
    slab.faces[static_cast<std::size_t>(Face::top)].texture =
        static_cast<TextureId>(Material::wood);
    for (int x = 8; x < 40; ++x)
        world.maps[0].setCell(x, 1, 0, static_cast<BlueprintId>(world.blueprints.size() - 1));
    Listener who(std::move(world), 1.5, 1.5, 0.0);
    who.walk(8 * kSecond);
    EXPECT_EQ(who.heard.front().material, Material::grass);
    EXPECT_EQ(who.heard.back().material, Material::wood);
    const auto onMetal = [](const Sound& sound) { return sound.material == Material::metal; };
    EXPECT_TRUE(std::none_of(who.heard.begin(), who.heard.end(), onMetal));
}

// With the middle of the body over the edge, one still stands on the block.
TEST(Hearing, TheEdgeOfABlockIsTroddenOn) {
    World world = groundOf(Material::grass, 40, 5);
    putBlock(world, 5, 2, {}, 1.0_u);
    for (FaceBlueprint& face : world.blueprints.back().faces)
        face.texture = static_cast<TextureId>(Material::wood);
    Listener who(std::move(world), 6.15, 2.5, 1.6, 270.0);
    who.walk(kSecond, kNothing);
    EXPECT_EQ(who.z(), 1.0);
    ASSERT_EQ(who.all(SoundKind::land).size(), 1u);
    EXPECT_EQ(who.heard.front().material, Material::wood);
}

TEST(Hearing, JumpsAndLandings) {
    Listener who(groundOf(Material::sand), 1.5, 1.5, 0.0);
    who.walk(2 * kSecond, {.jump = true});
    ASSERT_EQ(who.heard.size(), 2u);
    EXPECT_EQ(who.heard[0].kind, SoundKind::jump);
    EXPECT_EQ(who.heard[1].kind, SoundKind::land);
    EXPECT_EQ(who.heard[1].material, Material::sand);
    EXPECT_NEAR(who.heard[1].gain, kJumpSpeed / 8.0, 0.02);

    Listener deep(groundOf(Material::sand), 1.5, 1.5, 2.5);
    deep.walk(2 * kSecond, kNothing);
    ASSERT_EQ(deep.heard.size(), 1u);
    EXPECT_GT(deep.heard[0].gain, who.heard[1].gain);
}

// ---- Water

World pool(Coordinate deep) {
    World world = groundOf(Material::stone);
    for (int x = 10; x < 40; ++x) {
        for (int y = 0; y < 3; ++y) {
            putBlock(world, x, y, {}, deep);
            world.blueprints.back().isWater = true;
        }
    }
    return world;
}

TEST(Hearing, WadersSplashAndSwimmersStroke) {
    Listener wader(pool(0.3_u), 7.5, 1.5, 0.0);
    wader.walk(3 * kSecond);
    EXPECT_EQ(wader.heard.front().material, Material::stone);
    EXPECT_EQ(wader.heard.back().material, Material::water);
    EXPECT_EQ(wader.heard.back().kind, SoundKind::step);

    Listener swimmer(pool(1.0_u), 12.5, 1.5, 2.5);
    swimmer.walk(6 * kSecond);
    ASSERT_EQ(swimmer.all(SoundKind::splash).size(), 1u);
    EXPECT_GT(swimmer.all(SoundKind::splash)[0].gain, 0.4) << "from a height";
    EXPECT_GT(swimmer.all(SoundKind::stroke).size(), 3u);
    EXPECT_TRUE(swimmer.all(SoundKind::step).empty());
}

TEST(Hearing, WaterNearbyFromItsSide) {
    Listener who(pool(1.0_u), 7.5, 1.5, 0.0, 270.0);  // looks north, the pool lies east
    const Sound right = who.lasting(SoundKind::water);
    EXPECT_GT(right.gain, 0.2);
    EXPECT_GT(right.pan, 0.7);
    setHeading(who.player, 90.0);
    EXPECT_NEAR(who.lasting(SoundKind::water).pan, -right.pan, 1e-9);
    setHeading(who.player, 0.0);
    EXPECT_NEAR(who.lasting(SoundKind::water).pan, 0.0, 1e-9);
    Listener far(pool(1.0_u), 2.5, 1.5, 0.0);
    EXPECT_EQ(far.lasting(SoundKind::water).gain, 0.0);
}

TEST(Hearing, AFloorOfWaterIsWater) {
    World world = groundOf(Material::stone);
    Map& map = world.maps[0];
    map.floor.water = static_cast<TextureId>(Material::water);
    for (int x = 4; x < 40; ++x) {
        for (int y = 0; y < 3; ++y) map.floor.tiles[map.tileIndex(x, y)] = map.floor.water;
    }
    Listener who(std::move(world), 1.5, 1.5, 0.0);
    EXPECT_GT(who.lasting(SoundKind::water).gain, 0.1);
    who.walk(4 * kSecond);
    EXPECT_EQ(who.heard.front().material, Material::stone);
    EXPECT_EQ(who.heard.back().material, Material::water);
}

TEST(Hearing, UnderWaterIsToldApart) {
    World world = pool(1.0_u);
    Listener who(std::move(world), 12.5, 1.5, 0.0);
    who.player = playerWithEye(0, 12.5_u, 1.5_u, 0.5_u, 0.0, 0.0);
    EXPECT_EQ(who.lasting(SoundKind::submerged).gain, 1.0);
    who.player = playerWithEye(0, 12.5_u, 1.5_u, 1.5_u, 0.0, 0.0);
    EXPECT_EQ(who.lasting(SoundKind::submerged).gain, 0.0);
}

// ---- Gates and movers

World gateAt(int x, int y, Material material) {
    World world = groundOf(Material::stone, 20, 20);
    const BlueprintId id = addGate(world, {.steps = 60, .reach = 20.0_u});
    for (FaceBlueprint& face : world.blueprints[id].faces)
        face.texture = static_cast<TextureId>(material);
    world.maps[0].setCell(x, y, 0, id);
    EXPECT_TRUE(makeGates(world).empty());
    return world;
}

TEST(Hearing, AGateIsHeardFromItsSideWhileItMoves) {
    for (const bool isLeft : {true, false}) {
        Listener who(gateAt(10, isLeft ? 7 : 12, Material::wood), 10.5, 10.0, 0.0);
        EXPECT_EQ(who.lasting(SoundKind::gate).gain, 0.0);
        who.walk(1, kNothing, asks(who.player, GateAsk::Wish::open));
        const Sound moving = who.lasting(SoundKind::gate);
        EXPECT_EQ(moving.material, Material::wood);
        EXPECT_GT(moving.gain, 0.5);
        EXPECT_GT(moving.pan * (isLeft ? -1.0 : 1.0), 0.8);
        who.walk(59, kNothing);
        EXPECT_EQ(who.lasting(SoundKind::gate).gain, 0.0);
        ASSERT_EQ(who.heard.size(), 1u);
        EXPECT_EQ(who.heard[0].kind, SoundKind::knock);
        EXPECT_EQ(who.heard[0].material, Material::wood);
        EXPECT_NEAR(who.heard[0].pan, moving.pan, 1e-9);
        who.walk(60, kNothing, asks(who.player, GateAsk::Wish::close));
        EXPECT_EQ(who.heard.size(), 2u) << "shut";
    }
}

TEST(Hearing, AGateFadesWithDistance) {
    double before = 1.1;
    for (const double x : {9.5, 7.5, 5.5, 3.5, 0.5}) {
        Listener who(gateAt(11, 10, Material::stone), x, 10.5, 0.0);
        who.walk(1, kNothing, asks(who.player, GateAsk::Wish::open));
        const double gain = who.lasting(SoundKind::gate).gain;
        EXPECT_GT(gain, 0.0);
        EXPECT_LT(gain, before);
        EXPECT_NEAR(gain, std::pow(1.0 - (11.0 - x) / kEarshot, 2.0), 0.02);
        before = gain;
    }
}

TEST(Hearing, ResetIsNoKnock) {
    Listener who(gateAt(10, 8, Material::wood), 10.5, 10.5, 0.0);
    who.walk(10, kNothing, asks(who.player, GateAsk::Wish::open));
    resetWorld(who.world);
    who.walk(10, kNothing);
    EXPECT_TRUE(who.heard.empty());
}

TEST(Hearing, MoversWhileTheyMove) {
    World world = groundOf(Material::stone, 20, 5);
    const BlueprintId id = addMoving(
        world, {}, 1.0_u,
        {.name = "lift", .to = 1.0_u, .periodSteps = 480, .shape = MotionShape::stopAndGo});
    for (FaceBlueprint& face : world.blueprints[id].faces)
        face.texture = static_cast<TextureId>(Material::metal);
    world.maps[0].setCell(8, 2, 0, id);
    ASSERT_TRUE(makeMovers(world).empty());
    Listener who(std::move(world), 6.5, 2.5, 0.0);
    int moving = 0;
    int heard = 0;
    for (int step = 0; step < 480; ++step) {
        who.walk(1, kNothing);
        const Mover& mover = who.world.movers[0];
        const Sound sound = who.lasting(SoundKind::mover);
        const bool moves = mover.offset != mover.previousOffset;
        EXPECT_EQ(sound.gain > 0.0, moves);
        moving += moves;
        heard += sound.gain > 0.0 && sound.material == Material::metal;
    }
    EXPECT_GT(moving, 100);
    EXPECT_LT(moving, 400);
    EXPECT_EQ(heard, moving);
}

// ---- Wind

TEST(Hearing, WindUnderTheOpenSkyAndMoreOfItHighUp) {
    World open = groundOf(Material::grass, 20, 20);
    open.maps[0].levels = 3;
    Listener low(open.copy(), 10.5, 10.5, 0.0);
    const double ground = low.lasting(SoundKind::wind).gain;
    EXPECT_GT(ground, 0.2);
    low.player = playerWithEye(0, 10.5_u, 10.5_u, 8.0_u, 0.0, 0.0);
    EXPECT_EQ(low.lasting(SoundKind::wind).gain, 1.0);

    World walled = open.copy();
    for (int y = 0; y < 20; ++y) putBlock(walled, 12, y, {}, 1.0_u);
    Listener sheltered(std::move(walled), 10.5, 10.5, 0.0);
    EXPECT_GT(sheltered.lasting(SoundKind::wind).gain, 0.0);
    EXPECT_LT(sheltered.lasting(SoundKind::wind).gain, ground);

    putCeiling(open, 1.0_u);
    Listener indoors(std::move(open), 10.5, 10.5, 0.0);
    EXPECT_EQ(indoors.lasting(SoundKind::wind).gain, 0.0);
}

// ---- What is not collected

TEST(Hearing, AListenerWhoNeverTakesKeepsNoMoreThanTheLimit) {
    World world = groundOf(Material::stone, 400);
    Player player = Walker(world.copy(), 1.5, 1.5, 0.0).player;
    Hearing ears;
    for (int step = 0; step < 60 * kSecond; ++step) {
        const Player before = player;
        stepBoth(world, player, kAhead);
        ears.step(world, before, player);
    }
    std::size_t once = 0;
    for (const Sound& sound : ears.take(world, player)) once += sound.kind < kFirstLasting;
    EXPECT_GT(once, 20u);
    EXPECT_LE(once, static_cast<std::size_t>(Hearing::kMostAtOnce));
}

}  // namespace
}  // namespace slicecast
