// The walk over the grid: known rays, step by step.
#include "render/spans/grid_walk.h"

#include "base/random.h"
#include "render/eye.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace slicecast {
namespace {

// The first tiles of a ray that runs (x, y) units each step of `along`: "tile at depth", and before
// it by which face it is entered.
std::string way(double eyeX, double eyeY, GroundDirection ray, int tiles) {
    constexpr std::array kSigns = {"north", "east", "south", "west"};
    GridWalk walk(toCoordinate(eyeX), toCoordinate(eyeY), ray);
    std::ostringstream text;
    for (int i = 0; i < tiles; ++i) {
        const Crossing enter = walk.enter();
        if (i > 0) text << ' ' << kSigns[static_cast<std::size_t>(enteredFace(enter))] << ' ';
        text << walk.tileX << ',' << walk.tileY << '@' << enter.along;
        walk.advance();
    }
    return text.str();
}

TEST(GridWalk, AlongTheAxes) {
    EXPECT_EQ(way(2.25, 3.5, {1.0, 0.0}, 4), "2,3@0 west 3,3@0.75 west 4,3@1.75 west 5,3@2.75");
    EXPECT_EQ(way(2.25, 3.5, {-2.0, 0.0}, 3), "2,3@0 east 1,3@0.125 east 0,3@0.625");
    EXPECT_EQ(way(2.25, 3.5, {0.0, 0.5}, 3), "2,3@0 north 2,4@1 north 2,5@3");
    EXPECT_EQ(way(2.25, 3.5, {0.0, -0.5}, 3), "2,3@0 south 2,2@1 south 2,1@3");
}

// Borders of constant x at 0.25, 0.75, 1.25 (speed 2), of constant y at 0.5, 1.5.
TEST(GridWalk, Aslant) {
    EXPECT_EQ(way(0.5, 0.5, {2.0, 1.0}, 6),
              "0,0@0 west 1,0@0.25 north 1,1@0.5 west 2,1@0.75 west 3,1@1.25 north 3,2@1.5");
    EXPECT_EQ(way(0.5, 0.5, {-2.0, -1.0}, 5),
              "0,0@0 east -1,0@0.25 south -1,-1@0.5 east -2,-1@0.75 east -3,-1@1.25");
}

// Through corners. The eye counts as a little further east, so a border that is crossed eastward is
// met first and one that is crossed westward last.
TEST(GridWalk, ThroughCorners) {
    EXPECT_EQ(way(0.5, 0.5, {1.0, 1.0}, 4), "0,0@0 west 1,0@0.5 north 1,1@0.5 west 2,1@1.5");
    EXPECT_EQ(way(0.5, 0.5, {1.0, -1.0}, 4), "0,0@0 west 1,0@0.5 south 1,-1@0.5 west 2,-1@1.5");
    EXPECT_EQ(way(0.5, 0.5, {-1.0, 1.0}, 4), "0,0@0 north 0,1@0.5 east -1,1@0.5 north -1,2@1.5");
    EXPECT_EQ(way(0.5, 0.5, {-1.0, -1.0}, 4),
              "0,0@0 south 0,-1@0.5 east -1,-1@0.5 south -1,-2@1.5");
}

// An eye on a border is in the eastern or southern tile; westward or northward it leaves that at
// once.
TEST(GridWalk, TheEyeOnABorder) {
    EXPECT_EQ(way(2.0, 3.5, {1.0, 0.0}, 2), "2,3@0 west 3,3@1");
    EXPECT_EQ(way(2.0, 3.5, {-1.0, 0.0}, 3), "2,3@0 east 1,3@0 east 0,3@1");
    EXPECT_EQ(way(2.5, 3.0, {0.0, 1.0}, 2), "2,3@0 north 2,4@1");
    EXPECT_EQ(way(2.5, 3.0, {0.0, -1.0}, 3), "2,3@0 south 2,2@0 south 2,1@1");
    EXPECT_EQ(way(2.0, 3.0, {-1.0, -1.0}, 4), "2,3@0 south 2,2@0 east 1,2@0 south 1,1@1");
    EXPECT_EQ(way(2.0, 3.0, {0.0, -1.0}, 2), "2,3@0 south 2,2@0") << "the border itself is east";
}

// Nothing is special about the outside of a grid, and tiles below zero are counted downwards.
TEST(GridWalk, FarOutside) {
    EXPECT_EQ(way(-1.25, -2.5, {1.0, 0.0}, 3), "-2,-3@0 west -1,-3@0.25 west 0,-3@1.25");
    EXPECT_EQ(way(-0.5, 100.5, {-0.25, 0.0}, 2), "-1,100@0 east -2,100@2");
}

TEST(GridWalk, TheEyesOwnTileIsNotEntered) {
    GridWalk walk(toCoordinate(0.5), toCoordinate(0.5), {1.0, 0.25});
    EXPECT_FALSE(walk.hasEntered());
    EXPECT_FALSE(walk.enter().border);
    EXPECT_EQ(walk.enter().along, 0.0);
    EXPECT_EQ(walk.enter().distance, 0.0);
    EXPECT_EQ(walk.enter().rowsPerRaw, kHugeRows);
    EXPECT_EQ(walk.nextAlongX(), 0.5);
    EXPECT_EQ(walk.nextAlongY(), 2.0);
    walk.advance();
    EXPECT_TRUE(walk.hasEntered());
    EXPECT_TRUE(walk.enter().border);
    const GridWalk straight(toCoordinate(0.5), toCoordinate(0.5), {1.0, 0.0});
    EXPECT_EQ(straight.nextAlongY(), std::numeric_limits<double>::infinity());
}

TEST(GridWalk, FacesOfACrossing) {
    const auto faces = [](bool alongX, bool nearing) {
        Crossing crossing;
        crossing.alongX = alongX;
        crossing.nearing = nearing;
        return std::array{enteredFace(crossing), leftFace(crossing)};
    };
    EXPECT_EQ(faces(true, true), (std::array{Face::west, Face::east}));
    EXPECT_EQ(faces(true, false), (std::array{Face::east, Face::west}));
    EXPECT_EQ(faces(false, true), (std::array{Face::north, Face::south}));
    EXPECT_EQ(faces(false, false), (std::array{Face::south, Face::north}));
}

void expectSame(const Crossing& a, const Crossing& b) {
    EXPECT_EQ(a.along, b.along);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.speed, b.speed);
    EXPECT_EQ(a.rowsPerRaw, b.rowsPerRaw);
    EXPECT_EQ(a.alongX, b.alongX);
    EXPECT_EQ(a.nearing, b.nearing);
    EXPECT_EQ(a.early, b.early);
    EXPECT_EQ(a.border, b.border);
}

// One of them in eight along an axis, and one in eight through corners.
GroundDirection anyRay(Random& random) {
    const double x = random.between(-200.0, 200.0);
    const double y = random.between(-200.0, 200.0);
    switch (random.below(16)) {
        case 0:
            return {x, 0.0};
        case 1:
            return {0.0, y};
        case 2:
            return {x, x};
        case 3:
            return {x, -x};
        default:
            return {x, y};
    }
}

// What a tile is left by is what the next one is entered by, and depths never decrease.
TEST(GridWalk, ATileBeginsWhereTheOneBeforeEnds) {
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const Coordinate x = {random.between(-1 << 20, 1 << 20)};
        const Coordinate y = random.oneIn(4) ? x : Coordinate{random.between(-1 << 20, 1 << 20)};
        GridWalk walk(x, y, anyRay(random));
        for (int tile = 0; tile < 30 && !HasFailure(); ++tile) {
            const Crossing leave = walk.leave();
            EXPECT_EQ(leave.along, walk.left());
            EXPECT_EQ(leave.along, std::min(walk.nextAlongX(), walk.nextAlongY()));
            EXPECT_GE(leave.along, walk.entered);
            EXPECT_EQ(leave.along, leave.distance / leave.speed);
            const int x0 = walk.tileX;
            const int y0 = walk.tileY;
            walk.advance();
            expectSame(walk.enter(), leave);
            EXPECT_EQ(walk.tileX - x0, leave.alongX ? walk.stepX : 0);
            EXPECT_EQ(walk.tileY - y0, leave.alongX ? 0 : walk.stepY);
            EXPECT_EQ(leave.nearing, (leave.alongX ? walk.stepX : walk.stepY) > 0);
            EXPECT_EQ(leave.early, leave.nearing);
        }
    }
}

// A walk that continues turned behind a portal passes the tiles of the old walk, turned about the
// tile where it continues. Its depths and its ties are the same.
TEST(GridWalk, TurnedItHasTheSameDepths) {
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const Coordinate x = {random.between(-1 << 20, 1 << 20)};
        const Coordinate y = random.oneIn(4) ? x : Coordinate{random.between(-1 << 20, 1 << 20)};
        GridWalk walk(x, y, anyRay(random));
        for (int before = random.below(4); before > 0; --before) walk.advance();
        const int turns = random.below(4);
        const int fromX = walk.tileX;
        const int fromY = walk.tileY;
        GridWalk turned = walk.turned(turns, 7, -4);
        EXPECT_EQ(turned.hasEntered(), walk.hasEntered());
        for (int tile = 0; tile < 20 && !HasFailure(); ++tile) {
            int east = walk.tileX - fromX;
            int south = walk.tileY - fromY;
            for (int turn = 0; turn < turns; ++turn) {
                const int oldEast = east;
                east = -south;
                south = oldEast;
            }
            EXPECT_EQ(turned.tileX, 7 + east);
            EXPECT_EQ(turned.tileY, -4 + south);
            EXPECT_EQ(turned.entered, walk.entered);
            const Crossing a = walk.leave();
            const Crossing b = turned.leave();
            EXPECT_EQ(b.along, a.along);
            EXPECT_EQ(b.distance, a.distance);
            EXPECT_EQ(b.early, a.early) << "the rule for ties is that of the eye's map";
            EXPECT_EQ(b.alongX, a.alongX == (turns % 2 == 0));
            walk.advance();
            turned.advance();
        }
    }
}

// A quarter turn clockwise makes an eastward ray a southward one, that enters by northern faces.
TEST(GridWalk, AQuarterTurn) {
    GridWalk walk(toCoordinate(0.5), toCoordinate(0.5), {1.0, 0.0});
    walk.advance();
    GridWalk turned = walk.turned(1, 5, 5);
    EXPECT_EQ(enteredFace(turned.enter()), Face::north);
    EXPECT_EQ(turned.enter().along, 0.5);
    turned.advance();
    EXPECT_EQ(turned.tileX, 5);
    EXPECT_EQ(turned.tileY, 6);
    EXPECT_EQ(turned.entered, 1.5);
}

// The quick way to a row and the exact quotient agree, for edges right on rows' middles too.
// From any tile of its way to any later one at once: as if it had walked there.
TEST(GridWalk, ComesToATileOfItsWay) {
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const GroundDirection ray = {random.between(-2.0, 2.0), random.between(-2.0, 2.0)};
        GridWalk walk(Coordinate{random.below(1 << 20)}, Coordinate{random.below(1 << 20)}, ray);
        GridWalk leaps = walk;
        for (int leap = 0; leap < 4; ++leap) {
            for (int tile = random.between(1, 9); tile > 0; --tile) walk.advance();
            leaps.comeTo(walk.tileX, walk.tileY, walk.enter().alongX);
            ASSERT_EQ(leaps.tileX, walk.tileX);
            ASSERT_EQ(leaps.tileY, walk.tileY);
            ASSERT_EQ(leaps.entered, walk.entered);
            ASSERT_EQ(leaps.enter().alongX, walk.enter().alongX);
            ASSERT_EQ(leaps.enter().distance, walk.enter().distance);
            ASSERT_EQ(leaps.nextAlongX(), walk.nextAlongX());
            ASSERT_EQ(leaps.nextAlongY(), walk.nextAlongY());
        }
    }
}

// At depth 0 a height above the eye is above all rows, one below it below them, and its own height
// is the horizon.
TEST(FirstRowBelow, AtTheEye) {
    const Eye eye = {.x = {}, .y = {}, .z = tileEdge(1)};
    const Projection projection(eye, {.fovDegrees = 90.0}, 100, 60);
    const GridWalk walk(toCoordinate(0.5), toCoordinate(0.5), projection.ray(50));
    EXPECT_EQ(firstRowBelow(projection, 1, walk.enter()), 0);
    EXPECT_EQ(firstRowBelow(projection, -1, walk.enter()), 60);
    EXPECT_EQ(firstRowBelow(projection, 0, walk.enter()), projection.firstFallingRow);
}

}  // namespace
}  // namespace slicecast
