// The rows that are still open, against a plain array of booleans.
#include "render/spans/open_rows.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace slicecast {
namespace {

// Runs as text: "2-5 7-9".
class RunText {
public:
    void operator()(int first, int last) {
        if (!text_.empty()) text_ += ' ';
        text_ += std::to_string(first) + '-' + std::to_string(last);
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

std::string textOf(const std::vector<OpenRows::Run>& runs) {
    RunText text;
    for (const auto& [first, last] : runs) text(first, last);
    return text.text();
}

std::string taken(OpenRows& open, int first, int last) {
    return textOf(open.take(first, last));
}

std::string within(OpenRows& open, int first, int last) {
    return textOf(open.within(first, last));
}

// The runs of true rows within [first, last).
std::string within(const std::vector<bool>& rows, int first, int last) {
    RunText text;
    const int end = std::min(last, static_cast<int>(rows.size()));
    for (int row = std::max(first, 0); row < end; ++row) {
        if (!rows[static_cast<std::size_t>(row)]) continue;
        const int from = row;
        while (row < end && rows[static_cast<std::size_t>(row)]) ++row;
        text(from, row);
    }
    return text.text();
}

OpenRows allOpen(int height) {
    OpenRows open;
    open.openOnly({{0, height}}, height);
    return open;
}

TEST(OpenRows, NoRowsAtAll) {
    OpenRows open;
    EXPECT_TRUE(open.none());
    EXPECT_FALSE(open.mayHold(0, 100));
    EXPECT_EQ(taken(open, 0, 100), "");
    open.openOnly({}, 10);
    EXPECT_TRUE(open.none());
    EXPECT_EQ(within(open, 0, 10), "");
}

TEST(OpenRows, AnEmptyRangeTakesNothing) {
    OpenRows open = allOpen(10);
    EXPECT_EQ(taken(open, 4, 4), "");
    EXPECT_EQ(taken(open, 6, 4), "");
    EXPECT_EQ(taken(open, 10, 12), "");
    EXPECT_EQ(taken(open, -3, 0), "");
    EXPECT_FALSE(open.mayHold(4, 4));
    EXPECT_EQ(within(open, 0, 10), "0-10");
}

TEST(OpenRows, AllRowsAtOnce) {
    OpenRows open = allOpen(10);
    EXPECT_EQ(taken(open, -5, 15), "0-10");
    EXPECT_TRUE(open.none());
    EXPECT_EQ(taken(open, 0, 10), "");
}

TEST(OpenRows, OneRow) {
    OpenRows open = allOpen(1);
    EXPECT_EQ(taken(open, 0, 1), "0-1");
    EXPECT_TRUE(open.none());
    open = allOpen(10);
    EXPECT_EQ(taken(open, 0, 1), "0-1");
    EXPECT_EQ(taken(open, 9, 10), "9-10");
    EXPECT_EQ(open.first(), 1);
    EXPECT_EQ(open.last(), 9);
}

TEST(OpenRows, TakingTheMiddleSplits) {
    OpenRows open = allOpen(10);
    EXPECT_EQ(taken(open, 4, 6), "4-6");
    EXPECT_EQ(within(open, 0, 10), "0-4 6-10");
    EXPECT_EQ(open.first(), 0);
    EXPECT_EQ(open.last(), 10);
    EXPECT_TRUE(open.mayHold(4, 6)) << "only the ends of all runs are asked";
    EXPECT_EQ(taken(open, 2, 8), "2-4 6-8");
    EXPECT_EQ(within(open, 0, 10), "0-2 8-10");
    EXPECT_EQ(within(open, 1, 9), "1-2 8-9");
}

TEST(OpenRows, SeveralRunsFromTheBeginning) {
    OpenRows open;
    open.openOnly({{1, 3}, {5, 6}, {8, 12}}, 20);
    EXPECT_EQ(open.first(), 1);
    EXPECT_EQ(open.last(), 12);
    EXPECT_EQ(taken(open, 2, 9), "2-3 5-6 8-9");
    EXPECT_EQ(within(open, 0, 20), "1-2 9-12");
    open.openOnly({{0, 20}}, 20);
    EXPECT_EQ(within(open, 0, 20), "0-20") << "nothing is left of what was open before";
}

// Whatever is taken, in whatever order: the same runs as of an array of booleans.
TEST(OpenRows, LikeAnArrayOfBooleans) {
    Random random(1);
    OpenRows open;
    for (int round = 0; round < 500; ++round) {
        const int height = random.between(1, 40);
        std::vector<bool> rows(static_cast<std::size_t>(height));
        std::vector<OpenRows::Run> runs;
        for (int row = random.below(3); row < height; row += random.between(1, 4)) {
            const int last = std::min(height, row + random.between(1, 20));
            runs.push_back({row, last});
            std::fill(rows.begin() + row, rows.begin() + last, true);
            row = last;
        }
        open.openOnly(runs, height);
        while (!open.none()) {
            const int first = random.between(-2, height);
            const int last = first + random.below(random.between(1, 12));
            const std::string expected = within(rows, first, last);
            ASSERT_EQ(within(open, first, last), expected);
            if (!expected.empty()) {
                ASSERT_TRUE(open.mayHold(first, last));
            }
            ASSERT_EQ(taken(open, first, last), expected);
            for (int row = std::max(0, first); row < std::min(last, height); ++row)
                rows[static_cast<std::size_t>(row)] = false;
            ASSERT_EQ(within(open, 0, height), within(rows, 0, height));
            const auto begin = std::find(rows.begin(), rows.end(), true);
            ASSERT_EQ(open.none(), begin == rows.end());
            if (!open.none()) {
                ASSERT_EQ(open.first(), begin - rows.begin());
                ASSERT_EQ(open.last(), rows.rend() - std::find(rows.rbegin(), rows.rend(), true));
            }
        }
    }
}

}  // namespace
}  // namespace slicecast
