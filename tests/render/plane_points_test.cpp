// Which points of a plane rows see: held inside tiles, and on borders behind turned portals.
#include "render/spans/plane_points.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr std::uint32_t kTileEnd = ~std::uint32_t{0};    // of a tile
constexpr double kTinyFraction = 1.0 / 1099511627776.0;  // far less than a fraction keeps

// The viewpoint is (2.5, 2.5), the plane half a unit below it. With a ray of (128, 64) a row of
// 1 / |horizon - (row + 0.5)| = i sees the point (2.5 + 64 i, 2.5 + 32 i).
class PointsOfPlanes : public testing::Test {
protected:
    static constexpr GroundDirection kRay = {128.0, 64.0};

    PointsOfPlanes()
        : projection_({.x = {}, .y = {}, .z = tileEdge(1)}, {.fovDegrees = 90.0}, 200, 200) {
        vista_.viewpoint = {.map = 0, .turn = 0, .x = 163840, .y = 163840, .z = 65536};
        vista_.projection = &projection_;
    }

    PlanePoints points(const TileRange& tiles, GroundDirection ray = kRay,
                       bool southReversed = false) const {
        return {vista_, ray, 0.5, southReversed, tiles};
    }
    PlanePoints pointsTurned(int turn, const TileRange& tiles, GroundDirection ray = kRay) {
        vista_.viewpoint.turn = turn;
        return points(tiles, ray);
    }

    // The number of the row that sees a point so far east of the viewpoint.
    static double atEast(double units, GroundDirection ray = kRay) { return units / (ray.x / 2); }

private:
    Projection projection_;
    Vista vista_;
};

TEST_F(PointsOfPlanes, KnownPoints) {
    const PlanePoints floor = points({2, 2, 12, 8});
    EXPECT_FALSE(floor.line.southReversed);
    // 1.5625 east and 0.78125 south of (2.5, 2.5) is (4.0625, 3.28125).
    const PlanePoints::Point point = floor.at(atEast(1.5625));
    EXPECT_EQ(point.east, 0x10000000u);
    EXPECT_EQ(point.south, 0x48000000u);
    EXPECT_TRUE(floor.isInside(atEast(1.5625)));
}

TEST_F(PointsOfPlanes, ACeilingIsAsFarAsAFloor) {
    const PlanePoints ceiling = points({2, 2, 12, 8}, kRay, true);
    EXPECT_TRUE(ceiling.line.southReversed);
    EXPECT_EQ(ceiling.at(atEast(1.5625)).south, 0x48000000u);
}

// Tiles 4 and 5: 1.5 to 3.5 east of the viewpoint.
TEST_F(PointsOfPlanes, ClampedToTheTiles) {
    const PlanePoints two = points({4, 2, 5, 9});
    EXPECT_EQ(two.at(atEast(1.5)).east, 0u);
    EXPECT_TRUE(two.isInside(atEast(1.5)));
    EXPECT_EQ(two.at(atEast(1.5 - kTinyFraction)).east, 0u);
    EXPECT_FALSE(two.isInside(atEast(1.5 - kTinyFraction)));
    EXPECT_EQ(two.at(atEast(1.0)).east, 0u) << "however far away";
    EXPECT_EQ(two.at(atEast(2.5)).east, 0u) << "the border of the two";
    EXPECT_TRUE(two.isInside(atEast(2.5)));
    EXPECT_EQ(two.at(atEast(3.5 - 1.0 / 4294967296.0)).east, kTileEnd);
    EXPECT_TRUE(two.isInside(atEast(3.5 - 1.0 / 4294967296.0)));
    EXPECT_EQ(two.at(atEast(3.5 - kTinyFraction)).east, kTileEnd)
        << "it would round up to the next tile";
    EXPECT_FALSE(two.isInside(atEast(3.5 - kTinyFraction)));
    EXPECT_EQ(two.at(atEast(3.5)).east, kTileEnd);
    EXPECT_FALSE(two.isInside(atEast(3.5)));
    EXPECT_EQ(two.at(atEast(7.0)).east, kTileEnd);
}

// South of the viewpoint by half as much: tile 3 is 0.5 to 1.5 south, 1 to 3 east.
TEST_F(PointsOfPlanes, ClampedBetweenNorthAndSouth) {
    const PlanePoints one = points({2, 3, 12, 3});
    EXPECT_EQ(one.at(atEast(1.0 - kTinyFraction)).south, 0u);
    EXPECT_FALSE(one.isInside(atEast(1.0 - kTinyFraction)));
    EXPECT_TRUE(one.isInside(atEast(1.0)));
    EXPECT_EQ(one.at(atEast(3.0)).south, kTileEnd);
    EXPECT_FALSE(one.isInside(atEast(3.0)));
}

// Tiles are told from the nearest on, whichever way the ray goes.
TEST_F(PointsOfPlanes, WestwardAndNorthward) {
    constexpr GroundDirection kBack = {-128.0, -64.0};
    const PlanePoints tiles = points({1, 2, 0, 1}, kBack);
    EXPECT_TRUE(tiles.isInside(1.0 / 64)) << "(1.5, 2)";
    EXPECT_TRUE(tiles.isInside(2.0 / 64)) << "(0.5, 1.5)";
    EXPECT_TRUE(tiles.isInside(2.5 / 64)) << "(0, 1.25) belongs to tile 0";
    EXPECT_FALSE(tiles.isInside(0.5 / 64)) << "(2, 2.25) does not belong to tile 1";
    EXPECT_EQ(tiles.at(0.5 / 64).east, kTileEnd);
    EXPECT_EQ(tiles.at(3.0 / 64).east, 0u);
}

TEST_F(PointsOfPlanes, EndlessTilesEndOnTheNearSideOnly) {
    const PlanePoints east = points({4, 2, 4, 2, true});
    EXPECT_EQ(east.at(atEast(1.25)).east, 0u);
    EXPECT_TRUE(east.isInside(atEast(1000.75)));
    EXPECT_EQ(east.at(atEast(1000.75)).east, 0x40000000u);
    const PlanePoints west = points({1, 2, 1, 2, true}, {-128.0, 0.0});
    EXPECT_EQ(west.at(0.25 / 64).east, kTileEnd);
    EXPECT_EQ(west.at(1000.25 / 64).east, 0x40000000u);
    EXPECT_EQ(west.at(1000.25 / 64).south, 0x80000000u);
    EXPECT_TRUE(west.isInside(1000.25 / 64));
}

// The eye counts as a trifle further east and a smaller one south. Turned clockwise once that is
// south and west, twice west and north, thrice north and east. A point on a border goes with it.
TEST_F(PointsOfPlanes, BordersBehindTurnedPortals) {
    struct Case {
        int turn;
        std::uint32_t east;   // of a point on a border of constant x
        std::uint32_t south;  // of a point on a border of constant y
    };
    for (const Case& c :
         {Case{0, 0, 0}, Case{1, kTileEnd, 0}, Case{2, kTileEnd, kTileEnd}, Case{3, 0, kTileEnd}}) {
        const PlanePoints all = pointsTurned(c.turn, {0, 0, 20, 20});
        // (4, 3.25), and (3.5, 3).
        const double onX = atEast(1.5);
        const double onY = atEast(1.0);
        EXPECT_EQ(all.at(onX).east, c.east) << c.turn;
        EXPECT_EQ(all.at(onX).south, 0x40000000u) << c.turn;
        EXPECT_EQ(all.at(onY).south, c.south) << c.turn;
        EXPECT_EQ(all.at(onY).east, 0x80000000u) << c.turn;
        const double rows[] = {atEast(1.3), onX, atEast(1.1), onY, atEast(1.2)};
        EXPECT_EQ(all.anyOnBorder(rows, 0, 3), c.east == kTileEnd) << c.turn;
        EXPECT_EQ(all.anyOnBorder(rows, 2, 5), c.south == kTileEnd) << c.turn;
        EXPECT_EQ(all.anyOnBorder(rows, 1, 2), c.east == kTileEnd) << c.turn;
        EXPECT_FALSE(all.anyOnBorder(rows, 2, 3)) << c.turn;
        EXPECT_FALSE(all.anyOnBorder(rows, 3, 3)) << c.turn;
    }
}

// Where the tiles begin a point is held, whichever tile a border within them would go to.
TEST_F(PointsOfPlanes, ClampedAtTheNearEdgeBehindTurnedPortals) {
    const PlanePoints two = pointsTurned(1, {4, 2, 5, 9});
    EXPECT_EQ(two.at(atEast(1.5 - kTinyFraction)).east, 0u);
    EXPECT_EQ(two.at(atEast(1.5 + kTinyFraction)).east, 0u);
    EXPECT_EQ(two.at(atEast(2.5)).east, kTileEnd) << "the border of the two";
}

// A fraction worked out without any trick, of a position held inside [first, end).
std::uint32_t heldFraction(double position, int first, int end) {
    const double held = std::clamp(position, static_cast<double>(first), end - 1.0 / 4294967296.0);
    return static_cast<std::uint32_t>(
        std::min(4294967295.0, std::floor((held - std::floor(held)) * 4294967296.0 + 0.5)));
}

TEST_F(PointsOfPlanes, AnyPoints) {
    Random random(1);
    for (int i = 0; i < 20000 && !HasFailure(); ++i) {
        const GroundDirection ray = {random.between(-300.0, 300.0), random.between(-300.0, 300.0)};
        const int x = random.between(-5, 8);
        const int y = random.between(-5, 8);
        const TileRange tiles = {x, y, x + random.between(-2, 2), y + random.between(-2, 2)};
        const PlanePoints some = points(tiles, ray);
        const double inverse = random.between(0.001, 0.05);
        const double east = 2.5 + ray.x / 2 * inverse;
        const double south = 2.5 + ray.y / 2 * inverse;
        const PlanePoints::Point point = some.at(inverse);
        const auto near = [](std::uint32_t a, std::uint32_t b) {
            return std::max(a, b) - std::min(a, b) <= 1;
        };
        EXPECT_TRUE(near(point.east, heldFraction(east, std::min(tiles.fromX, tiles.toX),
                                                  std::max(tiles.fromX, tiles.toX) + 1)));
        EXPECT_TRUE(near(point.south, heldFraction(south, std::min(tiles.fromY, tiles.toY),
                                                   std::max(tiles.fromY, tiles.toY) + 1)));
        const bool inside = east >= std::min(tiles.fromX, tiles.toX) &&
                            east < std::max(tiles.fromX, tiles.toX) + 1 &&
                            south >= std::min(tiles.fromY, tiles.toY) &&
                            south < std::max(tiles.fromY, tiles.toY) + 1;
        EXPECT_EQ(some.isInside(inverse), inside);
    }
}

}  // namespace
}  // namespace slicecast
