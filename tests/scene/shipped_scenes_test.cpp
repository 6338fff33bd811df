// Every scene that is shipped loads without a fault, and players reach all that is in it.
#include "scene/scene_files.h"
#include "scene/unreached.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(ShippedScenes, Load) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(SLICECAST_SOURCE_FOLDER) / "assets/scenes")) {
        // The index lists the scenes for the page's menu.
        if (entry.path().extension() != ".json" || entry.path().filename() == "index.json")
            continue;
        const LoadedScene loaded = loadFrom(entry.path());
        EXPECT_EQ(inWords(loaded.faults), "");
        EXPECT_EQ(inWords(loaded.warnings), "");
        EXPECT_EQ(inWords(findUnreached(loaded)), "");
        EXPECT_TRUE(loaded.world.has_value()) << entry.path();
        ++count;
    }
    EXPECT_GT(count, 0);
}

// The tutorial's scenes name pictures beside the built page, which is one folder deeper than
// assets.
TEST(ShippedScenes, OfTheTutorialHaveNoMistakes) {
    const std::filesystem::path root = SLICECAST_SOURCE_FOLDER;
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root / "web/learn/scenes")) {
        if (entry.path().extension() != ".json") continue;
        std::string text = readText(entry.path());
        for (std::size_t at = 0; (at = text.find("\"../../", at)) != std::string::npos;)
            text.erase(at + 1, 3);
        const LoadedScene loaded =
            loadText(text, entry.path().filename().string(), root / "assets/scenes");
        EXPECT_EQ(inWords(loaded.faults), "");
        EXPECT_EQ(inWords(loaded.warnings), "");
        EXPECT_EQ(inWords(findUnreached(loaded)), "");
        ++count;
    }
    EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace slicecast
