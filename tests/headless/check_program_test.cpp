// slicecast-check as people run it.
#include "files/scene_file.h"
#include "run_program.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

const std::string kFolder = SLICECAST_SOURCE_FOLDER "/tests/scene/";

std::string faultsOf(const std::string& path) {
    std::string lines;
    for (const Fault& fault : readSceneFile(path).faults) lines += describe(fault) + "\n";
    return lines;
}

TEST(CheckProgram, SaysOk) {
    const std::string path = SLICECAST_SOURCE_FOLDER "/assets/scenes/wayhouse-hunt.json";
    const Finished finished = runProgram(SLICECAST_CHECK, {path});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, path + ": ok\n");
    EXPECT_EQ(finished.err, "");
}

TEST(CheckProgram, ReportsAllFaultsOfAllScenes) {
    const std::string several = kFolder + "broken/several-faults.json";
    const std::string missing = kFolder + "no-such-scene.json";
    const Finished finished =
        runProgram(SLICECAST_CHECK, {several, kFolder + "everything.json", missing});
    EXPECT_EQ(finished.status, 1);
    EXPECT_GT(readSceneFile(several).faults.size(), 5u);
    EXPECT_EQ(finished.out, faultsOf(several) + kFolder + "everything.json: ok, 11 warnings\n" +
                                faultsOf(missing));
}

TEST(CheckProgram, WarnsOfProbableMistakes) {
    const std::string path = kFolder + "warnings.json";
    std::string lines;
    for (const Fault& warning : readSceneFile(path).warnings)
        lines += "warning: " + describe(warning) + "\n";
    const Finished finished = runProgram(SLICECAST_CHECK, {path});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, path + ": ok, 2 warnings\n");
    EXPECT_EQ(finished.err, lines);
    EXPECT_NE(lines, "");
}

TEST(CheckProgram, WarnsOfWhatNobodyReaches) {
    const std::string path = kFolder + "everything.json";
    const Finished finished = runProgram(SLICECAST_CHECK, {path});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, path + ": ok, 11 warnings\n");
    EXPECT_NE(finished.err.find("(/maps/5/objects/0/find): found a find \"leaf\" that nobody can "
                                "reach on foot"),
              std::string::npos);
}

// Whatever a scene and its file are named: a terminal would obey control characters.
TEST(CheckProgram, PrintsNoControlCharacters) {
    const TestFolder folder;
    const std::string path = (folder / "\x1b]0;file\x07.json").string();
    writeText(path, R"({
        "title": "\u001b]0;title\u0007",
        "textures": { "\u001b]52;c;cHduZWQ=\u0007": "nope.jpg", "b": "x\u009b31m\u007f.png" },
        "maps": [ { "name": "\u009b31m", "levels": [["..."]], "floor": "\u001b[31mnope" } ],
        "start": { "x": 1.5, "y": 0.5 },
        "\u001b[5mkey": 1
    })");
    const Finished finished = runProgram(SLICECAST_CHECK, {path});
    EXPECT_EQ(finished.status, 1);
    EXPECT_NE(finished.out.find("(/textures/?]52;c;cHduZWQ=?)"), std::string::npos) << finished.out;
    EXPECT_EQ(controlCharacters(finished.out + finished.err), 0);
}

TEST(CheckProgram, NeedsAScene) {
    const Finished finished = runProgram(SLICECAST_CHECK, {});
    EXPECT_EQ(finished.status, 2);
    EXPECT_NE(finished.err.find("SCENE is required"), std::string::npos);
}

TEST(CheckProgram, HasHelp) {
    const Finished finished = runProgram(SLICECAST_CHECK, {"--help"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_NE(finished.out.find("Examples:"), std::string::npos);
}

}  // namespace
}  // namespace slicecast
