// The named settings of the classic method, and what it says that it cannot show.
#include "session/old_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace slicecast {
namespace {

// Applies a list of options; the names that it has.
std::set<std::string> apply(SessionOptions& options, std::string_view list) {
    std::set<std::string> names;
    while (!list.empty()) {
        const std::string_view word = list.substr(0, list.find(' '));
        list.remove_prefix(std::min(word.size() + 1, list.size()));
        const std::size_t sign = word.find('=');
        EXPECT_NE(sign, std::string_view::npos) << word;
        names.insert(std::string(word.substr(0, sign)));
        EXPECT_EQ(setOption(options, word.substr(0, sign), word.substr(sign + 1)), "") << word;
    }
    return names;
}

TEST(OldWays, EachIsDifferentAndValid) {
    std::set<std::string> names;
    std::set<std::string> lists;
    for (const OldWay& way : knownOldWays()) {
        EXPECT_TRUE(names.insert(way.name).second) << way.name;
        EXPECT_TRUE(lists.insert(way.options).second) << way.options;
        EXPECT_EQ(std::string_view(way.description).back(), '.') << way.name;
        SessionOptions options;
        for (const std::string& option : apply(options, way.options)) {
            EXPECT_EQ(option.substr(0, 8), "classic.") << way.name;
            EXPECT_NE(optionValue(options, option), optionValue({}, option)) << way.name;
        }
    }
}

TEST(OldWays, EveryClassicOptionIsInOne) {
    std::set<std::string> used;
    for (const OldWay& way : knownOldWays()) {
        SessionOptions options;
        used.merge(apply(options, way.options));
    }
    for (const OptionInfo& option : knownOptions()) {
        const std::string_view name = option.name;
        EXPECT_TRUE(name.substr(0, 8) != "classic." || used.contains(option.name)) << name;
    }
}

TEST(OldWays, TheClassicMethodListsWhatItCannotDraw) {
    World world;
    CellBlueprint glass;
    glass.seeThrough = true;
    world.blueprints.push_back(glass);
    SessionOptions options;
    EXPECT_TRUE(leftOut(world, options).empty());
    options.compare = 0.5;
    world.portals.push_back({});
    EXPECT_EQ(leftOut(world, options).size(), 1u) << "glass through portals";
    options.compare = 0.0;
    EXPECT_TRUE(leftOut(world, options).empty());
    options.method = DrawMethod::classic;
    EXPECT_EQ(leftOut(world, options).size(), 1u) << "glass through portals";
    world.blueprints[1].faces[static_cast<std::size_t>(Face::top)].mirror = 9;
    EXPECT_EQ(leftOut(world, options).size(), 1u);
    options.classic.flippedMirrors = true;
    EXPECT_EQ(leftOut(world, options).size(), 2u) << "mirrors above the floor";
    world.blueprints[1].slopes.top.from = {};
    EXPECT_EQ(leftOut(world, options).size(), 2u);
    options.classic.oneLevel = true;
    EXPECT_EQ(leftOut(world, options).size(), 3u) << "slopes";
}

}  // namespace
}  // namespace slicecast
