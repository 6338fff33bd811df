// Each mistake that an author could make is reported in the words and at the place that
// broken/cases.txt states.
#include "scene/broken_scenes.h"
#include "scene/scene_files.h"

#include <gtest/gtest.h>

#include <set>

namespace slicecast {
namespace {

TEST(BrokenScenes, ReportWhatIsWrongAndWhere) {
    const std::vector<BrokenScene> scenes = brokenScenes();
    ASSERT_GE(scenes.size(), 208u);
    for (const BrokenScene& scene : scenes) {
        const std::string file = scene.name + ".json";
        const LoadedScene loaded = loadText(scene.text, file, brokenScenesFolder());
        EXPECT_FALSE(loaded.world.has_value()) << scene.name;
        EXPECT_FALSE(scene.faults.empty()) << scene.name;
        std::string expected;
        for (const std::string& fault : scene.faults) expected += file + ":" + fault + "\n";
        EXPECT_EQ(inWords(loaded.faults), expected);
    }
}

TEST(BrokenScenes, AreListedOnce) {
    std::set<std::string> listed;
    for (const BrokenScene& scene : brokenScenes())
        EXPECT_TRUE(listed.insert(scene.name).second) << scene.name;
    for (const auto& entry : std::filesystem::directory_iterator(brokenScenesFolder())) {
        if (entry.path().extension() != ".json") continue;
        EXPECT_TRUE(listed.contains(entry.path().stem().string())) << entry.path();
    }
}

TEST(BrokenScenes, AreChangesOfSoundOnes) {
    for (const auto& entry : std::filesystem::directory_iterator(brokenScenesFolder() / "base")) {
        const std::string name = entry.path().filename().string();
        const LoadedScene loaded = loadText(readText(entry.path()), name, brokenScenesFolder());
        EXPECT_EQ(inWords(loaded.faults), "");
        EXPECT_EQ(inWords(loaded.warnings), "");
    }
}

TEST(BrokenScenes, AreDescribedInOneLine) {
    Fault fault;
    fault.file = "castle.json";
    fault.pointer = "/maps/0/levels/1/3";
    fault.line = 12;
    fault.column = 5;
    fault.row = 3;
    fault.character = 7;
    fault.found = "'Q'";
    fault.expected = "a character of the legend";
    EXPECT_EQ(describe(fault),
              "castle.json:12:5 (/maps/0/levels/1/3, row 3, character 7): found 'Q', expected a "
              "character of the legend");
}

}  // namespace
}  // namespace slicecast
