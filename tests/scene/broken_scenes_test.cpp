// One file per kind of fault that a person could make. broken/expected.json lists for each file the
// faults that loading reports, with their places, and whether the schema rejects the file as well
// (schema.test.mjs looks at that).
#include "scene/json_tree.h"
#include "scene/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace slicecast {
namespace {

struct ExpectedScene {
    std::string file;
    std::vector<Fault> faults;  // `found` and `expected` may be parts of the words
};

std::vector<ExpectedScene> readExpected() {
    const std::string text = readText(sceneTestFolder() / "broken/expected.json");
    const SourceText source(text);
    const ParsedJson json = parseJson(source);
    EXPECT_FALSE(json.fault.has_value());
    const auto word = [](JsonValue object, std::string_view key) {
        return std::string(object.find(key)->text());
    };
    const auto number = [](JsonValue object, std::string_view key, int otherwise) {
        const auto value = object.find(key);
        return value ? static_cast<int>(value->number()) : otherwise;
    };
    std::vector<ExpectedScene> scenes;
    if (json.fault) return scenes;
    for (const JsonValue entry : json.tree.root()) {
        ExpectedScene scene{word(entry, "file"), {}};
        const JsonValue faults = *entry.find("faults");
        for (const JsonValue value : faults) {
            Fault fault;
            fault.file = scene.file;
            fault.pointer = word(value, "pointer");
            fault.line = number(value, "line", 0);
            fault.column = number(value, "column", 0);
            fault.row = number(value, "row", -1);
            fault.character = number(value, "character", -1);
            fault.found = word(value, "found");
            fault.expected = word(value, "expected");
            scene.faults.push_back(fault);
        }
        scenes.push_back(scene);
    }
    return scenes;
}

TEST(BrokenScenes, ReportWhatIsWrongAndWhere) {
    const std::vector<ExpectedScene> scenes = readExpected();
    ASSERT_GE(scenes.size(), 35u);
    for (const ExpectedScene& scene : scenes) {
        const LoadedScene loaded = loadFrom(sceneTestFolder() / "broken" / scene.file);
        SCOPED_TRACE(inWords(loaded.faults));
        EXPECT_FALSE(loaded.world.has_value()) << scene.file;
        ASSERT_EQ(loaded.faults.size(), scene.faults.size()) << scene.file;
        for (std::size_t i = 0; i < scene.faults.size(); ++i) {
            const Fault& found = loaded.faults[i];
            const Fault& expected = scene.faults[i];
            EXPECT_EQ(found.file, expected.file);
            EXPECT_EQ(found.pointer, expected.pointer);
            EXPECT_EQ(found.line, expected.line);
            EXPECT_EQ(found.column, expected.column);
            EXPECT_EQ(found.row, expected.row);
            EXPECT_EQ(found.character, expected.character);
            EXPECT_NE(found.found.find(expected.found), std::string::npos) << expected.found;
            EXPECT_NE(found.expected.find(expected.expected), std::string::npos)
                << expected.expected;
            EXPECT_FALSE(expected.found.empty());
            EXPECT_FALSE(expected.expected.empty());
        }
    }
}

TEST(BrokenScenes, AreAllListed) {
    std::set<std::string> listed;
    for (const ExpectedScene& scene : readExpected())
        EXPECT_TRUE(listed.insert(scene.file).second) << scene.file;
    std::set<std::string> present;
    for (const auto& entry : std::filesystem::directory_iterator(sceneTestFolder() / "broken")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".json" && name != "expected.json") present.insert(name);
    }
    EXPECT_EQ(listed, present);
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
