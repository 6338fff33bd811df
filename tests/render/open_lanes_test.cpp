// The open rows of sixteen columns at once, against those of one column at a time.
#include "render/strips/open_lanes.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace slicecast {
namespace {

constexpr int kLaneHeight = 60;
constexpr unsigned kAll = 0xffff;

using Rows = std::tuple<int, int, int>;  // lane, first, last

class OpenLanesTest : public testing::Test {
protected:
    void begin(unsigned bits = kAll) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const std::vector<OpenRows::Run> whole = {{0, kLaneHeight}};
            const std::vector<OpenRows::Run> none;
            known_[static_cast<std::size_t>(lane)].openOnly(bits >> lane & 1 ? whole : none,
                                                            kLaneHeight);
            scratch_.rows[static_cast<std::size_t>(lane)] = known_[static_cast<std::size_t>(lane)];
        }
        lanes_.begin(bits);
    }

    // Takes rows of both, and compares what they give and what is left.
    void take(unsigned bits, const LaneValues& first, const LaneValues& last) {
        std::vector<Rows> expected;
        eachLane(bits, [&](int lane) {
            OpenRows& known = known_[static_cast<std::size_t>(lane)];
            for (const auto& [from, to] : known.take(first.at[lane], last.at[lane]))
                expected.emplace_back(lane, from, to);
        });
        std::vector<Rows> taken;
        for (const LaneRows& rows : lanes_.take(maskOf(bits), first.lanes(), last.lanes()))
            taken.emplace_back(rows.lane, rows.first, rows.last);
        std::sort(taken.begin(), taken.end());
        std::sort(expected.begin(), expected.end());
        ASSERT_EQ(taken, expected);
        lanes_.findEnds();
        unsigned live = 0;
        int least = 32767;
        int greatest = -1;
        for (int lane = 0; lane < kLanes; ++lane) {
            const OpenRows& rows = known_[static_cast<std::size_t>(lane)];
            if (rows.none()) continue;
            live |= 1u << lane;
            least = std::min(least, rows.first());
            greatest = std::max(greatest, rows.last());
        }
        ASSERT_EQ(lanes_.live(), live);
        ASSERT_EQ(lanes_.first(), least);
        ASSERT_EQ(lanes_.last(), greatest);
    }

    // A lane's rows as its list has them.
    void expectWritten(int lane) {
        lanes_.write(lane);
        const auto& runs = scratch_.rows[static_cast<std::size_t>(lane)].runs();
        const auto& known = known_[static_cast<std::size_t>(lane)].runs();
        ASSERT_TRUE(std::equal(runs.begin(), runs.end(), known.begin(), known.end(),
                               [](const OpenRows::Run& a, const OpenRows::Run& b) {
                                   return a.first == b.first && a.last == b.last;
                               }));
    }

    OpenLanes::Scratch scratch_;
    OpenLanes lanes_{scratch_};
    std::array<OpenRows, kLanes> known_;
};

LaneValues all(int value) {
    return LaneValues(inAllLanes(value));
}

TEST_F(OpenLanesTest, FromTheEndsAndInside) {
    begin();
    take(kAll, all(50), all(90));
    take(0x00ff, all(-5), all(10));
    take(0x0ff0, all(20), all(30));
    take(0x0ff0, all(30), all(40));
    take(0x0ff0, all(5), all(25));
    take(kAll, all(0), all(45));
    take(kAll, all(0), all(kLaneHeight));
    EXPECT_EQ(lanes_.live(), 0u);
}

TEST_F(OpenLanesTest, OnlySomeLanesAreOpen) {
    begin(0x00f1);
    EXPECT_EQ(lanes_.live(), 0x00f1u);
    take(kAll, all(10), all(20));
    lanes_.close(0x0011);
    lanes_.findEnds();
    EXPECT_EQ(lanes_.live(), 0x00e0u);
}

TEST_F(OpenLanesTest, ASecondGapAndBack) {
    begin();
    take(kAll, all(10), all(12));
    take(0x0003, all(20), all(22));
    expectWritten(0);
    take(0x0001, all(30), all(32));
    expectWritten(0);
    expectWritten(5);
    take(0x0003, all(0), all(25));
    expectWritten(0);
    expectWritten(1);
}

TEST_F(OpenLanesTest, AnyRows) {
    Random random(1);
    for (int i = 0; i < 500 && !HasFatalFailure(); ++i) {
        begin(static_cast<unsigned>(random.below(65536)));
        for (int step = 0; step < 30 && lanes_.live() != 0 && !HasFatalFailure(); ++step) {
            LaneValues first;
            LaneValues last;
            for (int lane = 0; lane < kLanes; ++lane) {
                first.at[lane] = static_cast<std::int16_t>(random.between(-10, kLaneHeight));
                last.at[lane] = static_cast<std::int16_t>(
                    first.at[lane] + random.between(-3, random.oneIn(3) ? 40 : 8));
            }
            take(static_cast<unsigned>(random.below(65536)), first, last);
            const int lane = random.below(kLanes);
            if (lanes_.live() >> lane & 1) {
                expectWritten(lane);
                lanes_.read(lane);
            }
        }
    }
}

TEST(Lanes, MasksAndBits) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const auto bits = static_cast<unsigned>(random.below(65536));
        ASSERT_EQ(bitsOf(maskOf(bits)), bits);
        LaneValues a;
        LaneValues b;
        for (int lane = 0; lane < kLanes; ++lane) {
            a.at[lane] = static_cast<std::int16_t>(random.between(-32768, 32767));
            b.at[lane] = static_cast<std::int16_t>(random.between(-3, 3) + a.at[lane] / 2);
        }
        const LaneValues lower(lesser(a.lanes(), b.lanes()));
        const LaneValues upper(greater(a.lanes(), b.lanes()));
        const LaneValues mixed(chosen(maskOf(bits), a.lanes(), b.lanes()));
        const unsigned below = bitsOf(a.lanes() < b.lanes());
        int least = 32767;
        int greatest = -32768;
        for (int lane = 0; lane < kLanes; ++lane) {
            ASSERT_EQ(lower.at[lane], std::min(a.at[lane], b.at[lane]));
            ASSERT_EQ(upper.at[lane], std::max(a.at[lane], b.at[lane]));
            ASSERT_EQ(mixed.at[lane], bits >> lane & 1 ? a.at[lane] : b.at[lane]);
            ASSERT_EQ(below >> lane & 1, a.at[lane] < b.at[lane] ? 1u : 0u);
            least = std::min<int>(least, a.at[lane]);
            greatest = std::max<int>(greatest, a.at[lane]);
        }
        ASSERT_EQ(leastOf(a.lanes()), least);
        ASSERT_EQ(greatestOf(a.lanes()), greatest);
    }
}

}  // namespace
}  // namespace slicecast
