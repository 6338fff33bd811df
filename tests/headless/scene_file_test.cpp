#include "headless/scene_file.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

const std::string kFolder = SLICECAST_SOURCE_FOLDER "/tests/scene/";

TEST(SceneFile, FindsImagesFromTheScenesFolder) {
    const SceneFromFile scene = readScene(kFolder + "everything.json");
    EXPECT_TRUE(scene.faults.empty());
    ASSERT_TRUE(scene.world.has_value());
    EXPECT_GE(scene.world->textures.size(), 3u);
    EXPECT_EQ(scene.world->maps[1].sky.panorama.width, 24);
}

TEST(SceneFile, NamesTheFileAsItWasGiven) {
    const std::string path = kFolder + "broken/image-missing.json";
    const SceneFromFile scene = readScene(path);
    EXPECT_FALSE(scene.world.has_value());
    ASSERT_EQ(scene.faults.size(), 1u);
    EXPECT_EQ(scene.faults[0].file, path);
    EXPECT_EQ(scene.faults[0].pointer, "/textures/brick");
}

TEST(SceneFile, ThatCannotBeReadIsAFault) {
    for (const std::string& path :
         {kFolder + "no-such-scene.json", kFolder, kFolder + "broken", std::string()}) {
        const SceneFromFile scene = readScene(path);
        EXPECT_FALSE(scene.world.has_value());
        ASSERT_EQ(scene.faults.size(), 1u) << path;
        EXPECT_EQ(scene.faults[0].file, path);
    }
}

}  // namespace
}  // namespace slicecast
