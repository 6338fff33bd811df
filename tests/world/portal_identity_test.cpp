// A portal to a copy of the place that it stands in changes nothing: who goes through walks the
// same way as without it, in the copy.
#include "portal_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace slicecast {
namespace {

// Headings on a grid on which quarter turns are exact.
double gridDegrees(Random& random, double range) {
    return random.between(static_cast<int>(-range * 64), static_cast<int>(range * 64)) / 64.0;
}

PlayerInput randomGridInput(Random& random) {
    PlayerInput input;
    input.forward = random.oneIn(4) ? random.between(-1.0, 1.0) : 1.0;
    input.strafe = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.fly = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.turnDegrees = random.oneIn(2) ? 0.0 : gridDegrees(random, 3.0);
    input.jump = random.oneIn(4);
    input.fast = random.oneIn(3);
    input.slow = random.oneIn(6);
    input.speed = random.oneIn(3) ? random.between(kLeastSpeed, kGreatestSpeed) : 1.0;
    return input;
}

// The player of a world with portals as seen from the world without.
Player broughtBack(const Player& player, const Portal& toCopy) {
    Player back = player;
    back.behind = {};
    back.leaps = 0;
    if (player.map == toCopy.fromMap) return back;
    const Portal portal = reversed(toCopy);
    const Position place = carried(portal, {player.x, player.y, player.z});
    back.map = portal.toMap;
    back.x = place.x;
    back.y = place.y;
    back.z = place.z;
    back.headingDegrees = carriedHeading(portal, player.headingDegrees);
    turnArrow(portal.turn, back.velocityX, back.velocityY);
    return back;
}

struct Counts {
    std::int64_t steps = 0;
    std::int64_t leaps = 0;
    std::int64_t straddling = 0;
    int turned[4] = {};
    int rejoined = 0;
};

bool slidesAlongSomething(const Player& player) {
    return player.velocityX == 0.0 || player.velocityY == 0.0 ||
           std::abs(player.velocityX) == std::abs(player.velocityY);
}

// Whether a turn may make this difference. A player who ends a step exactly on a border may be put
// 1/65536 inside the tile. And steps go along x first, in the turned copy too: so a player who
// slides around the end of a wall, or along a cut, may do so a part of a step earlier or later
// there.
bool mayPart(const Portal& toCopy, const Player& before, const Player& a, const Player& b) {
    const int x = std::abs(a.x.raw - b.x.raw);
    const int y = std::abs(a.y.raw - b.y.raw);
    const bool isOnBorder = a.x.fraction() == 0.0 || a.y.fraction() == 0.0;
    const int z = std::abs(a.z.raw - b.z.raw);  // on a slope
    if (toCopy.turn != 0 && isOnBorder && std::max({x, y, z}) <= 1) return true;
    const bool isAtCorner =
        slidesAlongSomething(before) || slidesAlongSomething(a) || slidesAlongSomething(b);
    // And a player who leaves a slope over its side may have climbed a little more of it
    const bool leavesSlope = before.onGround && !a.onGround && !b.onGround && z < 65536 / 64;
    return toCopy.turn % 2 != 0 && (isAtCorner || leavesSlope) && std::max(x, y) < 65536 / 8;
}

// Two players with the same inputs, one of them with portals. False if their ways part.
bool walkBoth(const World& plain, const World& portals, const Portal& toCopy, const Player& start,
              Random& random, int steps, Counts& counts) {
    Player without = start;
    Player with = start;
    PlayerInput input = randomGridInput(random);
    for (int step = 0; step < steps; ++step) {
        if (random.oneIn(25)) input = randomGridInput(random);
        if (random.oneIn(100)) {
            setFlying(plain, without, !without.flying);
            setFlying(portals, with, !with.flying);
        }
        const Player before = without;
        stepPlayer(plain, without, input);
        stepPlayer(portals, with, input);
        ++counts.steps;
        counts.straddling += with.behind.isOn;
        const Player back = broughtBack(with, toCopy);
        if (back == without) continue;
        if (!mayPart(toCopy, before, without, back)) return false;
        ++counts.rejoined;
        without = back;
    }
    counts.leaps += with.leaps;
    counts.turned[toCopy.turn] += with.leaps;
    return true;
}

// Tiles of both maps lead to their places in the other one.
World withTilePortals(const World& plain, int turn, int levels, Random& random, Portal& toCopy) {
    World world = plain.copy();
    toCopy = appendCopy(world, 0, turn, levels);
    const int width = world.maps[0].width;
    const int depth = world.maps[0].depth;
    const int density = random.between(1, 6);
    for (int y = 0; y < depth; ++y) {
        for (int x = 0; x < width; ++x) {
            const Portal portal = portalAt(toCopy, x, y);
            if (random.oneIn(density)) putTilePortal(world, portal);
            if (random.oneIn(density)) putTilePortal(world, reversed(portal));
        }
    }
    return world;
}

// How far the copy can be raised without more levels than a map may have.
int liftOf(const World& world, Random& random) {
    return random.between(0, std::min(2, kMaxLevels - world.maps[0].levels));
}

TEST(PortalIdentity, TilesToACopyChangeNoWay) {
    Counts counts;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) * 7919);
        const World plain = randomWorld(static_cast<std::uint64_t>(seed));
        Portal toCopy;
        const World world = withTilePortals(plain, 0, liftOf(plain, random), random, toCopy);
        Player player;
        if (!placeRandomly(plain, random, player)) continue;
        player.headingDegrees = gridDegrees(random, 180.0) + 180.0;
        EXPECT_TRUE(walkBoth(plain, world, toCopy, player, random, 600, counts)) << "seed " << seed;
    }
    EXPECT_GT(counts.leaps, counts.steps / 200);
    EXPECT_GT(counts.straddling, counts.steps / 100);
}

TEST(PortalIdentity, TurnedToo) {
    Counts counts;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) * 104729);
        const World plain = randomWorld(static_cast<std::uint64_t>(seed));
        Portal toCopy;
        const World world =
            withTilePortals(plain, 1 + seed % 3, liftOf(plain, random), random, toCopy);
        Player player;
        if (!placeRandomly(plain, random, player)) continue;
        player.headingDegrees = gridDegrees(random, 180.0) + 180.0;
        EXPECT_TRUE(walkBoth(plain, world, toCopy, player, random, 600, counts))
            << "seed " << seed << ", turn " << toCopy.turn;
    }
    for (const int turn : {1, 2, 3}) EXPECT_GT(counts.turned[turn], kPortalSeeds / 2) << turn;
    EXPECT_GT(counts.straddling, counts.steps / 100);
    EXPECT_LT(counts.rejoined, counts.steps / 500);
}

// Where a block has portals on two opposite faces.
struct Barrier {
    int x;
    int y;
    int level;
};

// Blocks that fill a passage and lead into the copy; in the copy others lead back.
World withBarriers(const World& plain, int turn, int levels, const std::vector<Barrier>& here,
                   const std::vector<Barrier>& there, Face face, Face opposite, Portal& toCopy) {
    World world = plain.copy();
    toCopy = appendCopy(world, 0, turn, levels);
    CellBlueprint whole;
    world.blueprints.push_back(whole);
    const auto id = static_cast<BlueprintId>(world.blueprints.size() - 1);
    for (const Barrier& barrier : here) {
        world.maps[0].setCell(barrier.x, barrier.y, barrier.level, id);
        for (const Face side : {face, opposite})
            putFacePortal(world, portalAt(toCopy, barrier.x, barrier.y), barrier.level, side);
    }
    for (const Barrier& barrier : there) {
        const Portal portal = reversed(portalAt(toCopy, barrier.x, barrier.y));
        world.maps[1].setCell(portal.fromX, portal.fromY, barrier.level + levels, id);
        for (const Face side : {face, opposite})
            putFacePortal(world, portal, barrier.level + levels, turned(side, turn));
    }
    return world;
}

TEST(PortalIdentity, FacesInACorridorToACopyChangeNoWay) {
    Counts counts;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) * 15485863);
        World plain = emptyWorld(10, 3, 2);
        for (int x = 0; x < 10; ++x) {
            putBlock(plain, x, 0, 0.0_u, 1.0_u);
            putBlock(plain, x, 2, 0.0_u, 1.0_u);
            putBlock(plain, x, 1, 1.0_u, 2.0_u);
        }
        Portal toCopy;
        const World world = withBarriers(plain, seed % 4, random.between(0, 2), {{6, 1, 0}},
                                         {{3, 1, 0}}, Face::west, Face::east, toCopy);
        const Walker walker(plain.copy(), 4.5, 1.5, 0.0, gridDegrees(random, 180.0) + 180.0);
        EXPECT_TRUE(walkBoth(plain, world, toCopy, walker.player, random, 1200, counts))
            << "seed " << seed << ", turn " << toCopy.turn;
    }
    for (const int turn : {0, 1, 2, 3}) EXPECT_GT(counts.turned[turn], kPortalSeeds / 8) << turn;
    EXPECT_GT(counts.straddling, counts.steps / 500);
    EXPECT_LT(counts.rejoined, counts.steps / 1000);
}

TEST(PortalIdentity, TopsAndBottomsInAShaftToACopyChangeNoWay) {
    Counts counts;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) * 32452843);
        World plain = emptyWorld(3, 3, 6);
        for (int tile = 0; tile < 9; ++tile) {
            for (int level = 0; level < 4; ++level) {
                if (tile != 4)
                    putBlock(plain, tile % 3, tile / 3, tileEdge(level), tileEdge(level + 1));
            }
        }
        Portal toCopy;
        const World world = withBarriers(plain, seed % 4, random.between(0, 2), {{1, 1, 2}},
                                         {{1, 1, 1}}, Face::top, Face::bottom, toCopy);
        const Walker walker(plain.copy(), 1.5, 1.5, 3.3, gridDegrees(random, 180.0) + 180.0);
        Player player = walker.player;
        if (random.oneIn(2)) setFlying(plain, player, true);
        EXPECT_TRUE(walkBoth(plain, world, toCopy, player, random, 1200, counts))
            << "seed " << seed << ", turn " << toCopy.turn;
    }
    for (const int turn : {0, 1, 2, 3}) EXPECT_GT(counts.turned[turn], kPortalSeeds / 20) << turn;
    EXPECT_GT(counts.straddling, counts.steps / 500);
    EXPECT_LT(counts.rejoined, counts.steps / 1000);
}

// Portals side by side and one above the other that lead on side by side are one wide portal.
TEST(PortalIdentity, WideGatesToACopyChangeNoWay) {
    Counts counts;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) * 49979687);
        World plain = emptyWorld(10, 4, 3);
        for (int x = 0; x < 10; ++x) {
            for (int level = 0; level < 3; ++level) {
                for (const int y : {0, 3})
                    putBlock(plain, x, y, tileEdge(level), tileEdge(level + 1));
            }
            for (const int y : {1, 2}) putBlock(plain, x, y, 2.0_u, 3.0_u);
        }
        Portal toCopy;
        const World world = withBarriers(
            plain, seed % 4, random.between(0, 2), {{6, 1, 0}, {6, 2, 0}, {6, 1, 1}, {6, 2, 1}},
            {{3, 1, 0}, {3, 2, 0}, {3, 1, 1}, {3, 2, 1}}, Face::west, Face::east, toCopy);
        const Walker walker(plain.copy(), 4.5, 2.0, 0.0, gridDegrees(random, 180.0) + 180.0);
        EXPECT_TRUE(walkBoth(plain, world, toCopy, walker.player, random, 1200, counts))
            << "seed " << seed << ", turn " << toCopy.turn;
    }
    for (const int turn : {0, 1, 2, 3}) EXPECT_GT(counts.turned[turn], kPortalSeeds / 8) << turn;
    EXPECT_GT(counts.straddling, counts.steps / 500);
    EXPECT_LT(counts.rejoined, counts.steps / 1000);
}

TEST(PortalIdentity, WideWellsToACopyChangeNoWay) {
    Counts counts;
    for (int seed = 1; seed <= kPortalSeeds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) * 67867967);
        World plain = emptyWorld(4, 4, 6);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                if (x >= 1 && x <= 2 && y >= 1 && y <= 2) continue;
                for (int level = 0; level < 4; ++level)
                    putBlock(plain, x, y, tileEdge(level), tileEdge(level + 1));
            }
        }
        Portal toCopy;
        const int level = 2;
        const World world = withBarriers(
            plain, seed % 4, random.between(0, 2),
            {{1, 1, level}, {2, 1, level}, {1, 2, level}, {2, 2, level}},
            {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {2, 2, 1}}, Face::top, Face::bottom, toCopy);
        const Walker walker(plain.copy(), 2.0, 2.0, 3.3, gridDegrees(random, 180.0) + 180.0);
        Player player = walker.player;
        if (random.oneIn(2)) setFlying(plain, player, true);
        EXPECT_TRUE(walkBoth(plain, world, toCopy, player, random, 1200, counts))
            << "seed " << seed << ", turn " << toCopy.turn;
    }
    for (const int turn : {0, 1, 2, 3}) EXPECT_GT(counts.turned[turn], kPortalSeeds / 20) << turn;
    EXPECT_GT(counts.straddling, counts.steps / 500);
    EXPECT_LT(counts.rejoined, counts.steps / 1000);
}

}  // namespace
}  // namespace slicecast
