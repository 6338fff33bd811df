#include "overlay/marks.h"

#include "canvas.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr Colour kYellow = {255, 220, 0, 255};
constexpr int kMarksWidth = 320;
constexpr int kMarksHeight = 200;

World makeWalledYard() {
    WorldBuilder make;
    make.texture("grey", {128, 128, 128, 255});
    make.block('#', {.name = "wall"});
    make.map("yard", 2, R"(
........
........
....#...
........
........
)");
    return std::move(make.world);
}

// Looks east from the west, over the middle of the wall or not.
Eye eyeToEast(double y, double z) {
    Eye eye;
    eye.x = toCoordinate(0.5);
    eye.y = toCoordinate(y);
    eye.z = toCoordinate(z);
    return eye;
}

// Of the columns, or of the rows of an upright line.
struct SeenLine {
    int first = -1;
    int last = -1;
    int touched = 0;

    int gaps() const { return last - first + 1 - touched; }
};

bool isYellow(Pixel pixel) {
    const Colour colour = toColour(pixel);
    return colour.r > 80 && colour.g > 70 && colour.b < 30;
}

SeenLine linesIn(const Canvas& canvas, bool isUpright) {
    SeenLine seen;
    const int length = isUpright ? kMarksHeight : kMarksWidth;
    const int width = isUpright ? kMarksWidth : kMarksHeight;
    for (int along = 0; along < length; ++along) {
        bool isTouched = false;
        for (int across = 0; across < width; ++across) {
            isTouched |= isYellow(isUpright ? canvas.at(across, along) : canvas.at(along, across));
        }
        if (!isTouched) continue;
        if (seen.first < 0) seen.first = along;
        seen.last = along;
        ++seen.touched;
    }
    return seen;
}

SeenLine linesOf(const Eye& eye, const std::vector<Mark>& marks, bool isUpright = false) {
    const World world = makeWalledYard();
    Canvas canvas(kMarksWidth, kMarksHeight);
    drawMarks(world, eye, {.fovDegrees = 90.0}, marks, canvas.picture);
    EXPECT_TRUE(canvas.borderUntouched());
    return linesIn(canvas, isUpright);
}

// With 90 degrees, a unit at the depth of 1 is half of the width.
TEST(Marks, StandWhereTheWorldStands) {
    const Mark across = {0, {4.5, 0.5, 0.5}, {4.5, 1.5, 0.5}, kYellow};
    const SeenLine seen = linesOf(eyeToEast(1.5, 0.5), {across});
    EXPECT_EQ(seen.first, 120) << "a unit to the left at a depth of four";
    EXPECT_EQ(seen.last, 160);
    EXPECT_EQ(seen.gaps(), 0);
    EXPECT_EQ(linesOf(eyeToEast(1.5, 0.5), {}).first, -1);
}

TEST(Marks, AreDashedWhereABlockHidesThem) {
    const Mark along = {0, {7.0, 1.0, 0.5}, {7.0, 4.0, 0.5}, kYellow};
    const SeenLine free = linesOf(eyeToEast(2.5, 2.4), {along});
    const SeenLine hidden = linesOf(eyeToEast(2.5, 0.5), {along});
    EXPECT_EQ(free.gaps(), 0);
    EXPECT_GT(hidden.gaps(), 8);
    EXPECT_EQ(hidden.first, free.first) << "beside the wall";
}

// The four upright edges of the wall: those at its west are seen, those at its east are not.
TEST(Marks, ABlockHidesItsOwnFarEdges) {
    const auto edge = [](double x, double y) { return Mark{0, {x, y, 0.0}, {x, y, 1.0}, kYellow}; };
    for (const double y : {2.0, 3.0}) {
        EXPECT_EQ(linesOf(eyeToEast(2.5, 0.5), {edge(4.0, y)}, true).gaps(), 0) << y;
        EXPECT_GT(linesOf(eyeToEast(2.5, 0.5), {edge(4.0, y)}, true).touched, 40) << y;
        EXPECT_GT(linesOf(eyeToEast(2.5, 0.5), {edge(5.0, y)}, true).gaps(), 10) << y;
        EXPECT_GT(linesOf(eyeToEast(2.5, 1.9), {edge(5.0, y)}, true).gaps(), 6) << "below its top";
    }
}

TEST(Marks, EndWhereTheyLeaveThePicture) {
    const Eye eye = eyeToEast(1.5, 0.5);
    const Mark past = {0, {-3.0, 1.0, 0.5}, {7.0, 1.0, 0.5}, kYellow};
    const SeenLine seen = linesOf(eye, {past});
    EXPECT_EQ(seen.first, 0);
    EXPECT_GT(seen.last, 140);
    EXPECT_LT(seen.last, 160);
    EXPECT_EQ(linesOf(eye, {{0, {-3.0, 1.0, 0.5}, {0.0, 1.0, 0.5}, kYellow}}).first, -1)
        << "behind";
    EXPECT_EQ(linesOf(eye, {{0, {3.0, 0.0, 9.5}, {3.0, 3.0, 9.5}, kYellow}}).first, -1) << "above";
    EXPECT_EQ(linesOf(eye, {{1, {4.5, 0.5, 0.5}, {4.5, 1.5, 0.5}, kYellow}}).first, -1)
        << "elsewhere";
    for (const double most : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(linesOf(eye, {{0, {-most, -most, 0.5}, {most, most, most}, kYellow}}).first, -1)
            << most;
    }
    const double far = 32000.0;
    EXPECT_GE(linesOf(eye, {{0, {-far, 1.0, 0.5}, {far, 1.0, 0.5}, kYellow}}).touched, 150);
}

TEST(Marks, OnlySoManyAreDrawn) {
    const Mark across = {0, {4.5, 0.5, 0.5}, {4.5, 1.5, 0.5}, kYellow};
    std::vector<Mark> marks(kMostMarks, {1, {}, {}, kYellow});
    marks.push_back(across);
    EXPECT_EQ(linesOf(eyeToEast(1.5, 0.5), marks).first, -1);
    marks.erase(marks.begin());
    EXPECT_GE(linesOf(eyeToEast(1.5, 0.5), marks).touched, 38);
}

}  // namespace
}  // namespace slicecast
