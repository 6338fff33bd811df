// Random players in random worlds: nobody is ever inside anything, nobody is ever stuck, and it all
// happens the same way twice.
#include "sanitized.h"
#include "walking.h"
#include "world/water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace slicecast {
namespace {

constexpr int kPlayerWorlds = kSanitized ? 500 : 5000;
static_assert(kPlayerWorlds < 5000 ||
              std::int64_t{kPlayerWorlds} * kPlayersPerWorld * kStepsPerPlayer >= 10'000'000);

// Wishes that last for a while, as a player's do, now and then all at once.
PlayerInput randomInput(Random& random) {
    const auto axis = [&random] {
        return random.oneIn(3)   ? 0.0
               : random.oneIn(2) ? (random.oneIn(2) ? 1.0 : -1.0)
                                 : random.between(-1.5, 1.5);
    };
    PlayerInput input;
    input.forward = random.oneIn(2) ? 1.0 : axis();
    input.strafe = axis();
    input.turn = axis();
    input.look = axis();
    input.fly = axis();
    input.turnDegrees = random.oneIn(4) ? random.between(-90.0, 90.0) : 0.0;
    input.lookHeights = random.oneIn(4) ? random.between(-1.0, 1.0) : 0.0;
    input.jump = random.oneIn(3);
    input.fast = random.oneIn(3);
    input.slow = random.oneIn(6);
    input.speed = random.oneIn(5) ? random.between(kLeastSpeed, kGreatestSpeed) : 1.0;
    return input;
}

// One random thing that a player may do between steps.
void doSomethingElse(const World& world, Player& player, Random& random) {
    switch (random.below(6)) {
        case 0:
            levelLook(world, player);
            break;
        case 1:
            setHeading(player, 45.0 * random.below(8));
            break;
        default:
            setFlying(world, player, !player.flying);
            break;
    }
}

// The eye is a point: it must not be inside a block, below the floor or beyond the grid.
bool eyeIsInside(const World& world, const Player& player) {
    const Coordinate eye = eyeHeight(player);
    return reachesIntoSomething(world, {player.x, player.x, player.y, player.y, eye, eye});
}

TEST(RandomPlayers, NobodyIsEverInsideABlock) {
    std::int64_t steps = 0;
    std::int64_t walked = 0;
    std::int64_t crouched = 0;
    std::int64_t flown = 0;
    std::int64_t inAir = 0;
    std::int64_t stepsUp = 0;
    for (int seed = 1; seed <= kPlayerWorlds; ++seed) {
        const World world = randomWorld(static_cast<std::uint64_t>(seed));
        Random random(static_cast<std::uint64_t>(seed) << 20);
        for (int i = 0; i < kPlayersPerWorld; ++i) {
            Player player;
            if (!placeRandomly(world, random, player)) continue;
            PlayerInput input = randomInput(random);
            for (int step = 0; step < kStepsPerPlayer; ++step) {
                if (random.oneIn(20)) input = randomInput(random);
                if (random.oneIn(60)) {
                    doSomethingElse(world, player, random);
                    ASSERT_FALSE(reachesIntoSomething(world, bodyBox(player)))
                        << "world " << seed << ", player " << i << ", before step " << step;
                    ASSERT_FALSE(eyeIsInside(world, player))
                        << "world " << seed << ", player " << i << ", before step " << step;
                }
                const Player before = player;
                stepPlayer(world, player, input);
                ASSERT_FALSE(reachesIntoSomething(world, bodyBox(player)))
                    << "world " << seed << ", player " << i << ", step " << step;
                ASSERT_FALSE(eyeIsInside(world, player))
                    << "world " << seed << ", player " << i << ", step " << step;
                ++steps;
                walked += player.onGround;
                crouched += player.crouched;
                flown += player.flying;
                inAir += !player.flying && !player.onGround;
                stepsUp += before.onGround && player.onGround && player.z > before.z;
            }
        }
    }
    // Most worlds have room for somebody, and all kinds of motion came up.
    EXPECT_GT(steps, std::int64_t{kPlayerWorlds} * kPlayersPerWorld * kStepsPerPlayer * 9 / 10);
    for (const std::int64_t kind : {walked, crouched, flown, inAir}) EXPECT_GT(kind, steps / 50);
    EXPECT_GT(stepsUp, steps / 10'000);
}

// A body of 0.4 in tiles of 1 has room along both axes. Only between a slope that it does not climb
// and what stands at its foot it may have none up the slope.
bool canMove(const World& world, bool movesX, bool movesY) {
    const bool hasSlopes =
        std::any_of(world.blueprints.begin(), world.blueprints.end(),
                    [](const CellBlueprint& block) { return block.slopes.any(); });
    return hasSlopes ? movesX || movesY : movesX && movesY;
}

TEST(RandomPlayers, NobodyInWaterIsEverInsideABlockOrStuck) {
    std::int64_t swum = 0;
    std::int64_t waded = 0;
    std::int64_t dived = 0;
    int climbed = 0;
    int tried = 0;
    for (int seed = 1; seed <= kPlayerWorlds / 4; ++seed) {
        const World world = randomWaterWorld(static_cast<std::uint64_t>(seed));
        Random random(static_cast<std::uint64_t>(seed) << 20);
        Player player;
        if (!placeRandomly(world, random, player)) continue;
        player.flying = false;
        if (reachesIntoSomething(world, bodyBox(player))) continue;
        for (int leg = 0; leg < 60; ++leg) {
            const PlayerInput input = randomInput(random);
            if (random.oneIn(8)) doSomethingElse(world, player, random);
            for (int step = 0; step < 30; ++step) {
                const Player before = player;
                stepPlayer(world, player, input);
                ASSERT_FALSE(reachesIntoSomething(world, bodyBox(player)))
                    << "world " << seed << ", leg " << leg << ", step " << step;
                ASSERT_FALSE(eyeIsInside(world, player))
                    << "world " << seed << ", leg " << leg << ", step " << step;
                ASSERT_GT(eyeHeight(player), Coordinate{0}) << "world " << seed;
                const Map& map = world.maps[0];
                swum += player.swimming;
                waded += player.onGround && waterDepth(world, travellerOf(player)).raw > 0;
                dived += waterAt(world, map, player.x.tile(), player.y.tile(), eyeHeight(player))
                             .water != nullptr;
                climbed += before.swimming && !player.swimming && !player.flying;
            }
            if (leg % 20 != 0) continue;
            bool movesX = false;
            bool movesY = false;
            for (int heading = 0; heading < 360; heading += 90) {
                Player probe = player;
                probe.velocityX = probe.velocityY = 0.0;
                setHeading(probe, heading);
                for (int step = 0; step < 20; ++step) stepPlayer(world, probe, kAhead);
                movesX = movesX || probe.x != player.x;
                movesY = movesY || probe.y != player.y;
            }
            ASSERT_TRUE(canMove(world, movesX, movesY)) << "world " << seed << ", leg " << leg;
            ++tried;
        }
    }
    EXPECT_GT(tried, kPlayerWorlds / 4);
    for (const std::int64_t kind : {swum, waded, dived}) EXPECT_GT(kind, kPlayerWorlds * 10);
    EXPECT_GT(climbed, kPlayerWorlds / 4);
}

// A body that is free finds a way to move, wherever it has got to and in either mode.
TEST(RandomPlayers, NobodyIsEverStuck) {
    int tried = 0;
    for (int seed = 1; seed <= kPlayerWorlds / 10; ++seed) {
        const World world = randomWorld(static_cast<std::uint64_t>(seed) + 1'000'000);
        Random random(static_cast<std::uint64_t>(seed) << 20);
        Player player;
        if (!placeRandomly(world, random, player)) continue;
        for (int leg = 0; leg < 10; ++leg) {
            const PlayerInput input = randomInput(random);
            for (int step = 0; step < 60; ++step) stepPlayer(world, player, input);
            if (random.oneIn(3)) setFlying(world, player, !player.flying);
            bool movesX = false;
            bool movesY = false;
            for (int heading = 0; heading < 360; heading += 90) {
                Player probe = player;
                probe.velocityX = probe.velocityY = 0.0;
                setHeading(probe, heading);
                for (int step = 0; step < 20; ++step) stepPlayer(world, probe, kAhead);
                movesX = movesX || probe.x != player.x;
                movesY = movesY || probe.y != player.y;
            }
            ASSERT_TRUE(canMove(world, movesX, movesY)) << "world " << seed << ", leg " << leg;
            ++tried;
        }
    }
    EXPECT_GT(tried, kPlayerWorlds / 2);
}

std::uint64_t hashOfManySteps() {
    std::uint64_t hash = 0;
    const auto add = [&hash](std::uint64_t number) {
        hash = (hash ^ number) * 0x100000001b3u + (hash >> 29);
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const World world = randomWorld(seed);
        Random random(seed << 20);
        Player player;
        if (!placeRandomly(world, random, player)) continue;
        PlayerInput input;
        for (int step = 0; step < 600; ++step) {
            if (step % 15 == 0) input = randomInput(random);
            if (step % 75 == 0) doSomethingElse(world, player, random);
            stepPlayer(world, player, input);
        }
        for (const Coordinate coordinate : {player.x, player.y, player.z, player.eyeLag})
            add(static_cast<std::uint64_t>(coordinate.raw));
        for (const double number : {player.velocityX, player.velocityY, player.velocityZ,
                                    player.headingDegrees, player.look, player.eyeLagRate}) {
            add(std::bit_cast<std::uint64_t>(number));
        }
    }
    return hash;
}

// The same from every compiler and at every level of optimisation. A change of the motion itself
// changes this number.
TEST(RandomPlayers, TheSameInputsGiveTheSameStatesEverywhere) {
    EXPECT_EQ(hashOfManySteps(), hashOfManySteps());
    EXPECT_EQ(hashOfManySteps(), 0xddda78154e87802au);
}

}  // namespace
}  // namespace slicecast
