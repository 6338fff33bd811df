#include "base/sort.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

TEST(MergeSort, SortsAsTheLibraryDoesAndKeepsTheOrderOfEquals) {
    std::uint32_t state = 1;
    for (int length = 0; length < 200; ++length) {
        std::vector<std::pair<int, int>> things;
        for (int i = 0; i < length; ++i) {
            state = state * 1664525u + 1013904223u;
            things.emplace_back(static_cast<int>((state >> 16) % 20), i);
        }
        auto expected = things;
        const auto isBefore = [](const auto& a, const auto& b) { return a.first < b.first; };
        std::stable_sort(expected.begin(), expected.end(), isBefore);
        mergeSort(things, isBefore);
        ASSERT_EQ(things, expected) << length;
    }
}

TEST(MergeSort, MovesTexts) {
    std::vector<std::string> names = {"stone, which is longer than what is kept in place", "brick",
                                      "wood"};
    std::vector<std::string> room;
    mergeSort(names, room, std::less<>());
    EXPECT_EQ(names, (std::vector<std::string>{
                         "brick", "stone, which is longer than what is kept in place", "wood"}));
}

}  // namespace
}  // namespace slicecast
