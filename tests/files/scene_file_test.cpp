#include "files/scene_file.h"

#include "files/read_file.h"
#include "scene/limits.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace slicecast {
namespace {

namespace fs = std::filesystem;

const std::string kFolder = SLICECAST_SOURCE_FOLDER "/tests/scene/";

// A scene that names one texture, in a folder of its own.
class SceneFile : public testing::Test {
protected:
    SceneFile()
        : folder_(fs::path(testing::TempDir()) / ("slicecast-files-" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(scene()) << R"({ "title": "One texture",
  "textures": { "brick": "brick.png" },
  "blueprints": { "wall": { "faces": "brick" } },
  "legend": { "#": "wall" },
  "maps": [{ "name": "room", "floor": "brick", "levels": [["###", "#.#", "###"]] }],
  "start": { "x": 1.5, "y": 1.5 }
})";
        fs::copy_file(SLICECAST_SOURCE_FOLDER "/tests/scene/broken/images/brick.png", image());
    }
    ~SceneFile() override { fs::remove_all(folder_); }

    fs::path scene() const { return folder_ / "scene.json"; }
    fs::path image() const { return folder_ / "brick.png"; }

    // Each way in which a file may be one that nobody reads, made at `path`, and what is said of
    // it.
    struct Bad {
        std::string found;
        std::function<void(const fs::path&)> make;
    };
    static std::vector<Bad> badFiles(std::uintmax_t limit) {
        const std::uintmax_t large =
            limit + (std::uintmax_t{1} << 36);  // with no bytes on the disk
        return {
            {"does not exist", [](const fs::path&) {}},
            {"is a folder", [](const fs::path& path) { fs::create_directory(path); }},
            {"is not a regular file",
             [](const fs::path& path) { ASSERT_EQ(mkfifo(path.c_str(), 0600), 0); }},
            {"is not a regular file",
             [](const fs::path& path) { fs::create_symlink("/dev/zero", path); }},
            {"has " + std::to_string(large) + " bytes; at most " + std::to_string(limit) +
                 " are read",
             [=](const fs::path& path) {
                 std::ofstream(path).close();
                 fs::resize_file(path, large);
             }},
        };
    }

private:
    fs::path folder_;
};

TEST_F(SceneFile, IsReadWithItsImages) {
    const LoadedScene loaded = readSceneFile(scene());
    EXPECT_TRUE(loaded.faults.empty()) << describe(loaded.faults.front());
    ASSERT_TRUE(loaded.world.has_value());
    EXPECT_EQ(loaded.world->textures.size(), 1u);
}

TEST_F(SceneFile, FindsImagesFromTheScenesFolder) {
    const LoadedScene loaded = readSceneFile(kFolder + "everything.json");
    EXPECT_TRUE(loaded.faults.empty());
    ASSERT_TRUE(loaded.world.has_value());
    EXPECT_GE(loaded.world->textures.size(), 3u);
    EXPECT_EQ(loaded.world->maps[1].sky.panorama.width, 24);
}

TEST_F(SceneFile, FaultsHaveTheNameFromTheCaller) {
    fs::remove(image());
    const std::string path = scene().string();
    const LoadedScene loaded = readSceneFile(path);
    EXPECT_FALSE(loaded.world.has_value());
    ASSERT_EQ(loaded.faults.size(), 1u);
    EXPECT_EQ(loaded.faults[0].file, path);
    EXPECT_EQ(loaded.faults[0].pointer, "/textures/brick");
}

TEST_F(SceneFile, AnythingButARegularFileIsAFault) {
    const std::clock_t start = std::clock();
    for (const Bad& bad : badFiles(kMaxSceneBytes)) {
        fs::remove_all(scene());
        bad.make(scene());
        const LoadedScene loaded = readSceneFile(scene());
        EXPECT_FALSE(loaded.world.has_value());
        ASSERT_EQ(loaded.faults.size(), 1u) << bad.found;
        EXPECT_EQ(describe(loaded.faults[0]), scene().string() + ": found a path that " +
                                                  bad.found + ", expected a scene file");
    }
    EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC);
    EXPECT_EQ(readSceneFile("").faults.size(), 1u);
}

TEST_F(SceneFile, FaultsSayWhyImagesCannotBeRead) {
    const std::clock_t start = std::clock();
    for (const Bad& bad : badFiles(kMaxImageBytes)) {
        fs::remove_all(image());
        bad.make(image());
        const LoadedScene loaded = readSceneFile(scene());
        EXPECT_FALSE(loaded.world.has_value());
        ASSERT_EQ(loaded.faults.size(), 1u) << bad.found;
        EXPECT_EQ(loaded.faults[0].found, "\"brick.png\", which " + bad.found);
        EXPECT_EQ(loaded.faults[0].line, 2);
    }
    EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC);
}

TEST_F(SceneFile, AMissingImageMayHaveANameLikeIt) {
    fs::rename(image(), image().parent_path() / "Brick.png");
    const LoadedScene loaded = readSceneFile(scene());
    ASSERT_EQ(loaded.faults.size(), 1u);
    EXPECT_EQ(loaded.faults[0].found, "\"brick.png\", which does not exist");
    EXPECT_EQ(loaded.faults[0].expected.substr(loaded.faults[0].expected.find(';')),
              "; did you mean \"Brick.png\"?");
}

// The table of shipped pictures names files with their frames.
TEST_F(SceneFile, MayNameShippedPictures) {
    std::ofstream(scene()) << R"({ "title": "Shipped",
  "textures": { "grass": "brick.png" },
  "blueprints": { "wall": { "faces": { "all": "brick-mossy", "top": "lava" } } },
  "legend": { "#": "wall" },
  "maps": [{ "name": "room", "floor": "grass", "levels": [["###", "#.#", "###"]],
    "objects": [{ "sprite": "fox-running", "x": 1.5, "y": 1.5, "height": 0.5 }] }],
  "start": { "x": 1.5, "y": 1.5 }
})";
    const LoadedScene loaded = readSceneFile(scene());
    ASSERT_TRUE(loaded.world.has_value());
    const std::vector<Texture>& textures = loaded.world->textures;
    ASSERT_EQ(textures.size(), 3u);
    EXPECT_EQ(textures[0].name, "grass");
    EXPECT_EQ(textures[0].levels[0].size, 8) << "the scene's own";
    EXPECT_EQ(textures[1].name, "brick-mossy");
    EXPECT_EQ(textures[2].laterFrames.size(), 7u);
    EXPECT_EQ(textures[2].rate, 6.0);
    EXPECT_EQ(loaded.world->sprites[0].views, 4);
    EXPECT_EQ(loaded.world->sprites[0].frames.size(), 24u);
}

TEST_F(SceneFile, MayBeElsewhereThanTheShippedPicturesThatItNames) {
    const auto load = [&](const std::string& file) {
        std::ofstream(scene()) << R"({ "title": "Elsewhere", "textures": { "ground": "../)" + file +
                                      R"(" },
  "maps": [{ "name": "room", "floor": "ground", "levels": [["."]] }],
  "start": { "x": 0.5, "y": 0.5 } })";
        return readSceneFile(scene());
    };
    EXPECT_TRUE(load("textures/brick.png").world.has_value());
    for (const char* missing : {"textures/brickk.png", "pictures/brick.png"}) {
        const LoadedScene loaded = load(missing);
        ASSERT_EQ(loaded.faults.size(), 1u);
        EXPECT_EQ(loaded.faults[0].found,
                  "\"../" + std::string(missing) + "\", which does not exist");
    }
}

TEST_F(SceneFile, SuggestsShippedPictures) {
    std::ofstream(scene()) << R"({ "title": "Shipped", "maps": [{ "name": "room",
  "floor": "lavva", "levels": [["."]] }], "start": { "x": 0.5, "y": 0.5 } })";
    const LoadedScene loaded = readSceneFile(scene());
    ASSERT_EQ(loaded.faults.size(), 1u);
    EXPECT_EQ(loaded.faults[0].expected, "the name of a texture; did you mean \"lava\"?");
}

TEST(ReadWholeFile, ReportsTheErrorOfTheSystem) {
    // A regular file of Linux that tells no size and refuses to be read, by root too
    const char* kUnreadable = "/proc/self/mem";
    if (!fs::is_regular_file(kUnreadable)) GTEST_SKIP() << "needs Linux";
    const ReadFile file = readWholeFile(kUnreadable, 100);
    EXPECT_TRUE(file.bytes.empty());
    EXPECT_EQ(file.fault.substr(0, 16), "cannot be read: ") << file.fault;
}

// Of this process alone.
fs::path ownPath(const std::string& name) {
    return fs::path(testing::TempDir()) / (name + "-" + std::to_string(getpid()));
}

TEST(ReadWholeFile, AnUnreadableFileIsAFault) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const fs::path path = ownPath("slicecast-locked");
    std::ofstream(path) << "secret";
    fs::permissions(path, fs::perms::none);
    EXPECT_EQ(readWholeFile(path, 100).fault, "cannot be read: Permission denied");
    fs::remove(path);
}

TEST(ReadWholeFile, ReadsUpToTheLimit) {
    const fs::path path = ownPath("slicecast-limit");
    std::ofstream(path) << "12345";
    EXPECT_EQ(readWholeFile(path, 5).text(), "12345");
    EXPECT_EQ(readWholeFile(path, 4).fault, "has 5 bytes; at most 4 are read");
    fs::remove(path);
}

TEST(ReadWholeFile, KeepsTheLimitWithoutAReportedSize) {
    if (!fs::is_regular_file("/proc/self/status")) GTEST_SKIP() << "needs Linux";
    EXPECT_NE(readWholeFile("/proc/self/status", 1u << 20).text().find("Name:"), std::string::npos);
    EXPECT_NE(readWholeFile("/proc/self/status", 10).fault.find("at most 10"), std::string::npos);
}

}  // namespace
}  // namespace slicecast
