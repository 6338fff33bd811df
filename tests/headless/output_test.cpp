// Where the programs' output goes: files, links, pipes and devices, and what cannot be written.
#include "run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <utility>

namespace slicecast {
namespace {

namespace fs = std::filesystem;

const std::string kPngBeginning = "\x89PNG";

Finished renderTo(const fs::path& out) {
    return runProgram(SLICECAST_RENDER, {kEveryFeature, "--size", "16x9", "--out", out.string()});
}

bool isPng(const std::string& bytes) {
    return bytes.compare(0, kPngBeginning.size(), kPngBeginning) == 0;
}

TEST(Output, KeepsTheModeOfAnExistingFile) {
    const TestFolder folder;
    const fs::path out = folder / "out.png";
    writeText(out, "old");
    ASSERT_EQ(chmod(out.c_str(), 0640), 0);
    EXPECT_EQ(renderTo(out).status, 0);
    EXPECT_TRUE(isPng(readText(out)));
    EXPECT_EQ(fs::status(out).permissions(), static_cast<fs::perms>(0640));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"out.png"});
}

TEST(Output, FollowsLinks) {
    const TestFolder folder;
    fs::create_directory(folder / "there");
    writeText(folder / "there/old.png", "old");
    fs::create_symlink("there/old.png", folder / "one.png");
    fs::create_symlink("one.png", folder / "two.png");
    fs::create_symlink("there/new.png", folder / "new.png");  // nothing is there yet
    for (const auto& [link, file] :
         {std::pair{"two.png", "there/old.png"}, {"new.png", "there/new.png"}}) {
        EXPECT_EQ(renderTo(folder / link).status, 0);
        EXPECT_TRUE(fs::is_symlink(folder / link)) << link;
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / file))) << file;
        EXPECT_TRUE(isPng(readText(folder / file))) << file;
    }
    EXPECT_TRUE(fs::is_symlink(folder / "one.png"));

    fs::create_symlink("round.png", folder / "round.png");
    const Finished round = renderTo(folder / "round.png");
    EXPECT_EQ(round.status, 1);
    EXPECT_NE(round.err.find("round.png\" cannot be written: "), std::string::npos) << round.err;
}

TEST(Output, GoesIntoAPipe) {
    const TestFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    // Opened for both, so that nobody waits for ever if the program does not open it.
    const int end = open(pipe.c_str(), O_RDWR | O_NONBLOCK);
    ASSERT_GE(end, 0);
    EXPECT_EQ(renderTo(pipe).status, 0);
    EXPECT_TRUE(fs::is_fifo(pipe));
    std::array<char, 8> bytes{};
    EXPECT_EQ(read(end, bytes.data(), 4), 4);
    EXPECT_TRUE(isPng({bytes.data(), 4}));
    close(end);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"pipe"});
}

const fs::path kFull = "/dev/full";  // takes nothing; some systems have none

// A device that takes no bytes; an empty path if the system has none. A user who may replace files
// of /dev (root) gets a device in the test's folder: a fault of the program must not harm the
// machine.
fs::path fullDevice(const TestFolder& folder) {
    struct stat full {};
    if (stat(kFull.c_str(), &full) != 0) return {};
    if (geteuid() != 0) return kFull;
    const fs::path path = folder / "full";
    return mknod(path.c_str(), S_IFCHR | 0666, full.st_rdev) == 0 ? path : fs::path();
}

TEST(Output, GoesIntoADevice) {
    const TestFolder folder;
    const fs::path full = fullDevice(folder);
    if (full.empty()) GTEST_SKIP() << "no device can be made here";
    const std::string says =
        ": \"" + full.string() + "\" cannot be written: No space left on device\n";

    const Finished picture = renderTo(full);
    EXPECT_EQ(picture.status, 1);
    EXPECT_EQ(picture.err, "slicecast-render" + says);
    EXPECT_TRUE(fs::is_character_file(full));

    const Finished sheet =
        runProgram(SLICECAST_TEXTURES, {"--only", "brick", "--sheet", full.string()});
    EXPECT_EQ(sheet.status, 1);
    EXPECT_EQ(sheet.err, "slicecast-textures" + says);
    EXPECT_TRUE(fs::is_character_file(full));
}

struct Printing {
    std::string program;
    std::vector<std::string> arguments;
};

// What each program prints where all is well: little, and more than a buffer holds.
const std::vector<Printing> kPrintings = {
    {SLICECAST_RENDER, {kEveryFeature, "--size", "64x48", "--hits", "3"}},
    {SLICECAST_RENDER, {kEveryFeature, "--size", "64x48", "--trace", "all"}},
    {SLICECAST_RENDER, {"--help"}},
    {SLICECAST_CHECK, {SLICECAST_SOURCE_FOLDER "/assets/scenes/wayhouse-hunt.json"}},
    {SLICECAST_CHECK, {"--help"}},
    {SLICECAST_TEXTURES, {"--list"}},
    {SLICECAST_TEXTURES, {"--help"}},
};

TEST(Output, IsNotLostWithoutAMessage) {
    constexpr int kClosedPipe = 9;
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    ASSERT_EQ(dup2(ends[1], kClosedPipe), kClosedPipe);
    for (const int end : ends) close(end);
    for (const Printing& printing : kPrintings) {
        const std::string name = fs::path(printing.program).filename().string();
        for (const std::string& output : {kFull.string(), std::string("&9")}) {
            if (output == kFull && !fs::exists(kFull)) continue;
            const Finished finished = runProgram(printing.program, printing.arguments, output);
            const std::string what = name + " " + printing.arguments.back() + " >" + output;
            EXPECT_EQ(finished.status, 1) << what;
            EXPECT_EQ(finished.err.find(name + ": cannot write the standard output"), 0u)
                << what << ": " << finished.err;
        }
        EXPECT_EQ(runProgram(printing.program, printing.arguments).status, 0) << name;
    }
    close(kClosedPipe);
}

}  // namespace
}  // namespace slicecast
