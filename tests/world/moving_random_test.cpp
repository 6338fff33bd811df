// Random players in random worlds whose blocks move and whose gates open and close: whoever was
// free stays free, and it all happens the same way twice.
#include "moving.h"
#include "portal_worlds.h"
#include "sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicecast {
namespace {

constexpr int kMovingWorlds = kSanitized ? 200 : 2000;
constexpr int kPlayersPerMovingWorld = 2;
constexpr int kStepsAmongMovers = 600;

Motion randomMotion(Random& random, Coordinate bottom, Coordinate top, int level, int levels) {
    Motion motion;
    motion.edges = static_cast<MovingEdges>(random.below(3));
    motion.shape = static_cast<MotionShape>(random.below(3));
    const double low = level + bottom.value();
    const double high = level + top.value();
    // Somewhat less than all the room that there is, and now and then through nothing
    const double least = motion.edges == MovingEdges::high ? -1.2 * (high - low) : -low;
    const double most = motion.edges == MovingEdges::low ? 1.2 * (high - low) : levels - high;
    motion.from = toCoordinate(random.between(0.0, 1.0) * least);
    motion.to = toCoordinate(random.between(0.0, 1.0) * most);
    if (random.oneIn(2)) std::swap(motion.from, motion.to);
    const double distance = std::abs((motion.to - motion.from).value());
    const double speed = random.oneIn(4) ? kFastestMotion : random.between(0.3, kFastestMotion);
    const double period =
        std::max(kShortestPeriod, fastestSpeed(motion.shape, distance, 1.0) / speed);
    motion.periodSteps = static_cast<int>(period * kSecond) + 1;
    motion.phaseSteps = random.below(motion.periodSteps);
    return motion;
}

GateKind randomKind(Random& random) {
    GateKind kind;
    kind.steps = random.between(1, 60);
    kind.reach = toCoordinate(random.between(0.5, 4.0));
    kind.opensOnApproach = random.oneIn(2);
    kind.approach = toCoordinate(random.between(0.1, 2.0));
    kind.holdSteps = random.between(1, 60);
    kind.startsOpen = random.oneIn(3);
    return kind;
}

// Many tiles and faces, of moving blocks too, lead to other places of the map.
void putPortals(World& world, Random& random) {
    const Map& map = world.maps[0];
    const int tileDensity = random.between(2, 20);
    const int faceDensity = random.between(1, 12);
    const auto exit = [&](int x, int y) {
        Portal portal;
        portal.fromX = x;
        portal.fromY = y;
        portal.toX = random.below(map.width);
        portal.toY = random.below(map.depth);
        portal.turn = random.below(4);
        portal.levels = random.oneIn(2) ? 0 : random.between(-2, 2);
        return portal;
    };
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            if (random.oneIn(tileDensity)) putTilePortal(world, exit(x, y));
            for (int level = 0; level < map.levels; ++level) {
                if (!map.isOccupied(x, y, level)) continue;
                for (int face = 0; face < kFaces; ++face) {
                    if (random.oneIn(faceDensity))
                        putFacePortal(world, exit(x, y), level, static_cast<Face>(face));
                }
            }
        }
    }
}

// Lets a thing at these cells of one level move along x or y instead, where it has room; clears its
// way. Its motion becomes a gate's now and then.
void turnSideways(World& world, Random& random, BlueprintId id, const Box& cells, int level) {
    Map& map = world.maps[0];
    CellBlueprint& block = world.blueprints[id];
    Motion& motion = world.motions[static_cast<std::size_t>(block.motion)];
    motion.axis = random.oneIn(2) ? Axis::x : Axis::y;
    const bool alongX = motion.axis == Axis::x;
    const Coordinate low = alongX ? cells.west : cells.north;
    const Coordinate high = alongX ? cells.east : cells.south;
    const Coordinate end = tileEdge(alongX ? map.width : map.depth);
    const double least = -std::min(3.0, low.value());
    const double most = std::min(3.0, (end - high).value());
    motion.edges = random.oneIn(3) ? static_cast<MovingEdges>(random.below(2)) : MovingEdges::both;
    motion.from = toCoordinate(random.between(0.0, 1.0) * least);
    motion.to = toCoordinate(random.between(0.0, 1.0) * most);
    if (random.oneIn(2)) std::swap(motion.from, motion.to);
    const double distance = std::abs((motion.to - motion.from).value());
    const double speed = random.between(0.3, kFastestMotion);
    motion.periodSteps =
        static_cast<int>(fastestSpeed(motion.shape, distance, 1.0) / speed * kSecond) + 2;
    motion.phaseSteps = random.below(motion.periodSteps);
    if (random.oneIn(3)) {
        GateKind kind = randomKind(random);
        kind.steps = motion.periodSteps;
        kind.everySteps = random.oneIn(3) ? random.between(1, 400) : 0;
        kind.once = random.oneIn(6);
        block.gate = static_cast<int>(world.gateKinds.size());
        world.gateKinds.push_back(kind);
    }
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const bool isAside = alongX ? y < cells.north.tile() || y >= cells.south.tile()
                                        : x < cells.west.tile() || x >= cells.east.tile();
            if (!isAside && world.blueprints[map.cell(x, y, level)].motion < 0)
                map.setCell(x, y, level, kEmptyCell);
        }
    }
}

// Slopes within the block's heights, for a block that moves as a whole. `isRow` if it stands in
// more than one tile along its motion: then the slopes rise across.
void slant(World& world, Random& random, BlueprintId id, bool isRow) {
    CellBlueprint& block = world.blueprints[id];
    const Motion& motion = world.motions[static_cast<std::size_t>(block.motion)];
    if (motion.edges != MovingEdges::both) return;
    const Coordinate low = block.bottom;
    const Coordinate high = block.top;
    const Coordinate drop = {random.between(1, (high - low).raw)};
    Slant bottom = {low, low};
    Slant top = {high, high};
    const int kind = random.below(3);  // a roof, a vault, or a board
    if (kind != 1) top.from = high - drop;
    if (kind == 1) bottom.to = low + drop;
    if (kind == 2) bottom.to = low + drop - Coordinate{1};
    const bool alongX = random.oneIn(2);
    const bool isBack = random.oneIn(2);
    const bool turns = isRow && alongX == (motion.axis == Axis::x);
    block.slopes = slopesTo(
        alongX != turns ? (isBack ? Face::west : Face::east) : (isBack ? Face::north : Face::south),
        bottom, top);
}

// A random world with columns of its own for movers and gates.
World randomMovingWorld(std::uint64_t seed, bool hasPortals = false, bool hasSlopes = false) {
    World world = randomWorld(seed);
    Random random(seed + 77);
    Map& map = world.maps[0];
    const int things = random.between(1, 6);
    for (int thing = 0; thing < things; ++thing) {
        const int level = random.below(map.levels);
        const int stacked = random.oneIn(3) && level + 1 < map.levels ? 2 : 1;
        const Coordinate bottom =
            stacked == 1 && random.oneIn(2) ? Coordinate{random.below(60000)} : Coordinate{0};
        const Coordinate top = stacked == 1 && random.oneIn(2)
                                   ? Coordinate{random.between(bottom.raw + 1000, 65536)}
                                   : tileEdge(1);
        const bool isGate = random.oneIn(3);
        BlueprintId id = kEmptyCell;
        if (isGate) {
            id = addGate(world, randomKind(random));
            world.blueprints[id].bottom = bottom;
            world.blueprints[id].top = top;
        } else {
            id = addMoving(
                world, bottom, top,
                randomMotion(random, bottom, stacked == 2 ? tileEdge(2) : top, level, map.levels));
        }
        const int x0 = random.below(map.width);
        const int y0 = random.below(map.depth);
        Random sideways(seed * 8 + static_cast<std::uint64_t>(thing));
        Random slopes(seed * 8 + static_cast<std::uint64_t>(thing) + 0x736c6f70u);
        const bool isSlanted = hasSlopes && !isGate && stacked == 1 && !slopes.oneIn(3);
        if (!isGate && stacked == 1 && sideways.oneIn(2)) {
            const Box cells = {
                tileEdge(x0), tileEdge(std::min(map.width, x0 + sideways.between(1, 3))),
                tileEdge(y0), tileEdge(std::min(map.depth, y0 + sideways.between(1, 2))),
                {},           {}};
            turnSideways(world, sideways, id, cells, level);
            const bool alongX =
                world.motions[static_cast<std::size_t>(world.blueprints[id].motion)].axis ==
                Axis::x;
            const Coordinate length = alongX ? cells.east - cells.west : cells.south - cells.north;
            if (isSlanted) slant(world, slopes, id, length > tileEdge(1));
            for (int y = y0; y < cells.south.tile(); ++y) {
                for (int x = x0; x < cells.east.tile(); ++x) map.setCell(x, y, level, id);
            }
            continue;
        }
        if (isSlanted) slant(world, slopes, id, false);
        for (int y = y0; y < std::min(map.depth, y0 + random.between(1, 3)); ++y) {
            for (int x = x0; x < std::min(map.width, x0 + random.between(1, 3)); ++x) {
                for (int other = 0; other < map.levels; ++other) {
                    if (!isGate) map.setCell(x, y, other, kEmptyCell);
                }
                for (int part = 0; part < stacked; ++part) map.setCell(x, y, level + part, id);
            }
        }
    }
    if (hasPortals) putPortals(world, random);
    // What a later thing has cut or built into leaves no room here and there.
    if (!makeMovers(world).empty()) return randomMovingWorld(seed + 0x10000, hasPortals, hasSlopes);
    EXPECT_TRUE(makeGates(world).empty());
    markPortals(world);
    return world;
}

// Whether the player stands on a slope of a moving block, or slides down it.
bool isOnMovingSlope(const World& world, const Player& player) {
    const Map& map = world.maps[0];
    const Box box = bodyBox(player);
    const Box below = {box.west,  box.east, box.north, box.south, box.bottom - Coordinate{1},
                       box.bottom};
    for (int y = below.north.tile(); y <= below.south.tile(); ++y) {
        for (int x = below.west.tile(); x <= below.east.tile(); ++x) {
            const int level = below.bottom.tile();
            const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
            if (block.mover >= 0 && !block.slopes.top.isLevel() &&
                below.bottom < tileEdge(level) + block.top && isOverPart(block.plan, x, y, below) &&
                reachesBetweenSlopes(below, block, x, y, level))
                return true;
        }
    }
    return false;
}

PlayerInput randomMoverInput(Random& random) {
    PlayerInput input;
    input.forward = random.between(-1.0, 1.0);
    input.strafe = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.turn = random.between(-1.0, 1.0);
    input.fly = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.jump = random.oneIn(4);
    input.fast = random.oneIn(3);
    if (random.oneIn(3)) input.forward = input.strafe = 0.0;
    return input;
}

bool isInside(const World& world, const Player& player) {
    const Coordinate eye = eyeHeight(player);
    return reachesIntoSolid(world, 0, bodyBox(player)) ||
           reachesIntoSolid(world, 0, {player.x, player.x, player.y, player.y, eye, eye});
}

TEST(RandomMovingWorlds, NobodyIsEverInsideABlock) {
    std::int64_t steps = 0;
    std::int64_t lifted = 0;
    std::int64_t lowered = 0;
    std::int64_t rodeThere = 0;
    std::int64_t shifted = 0;
    std::int64_t rodeSideways = 0;
    std::int64_t waits = 0;
    std::int64_t gatesMoved = 0;
    std::int64_t inOpenGate = 0;
    std::int64_t gatesHeld = 0;
    std::int64_t onSlopes = 0;
    std::int64_t rodeOnSlopes = 0;
    for (int seed = 1; seed <= kMovingWorlds; ++seed) {
        World world = randomMovingWorld(static_cast<std::uint64_t>(seed), false, seed % 2 == 0);
        Random random(static_cast<std::uint64_t>(seed) << 20);
        for (int i = 0; i < kPlayersPerMovingWorld; ++i) {
            Player player;
            if (!placeRandomly(world, random, player) || isInside(world, player)) continue;
            PlayerInput input = randomMoverInput(random);
            for (int step = 0; step < kStepsAmongMovers; ++step) {
                if (random.oneIn(40)) input = randomMoverInput(random);
                if (random.oneIn(200)) setFlying(world, player, !player.flying);
                GateAsk ask = asks(player, GateAsk::Wish::nothing);
                if (random.oneIn(20)) ask.wish = static_cast<GateAsk::Wish>(random.below(4));
                std::vector<int> clocks;
                for (const Mover& mover : world.movers) clocks.push_back(mover.clock);
                for (const Gate& gate : world.gates) clocks.push_back(gate.progress);

                Body body = {.map = 0, .box = bodyBox(player), .rides = player.onGround};
                stepWorld(world, {&body, 1}, ask);
                shift(player, body);
                ASSERT_EQ(bodyBox(player), body.box);
                ASSERT_FALSE(reachesIntoSomething(world, bodyBox(player)) &&
                             !isFree(world, 0, bodyBox(player)))
                    << "world " << seed << ", player " << i << ", step " << step << " of the world";
                ASSERT_FALSE(reachesIntoSolid(world, 0, bodyBox(player)))
                    << "world " << seed << ", player " << i << ", step " << step << " of the world";
                const bool rode = body.shift.z != Coordinate{0};
                rodeThere += rode && player.onGround && isSupported(world, 0, bodyBox(player));
                stepPlayer(world, player, input);
                ASSERT_FALSE(isInside(world, player))
                    << "world " << seed << ", player " << i << ", step " << step;

                ++steps;
                lifted += body.shift.z > Coordinate{0};
                lowered += body.shift.z < Coordinate{0};
                const bool isShifted = (body.shift.x.raw | body.shift.y.raw) != 0;
                shifted += isShifted;
                rodeSideways += isShifted && player.onGround;
                const bool isOnSlope = isOnMovingSlope(world, player);
                onSlopes += isOnSlope;
                rodeOnSlopes += isOnSlope && (isShifted || body.shift.z != Coordinate{0});
                std::size_t k = 0;
                for (const Mover& mover : world.movers) waits += mover.clock == clocks[k++];
                for (const Gate& gate : world.gates) {
                    const int whole = world.gateKinds[static_cast<std::size_t>(gate.kind)].steps;
                    gatesMoved += gate.progress != clocks[k];
                    gatesHeld +=
                        gate.progress == clocks[k] && gate.progress == whole && !gate.wantsOpen;
                    ++k;
                }
                inOpenGate += reachesIntoSomething(world, bodyBox(player));
            }
        }
    }
    // All of it came up.
    EXPECT_GT(steps,
              std::int64_t{kMovingWorlds} * kPlayersPerMovingWorld * kStepsAmongMovers * 8 / 10);
    for (const std::int64_t kind : {lifted, lowered, rodeThere, waits, gatesMoved, inOpenGate})
        EXPECT_GT(kind, steps / 400);
    for (const std::int64_t kind : {shifted, rodeSideways}) EXPECT_GT(kind, steps / 1000);
    EXPECT_GT(gatesHeld, steps / 4000);
    EXPECT_GT(onSlopes, steps / 1000);
    EXPECT_GT(rodeOnSlopes, steps / 2000);
}

// What reaches through a portal, or has not left it behind, is spared on both sides.
TEST(RandomMovingWorlds, NobodyIsEverInsideABlockAmongPortals) {
    std::int64_t steps = 0;
    std::int64_t lifted = 0;
    std::int64_t waits = 0;
    std::int64_t leaps = 0;
    std::int64_t straddling = 0;
    for (int seed = 1; seed <= kMovingWorlds / 2; ++seed) {
        World world =
            randomMovingWorld(static_cast<std::uint64_t>(seed) + 500'000, true, seed % 2 == 0);
        Random random(static_cast<std::uint64_t>(seed) << 20);
        for (int i = 0; i < kPlayersPerMovingWorld; ++i) {
            Player player;
            if (!placeRandomly(world, random, player) || !isFree(world, travellerOf(player)))
                continue;
            PlayerInput input = randomMoverInput(random);
            for (int step = 0; step < kStepsAmongMovers; ++step) {
                if (random.oneIn(40)) input = randomMoverInput(random);
                if (random.oneIn(200)) setFlying(world, player, !player.flying);
                GateAsk ask = asks(player, GateAsk::Wish::nothing);
                if (random.oneIn(20)) ask.wish = static_cast<GateAsk::Wish>(random.below(4));
                int moving = 0;
                for (const Mover& mover : world.movers) moving -= mover.clock;
                Body body = bodyOf(travellerOf(player), player.onGround);
                stepWorld(world, {&body, 1}, ask);
                shift(player, body);
                ASSERT_TRUE(isFree(world, travellerOf(player)))
                    << "world " << seed << ", player " << i << ", step " << step << " of the world";
                for (const Mover& mover : world.movers) moving += mover.clock;
                const int leapsBefore = player.leaps;
                stepPlayer(world, player, input);
                ASSERT_TRUE(isFree(world, travellerOf(player)))
                    << "world " << seed << ", player " << i << ", step " << step;
                ++steps;
                lifted += body.shift.z != Coordinate{0};
                waits += moving == 0 && !world.movers.empty();
                leaps += player.leaps - leapsBefore;
                straddling += body.straddles;
            }
        }
    }
    EXPECT_GT(steps, std::int64_t{kMovingWorlds} * kPlayersPerMovingWorld * kStepsAmongMovers / 5);
    EXPECT_GT(straddling, steps / 20);
    for (const std::int64_t kind : {lifted, waits, leaps}) EXPECT_GT(kind, steps / 1000);
}

std::uint64_t hashAmongMovers() {
    std::uint64_t hash = 0;
    const auto add = [&hash](std::int64_t number) {
        hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x100000001b3u + (hash >> 29);
    };
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        World world = randomMovingWorld(seed);
        Random random(seed << 20);
        Player player;
        if (!placeRandomly(world, random, player)) continue;
        PlayerInput input;
        for (int step = 0; step < 400; ++step) {
            if (step % 15 == 0) input = randomMoverInput(random);
            stepBoth(world, player, input,
                     asks(player, step % 50 == 0 ? GateAsk::Wish::change : GateAsk::Wish::nothing));
        }
        for (const Coordinate coordinate : {player.x, player.y, player.z}) add(coordinate.raw);
        for (const CellBlueprint& block : world.blueprints) {
            add(block.bottom.raw);
            add(block.top.raw);
            add(block.passable);
        }
    }
    return hash;
}

TEST(RandomMovingWorlds, GoTheSameWayEverywhere) {
    EXPECT_EQ(hashAmongMovers(), hashAmongMovers());
    EXPECT_EQ(hashAmongMovers(), 0xa1c53c9ec73b5d6fu);
}

}  // namespace
}  // namespace slicecast
