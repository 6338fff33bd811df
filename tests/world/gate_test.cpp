// Gates: who opens them, who goes through, and that they never close on anyone.
#include "moving.h"

#include "world/world_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slicecast {
namespace {

using Wish = GateAsk::Wish;
constexpr int kGateSteps = 96;

// A corridor along row 1 with a gate two high across its column 4.
World corridor(const GateKind& kind = {}) {
    World world = emptyWorld(9, 3, 2);
    for (int x = 0; x < 9; ++x) {
        for (const int y : {0, 2}) putBlock(world, x, y, {}, 1.0_u);
    }
    const BlueprintId id = addGate(world, kind);
    for (const int level : {0, 1}) world.maps[0].setCell(4, 1, level, id);
    EXPECT_TRUE(makeGates(world).empty());
    EXPECT_EQ(world.gates.size(), 1u);
    return world;
}

GateState state(const World& world) {
    return stateOf(world.gates[0], world.gateKinds[0]);
}

void steps(Walker& who, int count, const PlayerInput& input = {}) {
    for (int i = 0; i < count; ++i) stepBoth(who.world, who.player, input);
}
void ask(Walker& who, Wish wish) {
    stepBoth(who.world, who.player, {}, asks(who.player, wish));
}

TEST(Gates, OpenAndCloseByKey) {
    Walker who(corridor(), 2.5, 1.5, 0.0);
    EXPECT_EQ(state(who.world), GateState::closed);
    ask(who, Wish::change);
    EXPECT_EQ(state(who.world), GateState::opening);
    steps(who, kGateSteps - 2);
    EXPECT_EQ(state(who.world), GateState::opening);
    EXPECT_FALSE(who.world.blueprints[who.world.gates[0].parts[0]].passable);
    steps(who, 1);
    EXPECT_EQ(state(who.world), GateState::open);
    EXPECT_TRUE(who.world.blueprints[who.world.gates[0].parts[0]].passable);
    steps(who, kSecond * 5);
    EXPECT_EQ(state(who.world), GateState::open);
    ask(who, Wish::change);
    EXPECT_EQ(state(who.world), GateState::closing);
    EXPECT_FALSE(who.world.blueprints[who.world.gates[0].parts[0]].passable);
    steps(who, kGateSteps - 1);
    EXPECT_EQ(state(who.world), GateState::closed);
}

TEST(Gates, ReverseFromTheirProgress) {
    Walker who(corridor(), 2.5, 1.5, 0.0);
    ask(who, Wish::open);
    steps(who, 29);
    EXPECT_EQ(who.world.gates[0].progress, 30);
    ask(who, Wish::change);
    EXPECT_EQ(state(who.world), GateState::closing);
    EXPECT_EQ(who.world.gates[0].progress, 29);
    ask(who, Wish::open);
    EXPECT_EQ(who.world.gates[0].progress, 30);
    ask(who, Wish::open);  // again changes nothing
    EXPECT_EQ(who.world.gates[0].progress, 31);
    ask(who, Wish::close);
    steps(who, 29);
    EXPECT_EQ(who.world.gates[0].progress, 1);
    steps(who, 1);
    EXPECT_EQ(state(who.world), GateState::closed);
}

TEST(Gates, LetBodiesThroughOnlyWhenOpen) {
    Walker who(corridor(), 2.5, 1.5, 0.0);
    ask(who, Wish::open);
    int through = 0;
    for (int step = 1; step < 2 * kSecond; ++step) {
        stepBoth(who.world, who.player, kAhead);
        ASSERT_TRUE(state(who.world) == GateState::open || who.player.x + kBodyHalfWidth <= 4.0_u);
        through += who.x() > 4.3;
    }
    EXPECT_GT(through, 0);
    EXPECT_GT(who.x(), 5.2);
}

// The eye at each of these distances from the nearest point of the gate, which is two high and one
// wide.
TEST(Gates, ObeyKeysWithinARoundReach) {
    GateKind kind;
    kind.reach = 2.0_u;
    World world = emptyWorld(9, 9, 6);
    const BlueprintId id = addGate(world, kind);
    for (const int level : {0, 1}) world.maps[0].setCell(4, 4, level, id);
    EXPECT_TRUE(makeGates(world).empty());
    int heard = 0;
    for (double x = 0.25; x < 9.0; x += 0.5) {
        for (double y = 0.25; y < 9.0; y += 0.5) {
            for (double z = 0.25; z < 6.0; z += 0.5) {
                World tried = world.copy();
                stepWorld(tried, {},
                          {.wish = Wish::open,
                           .map = 0,
                           .x = toCoordinate(x),
                           .y = toCoordinate(y),
                           .z = toCoordinate(z)});
                const auto beyond = [](double v, double low, double high) {
                    return std::max({low - v, v - high, 0.0});
                };
                const double dx = beyond(x, 4.0, 5.0);
                const double dy = beyond(y, 4.0, 5.0);
                const double dz = beyond(z, 0.0, 2.0);
                const bool isWithin = dx * dx + dy * dy + dz * dz <= 4.0;
                ASSERT_EQ(tried.gates[0].wantsOpen, isWithin) << x << " " << y << " " << z;
                heard += isWithin;
            }
        }
    }
    EXPECT_GT(heard, 100);
    stepWorld(world, {}, {.wish = Wish::open, .map = 1, .x = 4.5_u, .y = 4.5_u, .z = 0.5_u});
    EXPECT_FALSE(world.gates[0].wantsOpen) << "from another map";
}

TEST(Gates, ReportWhatTheKeyWouldDo) {
    Walker who(corridor(), 2.5, 1.5, 0.0);
    const auto offer = [&] { return gateOffer(who.world, asks(who.player, Wish::nothing)); };
    EXPECT_EQ(offer(), GateOffer::open);
    ask(who, Wish::change);
    EXPECT_EQ(offer(), GateOffer::close);
    ask(who, Wish::change);
    EXPECT_EQ(offer(), GateOffer::open);
    who.player.x = toCoordinate(1.5);  // 2.5 units away
    EXPECT_EQ(offer(), GateOffer::none);
    Walker deaf(corridor({.keyed = false}), 2.5, 1.5, 0.0);
    EXPECT_EQ(gateOffer(deaf.world, asks(deaf.player, Wish::nothing)), GateOffer::none);
}

TEST(Gates, WithoutAKeyIgnoreKeys) {
    GateKind kind;
    kind.keyed = false;
    kind.startsOpen = true;
    Walker who(corridor(kind), 2.5, 1.5, 0.0);
    ask(who, Wish::close);
    steps(who, 10);
    EXPECT_EQ(state(who.world), GateState::open);
}

TEST(Gates, NeverCloseOnAnyone) {
    GateKind kind;
    kind.startsOpen = true;
    for (const double x : {3.81, 4.5, 5.19}) {
        Walker who(corridor(kind), x, 1.5, 0.0);
        ask(who, Wish::close);
        steps(who, kSecond);
        EXPECT_EQ(state(who.world), GateState::open) << x;
        EXPECT_TRUE(isFree(who.world, 0, bodyBox(who.player)));
        // It is remembered until they have gone.
        steps(who, kSecond, kAhead);
        EXPECT_GT(who.x(), 5.2);
        EXPECT_NE(state(who.world), GateState::open) << x;
    }
    // Touching is not being in it.
    Walker beside(corridor(kind), 3.8, 1.5, 0.0);
    ask(beside, Wish::close);
    EXPECT_EQ(state(beside.world), GateState::closing);
    // Asked to open again, it forgets.
    Walker undecided(corridor(kind), 4.5, 1.5, 0.0);
    ask(undecided, Wish::change);
    ask(undecided, Wish::change);
    steps(undecided, kSecond, kAhead);
    EXPECT_EQ(state(undecided.world), GateState::open);
}

TEST(Gates, OpenOnApproachAndCloseAfterwards) {
    GateKind kind;
    kind.keyed = false;
    kind.opensOnApproach = true;
    kind.approach = 1.0_u;
    kind.holdSteps = kSecond / 2;
    Walker who(corridor(kind), 1.0, 1.5, 0.0);
    steps(who, 10);
    EXPECT_EQ(state(who.world), GateState::closed);
    while (who.x() + 0.2 < 3.0) {
        ASSERT_EQ(state(who.world), GateState::closed);
        steps(who, 1, kAhead);
    }
    steps(who, 1);
    EXPECT_EQ(state(who.world), GateState::opening);
    steps(who, 10 * kSecond);
    EXPECT_EQ(state(who.world), GateState::open) << "as long as somebody is near";
    while (who.x() - 0.2 <= 6.0) steps(who, 1, kAhead);
    steps(who, kSecond / 2 - 2);
    EXPECT_EQ(state(who.world), GateState::open);
    steps(who, 2);
    EXPECT_EQ(state(who.world), GateState::closing);
    // It opens again if the player comes back.
    while (who.x() - 0.2 > 6.0) steps(who, 1, {.forward = -1.0});
    steps(who, 1);
    EXPECT_EQ(state(who.world), GateState::opening);
}

TEST(Gates, OfTouchingCellsAreOneAndOthersStayShut) {
    World world = emptyWorld(9, 3, 2);
    const BlueprintId id = addGate(world, {});
    for (const int x : {1, 2, 4}) world.maps[0].setCell(x, 1, 0, id);
    EXPECT_TRUE(makeGates(world).empty());
    ASSERT_EQ(world.gates.size(), 2u);
    EXPECT_EQ(world.gates[0].boxes.size(), 2u);
    EXPECT_EQ(world.maps[0].cell(1, 1, 0), world.maps[0].cell(2, 1, 0));
    EXPECT_NE(world.maps[0].cell(1, 1, 0), world.maps[0].cell(4, 1, 0));
    const GateAsk fromTheWest = {.wish = Wish::open, .map = 0, .x = 0.5_u, .y = 1.5_u, .z = 0.5_u};
    for (int i = 0; i < kGateSteps; ++i) stepWorld(world, {}, fromTheWest);
    EXPECT_TRUE(world.blueprints[world.maps[0].cell(1, 1, 0)].passable);
    EXPECT_FALSE(world.blueprints[world.maps[0].cell(4, 1, 0)].passable);
    EXPECT_FALSE(world.blueprints[id].passable);
}

TEST(Gates, AreLimitedByTheirCells) {
    World world = emptyWorld(33, 32, 1);
    const BlueprintId id = addGate(world, {});
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) world.maps[0].setCell(x, y, 0, id);
    }
    World more = world.copy();
    EXPECT_TRUE(makeGates(world).empty());
    more.maps[0].setCell(32, 0, 0, id);
    const std::vector<PlacingFault> faults = makeGates(more);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].found, "more than 1024 cells of gates");
}

TEST(Gates, ShowTheFrameOfTheirProgress) {
    World world = emptyWorld(3, 3, 1);
    Image sheet(4 * 8, 8);
    for (int frame = 0; frame < 4; ++frame) {
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x)
                sheet.at(8 * frame + x, y) =
                    toPixel({static_cast<std::uint8_t>(50 * frame), 1, 2,
                             static_cast<std::uint8_t>(frame == 3 ? 0 : 255)});
        }
    }
    Image plain(8, 8);
    for (Pixel& pixel : plain.pixels) pixel = toPixel({0, 1, 2, 255});
    world.textures.push_back(makeTexture("plain", plain));
    world.textures.push_back(makeTexture("sheet", sheet, 4));
    const BlueprintId id = addGate(world, {});
    for (FaceBlueprint& face : world.blueprints[id].faces) face.texture = 0;
    for (const Face face : {Face::north, Face::south})
        world.blueprints[id].faces[static_cast<std::size_t>(face)].texture = 1;
    world.maps[0].setCell(1, 1, 0, id);
    EXPECT_TRUE(makeGates(world).empty());
    makeGateFrames(world);
    markSeeThrough(world);
    ASSERT_EQ(world.textures.size(), 2u + 3u);
    const CellBlueprint& block = world.blueprints[world.maps[0].cell(1, 1, 0)];
    EXPECT_TRUE(block.seeThrough) << "in its last frame";
    const GateAsk open = {.wish = Wish::open, .map = 0, .x = 0.5_u, .y = 1.5_u, .z = 0.5_u};
    for (int progress = 0; progress <= kGateSteps; ++progress) {
        const int frame = std::min(3, progress * 4 / kGateSteps);
        for (const Face face : {Face::north, Face::south}) {
            const Texture& shown = world.textures[block.face(face).texture];
            ASSERT_EQ(toColour(shown.levels[0].texels[0]).r, 50 * frame) << progress;
            ASSERT_EQ(shown.frameAt(840), 0);
            ASSERT_EQ(shown.levels.size(), 4u);
        }
        ASSERT_EQ(block.face(Face::east).texture, 0);
        stepWorld(world, {}, open);
    }
    resetWorld(world);
    EXPECT_EQ(block.face(Face::north).texture, 1);
    EXPECT_FALSE(block.passable);
}

// Gates in a row, each of a kind of its own.
World gatesInARow(const std::vector<GateKind>& kinds) {
    World world = emptyWorld(2 * static_cast<int>(kinds.size()) + 1, 5, 1);
    for (std::size_t i = 0; i < kinds.size(); ++i)
        world.maps[0].setCell(2 * static_cast<int>(i) + 1, 1, 0, addGate(world, kinds[i]));
    EXPECT_TRUE(makeGates(world).empty());
    return world;
}

// Whoever follows is told of each gate once, however many of its leaders there are.
TEST(Gates, FollowAsLongAsOneOfTheirLeadersIsOpen) {
    const GateKind leader = {.steps = 1};
    const GateKind follower = {.steps = 1, .keyed = false, .follows = {0, 1}};
    World world = gatesInARow({leader, leader, follower});
    EXPECT_EQ(world.gateKinds[0].followers, std::vector<int>{2});
    const auto step = [&](int gate, Wish wish) {
        GateAsk ask;
        ask.wish = wish;
        const Box& box = world.gates[static_cast<std::size_t>(gate)].bounds;
        ask.x = box.west;
        ask.y = box.north;
        world.gateKinds[0].reach = world.gateKinds[1].reach = {};
        stepWorld(world, {}, ask);
    };
    const auto isOpen = [&] { return world.gates[2].progress == 1; };
    step(0, Wish::open);
    EXPECT_TRUE(isOpen());
    step(1, Wish::open);
    EXPECT_EQ(world.gateKinds[2].openLeaders, 2);
    step(0, Wish::close);
    EXPECT_TRUE(isOpen()) << "the other one is open";
    step(1, Wish::close);
    EXPECT_FALSE(isOpen());
    EXPECT_EQ(world.gateKinds[2].openLeaders, 0);
    step(0, Wish::open);
    resetGates(world);
    EXPECT_EQ(world.gateKinds[2].openLeaders, 0);
}

// With more pairs of gates and bodies than a step compares, gates take turns: each looks again
// after a few steps.
TEST(Gates, LookForBodiesInTurnWhereThereAreMany) {
    const GateKind kind = {.steps = 1, .opensOnApproach = true, .approach = 0.25_u};
    constexpr std::size_t kGates = 100;
    World world = gatesInARow(std::vector<GateKind>(kGates, kind));
    Body far;
    far.box = {0.1_u, 0.3_u, 4.1_u, 4.3_u, {}, 0.5_u};
    std::vector<Body> bodies(kMostApproachLooks / 30, far);
    for (std::size_t i = 0; i < kGates; ++i) {
        Body near = far;
        const Box& gate = world.gates[i].bounds;
        near.box.west = gate.west + 0.4_u;
        near.box.east = gate.west + 0.6_u;
        near.box.north = gate.south + 0.1_u;
        near.box.south = gate.south + 0.3_u;
        bodies[bodies.size() - kGates + i] = near;
    }
    const auto open = [&] {
        return std::count_if(world.gates.begin(), world.gates.end(),
                             [](const Gate& gate) { return gate.progress == 1; });
    };
    for (const int expected : {30, 60, 90, 100}) {
        stepWorld(world, bodies, {});
        EXPECT_EQ(open(), expected);
    }
    EXPECT_GT(world.nextLookout, 0u);
    resetGates(world);
    EXPECT_EQ(world.nextLookout, 0u);
    // All look at few bodies
    bodies.erase(bodies.begin(), bodies.end() - kGates);
    stepWorld(world, bodies, {});
    EXPECT_EQ(open(), 100);
    EXPECT_EQ(world.nextLookout, 0u);
}

}  // namespace
}  // namespace slicecast
