#include "app/find_scene.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace slicecast {
namespace {

TEST(FindScene, TheOpeningSceneIsTheFirstOfTheList) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) /
                                         ("slicecast-opening-" + std::to_string(getpid()));
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

}  // namespace
}  // namespace slicecast
