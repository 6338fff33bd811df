#include "overlay/slow_drawing.h"

#include "canvas.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicecast {
namespace {

constexpr int kSlowWidth = 10;
constexpr int kSlowHeight = 4;

// Shows a picture of one grey; gives the grey of each column after it: 0 where nothing has been
// drawn yet.
std::vector<int> shown(SlowDrawing& slow, std::uint8_t grey, int slices) {
    Canvas canvas(kSlowWidth, kSlowHeight);
    for (int y = 0; y < kSlowHeight; ++y) {
        for (int x = 0; x < kSlowWidth; ++x)
            canvas.picture.row(y)[x] = toPixel({grey, grey, grey, 255});
    }
    slow.show(canvas.picture, slices);
    EXPECT_TRUE(canvas.borderUntouched());
    std::vector<int> columns;
    for (int x = 0; x < kSlowWidth; ++x) {
        const Colour colour = toColour(canvas.at(x, kSlowHeight - 1));
        columns.push_back(x == slow.next() ? -1 : colour == kNotYetDrawn ? 0 : colour.r);
    }
    return columns;
}

TEST(SlowDrawing, BuildsThePictureUpSliceBySliceAgainAndAgain) {
    SlowDrawing slow;
    EXPECT_EQ(shown(slow, 100, 3), (std::vector<int>{100, 100, 100, -1, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(shown(slow, 120, 5),
              (std::vector<int>{120, 120, 120, 120, 120, 120, 120, 120, -1, 0}));
    EXPECT_EQ(shown(slow, 140, 4),
              (std::vector<int>{140, 140, -1, 140, 140, 140, 140, 140, 140, 140}))
        << "over the picture that was complete";
    EXPECT_EQ(shown(slow, 160, 0),
              (std::vector<int>{160, 160, -1, 140, 140, 140, 140, 140, 140, 140}));
    EXPECT_EQ(shown(slow, 180, 200),
              (std::vector<int>{180, 180, -1, 180, 180, 180, 180, 180, 180, 180}));
}

// What drawColumns makes of a grey picture: the grey of each column, -1 for the line, 0 if not yet
// drawn.
std::vector<int> drawnColumns(int count) {
    Canvas canvas(kSlowWidth, kSlowHeight);
    for (int y = 0; y < kSlowHeight; ++y) {
        for (int x = 0; x < kSlowWidth; ++x) canvas.picture.row(y)[x] = toPixel({90, 90, 90, 255});
    }
    drawColumns(canvas.picture, count);
    EXPECT_TRUE(canvas.borderUntouched());
    std::vector<int> columns;
    for (int x = 0; x < kSlowWidth; ++x) {
        const Colour colour = toColour(canvas.at(x, kSlowHeight - 1));
        columns.push_back(colour == kNotYetDrawn ? 0 : colour.r == colour.g ? colour.r : -1);
    }
    return columns;
}

TEST(DrawColumns, KeepsTheFirstOnes) {
    EXPECT_EQ(drawnColumns(0), (std::vector<int>{-1, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(drawnColumns(4), (std::vector<int>{90, 90, 90, 90, -1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(drawnColumns(9), (std::vector<int>{90, 90, 90, 90, 90, 90, 90, 90, 90, -1}));
    EXPECT_EQ(drawnColumns(10), std::vector<int>(10, 90));
    EXPECT_EQ(drawnColumns(8192), std::vector<int>(10, 90));
}

TEST(SlowDrawing, ANegativeRateWaits) {
    SlowDrawing slow;
    std::vector<int> next;
    for (int i = 0; i < 7; ++i) {
        shown(slow, 100, -3);
        next.push_back(slow.next());
    }
    EXPECT_EQ(next, (std::vector<int>{0, 0, 1, 1, 1, 2, 2}));
}

TEST(SlowDrawing, RestartsWhenAskedOrForAnotherSize) {
    SlowDrawing slow;
    shown(slow, 100, 7);
    slow.restart();
    EXPECT_EQ(shown(slow, 120, 1), (std::vector<int>{120, -1, 0, 0, 0, 0, 0, 0, 0, 0}));
    Canvas other(20, 5);
    slow.show(other.picture, 2);
    EXPECT_EQ(slow.next(), 2);
    EXPECT_EQ(toColour(other.at(19, 4)), kNotYetDrawn);
}

}  // namespace
}  // namespace slicecast
