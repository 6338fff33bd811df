// Blocks with slopes that move: what their cells hold of them, whom they carry and push, and where
// they may not go.
#include "moving.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace slicecast {
namespace {

constexpr int kRampPeriod = 4 * kSecond;

// 1.75 units along an axis in 2 seconds, and back.
Motion wayAlong(Axis axis) {
    return {.name = "way",
            .axis = axis,
            .from = {},
            .to = 1.75_u,
            .periodSteps = kRampPeriod,
            .shape = MotionShape::even};
}

BlueprintId addRamp(World& world, Face rise, Slant bottom, Slant top, Axis axis) {
    const BlueprintId id = addMoving(world, bottom.least(), top.most(), wayAlong(axis));
    world.blueprints[id].slopes = slopesTo(rise, bottom, top);
    return id;
}

struct Point {
    std::int64_t x;  // 1/65536 units
    std::int64_t y;
    std::int64_t z;
};

// Whether a block in a tile and a level that begin at (0, 0, 0) holds a point: exact.
bool holdsPoint(const CellBlueprint& block, const Point& at) {
    const std::int64_t along = block.slopes.alongX ? at.x : at.y;
    const auto height = [&](const Slant& slant) {
        return slant.from.raw * 65536ll +
               (slant.to.raw - slant.from.raw) * (along - slant.shift.raw);
    };
    return at.x >= block.plan.west.raw && at.x < block.plan.east.raw &&
           at.y >= block.plan.north.raw && at.y < block.plan.south.raw &&
           at.z >= block.bottom.raw && at.z < block.top.raw &&
           at.z * 65536 >= height(block.slopes.bottom) && at.z * 65536 < height(block.slopes.top);
}

// The parts in all cells together are the block, moved by the offset.
TEST(MovingSlope, PartsMakeUpTheMovedBlock) {
    Random random(1);
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        for (const Face rise : {Face::north, Face::east, Face::south, Face::west}) {
            World world = emptyWorld(5, 5, 4);
            const BlueprintId id = addRamp(world, rise, {0.1_u, 0.3_u}, {0.2_u, 0.9_u}, axis);
            world.blueprints[id].plan = {0.125_u, 0.0_u, 1.0_u, 0.75_u};
            const CellBlueprint whole = world.blueprints[id];
            world.maps[0].setCell(1, 1, 1, id);
            ASSERT_TRUE(makeMovers(world).empty());
            const Map& map = world.maps[0];
            for (int step = 0; step < kRampPeriod; step += 7) {
                const std::int64_t offset = world.movers[0].offset.raw;
                for (int i = 0; i < 400; ++i) {
                    const auto any = [&] { return std::int64_t{random.between(0, 4 * 65536 - 1)}; };
                    Point at = {any(), 0, 0};
                    at.y = any();
                    at.z = any();
                    const Point before = {at.x - 65536 - (axis == Axis::x ? offset : 0),
                                          at.y - 65536 - (axis == Axis::y ? offset : 0),
                                          at.z - 65536 - (axis == Axis::z ? offset : 0)};
                    const auto tile = [](std::int64_t raw) { return static_cast<int>(raw >> 16); };
                    const BlueprintId part = map.cell(tile(at.x), tile(at.y), tile(at.z));
                    const bool isIn = part != kEmptyCell &&
                                      holdsPoint(world.blueprints[part],
                                                 {at.x & 65535, at.y & 65535, at.z & 65535});
                    ASSERT_EQ(isIn, holdsPoint(whole, before)) << step << " " << i;
                }
                for (int k = 0; k < 7; ++k) stepWorld(world, {}, {});
            }
        }
    }
}

Player standingOn(const World& world, Coordinate x, Coordinate y, Coordinate z) {
    Player player;
    player.x = x;
    player.y = y;
    player.z = z;
    player.onGround = true;
    EXPECT_TRUE(isFree(world, travellerOf(player)));
    EXPECT_TRUE(isSupported(world, 0, bodyBox(player)));
    return player;
}

// A ramp of half a unit under a player at (2.5, 2.5).
World rampUnder(Axis axis, Face rise) {
    World world = emptyWorld(6, 6, 4);
    world.maps[0].setCell(2, 2, 0, addRamp(world, rise, {}, {0.0_u, 0.5_u}, axis));
    EXPECT_TRUE(makeMovers(world).empty());
    return world;
}

TEST(MovingSlope, CarriesWhoStandsOnIt) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        for (const Face rise : {Face::north, Face::east, Face::south, Face::west}) {
            World world = rampUnder(axis, rise);
            Player player;
            player.x = player.y = 2.5_u;
            const Box box = bodyBox(player);
            // At the height under the body's uphill edge
            const Coordinate half = {(box.east - box.west).raw / 2};
            const Coordinate height = {(65536 / 2 + half.raw + 1) / 2};
            player = standingOn(world, 2.5_u, 2.5_u, height);
            for (int step = 1; step <= kRampPeriod; ++step) {
                stepBoth(world, player);
                ASSERT_FALSE(reachesIntoSolid(world, 0, bodyBox(player))) << step;
                const Coordinate offset = world.movers[0].offset;
                ASSERT_EQ(player.x, 2.5_u + (axis == Axis::x ? offset : 0.0_u)) << step;
                ASSERT_EQ(player.y, 2.5_u + (axis == Axis::y ? offset : 0.0_u)) << step;
                ASSERT_EQ(player.z, height + (axis == Axis::z ? offset : 0.0_u)) << step;
            }
            EXPECT_EQ(world.movers[0].clock, 0);
        }
    }
}

// A ramp's thin edge and its high side push alike, and so does a board that hangs in the air.
TEST(MovingSlope, PushesWhoIsInItsWay) {
    for (const Axis axis : {Axis::x, Axis::y}) {
        const bool alongX = axis == Axis::x;
        for (const bool isBack : {false, true}) {
            const Face rise =
                alongX ? (isBack ? Face::west : Face::east) : (isBack ? Face::north : Face::south);
            for (const Coordinate lift : {0.0_u, 0.25_u}) {
                World world = emptyWorld(8, 8, 2);
                world.maps[0].setCell(
                    2, 2, 0, addRamp(world, rise, {lift, lift}, {lift, lift + 0.5_u}, axis));
                ASSERT_TRUE(makeMovers(world).empty());
                Player player;
                player.x = alongX ? 3.5_u : 2.5_u;
                player.y = alongX ? 2.5_u : 3.5_u;
                player.onGround = true;
                for (int step = 1; step <= kRampPeriod / 2; ++step) {
                    stepBoth(world, player);
                    ASSERT_FALSE(reachesIntoSolid(world, 0, bodyBox(player))) << step;
                }
                EXPECT_EQ(world.movers[0].offset, 1.75_u);
                const Box box = bodyBox(player);
                EXPECT_EQ(player.z, Coordinate{0});
                EXPECT_EQ(alongX ? box.west : box.north, 4.75_u);
            }
        }
    }
}

// Off the floor, a body meets a slope where it is as high as its feet.
TEST(MovingSlope, PushesFromWhereItIsAsHighAsTheFeet) {
    World world = emptyWorld(8, 8, 2);
    world.maps[0].setCell(2, 2, 0, addRamp(world, Face::west, {}, {0.0_u, 1.0_u}, Axis::x));
    ASSERT_TRUE(makeMovers(world).empty());
    Player player;
    player.flying = true;
    player.x = 3.5_u;
    player.y = 2.5_u;
    player.z = 0.25_u;
    for (int step = 1; step <= kRampPeriod / 2; ++step) {
        stepBoth(world, player);
        ASSERT_FALSE(reachesIntoSolid(world, 0, bodyBox(player))) << step;
    }
    EXPECT_EQ(bodyBox(player).west, 4.5_u);
}

TEST(MovingSlope, WaitsForWhoHasNoRoom) {
    World world = emptyWorld(8, 8, 2);
    world.maps[0].setCell(2, 2, 0, addRamp(world, Face::west, {}, {0.0_u, 1.0_u}, Axis::x));
    putBlock(world, 5, 2, {}, 1.0_u);
    ASSERT_TRUE(makeMovers(world).empty());
    Player player;
    player.x = 4.0_u;
    player.y = 2.5_u;
    player.onGround = true;
    for (int step = 1; step <= kRampPeriod / 2; ++step) {
        stepBoth(world, player);
        ASSERT_FALSE(reachesIntoSolid(world, 0, bodyBox(player))) << step;
    }
    EXPECT_LE(bodyBox(player).east, 5.0_u);
    EXPECT_LT(world.movers[0].offset, 1.75_u);
}

std::string onlyFault(const std::vector<PlacingFault>& faults) {
    return faults.size() == 1 ? faults[0].found + ", expected " + faults[0].expected
                              : std::to_string(faults.size()) + " faults";
}

TEST(MovingSlope, FaultsSayWhatIsInItsWay) {
    const auto worldWith = [](Axis axis, Face rise) {
        World world = emptyWorld(6, 6, 4);
        addRamp(world, rise, {}, {0.0_u, 0.5_u}, axis);
        world.maps[0].setCell(2, 2, 0, static_cast<BlueprintId>(world.blueprints.size() - 1));
        return world;
    };
    World world = worldWith(Axis::x, Face::east);
    world.maps[0].setCell(3, 2, 0, world.maps[0].cell(2, 2, 0));
    EXPECT_EQ(onlyFault(makeMovers(world)),
              "the moving block \"moving 0\" in a row along its \"rise\", expected a motion across "
              "the \"rise\", or one tile alone");
    world = worldWith(Axis::x, Face::north);
    world.maps[0].setCell(3, 2, 0, world.maps[0].cell(2, 2, 0));
    EXPECT_TRUE(makeMovers(world).empty());

    world = worldWith(Axis::z, Face::east);
    world.maps[0].setCell(2, 2, 1, world.maps[0].cell(2, 2, 0));
    EXPECT_EQ(
        onlyFault(makeMovers(world)),
        "the moving block \"moving 0\" stacked, with slopes between its parts, expected level "
        "moving blocks where they are stacked");

    for (const Coordinate height : {1.0_u, 2.25_u}) {
        world = worldWith(Axis::z, Face::east);
        world.maps[0].ceiling.height = height;
        world.maps[0].ceiling.tiles.assign(36, 0);
        EXPECT_EQ(onlyFault(makeMovers(world)),
                  height == 1.0_u
                      ? "the moving block \"moving 0\" with slopes that moves through the "
                        "ceiling of tile (2, 2), expected a motion above or below the ceiling, or "
                        "none there"
                      : "0 faults");
    }

    world = worldWith(Axis::x, Face::east);
    world.portals.push_back({.toX = 3, .toY = 2});
    putBlock(world, 5, 5, {}, 1.0_u);
    CellBlueprint& hatch = world.blueprints[world.maps[0].cell(5, 5, 0)];
    hatch.faces[static_cast<std::size_t>(Face::top)].portal = 0;
    EXPECT_EQ(onlyFault(makeMovers(world)),
              "the moving block \"moving 0\" with slopes that moves to tile (3, 2), where a "
              "portal in a roof or an underside leads, expected a motion elsewhere, or a level "
              "block");
}

}  // namespace
}  // namespace slicecast
