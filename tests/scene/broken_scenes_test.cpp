// One file per kind of fault that a person could make. broken/expected.json lists for each file the faults that loading reports, with their places, and
// whether the schema rejects the file as well (schema.test.mjs looks at that).
#include "scene/scene_files.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

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
    rapidjson::Document document;
    document.Parse(readText(sceneTestFolder() / "broken/expected.json").c_str());
    std::vector<ExpectedScene> scenes;
    if (!document.IsArray()) return scenes;
    for (const auto& entry : document.GetArray()) {
        ExpectedScene scene{entry["file"].GetString(), {}};
        for (const auto& value : entry["faults"].GetArray()) {
            Fault fault;
            fault.file = scene.file;
            fault.pointer = value["pointer"].GetString();
            fault.line = value["line"].GetInt();
            fault.column = value["column"].GetInt();
            if (value.HasMember("row")) fault.row = value["row"].GetInt();
            if (value.HasMember("character")) fault.character = value["character"].GetInt();
            fault.found = value["found"].GetString();
            fault.expected = value["expected"].GetString();
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
            EXPECT_NE(found.expected.find(expected.expected), std::string::npos) << expected.expected;
            EXPECT_FALSE(expected.found.empty());
            EXPECT_FALSE(expected.expected.empty());
        }
    }
}

TEST(BrokenScenes, AreAllListed) {
    std::set<std::string> listed;
    for (const ExpectedScene& scene : readExpected()) EXPECT_TRUE(listed.insert(scene.file).second) << scene.file;
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
              "castle.json:12:5 (/maps/0/levels/1/3, row 3, character 7): found 'Q', expected a character of the legend");
}

}  // namespace
}  // namespace slicecast
