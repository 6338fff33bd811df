#include "base/words.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>

namespace slicecast {
namespace {

TEST(Words, PutTextsAndNumbersTogether) {
    const std::string name = "hall";
    EXPECT_EQ(words("a map of ", 3, " x ", std::size_t{4}, " tiles in ", name,
                    std::string_view("way", 1)),
              "a map of 3 x 4 tiles in hallw");
    EXPECT_EQ(words(std::numeric_limits<std::int64_t>::min(), " ", false),
              "-9223372036854775808 0");
    EXPECT_EQ(words(Fixed{2.0, 2}, " ", Fixed{-0.5, 0}, " ", Shortest{0.1}), "2.00 -0 0.1");
    EXPECT_EQ(words(Counted{1, "row"}, ", ", Counted{0, "row"}, ", ", Counted{2, "cell"}),
              "1 row, 0 rows, 2 cells");
    EXPECT_EQ(words(roundedText(1.0 / 3.0, 3)), "0.333");
}

TEST(Words, AreAppended) {
    std::string text = "eye";
    for (const int number : {1, -2}) add(text, {" ", number});
    add(text, "!");
    EXPECT_EQ(text, "eye 1 -2!");
}

TEST(Words, FillAPlaceAsFarAsTheyFit) {
    std::array<char, 8> place;
    EXPECT_EQ(write(place, {"level ", 5}), "level 5");
    EXPECT_EQ(write(place, {"level ", 1234}), "level 12");
    EXPECT_EQ(write(place, {"levels up ", 1234}), "levels u");
    EXPECT_EQ(write(place, ""), "");
}

}  // namespace
}  // namespace slicecast
