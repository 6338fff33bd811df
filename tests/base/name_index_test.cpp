#include "base/name_index.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

using namespace slicecast;

TEST(NameIndex, FindsWhatWasAdded) {
    NameIndex index;
    EXPECT_FALSE(index.find("brick").has_value());
    EXPECT_EQ(index.add("brick", 7), 7u);
    EXPECT_EQ(index.add("", 0), 0u);
    EXPECT_EQ(index.find("brick"), 7u);
    EXPECT_EQ(index.find(""), 0u);
    EXPECT_FALSE(index.find("bric").has_value());
}

TEST(NameIndex, ANameKeepsItsNumber) {
    NameIndex index;
    index.add("brick", 7);
    EXPECT_EQ(index.add("brick", 8), 7u);
    EXPECT_EQ(index.find("brick"), 7u);
}

TEST(NameIndex, HoldsMany) {
    std::vector<std::string> names;
    for (int i = 0; i < 5000; ++i) names.push_back("name " + std::to_string(i));
    NameIndex index;
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_EQ(index.add(names[i], static_cast<std::uint32_t>(i)), i);
    for (std::size_t i = 0; i < names.size(); ++i)
        ASSERT_EQ(index.find(names[i]), static_cast<std::uint32_t>(i)) << names[i];
    EXPECT_FALSE(index.find("name 5000").has_value());
}

// Names that a plain FNV-1a puts next to each other: they are found all the same, and among others.
TEST(NameIndex, HoldsNamesThatWereMadeToComeTogether) {
    std::vector<std::string> names;
    for (int i = 0; names.size() < 600; ++i) {
        const std::string name = std::to_string(i);
        std::uint32_t hash = 2166136261u;
        for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
        if (((hash ^ (hash >> 15)) & 0x7ff) == 5) names.push_back(name);
    }
    NameIndex index;
    for (std::size_t i = 0; i < names.size(); ++i)
        ASSERT_EQ(index.add(names[i], static_cast<std::uint32_t>(i)), i);
    for (std::size_t i = 0; i < names.size(); ++i)
        ASSERT_EQ(index.find(names[i]), static_cast<std::uint32_t>(i)) << names[i];
    EXPECT_FALSE(index.find("").has_value());
}
