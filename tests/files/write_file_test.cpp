#include "files/write_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace slicecast {
namespace {

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
protected:
    WriteFile() { fs::create_directory(folder); }
    ~WriteFile() override { fs::remove_all(folder); }

    std::string at(const std::string& name) const { return (folder / name).string(); }

    const fs::path folder =
        fs::temp_directory_path() / ("slicecast-write-" + std::to_string(getpid()));
};

// Asked before a game is recorded: says what writing would say.
TEST_F(WriteFile, SaysBeforehandWhatCannotBeWritten) {
    const std::string missing = at("no-folder/walk.txt");
    EXPECT_EQ(whyNotWritable(missing),
              '"' + missing + "\" cannot be written: No such file or directory");
    EXPECT_EQ(whyNotWritable(missing), writeWholeFile(missing, std::string_view("text")));
    EXPECT_EQ(whyNotWritable(folder.string()),
              '"' + folder.string() + "\" is a folder; expected the name of a file");
    EXPECT_NE(whyNotWritable("/proc/walk.txt"), "");
}

TEST_F(WriteFile, LeavesEverythingAsItIsWhenAsked) {
    EXPECT_EQ(whyNotWritable(at("new.txt")), "");
    EXPECT_TRUE(fs::is_empty(folder));

    ASSERT_EQ(writeWholeFile(at("old.txt"), std::string_view("old")), "");
    fs::create_symlink("old.txt", folder / "link.txt");
    EXPECT_EQ(whyNotWritable(at("old.txt")), "");
    EXPECT_EQ(whyNotWritable(at("link.txt")), "");
    std::ifstream file(at("old.txt"));
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));

    EXPECT_EQ(whyNotWritable("/dev/null"), "");
}

}  // namespace
}  // namespace slicecast
