// Scenes at and beyond the limits: refused before they take the memory, and quick to read up to
// there.
#include "scene/limits.h"

#include "base/image.h"
#include "sanitized.h"
#include "scene/json_tree.h"
#include "scene/scene_files.h"
#include "world/player.h"

#include <gtest/gtest.h>

#include <ctime>

namespace slicecast {
namespace {

// A level of empty tiles with a free start, as JSON.
std::string level(int width, int depth) {
    std::string rows = "[";
    const std::string row = "\"" + std::string(static_cast<std::size_t>(width), '.') + "\"";
    for (int y = 0; y < depth; ++y) rows += (y > 0 ? "," : "") + row;
    return rows + "]";
}

std::vector<Fault> faultsOf(const std::string& text) {
    return parseScene(text, "test.json").faults;
}

double secondsUsed() {  // of the processor
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

TEST(Limits, TheLargestMapIsReadInSeconds) {
    const std::string text = smallScene("[" + level(kMaxMapWidth, kMaxMapDepth) + "]");
    const double start = secondsUsed();
    ParsedScene parsed = parseScene(text, "test.json");
    const double seconds = secondsUsed() - start;
    EXPECT_EQ(inWords(parsed.faults), "");
    EXPECT_LT(seconds, kSanitized ? 40.0 : 4.0);
    const SceneFiles files = readSceneFiles(sceneTestFolder(), parsed);
    const LoadedScene loaded = loadScene(std::move(parsed), files);
    ASSERT_TRUE(loaded.world.has_value());
    EXPECT_EQ(loaded.world->maps[0].width, kMaxMapWidth);
    EXPECT_EQ(loaded.world->maps[0].depth, kMaxMapDepth);
}

// Texts that would take minutes if reading took quadratic time anywhere.
TEST(Limits, HostileTextsAreReadInSeconds) {
    const auto repeated = [](const std::string& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) all += (i > 0 ? "," : "") + text;
        return all;
    };
    // A legend's key of many different characters, in falling order
    std::string key;
    for (char32_t c = 0x10000 + 200000; c > 0x10000; --c) key += toUtf8(c);
    // Rows of every width, and then many more
    std::string rows;
    for (int width = 10000; width > 1; --width)
        rows += "\"" + std::string(static_cast<std::size_t>(width), '.') + "\",";
    // The keys of one object, a third of them twice
    std::string members;
    for (int i = 0; i < 300000; ++i)
        members += (i > 0 ? ",\"" : "\"") + std::to_string(i % 200000) + "\":0";
    const std::string texts[] = {
        smallScene(R"([["###", "#.#", "###"]])", "\"legend\": { \"" + key + "\": \"wall\" }"),
        "[" + repeated("9e307", 100000) + "]",
        smallScene("[[" + rows + repeated("\".\"", 400000) + "]]"),
        smallScene("[[" + repeated("\".\"", 400000) + "," + repeated("1", 1000) + "]]"),
        "{" + members + "}",
    };
    for (const std::string& text : texts) {
        const double start = secondsUsed();
        EXPECT_FALSE(faultsOf(text).empty());
        const double seconds = secondsUsed() - start;
        EXPECT_LT(seconds, kSanitized ? 20.0 : 2.0) << text.substr(0, 60);
    }
}

TEST(Limits, EmptyLevelsCountAsCells) {
    // 4096 x 4096 x 4 cells are more than 64 million; the text says so in a few bytes.
    const std::vector<Fault> faults =
        faultsOf(smallScene("[" + level(kMaxMapWidth, kMaxMapDepth) + ",[],[],[]]"));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].found.find("67108864 cells"), std::string::npos) << faults[0].found;
}

TEST(Limits, CellsAreCountedInAllMapsTogether) {
    const std::string first = "[" + level(4096, 2048) + ",[],[],[]]";  // 33.6 million
    const std::string second = R"("levels": [)" + level(4096, 2048) + ",[],[],[]]";
    const std::string text =
        smallScene(first, R"("far": 9 }, { "name": "other", "floor": "brick", )" + second);
    const std::vector<Fault> faults = faultsOf(text);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].pointer, "/maps/1/levels");
}

TEST(Limits, MapsOfOneCellMore) {
    EXPECT_EQ(faultsOf(smallScene("[" + level(kMaxMapWidth, 3) + "]")).size(), 0u);
    EXPECT_EQ(faultsOf(smallScene("[" + level(kMaxMapWidth + 1, 3) + "]")).size(), 1u);
    EXPECT_EQ(faultsOf(smallScene("[" + level(3, kMaxMapDepth) + "]")).size(), 0u);
    EXPECT_EQ(faultsOf(smallScene("[" + level(3, kMaxMapDepth + 1) + "]")).size(), 1u);
}

TEST(Limits, FilesAndValues) {
    EXPECT_EQ(faultsOf(std::string(kMaxSceneBytes + 1, ' ')).at(0).expected, "at most 134217728");
    std::string values = "[0";
    for (std::size_t i = 0; i < kMaxSceneValues; ++i) values += ",0";
    const std::vector<Fault> faults = faultsOf(values + "]");
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].found, "more than 2000000 values");
    EXPECT_GT(faults[0].column, static_cast<int>(kMaxSceneValues));
}

TEST(Limits, NamesTitlesAndLegends) {
    const auto withTexture = [](std::size_t length) {
        const std::string name(length, 'n');
        return R"({ "title": "T", "textures": { ")" + name +
               R"(": "broken/images/brick.png" }, "maps": [{ "name": "m", "floor": ")" + name +
               R"(", "levels": [["..", ".."]] }], "start": { "x": 1, "y": 1 } })";
    };
    EXPECT_EQ(faultsOf(withTexture(kMaxNameLength)).size(), 0u);
    EXPECT_EQ(faultsOf(withTexture(kMaxNameLength + 1)).size(),
              2u);  // where it is given, and where it is used

    const auto withLegend = [](std::size_t count) {
        std::string legend;
        for (std::size_t i = 0; i < count; ++i)
            legend += (i > 0 ? ", \"" : "\"") + std::string("\xe4") +
                      static_cast<char>(0x80 + i / 64) + static_cast<char>(0x80 + i % 64) +
                      "\": \"wall\"";
        return smallScene(R"([["###", "#.#", "###"]])", R"("legend": { )" + legend + " }");
    };
    EXPECT_EQ(faultsOf(withLegend(kMaxLegend)).size(), 0u);
    EXPECT_EQ(faultsOf(withLegend(kMaxLegend - 1)).size(), 0u);
    const std::string tooMany = withLegend(kMaxLegend);
    const std::size_t at = tooMany.rfind(": \"wall\" }");
    EXPECT_EQ(faultsOf(std::string(tooMany).insert(at + 8, ", \"x\": \"wall\"")).size(), 1u);
}

TEST(Limits, BoundTheFaultsThatAreListed) {
    std::string rows = "[";
    for (int y = 0; y < 1500; ++y) rows += y > 0 ? ",\"Q\"" : "\"Q\"";
    const std::vector<Fault> faults = faultsOf(smallScene("[" + rows + "]]"));
    ASSERT_EQ(faults.size(), kMaxFaults + 1);
    EXPECT_EQ(faults[0].row, 0);
    EXPECT_EQ(faults[999].row, 999);
    EXPECT_EQ(faults.back().found, "500 more faults");
    EXPECT_EQ(faults.back().line, 0);
}

TEST(Limits, BoundTheMissingImagesThatAreListed) {
    std::string textures;
    for (int i = 0; i < 1200; ++i)
        textures += "\"t" + std::to_string(i) + "\": \"" + std::to_string(i) + ".png\", ";
    std::string text = smallScene();
    text.insert(text.find("\"brick\": "), textures);
    const std::vector<Fault> faults = loadScene(parseScene(text, "test.json"), {}).faults;
    ASSERT_EQ(faults.size(), kMaxFaults + 1);
    EXPECT_EQ(faults[7].pointer, "/textures/t7");
    EXPECT_EQ(faults.back().found, "201 more faults");
}

TEST(Limits, AreThoseOfTheSchema) {
    const std::string text =
        readText(std::filesystem::path(SLICECAST_SOURCE_FOLDER) / "assets/scene.schema.json");
    const SourceText source(text);
    const ParsedJson json = parseJson(source);
    ASSERT_FALSE(json.fault.has_value());
    // The number behind a path of keys; -1 if there is none.
    const auto number = [&](std::initializer_list<std::string_view> path) {
        FoundValue value = json.tree.root();
        for (const std::string_view key : path) {
            if (value) value = value->find(key);
        }
        return value ? value->number() : -1.0;
    };
    EXPECT_EQ(number({"properties", "title", "maxLength"}), kMaxTitleLength);
    EXPECT_EQ(number({"properties", "textures", "maxProperties"}), kMaxTextures);
    EXPECT_EQ(number({"properties", "textures", "propertyNames", "maxLength"}), kMaxNameLength);
    EXPECT_EQ(number({"properties", "blueprints", "maxProperties"}), kMaxBlueprints);
    EXPECT_EQ(number({"properties", "maps", "maxItems"}), kMaxMaps);
    EXPECT_EQ(number({"definitions", "file", "maxLength"}), kMaxPathLength);
    EXPECT_EQ(number({"definitions", "legend", "maxProperties"}), kMaxLegend);
    EXPECT_EQ(number({"definitions", "rows", "maxItems"}), kMaxMapDepth);
    EXPECT_EQ(number({"definitions", "rows", "items", "maxLength"}), kMaxMapWidth);

    const auto ofMap = [&](std::string_view part, std::string_view key, std::string_view keyword) {
        return number({"definitions", "map", "properties", part, "properties", key, keyword});
    };
    const Map normal;
    EXPECT_EQ(number({"definitions", "map", "properties", "levels", "maxItems"}), kMaxLevels);
    EXPECT_EQ(number({"definitions", "map", "properties", "sow", "maxItems"}), kMaxSowings);
    EXPECT_EQ(number({"definitions", "objectMotion", "properties", "speed", "maximum"}),
              kMaxObjectSpeed);
    EXPECT_EQ(number({"definitions", "objectMotion", "properties", "reach", "maximum"}),
              kMaxObjectReach);
    EXPECT_EQ(number({"definitions", "map", "properties", "far", "maximum"}), kMaxFar);
    EXPECT_EQ(number({"definitions", "map", "properties", "far", "default"}), kDefaultFar);
    EXPECT_EQ(ofMap("ceiling", "height", "maximum"), kMaxHeight);
    EXPECT_EQ(ofMap("light", "intensity", "maximum"), kMaxIntensity);
    EXPECT_EQ(ofMap("light", "intensity", "default"), normal.light.intensity);
    EXPECT_EQ(ofMap("light", "multiplier", "maximum"), kMaxMultiplier);
    EXPECT_EQ(ofMap("light", "multiplier", "default"), normal.light.multiplier);
    EXPECT_EQ(ofMap("light", "darkest", "default"), normal.light.darkest);
    EXPECT_EQ(ofMap("light", "brightest", "default"), normal.light.brightest);
    EXPECT_EQ(ofMap("fog", "end", "maximum"), kMaxFar);
    EXPECT_EQ(number({"definitions", "slope", "maximum"}), kMaxSkySlope);
    EXPECT_EQ(number({"definitions", "slope", "default"}), normal.sky.slope);
    const auto ofSky = [&](const char* layer, const char* key, const char* what) {
        return number({"definitions", layer, "properties", key, what});
    };
    for (const char* disc : {"sun", "moon"}) {
        EXPECT_EQ(ofSky(disc, "size", "maximum"), kMaxDiscSize);
        EXPECT_EQ(ofSky(disc, "glow", "maximum"), kMaxGlow);
        EXPECT_EQ(ofSky(disc, "altitude", "maximum"), kMaxDiscAltitude);
        EXPECT_EQ(ofSky(disc, "altitude", "default"), SkyDisc().altitude);
    }
    EXPECT_EQ(ofSky("sun", "azimuth", "default"), SkyDisc().azimuth);
    EXPECT_EQ(ofSky("stars", "density", "default"), kNormalStars);
    EXPECT_EQ(ofSky("stars", "brightness", "default"), SkyStars().brightness);
    EXPECT_EQ(ofSky("clouds", "cover", "default"), SkyClouds().cover);
    EXPECT_EQ(ofSky("clouds", "speed", "default"), SkyClouds().speed);
    EXPECT_EQ(ofSky("clouds", "speed", "maximum"), kMaxCloudSpeed);
    EXPECT_EQ(ofSky("clouds", "size", "minimum"), kMinCloudSize);
    EXPECT_EQ(ofSky("clouds", "size", "maximum"), kMaxCloudSize);
    EXPECT_EQ(number({"definitions", "start", "properties", "z", "maximum"}), kMaxHeight);
    EXPECT_EQ(number({"definitions", "start", "properties", "heading", "maximum"}),
              kMaxStartHeading);
    EXPECT_EQ(number({"definitions", "start", "properties", "look", "maximum"}), kLookLimit);
}

// A scene with one map of so many tiles a side, over which something is sown.
std::string sownScene(int side, const std::string& sow) {
    const std::string row = "\"" + std::string(static_cast<std::size_t>(side), '.') + "\"";
    std::string rows = row;
    for (int y = 1; y < side; ++y) rows += "," + row;
    return R"({ "title": "Sown", "textures": { "brick": "broken/images/brick.png" },
               "sprites": { "bush": "broken/images/tile.png" },
               "maps": [ { "name": "map", "floor": "brick", "levels": [[)" +
           rows + R"(]], "sow": [)" + sow + R"(] } ], "start": { "x": 1.5, "y": 1.5 } })";
}

TEST(Limits, SownObjects) {
    const std::string bush = R"({ "sprite": "bush", "density": 1, "height": 1 })";
    const ParsedScene full = parseScene(sownScene(256, bush), "test.json");
    EXPECT_EQ(inWords(full.faults), "")
        << "one less than there are tiles: nothing is sown at the start";
    const ParsedScene over = parseScene(sownScene(257, bush), "test.json");
    ASSERT_EQ(over.faults.size(), 1u);
    EXPECT_EQ(over.faults[0].pointer, "/maps/0/sow/0");
    EXPECT_EQ(over.faults[0].found, "more than 65536 objects, counting those before");
    EXPECT_EQ(over.faults[0].expected, "at most 65536 in a scene");

    const std::string walkers =
        R"({ "sprite": "bush", "density": 1, "height": 1,
             "motion": { "kind": "wander", "speed": 1 } })";
    EXPECT_EQ(inWords(parseScene(sownScene(64, walkers), "test.json").faults), "");
    const ParsedScene crowd = parseScene(sownScene(65, walkers), "test.json");
    ASSERT_EQ(crowd.faults.size(), 1u);
    EXPECT_EQ(crowd.faults[0].pointer, "/maps/0/sow/0");
    EXPECT_EQ(crowd.faults[0].found, "more than 4096 moving objects, counting those before");
    EXPECT_EQ(crowd.faults[0].expected, "at most 4096 in a scene");

    // Each that is higher than a unit may reach into three levels
    static_assert(kMaxMovingLevels == 2 * kMaxMovingObjects);
    const std::string tall =
        R"({ "sprite": "bush", "density": 1, "height": 1.1,
             "motion": { "kind": "wander", "speed": 1 } })";
    EXPECT_EQ(inWords(parseScene(sownScene(45, tall), "test.json").faults), "");
    const ParsedScene taller = parseScene(sownScene(46, tall), "test.json");
    ASSERT_EQ(taller.faults.size(), 1u);
    EXPECT_EQ(taller.faults[0].pointer, "/maps/0/sow/0");
    EXPECT_EQ(taller.faults[0].found,
              "moving objects that reach into more than 8192 levels, counting those before");
    EXPECT_EQ(taller.faults[0].expected,
              "at most 8192 in a scene: each counts as two for each unit of its height");

    std::string kinds = bush;
    for (int i = 1; i < kMaxSowings; ++i) kinds += "," + bush;
    EXPECT_EQ(inWords(parseScene(sownScene(3, kinds), "test.json").faults), "");
    const ParsedScene many = parseScene(sownScene(3, kinds + "," + bush), "test.json");
    ASSERT_EQ(many.faults.size(), 1u);
    EXPECT_EQ(many.faults[0].found, "33 elements");
}

// Maps with the same clouds share them; each further shape would take 10 frames to make.
TEST(Limits, ShapesOfClouds) {
    const auto scene = [](int maps, int shapes) {
        std::string list;
        for (int i = 0; i < maps; ++i)
            list += std::string(i > 0 ? "," : "") + R"({ "name": "m)" + std::to_string(i) +
                    R"(", "levels": [["..", ".."]], "floor": "brick",
                       "sky": { "low": "#ffffff", "high": "#4070c0",
                                "clouds": { "seed": )" +
                    std::to_string(i % shapes) + " } } }";
        return R"({ "title": "Clouds", "textures": { "brick": "broken/images/brick.png" },
               "blueprints": {}, "legend": {}, "maps": [)" +
               list + R"(], "start": { "x": 1.5, "y": 1.5, "heading": 0 } })";
    };
    EXPECT_EQ(inWords(parseScene(scene(20, kMaxCloudShapes), "test.json").faults), "");
    const ParsedScene many = parseScene(scene(20, kMaxCloudShapes + 1), "test.json");
    ASSERT_FALSE(many.faults.empty());
    EXPECT_EQ(many.faults[0].pointer, "/maps/4/sky/clouds");
    EXPECT_EQ(many.faults[0].found, "clouds of more than 4 shapes");
    EXPECT_EQ(many.faults[0].expected, "at most 4 in a scene; equal \"seed\" and \"size\" are one");
}

TEST(Limits, MovingBlocks) {
    // Each tile of a chess board's white fields is a mover of its own
    const auto board = [](int side) {
        std::string rows;
        for (int y = 0; y < side; ++y) {
            rows += y > 0 ? ",\"" : "\"";
            for (int x = 0; x < side; ++x) rows += y > 1 && (x + y) % 2 == 0 ? 'b' : '.';
            rows += '"';
        }
        return R"({ "title": "Board", "textures": { "brick": "broken/images/brick.png" },
               "motions": { "m": { "moves": "both", "to": 0.5, "period": 1 } },
               "blueprints": { "b": { "top": 0.5, "faces": "brick", "motion": "m" } },
               "legend": { "b": "b" },
               "maps": [ { "name": "map", "floor": "brick", "levels": [[)" +
               rows + R"(]] } ], "start": { "x": 1.5, "y": 0.5 } })";
    };
    EXPECT_EQ(inWords(faultsOf(board(128))), "");
    const std::vector<Fault> faults = faultsOf(board(131));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].found, "more than 8192 moving blocks, of which those that touch are one");
    EXPECT_EQ(faults[0].expected, "at most 8192 in a scene");
}

TEST(Limits, ColoursAsTextures) {
    const auto scene = [](int colours) {
        std::string textures;
        for (int i = 0; i < colours; ++i) {
            constexpr const char* kDigits = "0123456789abcdef";
            textures += "\"t" + std::to_string(i) + "\": \"#00";
            for (int shift = 12; shift >= 0; shift -= 4) textures += kDigits[i >> shift & 15];
            textures += "\", ";
        }
        return R"({ "title": "Colours", "textures": { )" + textures +
               R"("again": "#000000" }, "maps": [ { "name": "map", "floor": "t0",
               "levels": [["..."]] } ], "start": { "x": 1.5, "y": 0.5 } })";
    };
    EXPECT_EQ(inWords(faultsOf(scene(kMaxPlainTextures))), "");
    const std::vector<Fault> faults = faultsOf(scene(kMaxPlainTextures + 1));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].pointer, "/textures/t2048");
    EXPECT_EQ(faults[0].found, "more than 2048 colours as textures");
    EXPECT_EQ(faults[0].expected, "at most 2048; equal colours count as one");
}

// A scene with two maps, each with so many objects.
std::string scatteredScene(int first, int second, const std::string& motion) {
    const auto objects = [&](int count) {
        const std::string one =
            R"({ "sprite": "bush", "x": 0.5, "y": 0.5, "height": 1)" + motion + "}";
        std::string all = one;
        for (int i = 1; i < count; ++i) all += "," + one;
        return all;
    };
    return R"({ "title": "Scattered", "textures": { "brick": "broken/images/brick.png" },
               "sprites": { "bush": "broken/images/tile.png" },
               "maps": [ { "name": "a", "floor": "brick", "levels": [["..."]], "objects": [)" +
           objects(first) +
           R"(] }, { "name": "b", "floor": "brick", "levels": [["..."]], "objects": [)" +
           objects(second) + R"(] } ], "start": { "map": "a", "x": 1.5, "y": 0.5 } })";
}

TEST(Limits, PlacedObjectsOfAllMapsTogether) {
    EXPECT_EQ(inWords(parseScene(scatteredScene(65535, 1, ""), "test.json").faults), "");
    const ParsedScene over = parseScene(scatteredScene(65535, 2, ""), "test.json");
    ASSERT_EQ(over.faults.size(), 1u);
    EXPECT_EQ(over.faults[0].pointer, "/maps/1/objects");
    EXPECT_EQ(over.faults[0].found, "65537 objects, counting those of earlier maps");
    EXPECT_EQ(over.faults[0].expected, "at most 65536 in a scene");

    const std::string wander = R"(, "motion": { "kind": "wander", "speed": 1 })";
    EXPECT_EQ(inWords(parseScene(scatteredScene(4095, 1, wander), "test.json").faults), "");
    const ParsedScene crowd = parseScene(scatteredScene(4095, 3, wander), "test.json");
    ASSERT_EQ(crowd.faults.size(), 2u);
    EXPECT_EQ(crowd.faults[0].pointer, "/maps/1/objects/1");
    EXPECT_EQ(crowd.faults[0].found, "more than 4096 moving objects");
    EXPECT_EQ(crowd.faults[0].expected, "at most 4096 in a scene");
}

// A row of portal tiles. The first ones lead straight south and are one way; each of the others is
// a way of its own.
std::string sceneOfPortals(int parallel, int others) {
    const std::string row = '"' + std::string(1000, '.') + '"';
    std::string text = R"({"title": "t", "textures": {"a": "a.png"}, "blueprints": {},
        "maps": [{"name": "m", "floor": "a", "levels": [[)" +
                       row + ", " + row + ", " + row + R"(]], "portals": [)";
    for (int i = 0; i < parallel + others; ++i) {
        const int to = i < parallel ? i : 2 * i - parallel + 1;
        text += std::string(i == 0 ? "" : ", ") + R"({"x": )" + std::to_string(i) +
                R"(, "y": 0, "to": {"x": )" + std::to_string(to) + R"(, "y": 2}})";
    }
    return text + R"(]}], "start": {"x": 999.5, "y": 1.5}})";
}

TEST(Limits, WaysThroughPortals) {
    EXPECT_EQ(inWords(faultsOf(sceneOfPortals(40, 255))), "");
    const std::vector<Fault> faults = faultsOf(sceneOfPortals(40, 256));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].pointer, "/maps/0/portals/295");
    EXPECT_EQ(faults[0].found, "more than 256 different ways through portals");
}

TEST(Limits, ImagesOfAllMapsTogether) {
    // 32 maps that show one panorama of 2 million pixels have all that there may be; the texture is
    // too much.
    Image sky(2048, 1024);
    sky.pixels.assign(sky.pixels.size(), toPixel({120, 160, 220, 255}));
    constexpr int kMaps = 32;
    static_assert(kMaps * std::int64_t{2048} * 1024 == kMaxSceneTexels);
    std::string maps;
    for (int i = 1; i < kMaps; ++i) {
        maps += R"("sky": { "panorama": "sky.png" } }, { "name": "map )" + std::to_string(i) +
                R"(", "floor": "brick", "levels": [["."]], )";
    }
    ParsedScene parsed = parseScene(
        smallScene(R"([["...", "...", "..."]])", maps + R"("sky": { "panorama": "sky.png" })"),
        "test.json");
    EXPECT_EQ(inWords(parsed.faults), "");
    SceneFiles files = readSceneFiles(sceneTestFolder(), parsed);
    files["sky.png"] = encodePng(sky.pixels.data(), sky.width, sky.height, sky.width);
    const LoadedScene loaded = loadScene(std::move(parsed), files);
    ASSERT_EQ(loaded.faults.size(), 1u);
    EXPECT_EQ(loaded.faults[0].pointer, "/maps/31/sky/panorama");
}

}  // namespace
}  // namespace slicecast
