#include "app/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace slicecast {
namespace {

const std::filesystem::path kSource = SLICECAST_SOURCE_FOLDER;

TEST(SceneFile, ReadsASceneWithItsImages) {
    const LoadedScene loaded = readSceneFile(kSource / "assets/scenes/first-walk.json");
    EXPECT_TRUE(loaded.faults.empty()) << describe(loaded.faults.front());
    ASSERT_TRUE(loaded.world.has_value());
    EXPECT_FALSE(loaded.world->textures.empty());
}

TEST(SceneFile, AFileThatIsNotThereIsAFault) {
    for (const char* name : {"assets/scenes/nothing.json", "assets/scenes"}) {
        const LoadedScene loaded = readSceneFile(kSource / name);
        EXPECT_FALSE(loaded.world.has_value());
        ASSERT_EQ(loaded.faults.size(), 1u);
        EXPECT_NE(describe(loaded.faults[0]).find(name), std::string::npos);
    }
}

TEST(SceneFile, TheOpeningSceneIsTheFirstOfTheList) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "slicecast-opening";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "scenes");
    EXPECT_EQ(findOpeningScene(folder), std::filesystem::path());
    std::ofstream(folder / "scenes/index.json")
        << "[{\"file\": \"one.json\"}, {\"file\": \"two.json\"}]";
    EXPECT_EQ(findOpeningScene(folder), (folder / "scenes/one.json").lexically_normal());
    std::ofstream(folder / "scenes/index.json") << "[]";
    EXPECT_EQ(findOpeningScene(folder), std::filesystem::path());
    std::filesystem::remove_all(folder);
}

TEST(SceneFile, SaysWhyARecordingCannotBeWritten) {
    const std::filesystem::path nowhere =
        std::filesystem::path(testing::TempDir()) / "no such folder/walk.txt";
    EXPECT_EQ(writeText(nowhere, "text"),
              nowhere.string() + " cannot be written: No such file or directory");
    // Written in place: it stays what it is.
    if (std::filesystem::exists("/dev/full")) {
        EXPECT_EQ(writeText("/dev/full", "text"),
                  "/dev/full cannot be written: No space left on device");
    }
}

}  // namespace
}  // namespace slicecast
