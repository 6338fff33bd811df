#include "scene/names.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Names, SuggestTheNearest) {
    const std::vector<std::string_view> names = {"brick", "stone"};
    EXPECT_EQ(suggestion("grass", names), "");
    EXPECT_EQ(suggestion("stine", names), "; did you mean \"stone\"?");
}

TEST(Names, KeepTheirFirstNumber) {
    NameTable table;
    table.add("brick", 3);
    table.add("brick", 4);
    EXPECT_EQ(table.find("brick"), std::uint16_t{3});
    EXPECT_FALSE(table.find("stone").has_value());
    table.takeAny();
    EXPECT_EQ(table.find("brick"), std::uint16_t{3});
    EXPECT_EQ(table.find("stone"), std::uint16_t{0});
}

}  // namespace
}  // namespace slicecast
