// Random players in random worlds full of portals: nobody is ever inside anything on either side of
// one, and nobody is ever stuck.
#include "portal_worlds.h"
#include "sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

namespace slicecast {
namespace {

constexpr int kPortalWorlds = kSanitized ? 60 : 500;

// Up to three maps; of many tiles and faces some lead to any place of any map.
World randomPortalWorld(std::uint64_t seed) {
    Random random(seed);
    World world = randomWorld(seed);
    const int maps = random.between(1, 3);
    for (int i = 1; i < maps; ++i) {
        const World other = randomWorld(seed * 31 + static_cast<std::uint64_t>(i));
        Map map = other.maps[0];
        const std::size_t first = world.blueprints.size() - 1;
        for (BlueprintId& id : map.cells) {
            if (id != kEmptyCell) id = static_cast<BlueprintId>(id + first);
        }
        world.blueprints.insert(world.blueprints.end(), other.blueprints.begin() + 1,
                                other.blueprints.end());
        world.maps.push_back(map);
    }
    const int tileDensity = random.between(2, 20);
    const int faceDensity = random.between(1, 12);
    const bool together = random.oneIn(2);  // many portals side by side lead on side by side
    for (int m = 0; m < maps; ++m) {
        const auto exit = [&](int x, int y) {
            if (together && !world.portals.empty() && world.portals.back().fromMap == m &&
                !random.oneIn(4)) {
                const Portal portal = portalAt(world.portals.back(), x, y);
                if (world.maps[static_cast<std::size_t>(portal.toMap)].contains(portal.toX,
                                                                                portal.toY))
                    return portal;
            }
            const int to = random.below(maps);
            const Map& map = world.maps[static_cast<std::size_t>(to)];
            return Portal{.fromMap = m,
                          .fromX = x,
                          .fromY = y,
                          .toMap = to,
                          .toX = random.below(map.width),
                          .toY = random.below(map.depth),
                          .turn = random.below(4),
                          .levels = random.oneIn(2) ? 0 : random.between(-2, 2)};
        };
        const Map& map = world.maps[static_cast<std::size_t>(m)];
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
    return world;
}

// A cube of 1/65536, by its lowest corner.
struct Cube {
    int x;
    int y;
    int z;
};

GridTile tileOf(const Cube& cube) {
    return {cube.x >> 16, cube.y >> 16};
}

Cube carriedCube(const Portal& portal, const Cube& cube) {
    // In halves, from the middle of the tile to the middle of the cube.
    int x = 2 * cube.x + 1 - (2 * portal.fromX + 1) * 65536;
    int y = 2 * cube.y + 1 - (2 * portal.fromY + 1) * 65536;
    turnArrow(portal.turn, x, y);
    return {((2 * portal.toX + 1) * 65536 + x - 1) / 2, ((2 * portal.toY + 1) * 65536 + y - 1) / 2,
            cube.z + portal.levels * 65536};
}

const CellBlueprint* blockAt(const World& world, int map, const Cube& cube) {
    const int level = cube.z >> 16;
    const GridTile tile = tileOf(cube);
    const BlueprintId id = world.maps[static_cast<std::size_t>(map)].cell(tile.x, tile.y, level);
    if (id == kEmptyCell) return nullptr;
    const CellBlueprint& block = world.blueprints[id];
    const int height = cube.z - level * 65536;
    const Box space = {{cube.x}, {cube.x + 1}, {cube.y}, {cube.y + 1}, {cube.z}, {cube.z + 1}};
    if (!isOverPart(block.plan, tile.x, tile.y, space)) return nullptr;
    if (block.slopes.any()) {
        const std::int64_t above = std::int64_t{height} << 16;
        const int at = (block.slopes.alongX ? cube.x : cube.y) & 0xffff;
        if (above < block.slopes.bottom.heightAt(at) || above >= block.slopes.top.heightAt(at))
            return nullptr;
    }
    return height >= block.bottom.raw && height < block.top.raw ? &block : nullptr;
}

bool isSolidIn(const World& world, int map, const Cube& cube) {
    const GridTile tile = tileOf(cube);
    if (!world.maps[static_cast<std::size_t>(map)].contains(tile.x, tile.y) || cube.z < 0)
        return true;
    return blockAt(world, map, cube) != nullptr;
}

// The portal through which an eye in one tile sees a cube of its own tile: that of the first block
// on the way up or down.
const Portal* portalAboveOrBelow(const World& world, const Traveller& body, int height) {
    const Map& map = world.maps[static_cast<std::size_t>(body.map)];
    const Cube eye = {body.eye.x.raw, body.eye.y.raw, body.eye.z.raw};
    const GridTile tile = tileOf(eye);
    const bool down = height < eye.z;
    for (int z = eye.z; down ? z >= height : z <= height;) {
        if (const CellBlueprint* block = blockAt(world, body.map, {eye.x, eye.y, z})) {
            const PortalId portal = block->face(down ? Face::top : Face::bottom).portal;
            return portal == kNoPortal ? nullptr : &world.portals[portal];
        }
        // On to the next edge of a cell or block.
        const int base = z >> 16 << 16;
        const BlueprintId id = map.cell(tile.x, tile.y, z >> 16);
        const int bottom = base + world.blueprints[id].bottom.raw;
        const int top = base + world.blueprints[id].top.raw;
        if (down) {
            z = id != kEmptyCell && z >= top ? top - 1 : base - 1;
        } else {
            z = id != kEmptyCell && z < bottom ? bottom : base + 65536;
        }
    }
    return nullptr;
}

// The portal of a side at a height, through which an eye sees at its own height; null if other
// blocks or portals lie between these heights.
const Portal* portalOfSide(const World& world, const Traveller& body, const Cube& cube, Face side) {
    const Portal* seen = nullptr;
    int z = body.eye.z.raw;
    for (;;) {
        const CellBlueprint* block = blockAt(world, body.map, {cube.x, cube.y, z});
        const PortalId portal = block == nullptr ? kNoPortal : block->face(side).portal;
        if (portal == kNoPortal ||
            (seen != nullptr && !leadOnTogether(*seen, world.portals[portal])))
            return nullptr;
        seen = &world.portals[portal];
        const int bottom = (z >> 16 << 16) + block->bottom.raw;
        const int top = (z >> 16 << 16) + block->top.raw;
        if (cube.z >= bottom && cube.z < top) return seen;
        z = cube.z < bottom ? bottom - 1 : top;
    }
}

// As traveller.h has it, for one cube of the body.
bool isSolidFor(const World& world, const Traveller& body, const Cube& cube) {
    const GridTile tile = tileOf(cube);
    const auto through = [&](const Portal& portal) {
        return isSolidIn(world, portal.toMap, carriedCube(portal, cube));
    };

    const Threshold& behind = body.behind;
    const bool isBehind = behind.isOn && (behind.side == Face::west    ? tile.x < behind.back.fromX
                                          : behind.side == Face::east  ? tile.x > behind.back.fromX
                                          : behind.side == Face::north ? tile.y < behind.back.fromY
                                          : behind.side == Face::south ? tile.y > behind.back.fromY
                                          : behind.side == Face::top   ? cube.z >= behind.height.raw
                                                                     : cube.z < behind.height.raw);
    if (isBehind) return through(behind.back);

    const Map& map = world.maps[static_cast<std::size_t>(body.map)];
    const Cube eye = {body.eye.x.raw, body.eye.y.raw, body.eye.z.raw};
    const GridTile eyeTile = tileOf(eye);
    const PortalId ofTile = map.tilePortal(tile.x, tile.y);
    if (tile == eyeTile) {
        const Portal* portal = portalAboveOrBelow(world, body, cube.z);
        return portal != nullptr ? through(*portal) : isSolidIn(world, body.map, cube);
    }
    if (ofTile != kNoPortal) return through(world.portals[ofTile]);

    // Through sides; around a corner only together with a side right in front of the eye
    const Face sideX = tile.x > eyeTile.x ? Face::west : Face::east;
    const Face sideY = tile.y > eyeTile.y ? Face::north : Face::south;
    const auto atEyeHeight = [&](GridTile at, Face side) {
        return portalOfSide(world, body, {at.x << 16, at.y << 16, eye.z}, side);
    };
    const Portal* beside = nullptr;
    bool isSideSeen = false;
    if (tile.x != eyeTile.x && tile.y != eyeTile.y) {
        for (const auto& [between, side] : {std::pair{GridTile{tile.x, eyeTile.y}, sideX},
                                            std::pair{GridTile{eyeTile.x, tile.y}, sideY}}) {
            const Portal* inFront = atEyeHeight(between, side);
            const Portal* own = atEyeHeight(tile, side);
            if (isSideSeen || inFront == nullptr || own == nullptr ||
                !leadOnTogether(*inFront, *own))
                continue;
            isSideSeen = true;
            beside = portalOfSide(world, body, cube, side);
        }
    } else {
        const Face side = tile.x != eyeTile.x ? sideX : sideY;
        isSideSeen = atEyeHeight(tile, side) != nullptr;
        beside = portalOfSide(world, body, cube, side);
    }
    if (beside != nullptr) return through(*beside);
    if (isSideSeen) return isSolidIn(world, body.map, cube);

    // Through tops and bottoms beside one that the eye is above or below
    if (const Portal* own = portalAboveOrBelow(world, body, cube.z)) {
        const bool down = cube.z < eye.z;
        // The plane of that top or bottom
        int plane = eye.z;
        while (blockAt(world, body.map, {eye.x, eye.y, plane}) == nullptr) {
            const int base = plane >> 16 << 16;
            const CellBlueprint& block =
                world.blueprints[map.cell(eyeTile.x, eyeTile.y, plane >> 16)];
            const bool isBlock = map.isOccupied(eyeTile.x, eyeTile.y, plane >> 16);
            if (down) {
                plane =
                    isBlock && plane >= base + block.top.raw ? base + block.top.raw - 1 : base - 1;
            } else {
                plane = isBlock && plane < base + block.bottom.raw ? base + block.bottom.raw
                                                                   : base + 65536;
            }
        }
        const CellBlueprint* other = blockAt(world, body.map, {cube.x, cube.y, plane});
        const PortalId portal =
            other == nullptr ? kNoPortal : other->face(down ? Face::top : Face::bottom).portal;
        const bool isEdge =
            other != nullptr && (down ? plane + 1 - (plane >> 16 << 16) == other->top.raw
                                      : plane - (plane >> 16 << 16) == other->bottom.raw);
        if (isEdge && portal != kNoPortal && leadOnTogether(*own, world.portals[portal]))
            return through(world.portals[portal]);
    }
    return isSolidIn(world, body.map, cube);
}

// Looks at cubes all over the body, at its corners and on both sides of every border.
bool isInsideSomething(const World& world, const Player& player, Random& random) {
    const Traveller body = travellerOf(player);
    const auto places = [](Coordinate low, Coordinate high) {
        const int border = tileEdge(Coordinate{high.raw - 1}.tile()).raw;
        return std::array<int, 4>{low.raw, high.raw - 1, std::max(low.raw, border),
                                  std::max(low.raw, border - 1)};
    };
    std::array<int, 8> heights = {
        body.box.bottom.raw, body.box.top.raw - 1,
        std::max(body.box.bottom.raw, tileEdge(body.box.top.tile()).raw - 1)};
    for (std::size_t i = 3; i < heights.size(); ++i)
        heights[i] = random.between(body.box.bottom.raw, body.box.top.raw - 1);
    for (const int x : places(body.box.west, body.box.east)) {
        for (const int y : places(body.box.north, body.box.south)) {
            for (const int z : heights) {
                if (z < body.box.top.raw && isSolidFor(world, body, {x, y, z})) return true;
            }
        }
    }
    // The eye itself, which sees its own map only.
    return isSolidIn(world, body.map, {body.eye.x.raw, body.eye.y.raw, body.eye.z.raw});
}

PlayerInput randomPortalInput(Random& random) {
    PlayerInput input;
    input.forward = random.oneIn(3) ? random.between(-1.0, 1.0) : 1.0;
    input.strafe = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.turn = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.fly = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.turnDegrees = random.oneIn(4) ? random.between(-90.0, 90.0) : 0.0;
    input.jump = random.oneIn(3);
    input.fast = random.oneIn(3);
    input.slow = random.oneIn(6);
    input.speed = random.oneIn(5) ? random.between(kLeastSpeed, kGreatestSpeed) : 1.0;
    return input;
}

// True if some portal brings the eye from the one place to within a step of the other.
bool isALeap(const World& world, const Player& before, const Player& after) {
    const Position from = {before.x, before.y, eyeHeight(before)};
    const Position to = {after.x, after.y, eyeHeight(after)};
    return std::any_of(world.portals.begin(), world.portals.end(), [&](const Portal& portal) {
        if (portal.fromMap != before.map || portal.toMap != after.map) return false;
        const Position there = carried(portal, from);
        const auto near = [](Coordinate a, Coordinate b) {
            return std::abs((a - b).value()) < 0.75;
        };
        return near(there.x, to.x) && near(there.y, to.y) && near(there.z, to.z);
    });
}

TEST(RandomPortals, NobodyIsEverInsideABlockOnEitherSide) {
    std::int64_t steps = 0;
    std::int64_t leaps = 0;
    std::int64_t straddling[kFaces] = {};
    for (int seed = 1; seed <= kPortalWorlds; ++seed) {
        const World world = randomPortalWorld(static_cast<std::uint64_t>(seed));
        Random random(static_cast<std::uint64_t>(seed) << 20);
        for (int i = 0; i < kPlayersPerWorld; ++i) {
            Player player;
            if (!placeRandomly(world, random, player) || !isFree(world, travellerOf(player)))
                continue;
            ASSERT_FALSE(isInsideSomething(world, player, random));
            PlayerInput input = randomPortalInput(random);
            for (int step = 0; step < kStepsPerPlayer; ++step) {
                if (random.oneIn(20)) input = randomPortalInput(random);
                if (random.oneIn(60)) setFlying(world, player, !player.flying);
                if (random.oneIn(200)) levelLook(world, player);
                const Player before = player;
                stepPlayer(world, player, input);
                ASSERT_TRUE(isFree(world, travellerOf(player)))
                    << "world " << seed << ", player " << i << ", step " << step;
                ASSERT_FALSE(isInsideSomething(world, player, random))
                    << "world " << seed << ", player " << i << ", step " << step;
                if (player.leaps == before.leaps + 1) {
                    ASSERT_TRUE(isALeap(world, before, player))
                        << "world " << seed << ", player " << i << ", step " << step;
                }
                ++steps;
                leaps += player.leaps - before.leaps;
                if (player.behind.isOn) ++straddling[static_cast<std::size_t>(player.behind.side)];
            }
        }
    }
    EXPECT_GT(steps, std::int64_t{kPortalWorlds} * kPlayersPerWorld * kStepsPerPlayer / 2);
    EXPECT_GT(leaps, steps / 1000);
    for (const std::int64_t side : straddling) EXPECT_GT(side, steps / 20'000);
}

TEST(RandomPortals, NobodyIsEverStuck) {
    int tried = 0;
    for (int seed = 1; seed <= kPortalWorlds / 5; ++seed) {
        const World world = randomPortalWorld(static_cast<std::uint64_t>(seed) + 1'000'000);
        Random random(static_cast<std::uint64_t>(seed) << 20);
        Player player;
        if (!placeRandomly(world, random, player) || !isFree(world, travellerOf(player))) continue;
        for (int leg = 0; leg < 20; ++leg) {
            const PlayerInput input = randomPortalInput(random);
            for (int step = 0; step < 40; ++step) stepPlayer(world, player, input);
            if (random.oneIn(3)) setFlying(world, player, !player.flying);
            bool moves = false;
            for (int heading = 0; heading < 360 && !moves; heading += 90) {
                Player probe = player;
                probe.velocityX = probe.velocityY = 0.0;
                setHeading(probe, heading);
                for (int step = 0; step < 20; ++step) stepPlayer(world, probe, kAhead);
                moves = probe.x != player.x || probe.y != player.y;
            }
            ASSERT_TRUE(moves) << "world " << seed << ", leg " << leg;
            ++tried;
        }
    }
    EXPECT_GT(tried, kPortalWorlds);
}

std::uint64_t hashAmongPortals() {
    std::uint64_t hash = 0;
    const auto add = [&hash](std::uint64_t number) {
        hash = (hash ^ number) * 0x100000001b3u + (hash >> 29);
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const World world = randomPortalWorld(seed);
        Random random(seed << 20);
        Player player;
        if (!placeRandomly(world, random, player)) continue;
        PlayerInput input;
        for (int step = 0; step < 600; ++step) {
            if (step % 15 == 0) input = randomPortalInput(random);
            if (step % 75 == 0) setFlying(world, player, !player.flying);
            stepPlayer(world, player, input);
        }
        for (const Coordinate coordinate : {player.x, player.y, player.z, player.eyeLag})
            add(static_cast<std::uint64_t>(coordinate.raw));
        for (const double number :
             {player.velocityX, player.velocityY, player.velocityZ, player.headingDegrees})
            add(std::bit_cast<std::uint64_t>(number));
        add(static_cast<std::uint64_t>(player.map));
        add(static_cast<std::uint64_t>(player.leaps));
    }
    return hash;
}

// The same from every compiler and at every level of optimisation. A change of the motion itself
// changes this number.
TEST(RandomPortals, TheSameInputsGiveTheSameStatesEverywhere) {
    EXPECT_EQ(hashAmongPortals(), hashAmongPortals());
    EXPECT_EQ(hashAmongPortals(), 0x3b7958b8d5e85416u);
}

}  // namespace
}  // namespace slicecast
