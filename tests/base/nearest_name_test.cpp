#include "base/nearest_name.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(NearestName, IsTheOneMeant) {
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

TEST(NearestName, IsNoneWhereAllAreFar) {
    const std::vector<std::string_view> names = {"brick", "stone", "a", "is"};
    EXPECT_EQ(nearestName("grass", names), "");
    EXPECT_EQ(nearestName("b", names), "");
    EXPECT_EQ(nearestName("", names), "");
    EXPECT_EQ(nearestName(std::string(1000, 'b'), names), "");
    EXPECT_EQ(didYouMean("grass", names), "");
    EXPECT_EQ(didYouMean("stine", names), " Did you mean 'stone'?");
}

}  // namespace
}  // namespace slicecast
