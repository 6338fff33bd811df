// slicecast-render as people run it: pictures, hits, and what it refuses.
#include "base/image.h"
#include "files/scene_file.h"
#include "run_program.h"
#include "session/recording_text.h"
#include "session/session.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <cmath>
#include <cstdint>

namespace slicecast {
namespace {

Finished render(const std::vector<std::string>& arguments) {
    return runProgram(SLICECAST_RENDER, arguments);
}

Image readPicture(const std::filesystem::path& path) {
    const std::string bytes = readText(path);
    const DecodedImage decoded =
        decodePng({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, 4096, 4096);
    EXPECT_EQ(decoded.fault, "");
    return decoded.image;
}

Image drawn(Session& session, int width, int height) {
    Image image(width, height);
    EXPECT_TRUE(session.draw({image.pixels.data(), width, height, width}));
    return image;
}

// A floor of two frames, four of them a second: red for a quarter of a second, then green.
std::string blinking(const TestFolder& folder) {
    Image sheet(16, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x)
            sheet.at(x, y) = toPixel(x < 8 ? Colour{200, 0, 0, 255} : Colour{0, 200, 0, 255});
    }
    const std::vector<std::uint8_t> png =
        encodePng(sheet.pixels.data(), sheet.width, sheet.height, sheet.width);
    writeText(folder / "sheet.png", std::string(png.begin(), png.end()));
    const std::string path = (folder / "blinking.json").string();
    writeText(path, R"({
        "title": "Blinking",
        "textures": { "floor": { "file": "sheet.png", "frames": 2, "rate": 4 } },
        "maps": [ { "name": "room", "levels": [["...", "...", "..."]], "floor": "floor", "light": { "on": false } } ],
        "start": { "map": "room", "x": 1.5, "y": 1.5 }
    })");
    return path;
}

// A wall across a corridor that runs east, 2.5 units before an eye in its middle.
std::string corridor(const TestFolder& folder) {
    const std::string path = (folder / "corridor.json").string();
    std::filesystem::copy_file(SLICECAST_SOURCE_FOLDER "/tests/scene/broken/images/tile.png",
                               folder / "tile.png");
    writeText(path, R"({
        "title": "Corridor",
        "textures": { "tile": "tile.png" },
        "blueprints": { "wall": { "faces": "tile" }, "step": { "bottom": 0, "top": 0.25, "faces": "tile" } },
        "legend": { "#": "wall", "-": "step" },
        "maps": [ { "name": "corridor", "levels": [["######", "....#.", "....#.", "-.....", "######"]], "floor": "tile" } ],
        "start": { "map": "corridor", "x": 1.5, "y": 2.5 }
    })");
    return path;
}

TEST(RenderProgram, PrintsNoControlCharacters) {
    const TestFolder folder;
    std::filesystem::copy_file(SLICECAST_SOURCE_FOLDER "/tests/scene/broken/images/tile.png",
                               folder / "tile.png");
    const std::string path = (folder / "\x1b]0;file\x07.json").string();
    writeText(path, R"({
        "title": "\u001b]0;title\u0007",
        "textures": { "\u009b31m": "tile.png" },
        "maps": [ { "name": "\u009b31m\u007f", "levels": [["..."]], "floor": "\u009b31m" } ],
        "start": { "map": "\u009b31m\u007f", "x": 1.5, "y": 0.5 }
    })");
    const Finished hits = render({path, "--hits", "0"});
    EXPECT_EQ(hits.status, 0) << hits.err;
    EXPECT_EQ(controlCharacters(hits.out + hits.err), 0);
    rapidjson::Document json;
    json.Parse(hits.out.c_str());
    ASSERT_FALSE(json.HasParseError());
    EXPECT_STREQ(json["map"].GetString(), "\u009b31m\u007f");
    EXPECT_EQ(json["scene"].GetString(), path);

    const Finished noMap = render({path, "--map", "cellar", "--hits", "0"});
    EXPECT_EQ(noMap.status, 2);
    EXPECT_NE(noMap.err.find("expected a map of this scene: \"?31m?\""), std::string::npos)
        << noMap.err;
    EXPECT_EQ(controlCharacters(noMap.err), 0);
}

TEST(RenderProgram, DrawsTheStartAsThePlayerSeesIt) {
    const TestFolder folder;
    const Finished finished =
        render({kEveryFeature, "--size", "97x61", "--out", (folder / "start.png").string()});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(finished.out + finished.err, "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"start.png"});
    LoadedScene scene = readSceneFile(kEveryFeature);
    Session session(std::move(*scene.world));
    const Image picture = readPicture(folder / "start.png");
    EXPECT_EQ(picture.width, 97);
    EXPECT_EQ(picture.height, 61);
    EXPECT_EQ(picture.pixels, drawn(session, 97, 61).pixels);
}

TEST(RenderProgram, DrawsTheWorldAtATime) {
    const TestFolder folder;
    const std::string scene = blinking(folder);
    const auto floorAt = [&](const char* seconds) {
        const std::string out = (folder / "floor.png").string();
        const Finished finished = render({scene, "--time", seconds, "--size", "8x8", "--out", out});
        EXPECT_EQ(finished.status, 0) << finished.err;
        return toColour(readPicture(out).at(4, 7));
    };
    EXPECT_EQ(floorAt("0"), (Colour{200, 0, 0, 255}));
    EXPECT_EQ(floorAt("0.24"), (Colour{200, 0, 0, 255}));
    EXPECT_EQ(floorAt("0.25"), (Colour{0, 200, 0, 255}));
    EXPECT_EQ(floorAt("60.5"), (Colour{200, 0, 0, 255}));
}

TEST(RenderProgram, DrawsAnyEyeMapAndOptions) {
    const TestFolder folder;
    const Finished finished =
        render({kEveryFeature, "--map", "yard", "--eye", "-1.25,0.5,0.75,12.5,0.25", "--size",
                "64x48", "--fov", "75", "--set", "light=off", "--set", "detail=off", "--out",
                (folder / "yard.png").string()});
    EXPECT_EQ(finished.status, 0) << finished.err;
    LoadedScene scene = readSceneFile(kEveryFeature);
    Session session(std::move(*scene.world));
    ASSERT_EQ(session.world().maps[1].name, "yard");
    ASSERT_TRUE(session.setEye(
        {1, toCoordinate(-1.25), toCoordinate(0.5), toCoordinate(0.75), 12.5, 0.25}));
    const Image plain = drawn(session, 64, 48);
    for (const auto& [name, value] : {std::pair{"fov", "75"}, {"light", "off"}, {"detail", "off"}})
        EXPECT_EQ(session.setOption(name, value), "");
    const Image picture = readPicture(folder / "yard.png");
    EXPECT_EQ(picture.pixels, drawn(session, 64, 48).pixels);
    EXPECT_NE(picture.pixels, plain.pixels);
}

TEST(RenderProgram, PrintsTheHitsOfAColumn) {
    const TestFolder folder;
    const Finished finished = render({corridor(folder), "--eye", "1.5,2.5,0.5,0,0", "--fov", "90",
                                      "--size", "64x64", "--hits", "32"});
    ASSERT_EQ(finished.status, 0) << finished.err;
    rapidjson::Document json;
    ASSERT_FALSE(
        json.Parse<rapidjson::kParseFullPrecisionFlag>(finished.out.c_str()).HasParseError())
        << finished.out;

    // Half the width is the distance to the projection plane, so this column's rays run 1/64 aside.
    EXPECT_EQ(json["map"], "corridor");
    EXPECT_EQ(json["column"].GetInt(), 32);
    EXPECT_EQ(json["projectionDistance"].GetDouble(), 32.0);
    EXPECT_EQ(json["horizonRow"].GetDouble(), 32.0);
    EXPECT_EQ(json["ray"][0].GetDouble(), 1.0);
    EXPECT_EQ(json["ray"][1].GetDouble(), 1.0 / 64.0);
    ASSERT_GE(json["tiles"].Size(), 2u);
    EXPECT_EQ(json["tiles"][0][0].GetInt(), 1);  // the eye's own
    EXPECT_EQ(json["tiles"][0][1].GetInt(), 2);
    EXPECT_EQ(json["tiles"][1][0].GetInt(), 2);
    EXPECT_EQ(json["tiles"][1][2].GetDouble(), 0.5);
    ASSERT_EQ(json["hits"].Size(), 1u);
    const auto& hit = json["hits"][0];
    EXPECT_EQ(hit["map"], "corridor");
    EXPECT_EQ(hit["tile"][0].GetInt(), 4);
    EXPECT_EQ(hit["tile"][1].GetInt(), 2);
    EXPECT_EQ(hit["level"].GetInt(), 0);
    EXPECT_EQ(hit["blueprint"], "wall");
    EXPECT_EQ(hit["face"], "west");
    EXPECT_EQ(hit["point"][0].GetDouble(), 4.0);
    EXPECT_EQ(hit["point"][1].GetDouble(), 2.5 + 2.5 / 64.0);
    EXPECT_NEAR(hit["rawDepth"].GetDouble(), 2.5 * std::sqrt(1.0 + 1.0 / 4096.0), 1e-12);
    EXPECT_NEAR(hit["depth"].GetDouble(), 2.5, 1e-12);
    EXPECT_NEAR(hit["backDepth"].GetDouble(), 3.5, 1e-12);
    EXPECT_EQ(hit["bottom"].GetDouble(), 0.0);
    EXPECT_EQ(hit["top"].GetDouble(), 1.0);
    EXPECT_NEAR(hit["topFrontRow"].GetDouble(), 32.0 - 16.0 / 2.5, 1e-12);
    EXPECT_NEAR(hit["bottomFrontRow"].GetDouble(), 32.0 + 16.0 / 2.5, 1e-12);
    EXPECT_NEAR(hit["topBackRow"].GetDouble(), 32.0 - 16.0 / 3.5, 1e-12);
    EXPECT_NEAR(hit["bottomBackRow"].GetDouble(), 32.0 + 16.0 / 3.5, 1e-12);
    ASSERT_EQ(hit["filled"].Size(), 1u);
    EXPECT_EQ(hit["filled"][0]["what"], "side");
    EXPECT_EQ(hit["filled"][0]["face"], "west");
    EXPECT_EQ(hit["filled"][0]["first"].GetInt(),
              26);  // centres 26.5 to 37.5 lie between 25.6 and 38.4
    EXPECT_EQ(hit["filled"][0]["last"].GetInt(), 37);
    ASSERT_EQ(json["planes"].Size(), 2u);
    EXPECT_EQ(json["planes"][0]["what"], "floor");
    EXPECT_EQ(json["planes"][0]["first"].GetInt(), 38);
    EXPECT_EQ(json["planes"][0]["last"].GetInt(), 63);
    EXPECT_EQ(json["planes"][1]["what"], "sky");
    EXPECT_EQ(json["planes"][1]["first"].GetInt(), 0);
    EXPECT_EQ(json["planes"][1]["last"].GetInt(), 25);
}

TEST(RenderProgram, PrintsTheTraceOfAColumnOrOfAll) {
    const TestFolder folder;
    const std::string scene = corridor(folder);
    rapidjson::Document json;
    const Finished column = render(
        {scene, "--eye", "1.5,2.5,0.5,0,0", "--fov", "90", "--size", "64x64", "--trace", "32"});
    ASSERT_EQ(column.status, 0) << column.err;
    ASSERT_FALSE(json.Parse(column.out.c_str()).HasParseError()) << column.out;
    EXPECT_EQ(json["walk"][1]["depth"].GetDouble(), 0.5);
    EXPECT_EQ(json["runs"][0]["what"], "floor");
    EXPECT_EQ(json["runs"][1]["what"], "side");
    EXPECT_NEAR(json["runs"][1]["texels"][0]["depth"].GetDouble(), 2.5, 1e-12);
    const Finished all =
        render({scene, "--eye", "1.5,2.5,0.5,0,0", "--size", "64x48", "--trace", "all"});
    ASSERT_EQ(all.status, 0) << all.err;
    ASSERT_FALSE(json.Parse(all.out.c_str()).HasParseError()) << all.out;
    EXPECT_EQ(json["columns"]["nearest"].Size(), 64u);
    EXPECT_EQ(json["totals"]["rowsFilled"].GetInt(), 64 * 48);
}

TEST(RenderProgram, PrintsNullForInfiniteNumbers) {
    const TestFolder folder;
    const Finished finished =
        render({corridor(folder), "--eye", "0.5,3.5,0.5,0,0", "--size", "64x64", "--hits", "32"});
    ASSERT_EQ(finished.status, 0) << finished.err;
    rapidjson::Document json;
    ASSERT_FALSE(json.Parse(finished.out.c_str()).HasParseError()) << finished.out;
    ASSERT_GE(json["hits"].Size(), 1u);
    const auto& own = json["hits"][0];
    EXPECT_EQ(own["blueprint"], "step");
    EXPECT_TRUE(own["face"].IsNull());
    EXPECT_EQ(own["depth"].GetDouble(), 0.0);
    EXPECT_TRUE(own["topFrontRow"].IsNull());
    EXPECT_TRUE(own["bottomFrontRow"].IsNull());
    EXPECT_TRUE(own["topBackRow"].IsDouble());
}

struct WrongUse {
    std::vector<std::string> arguments;
    std::string says;
};

TEST(RenderProgram, ReportsFaultsOfTheCommandLine) {
    const TestFolder folder;
    const std::string out = (folder / "picture.png").string();
    const std::vector<WrongUse> uses = {
        {{}, "SCENE is required"},
        {{kEveryFeature}, "expected --out PICTURE.png, --hits COLUMN or --trace COLUMN"},
        {{kEveryFeature, "--out", out, "--size", "64"}, "found \"64\", expected WxH in pixels"},
        {{kEveryFeature, "--out", out, "--size", "0x5"}, "found \"0x5\""},
        {{kEveryFeature, "--out", out, "--size", "8193x5"}, "8192x8192"},
        {{kEveryFeature, "--out", out, "--size", "64x48 "}, "found \"64x48 \""},
        {{kEveryFeature, "--out", out, "--fov", "200"},
         "Option 'fov' takes a number from 10 to 150, not '200'."},
        {{kEveryFeature, "--out", out, "--set", "lights=on"},
         "Unknown option 'lights'. Did you mean 'light'?"},
        {{kEveryFeature, "--out", out, "--set", "light"}, "found \"light\", expected OPTION=VALUE"},
        {{kEveryFeature, "--out", out, "--map", "cellar"},
         "found \"cellar\", expected a map of this scene: \"hall\", \"yard\", \"works\", "
         "\"plain\", \"gallery\""},
        {{kEveryFeature, "--out", out, "--map", "yard"}, "add --eye"},
        {{kEveryFeature, "--out", out, "--eye", "1,1,0.5,0"},
         "expected five numbers X,Y,Z,HEADING,LOOK"},
        {{kEveryFeature, "--out", out, "--eye", "1,1,0.5,0,0,0"}, "expected five numbers"},
        {{kEveryFeature, "--out", out, "--eye", "1,north,0.5,0,0"},
         "Y: found \"north\", expected a number"},
        {{kEveryFeature, "--out", out, "--eye", "1,nan,0.5,0,0"}, "Y: found \"nan\""},
        {{kEveryFeature, "--out", out, "--eye", "1,1,0,0,0"},
         "an eye at or below the floor sees nothing"},
        {{kEveryFeature, "--out", out, "--eye", "1,1,-2,0,0"}, "found -2"},
        {{kEveryFeature, "--out", out, "--eye", "1,1,0.5,0,4.5"},
         "LOOK: found \"4.5\", expected a number from -4 to 4"},
        {{kEveryFeature, "--out", out, "--time", "-1"},
         "found \"-1\", expected seconds, from 0 to 3600"},
        {{kEveryFeature, "--out", out, "--time", "3601"}, "found \"3601\""},
        {{kEveryFeature, "--out", out, "--time", "soon"}, "found \"soon\""},
        {{kEveryFeature, "--hits", "64", "--size", "64x48"},
         "found \"64\", expected a column of the picture, 0 to 63"},
        {{kEveryFeature, "--hits", "-1"}, "0 to 1279"},
        {{kEveryFeature, "--hits", "middle"}, "found \"middle\""},
        {{kEveryFeature, "--trace", "64", "--size", "64x48"},
         "--trace: found \"64\", expected a column of the picture, 0 to 63"},
        {{kEveryFeature, "--trace", "1", "--hits", "1"}, "--hits"},
        {{kEveryFeature, "--out", out, "--quick"}, "--quick"},
    };
    for (const WrongUse& use : uses) {
        const Finished finished = render(use.arguments);
        EXPECT_EQ(finished.status, 2) << use.says;
        EXPECT_NE(finished.err.find(use.says), std::string::npos)
            << use.says << "\nnot in: " << finished.err;
        EXPECT_EQ(finished.out, "") << use.says;
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(RenderProgram, LeavesNoFilesIfItCannotWrite) {
    const TestFolder folder;
    std::filesystem::create_directory(folder / "taken.png");
    EXPECT_EQ(render({kEveryFeature, "--out", (folder / "taken.png").string()}).status, 1);
    EXPECT_EQ(
        render({kEveryFeature, "--out", (folder / "no such folder/picture.png").string()}).status,
        1);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"taken.png"});
}

TEST(RenderProgram, ReportsTheFaultsOfAScene) {
    const TestFolder folder;
    const std::string broken = SLICECAST_SOURCE_FOLDER "/tests/scene/broken/several-faults.json";
    const Finished finished = render({broken, "--out", (folder / "picture.png").string()});
    EXPECT_EQ(finished.status, 1);
    EXPECT_EQ(finished.err.find(broken + ":"), 0u) << finished.err;
    EXPECT_TRUE(folder.names().empty());
}

TEST(RenderProgram, HasHelp) {
    const Finished finished = render({"--help"});
    EXPECT_EQ(finished.status, 0);
    for (const char* word : {"--map", "--eye", "--time", "--size", "--fov", "--set", "--hits",
                             "--trace", "--out", "Examples:"}) {
        EXPECT_NE(finished.out.find(word), std::string::npos) << word;
    }
    for (const OptionInfo& option : knownOptions())
        EXPECT_NE(finished.out.find("  " + std::string(option.name) + " "), std::string::npos)
            << option.name;
    EXPECT_NE(finished.out.find(": plane, equalAngles, equalAnglesCorrected (plane)\n"),
              std::string::npos)
        << "the words of a choice";
}

// A recording of the corridor: ahead until the wall, then about.
std::string corridorWalk(const TestFolder& folder) {
    LoadedScene scene = readSceneFile(corridor(folder));
    Session session(std::move(*scene.world));
    Recorder recorder("corridor");
    session.record(&recorder);
    for (int i = 0; i < 50; ++i) session.step({.forward = 1.0});
    recorder.mark("half-way", session);
    for (int i = 0; i < 50; ++i) session.step({.turnDegrees = 1.5});
    const std::string path = (folder / "walk.txt").string();
    writeText(path, writeRecording(recorder.finish(session)));
    return path;
}

TEST(RenderProgram, PlaysARecordingUpToAStepOrAMark) {
    const TestFolder folder;
    const std::string walk = corridorWalk(folder);
    const std::string scene = (folder / "corridor.json").string();
    const std::string out = (folder / "view.png").string();
    const auto viewAfter = [&](int ahead, int turned) {
        LoadedScene read = readSceneFile(scene);
        Session session(std::move(*read.world));
        for (int i = 0; i < ahead; ++i) session.step({.forward = 1.0});
        for (int i = 0; i < turned; ++i) session.step({.turnDegrees = 1.5});
        return drawn(session, 64, 40);
    };
    const auto view = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments = {scene,   "--replay", walk, "--size",
                                              "64x40", "--out",    out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished finished = render(arguments);
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_EQ(finished.out + finished.err, "");
        return readPicture(out);
    };
    EXPECT_EQ(view({}).pixels, viewAfter(50, 50).pixels);
    EXPECT_EQ(view({"--at", "0"}).pixels, viewAfter(0, 0).pixels);
    EXPECT_EQ(view({"--at", "31"}).pixels, viewAfter(31, 0).pixels);
    EXPECT_EQ(view({"--at", "half-way"}).pixels, viewAfter(50, 0).pixels);
    EXPECT_EQ(view({"--at", "99"}).pixels, viewAfter(50, 49).pixels);
}

TEST(RenderProgram, RefusesARecordingThatDoesNotFit) {
    const TestFolder folder;
    const std::string walk = corridorWalk(folder);
    const std::string scene = (folder / "corridor.json").string();
    const std::string out = (folder / "view.png").string();
    struct Refusal {
        std::vector<std::string> arguments;
        int status;
        std::string words;
    };
    const std::string broken = (folder / "broken.txt").string();
    writeText(broken, "slicecast recording 1\nscene corridor\n5 run\nend 5 0123456789abcdef\n");
    const std::string elsewhere = (folder / "elsewhere.txt").string();
    writeText(elsewhere, "slicecast recording 1\nscene corridor\n5\nend 5 0123456789abcdef\n");
    const std::vector<Refusal> refusals = {
        {{scene, "--replay", walk, "--at", "101"},
         2,
         "--at: found \"101\", expected a step from 0 to 100 or one of the marks half-way"},
        {{scene, "--replay", walk, "--at", "there"}, 2, "--at: found \"there\""},
        {{scene, "--at", "7"}, 2, "--replay"},
        {{scene, "--replay", walk, "--eye", "1.5,2.5,0.5,0,0"},
         2,
         "cannot be used with --eye or --map"},
        {{kEveryFeature, "--replay", walk},
         2,
         "found a recording of the scene \"corridor\", expected one of \"everything\""},
        {{scene, "--replay", (folder / ".").string()},
         1,
         "found a path that is a folder, expected a recording"},
        {{scene, "--replay", broken}, 1, "broken.txt:3:3: found \"run\""},
        {{scene, "--replay", elsewhere}, 1, "ends elsewhere"},
    };
    for (const Refusal& refusal : refusals) {
        std::vector<std::string> arguments = refusal.arguments;
        arguments.insert(arguments.end(), {"--out", out});
        const Finished finished = render(arguments);
        EXPECT_EQ(finished.status, refusal.status) << finished.err;
        EXPECT_NE((finished.out + finished.err).find(refusal.words), std::string::npos)
            << finished.out << finished.err;
        EXPECT_FALSE(std::filesystem::exists(out));
    }
}

}  // namespace
}  // namespace slicecast
