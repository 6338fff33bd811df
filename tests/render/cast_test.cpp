#include "render/ask/cast.h"

#include "base/angle.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A row of blocks to the east of (1.5, 1.5): a step, glass, a beam above a wall, a wall.
World yard() {
    WorldBuilder make;
    make.block('#', {.name = "wall"});
    make.block('-', {.name = "step", .top = 0.25});
    make.block('o', {.name = "glass"}).seeThrough = true;
    make.block('=', {.name = "beam", .bottom = 0.5});
    make.map("yard", 2, R"(
..........
...-o.#.#.
..........
..........
..........
..........
..........
..........
)");
    make.put('=', 6, 1, 1);
    return std::move(make.world);
}

CastFrom from(double x, double y, double heading) {
    return {
        .map = 0, .x = toCoordinate(x), .y = toCoordinate(y), .z = {}, .headingDegrees = heading};
}

CastFrom at(CastFrom from, double z) {
    from.z = toCoordinate(z);
    return from;
}

TEST(Cast, WithoutAHeightListsAllBlocksUpToTheEdge) {
    const CastRay ray = cast(yard(), from(1.5, 1.5, 0.0));
    std::vector<int> tiles;
    for (const CastTile& tile : ray.tiles) {
        tiles.push_back(tile.x);
        EXPECT_EQ(tile.y, 1);
        EXPECT_EQ(tile.portals, 0);
        EXPECT_EQ(tile.entered, tile.x > 1);
        EXPECT_DOUBLE_EQ(tile.distance, tile.x == 1 ? 0.0 : tile.x - 1.5);
        EXPECT_DOUBLE_EQ(tile.nextX, tile.x - 0.5);
        EXPECT_TRUE(std::isinf(tile.nextY)) << "it runs along x";
    }
    EXPECT_EQ(tiles, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
    std::vector<std::pair<int, int>> hits;
    for (const CastHit& hit : ray.hits) {
        hits.emplace_back(hit.tileX, hit.level);
        EXPECT_EQ(hit.face, Face::west);
        EXPECT_DOUBLE_EQ(hit.distance, hit.tileX - 1.5);
        EXPECT_DOUBLE_EQ(hit.backDistance, hit.tileX - 0.5);
        EXPECT_DOUBLE_EQ(hit.x, hit.tileX);
        EXPECT_DOUBLE_EQ(hit.y, 1.5);
    }
    EXPECT_EQ(hits, (std::vector<std::pair<int, int>>{{3, 0}, {4, 0}, {6, 0}, {6, 1}, {8, 0}}));
    EXPECT_EQ(ray.hits[3].bottom, toCoordinate(1.5));
    EXPECT_EQ(ray.end, CastRay::End::edge);
    EXPECT_DOUBLE_EQ(ray.distance, 8.5);
    EXPECT_DOUBLE_EQ(ray.x, 10.0);
}

TEST(Cast, AtAHeightMeetsItsBlocksAndEndsAtAnOpaqueOne) {
    const World world = yard();
    const CastRay low = cast(world, at(from(1.5, 1.5, 0.0), 0.1));
    ASSERT_EQ(low.hits.size(), 1u);
    EXPECT_EQ(low.hits[0].blueprint, 2);
    EXPECT_EQ(low.end, CastRay::End::block);
    EXPECT_DOUBLE_EQ(low.distance, 1.5);

    // [bottom, top): over the step at its very top, through the glass, to the wall.
    const CastRay over = cast(world, at(from(1.5, 1.5, 0.0), 0.25));
    ASSERT_EQ(over.hits.size(), 2u);
    EXPECT_EQ(over.hits[0].blueprint, 3);
    EXPECT_EQ(over.hits[1].tileX, 6);
    EXPECT_DOUBLE_EQ(over.distance, 4.5);

    const CastRay between = cast(world, at(from(1.5, 1.5, 0.0), 1.25));
    EXPECT_TRUE(between.hits.empty());
    EXPECT_EQ(between.end, CastRay::End::edge);
    EXPECT_EQ(cast(world, at(from(1.5, 1.5, 0.0), 1.5)).hits.at(0).level, 1);
}

// A board across the tile (4, 1), and a post in the middle of the tile (6, 1).
TEST(Cast, MeetsWhatFillsAPartOfATileWhereItStands) {
    WorldBuilder make;
    make.block('|').plan = {toCoordinate(0.25), {}, toCoordinate(0.5), tileEdge(1)};
    make.block('i').plan = {toCoordinate(0.25), toCoordinate(0.25), toCoordinate(0.75),
                            toCoordinate(0.75)};
    make.map("yard", 1, R"(
.........
....|.i..
.........
)");
    const World world = std::move(make.world);
    const CastRay all = cast(world, from(1.5, 1.5, 0.0));
    ASSERT_EQ(all.hits.size(), 2u);
    EXPECT_EQ(all.hits[0].distance, 2.75);
    EXPECT_EQ(all.hits[0].backDistance, 3.0);
    EXPECT_EQ(all.hits[1].distance, 4.75);
    EXPECT_EQ(all.hits[1].x, 6.25);
    const CastRay low = cast(world, at(from(1.5, 1.5, 0.0), 0.5));
    EXPECT_EQ(low.end, CastRay::End::block);
    EXPECT_EQ(low.distance, 2.75);
    EXPECT_EQ(low.x, 4.25);
    const CastRay beside = cast(world, at(from(5.5, 1.125, 0.0), 0.5));
    EXPECT_TRUE(beside.hits.empty());
    EXPECT_EQ(beside.end, CastRay::End::edge);
    // In its tile, before it and behind it
    EXPECT_EQ(cast(world, at(from(4.125, 1.5, 0.0), 0.5)).hits.at(0).distance, 0.125);
    EXPECT_TRUE(cast(world, at(from(4.125, 1.5, 0.0), 0.5)).hits.at(0).entered);
    EXPECT_EQ(cast(world, at(from(4.75, 1.5, 180.0), 0.5)).hits.at(0).face, Face::east);
    EXPECT_TRUE(cast(world, at(from(4.75, 1.5, 90.0), 0.5)).hits.empty());
    // On its edges the eye counts as a trifle further east
    const CastRay onEastEdge = cast(world, at(from(4.5, 1.5, 180.0), 0.5));
    EXPECT_TRUE(onEastEdge.hits.at(0).entered);
    EXPECT_EQ(onEastEdge.hits[0].distance, 0.0);
    EXPECT_EQ(onEastEdge.hits[0].backDistance, 0.25);
    EXPECT_FALSE(cast(world, at(from(4.25, 1.5, 0.0), 0.5)).hits.at(0).entered);
    EXPECT_EQ(cast(world, at(from(4.5, 1.5, 0.0), 0.5)).hits.at(0).x, 6.25) << "the post";
}

TEST(Cast, MeetsTheCutOfAHalf) {
    for (const bool isNorthern : {true, false}) {
        WorldBuilder make;
        make.block('a').plan.half = isNorthern ? Half::northEast : Half::southWest;
        make.map("yard", 1, R"(
.......
...a...
.......
)");
        const World world = std::move(make.world);
        const CastRay east = cast(world, at(from(1.5, 1.25, 0.0), 0.5));
        ASSERT_EQ(east.hits.size(), 1u);
        EXPECT_EQ(east.hits[0].distance, isNorthern ? 1.75 : 1.5);
        EXPECT_EQ(east.hits[0].backDistance, isNorthern ? 2.5 : 1.75);
        EXPECT_EQ(east.hits[0].face, isNorthern ? Face::south : Face::west);
        EXPECT_EQ(east.distance, east.hits[0].distance);
        const CastRay west = cast(world, at(from(5.5, 1.25, 180.0), 0.5));
        EXPECT_EQ(west.hits.at(0).distance, isNorthern ? 1.5 : 2.25);
        EXPECT_EQ(west.hits.at(0).face, isNorthern ? Face::east : Face::north);
        // From within the tile, on either side of the cut and on it: there it is the eastern half
        EXPECT_EQ(cast(world, from(3.5, 1.25, 0.0)).hits.size(), isNorthern ? 1u : 0u);
        EXPECT_EQ(cast(world, from(3.25, 1.5, 90.0)).hits.size(), isNorthern ? 0u : 1u);
        EXPECT_EQ(cast(world, from(3.5, 1.5, 45.0)).hits.size(), isNorthern ? 1u : 0u);
        // Through the corners, along the cut
        EXPECT_EQ(cast(world, from(2.5, 0.5, 45.0)).hits.size(), isNorthern ? 1u : 0u);
    }
}

// A ray exactly along an edge, eastward and southward, behind portals of all turns: the eye counts
// as a trifle further east and south in its own map, however the map behind the portal lies.
TEST(Cast, AnEdgeAlongTheRayIsOnTheSideThatTheEyesMapSays) {
    constexpr Coordinate kHalf = {32768};
    constexpr Plan kNorthern = {{}, {}, tileEdge(1), kHalf};
    constexpr Plan kSouthern = {{}, kHalf, tileEdge(1), tileEdge(1)};
    constexpr Plan kWestern = {{}, {}, kHalf, tileEdge(1)};
    constexpr Plan kEastern = {kHalf, {}, tileEdge(1), tileEdge(1)};
    for (int turn = 0; turn < 4; ++turn) {
        const auto meets = [turn](const Plan& plan, int quarters) {
            WorldBuilder make;
            make.block('#').plan = turned(plan, turn);
            make.map("yard", 9, 9, 1);
            const int toX[] = {5, 4, 3, 4};
            const int toY[] = {4, 5, 4, 3};
            const std::size_t way = static_cast<std::size_t>(quarters + turn) % 4;
            make.put('#', toX[way], toY[way]);
            make.tilePortal({.fromMap = 0,
                             .fromX = quarters == 0 ? 2 : 1,
                             .fromY = quarters == 0 ? 1 : 2,
                             .toMap = 0,
                             .toX = 4,
                             .toY = 4,
                             .turn = turn});
            return !cast(make.world, at(from(1.5, 1.5, 90.0 * quarters), 0.5)).hits.empty();
        };
        EXPECT_FALSE(meets(kNorthern, 0)) << turn;
        EXPECT_TRUE(meets(kSouthern, 0)) << turn;
        EXPECT_FALSE(meets(kWestern, 1)) << turn;
        EXPECT_TRUE(meets(kEastern, 1)) << turn;
    }
}

TEST(Cast, BordersFollowFromTheDirection) {
    const World world = yard();
    for (const double heading : {17.0, 71.0, 133.0, 200.0, 299.0, 350.0}) {
        const CastRay ray = cast(world, from(4.3, 5.1, heading));
        const double dx = cosDegrees(heading);
        const double dy = sinDegrees(heading);
        EXPECT_DOUBLE_EQ(ray.direction.x, dx);
        const double x = toCoordinate(4.3).value();
        const double y = toCoordinate(5.1).value();
        for (std::size_t i = 0; i < ray.tiles.size(); ++i) {
            const CastTile& tile = ray.tiles[i];
            const double borderX = dx > 0 ? tile.x + 1 : tile.x;
            const double borderY = dy > 0 ? tile.y + 1 : tile.y;
            EXPECT_NEAR(tile.nextX, (borderX - x) / dx, 1e-12);
            EXPECT_NEAR(tile.nextY, (borderY - y) / dy, 1e-12);
            const double left = std::min(tile.nextX, tile.nextY);
            EXPECT_EQ(left, i + 1 < ray.tiles.size() ? ray.tiles[i + 1].distance : ray.distance);
        }
        EXPECT_GT(ray.tiles.size(), 2u);
        EXPECT_NEAR(ray.x, x + dx * ray.distance, 1e-12);
    }
}

TEST(Cast, BeginsOutsideAndInsideOfBlocks) {
    const World world = yard();
    const CastRay into = cast(world, from(-2.5, 1.5, 0.0));
    EXPECT_EQ(into.tiles.front().x, 0);
    EXPECT_TRUE(into.tiles.front().entered);
    EXPECT_DOUBLE_EQ(into.tiles.front().distance, 2.5);
    const CastRay away = cast(world, from(-2.5, 1.5, 180.0));
    EXPECT_TRUE(away.tiles.empty());
    EXPECT_EQ(away.end, CastRay::End::edge);
    const CastRay inside = cast(world, at(from(6.5, 1.5, 0.0), 0.25));
    ASSERT_EQ(inside.hits.size(), 2u);
    EXPECT_FALSE(inside.hits[0].entered);
    EXPECT_EQ(inside.hits[1].tileX, 8);
    EXPECT_DOUBLE_EQ(inside.distance, 1.5);
}

// A portal tile at (5, 1) that leads to (2, 7), turned by 90 degrees and a level up: what goes east
// goes on south. The way is blocked there by nothing: the map ends.
TEST(Cast, ContinuesBehindPortals) {
    World world = yard();
    world.maps.push_back(makeMap("cellar", 5, 9, 3, 0));
    world.maps[1].setCell(2, 5, 1, 1);
    world.portals.push_back({.fromMap = 0,
                             .fromX = 5,
                             .fromY = 1,
                             .toMap = 1,
                             .toX = 2,
                             .toY = 3,
                             .turn = 1,
                             .levels = 1});
    world.maps[0].tilePortals.assign(world.maps[0].occupied.size(), kNoPortal);
    world.maps[0].tilePortals[world.maps[0].tileIndex(5, 1)] = 0;
    const CastRay ray = cast(world, at(from(1.5, 1.25, 0.0), 0.5));
    ASSERT_EQ(ray.portals.size(), 1u);
    EXPECT_DOUBLE_EQ(ray.portals[0].distance, 3.5);
    ASSERT_EQ(ray.hits.size(), 2u);
    EXPECT_EQ(ray.hits[1].map, 1);
    EXPECT_EQ(ray.hits[1].portals, 1);
    EXPECT_EQ(ray.hits[1].face, Face::north);
    EXPECT_DOUBLE_EQ(ray.hits[1].distance, 5.5);
    EXPECT_NEAR(ray.hits[1].x, 2.75, 1e-12) << "a quarter north of the middle comes out east of it";
    EXPECT_NEAR(ray.hits[1].y, 5.0, 1e-12);
    EXPECT_EQ(ray.end, CastRay::End::block);
    EXPECT_EQ(ray.map, 1);

    world.portalLimit = 0;
    const CastRay ended = cast(world, at(from(1.5, 1.25, 0.0), 0.5));
    EXPECT_EQ(ended.end, CastRay::End::portal);
    EXPECT_DOUBLE_EQ(ended.distance, 3.5);
}

TEST(Cast, PortalFacesLeadOnAtTheirHeightOnly) {
    World world = yard();
    world.portals.push_back({.fromMap = 0,
                             .fromX = 6,
                             .fromY = 1,
                             .toMap = 0,
                             .toX = 2,
                             .toY = 5,
                             .turn = 0,
                             .levels = -1});
    world.blueprints.push_back(world.blueprints[4]);
    world.blueprints.back().faces[static_cast<std::size_t>(Face::west)].portal = 0;
    world.blueprints.back().hasPortals = true;
    world.maps[0].setCell(6, 1, 1, 5);
    const CastRay ray = cast(world, at(from(1.5, 1.5, 0.0), 1.75));
    ASSERT_EQ(ray.portals.size(), 1u);
    EXPECT_EQ(ray.end, CastRay::End::edge);
    EXPECT_EQ(ray.tiles.back().y, 5);
    EXPECT_DOUBLE_EQ(ray.distance, 4.5 + 8.0);
    EXPECT_TRUE(cast(world, at(from(1.5, 1.5, 0.0), 0.25)).portals.empty());
    EXPECT_TRUE(cast(world, from(1.5, 1.5, 0.0)).portals.empty());

    world.portals[0].levels = -2;
    EXPECT_EQ(cast(world, at(from(1.5, 1.5, 0.0), 1.75)).end, CastRay::End::floor);
}

// At its height a ray meets a slope where it has that height.
TEST(Cast, MeetsSlopesAtTheirHeight) {
    WorldBuilder make;
    make.block('/').slopes = slopesTo(Face::east, {}, {{}, tileEdge(1)});
    make.block('v').slopes = slopesTo(Face::east, {{}, tileEdge(1)}, {tileEdge(1), tileEdge(1)});
    make.map("yard", 1, R"(
.........
....v././
.........
)");
    const World world = std::move(make.world);
    const CastRay east = cast(world, at(from(5.5, 1.5, 0.0), 0.25));
    EXPECT_EQ(east.end, CastRay::End::block);
    EXPECT_EQ(east.x, 6.25);
    EXPECT_EQ(east.hits.at(0).face, Face::top);
    EXPECT_TRUE(east.hits.at(0).entered);
    const CastRay west = cast(world, at(from(7.5, 1.5, 180.0), 0.25));
    EXPECT_EQ(west.x, 7.0);
    EXPECT_EQ(west.hits.at(0).face, Face::east);
    EXPECT_EQ(west.hits.at(0).backDistance, 1.25);
    const CastRay vault = cast(world, at(from(5.5, 1.5, 180.0), 0.25));
    EXPECT_EQ(vault.x, 4.25);
    EXPECT_EQ(vault.hits.at(0).face, Face::bottom);
    EXPECT_TRUE(cast(world, at(from(5.5, 1.5, 90.0), 0.25)).hits.empty());
    // Without a height the whole tile counts
    EXPECT_EQ(cast(world, from(5.5, 1.5, 0.0)).hits.at(0).distance, 0.5);
}

}  // namespace
}  // namespace slicecast
