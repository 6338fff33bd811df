#include "scene/names.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Names, SuggestsTheNearest) {
    const std::vector<std::string_view> names = {"brick", "stone",  "planks",
                                                 "top",   "bottom", "sky-day"};
    EXPECT_EQ(nearestName("brik", names), "brick");
    EXPECT_EQ(nearestName("birck", names), "brick");  // two letters swapped
    EXPECT_EQ(nearestName("Stone", names), "stone");
    EXPECT_EQ(nearestName("plank", names), "planks");
    EXPECT_EQ(nearestName("tpo", names), "top");
    EXPECT_EQ(nearestName("buttom", names), "bottom");
    EXPECT_EQ(nearestName("skyday", names), "sky-day");
}

TEST(Names, SuggestsNothingFarFetched) {
    const std::vector<std::string_view> names = {"brick", "stone", "a", "is"};
    EXPECT_EQ(nearestName("grass", names), "");
    EXPECT_EQ(nearestName("b", names), "");
    EXPECT_EQ(nearestName("", names), "");
    EXPECT_EQ(nearestName(std::string(1000, 'b'), names), "");
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
