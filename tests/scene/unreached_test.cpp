// What nobody can get to on foot.
#include "scene/unreached.h"
#include "scene/scene_files.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

// The warnings after changes of the scene's text, without what is expected.
std::string unreachedAfter(std::initializer_list<std::pair<const char*, const char*>> changes) {
    std::string text = readText(sceneTestFolder() / "unreached.json");
    for (const auto& [from, to] : changes) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, std::string_view(from).size(), to);
    }
    const LoadedScene loaded = loadText(text);
    EXPECT_EQ(inWords(loaded.faults), "");
    EXPECT_EQ(inWords(loaded.warnings), "");
    std::string lines;
    for (const Fault& warning : findUnreached(loaded)) {
        const std::string line = describe(warning);
        lines += line.substr(0, line.find(", expected a way to it from the start")) + "\n";
    }
    return lines;
}

TEST(Unreached, IsFoundWhereTheFileStatesIt) {
    EXPECT_EQ(
        unreachedAfter({}),
        R"(test.json:11:51 (/blueprints/door/gate): found a gate at x 10, y 1 of the map "yard" that nobody can open on foot; the nearest place that one gets to is x 5.5, y 1.5, z 0.00
test.json:24:72 (/maps/0/objects/1/find): found a find "coin" that nobody can reach on foot; the nearest place that one gets to is x 5.5, y 1.5, z 0.00
test.json:25:72 (/maps/0/objects/2/find): found a find "key" that nobody can reach on foot; the nearest place that one gets to is x 5.5, y 2.5, z 0.00
test.json:26:22 (/maps/0/objects/2/message): found a message that nobody can come near on foot; the nearest place that one gets to is x 5.5, y 2.5, z 0.00
test.json:29:9 (/maps/0/sow/0): found sown finds "berry" of which nobody can reach 1 of 2 on foot
test.json:33:9 (/maps/0/messages/1): found a message that nobody can come near on foot; the nearest place that one gets to is x 5.5, y 1.5, z 0.00
test.json:40:82 (/maps/1/objects/0/find): found a find "coin" that nobody can reach on foot; nobody gets into the map "loft" on foot
test.json:44:50 (/game/at): found a goal that nobody can reach on foot; the nearest place that one gets to is x 5.5, y 1.5, z 0.00
)");
}

TEST(Unreached, IsNothingWhereThereIsAWay) {
    const std::pair<const char*, const char*> way = {"#...d.###.d#", "#...d.....d#"};
    const std::pair<const char*, const char*> loft = {
        R"("sow": [)", R"("portals": [{ "x": 1, "y": 2, "to": { "map": "loft", "x": 0, "y": 0 } }],
      "sow": [)"};
    EXPECT_EQ(unreachedAfter({way, loft}), "");
    EXPECT_EQ(
        unreachedAfter({way}),
        R"(test.json:40:82 (/maps/1/objects/0/find): found a find "coin" that nobody can reach on foot; nobody gets into the map "loft" on foot
)") << "number keys lead to what else is in the loft";
}

TEST(Unreached, MayBeABlockThatStandsNowhere) {
    const std::string lines = unreachedAfter(
        {{R"("blueprints": {)", R"("blueprints": { "spare": { "faces": "brick" },)"}});
    EXPECT_EQ(lines.substr(0, lines.find('\n')),
              "test.json:8:28 (/blueprints/spare): found a blueprint that stands in no map, "
              "expected its letter of the legend in the rows of a level");
}

TEST(Unreached, MayBeAPlaceThatNothingNames) {
    const std::pair<const char*, const char*> place = {
        R"("name": "yard",)", R"("name": "yard", "places": { "well": { "x": 1.5, "y": 1.5 } },)"};
    EXPECT_NE(
        unreachedAfter({place}).find("(/maps/0/places/well): found a place that nothing names"),
        std::string::npos);
    EXPECT_EQ(
        unreachedAfter({place, {R"("map": "yard", "x": 1.5, "y": 1.5)", R"("place": "well")"}})
            .find("/places"),
        std::string::npos);
}

// The places of what nothing uses, and what it is.
std::string sparesOf(const std::string& head, const std::string& map) {
    const LoadedScene loaded = loadText(R"({ "title": "Spares",
        "textures": { "brick": "broken/images/brick.png", "tile": "broken/images/tile.png" },
        "motions": { "up": { "moves": "top", "from": -0.5, "to": 0, "period": 8 } },
        "blueprints": { "wall": { "faces": "brick" },
                        "lift": { "faces": "brick", "motion": "up" } },)" +
                                        head + R"("maps": [{ "name": "room",)" + map + R"( }],
        "start": { "x": 1.5, "y": 1.5 } })");
    EXPECT_EQ(inWords(loaded.faults), "");
    std::string lines;
    for (const Fault& warning : findUnreached(loaded))
        lines += warning.pointer + ": " + warning.found + "\n";
    return lines;
}

TEST(Unreached, MayBeNamesThatNothingUses) {
    const std::string legend = R"("legend": { "#": "wall", "l": "lift" },)";
    const std::string levels = R"("levels": [["###", "#..", "##l"]])";
    EXPECT_EQ(sparesOf(legend, levels + R"(, "floor": "tile")"), "");
    EXPECT_EQ(sparesOf(legend, levels + R"(, "floor": "brick")"),
              "/textures/tile: a texture that nothing shows\n");
    const std::string sprites = R"("sprites": { "tile": "broken/images/tile.png" },)";
    EXPECT_EQ(sparesOf(legend + sprites, levels + R"(, "floor": "tile")"),
              "/sprites/tile: a sprite that nothing shows\n");
    EXPECT_EQ(sparesOf(legend + sprites, levels + R"(, "floor": "tile", "sow": [
                       { "sprite": "tile", "density": 0.5, "height": 0.5 }])"),
              "");
    EXPECT_EQ(sparesOf(R"("legend": { "#": "wall" },)",
                       R"("levels": [["###", "#..", "###"]], "floor": "tile")"),
              "/blueprints/lift: a blueprint that stands in no map\n")
        << "its motion has a blueprint";
}

TEST(Unreached, MayBeCharactersThatNoRowHas) {
    const auto lines = [](const std::string& legend, const std::string& levels,
                          const std::string& floor = R"("tile")") {
        return sparesOf(legend, "\"levels\": [" + levels + "], \"floor\": " + floor);
    };
    const std::string spare = ": a character of the legend that no row has\n";
    const std::string legend = R"("legend": { "#": "wall", "w": "wall", "l": "lift" },)";
    EXPECT_EQ(lines(legend, R"(["###", "#.l", "###"])"), "/legend/w" + spare);
    EXPECT_EQ(lines(legend, R"(["##w", "#.l", "###"])"), "");
    EXPECT_EQ(lines(legend, R"(["###", "#.l", "###"], { "fill": "w" })"), "");
    EXPECT_EQ(lines(legend, R"({ "fill": [{ "character": "w", "x": 0, "y": 0 }],
                                 "rows": ["  #", " .l", "   "] })"),
              "");
    EXPECT_EQ(lines(legend, R"(["###", "#.l", "###"],
                               { "repeat": 2, "levels": [["...", "..w", "..."]] })"),
              "");
    EXPECT_EQ(lines(R"("legend": { "#": "wall", "l": "lift", "x": "lift" },)",
                    R"(["##x", "#.#", "###"])"),
              "/legend/l" + spare);
    // A map's own one stands before that of all maps.
    const std::string ofMap = R"(, "legend": { "w": "wall", "v": "wall" })";
    EXPECT_EQ(sparesOf(legend, R"("levels": [["##w", "#.l", "###"]], "floor": "tile")" + ofMap),
              "/legend/w" + spare + "/maps/0/legend/v" + spare);
    EXPECT_EQ(lines(legend, R"(["##w", "#.l", "###"])",
                    R"({ "texture": "tile", "legend": { "b": "brick", "t": "tile" },
                         "tiles": ["   ", " b ", "   "] })"),
              "/maps/0/floor/legend/t" + spare);
}

TEST(Unreached, MayBeSpritesThatAreSheets) {
    const auto lines = [](const std::string& sprite) {
        return sparesOf(
            R"("legend": { "#": "wall", "l": "lift" }, "sprites": { "coin": )" + sprite + " },",
            R"("levels": [["###", "#..", "##l"]], "floor": "tile",
                           "objects": [{ "sprite": "coin", "x": 2.5, "y": 1.5, "height": 0.5 }])");
    };
    EXPECT_EQ(lines(R"("broken/images/sheet.png")"),
              "/sprites/coin: a picture so wide that it may be a sheet: all frames show at "
              "once\n");
    EXPECT_EQ(lines(R"({ "file": "broken/images/sheet.png", "frames": 3 })"), "");
    EXPECT_EQ(lines(R"("broken/images/not-square.png")"), "") << "twice as wide as high";
}

TEST(Unreached, MayBeObjectsInTheWayOfBlocks) {
    const auto lines = [](const std::string& place) {
        return sparesOf(R"("legend": { "#": "wall", "l": "lift" },
                           "sprites": { "coin": "broken/images/tile.png" },)",
                        R"("levels": [["###", "#..", "##l"]], "floor": "tile",
                           "objects": [{ "sprite": "coin", )" +
                            place + "}]");
    };
    EXPECT_EQ(lines(R"("x": 2.5, "y": 2.5, "z": 0.6, "height": 0.2)"),
              "/maps/0/objects/0: an object that the moving block \"lift\" passes through: it does "
              "not move along\n");
    EXPECT_EQ(lines(R"("x": 2.5, "y": 2.5, "z": 1, "height": 0.2)"), "") << "above it";
    EXPECT_EQ(lines(R"("x": 2.5, "y": 1.5, "z": 0.6, "height": 0.2)"), "") << "beside it";
}

TEST(Unreached, MayBeObjectsOnPaths) {
    const auto lines = [](const std::string& object) {
        return sparesOf(R"("legend": { "#": "wall", "l": "lift" },
                           "sprites": { "coin": "broken/images/tile.png" },)",
                        R"("levels": [["######", "#.....", "##l###"]], "floor": "tile",
                           "objects": [{ "sprite": "coin", "x": 2.5, "y": 1.5, "height": 0.7,
                               "motion": { "kind": "patrol", "speed": 1, "path": [
                                   { "x": 3, "y": 1.5 }, { "x": 5.5, "y": 1.5 }] } },
                               { "sprite": "coin", )" +
                            object + "}]");
    };
    EXPECT_EQ(lines(R"("x": 4.5, "y": 1.6, "height": 0.5)"),
              "/maps/0/objects/0/motion/path/1: a way to this point through the object at x 4.50, "
              "y 1.60: the figure walks through it\n");
    EXPECT_EQ(lines(R"("x": 4.5, "y": 1.8, "height": 0.5)"), "") << "beside the way";
    EXPECT_EQ(lines(R"("x": 4.5, "y": 1.6, "z": 0.8, "height": 0.5)"), "") << "overhead";
    EXPECT_EQ(lines(R"("x": 4.5, "y": 1.6, "height": 0.2)"), "") << "low";
}

TEST(Unreached, MayBeBakedLightThatIsDimmed) {
    const auto lines = [](const char* light) {
        const std::string baked = std::string(R"("name": "loft", "baked": {})") + light + ",";
        return unreachedAfter({{R"("name": "loft",)", baked.c_str()}});
    };
    EXPECT_NE(lines("").find("(/maps/1/baked): found baked light in a map whose \"light\" is on"),
              std::string::npos);
    EXPECT_NE(lines(R"(, "light": { "darkest": 0.5 })").find("/baked"), std::string::npos);
    EXPECT_EQ(lines(R"(, "light": { "on": false })").find("/baked"), std::string::npos);
}

TEST(Unreached, MayMove) {
    const std::string lines = unreachedAfter(
        {{R"("find": "key",)", R"("find": "key", "motion": { "kind": "wander", "speed": 1 },)"}});
    EXPECT_EQ(lines.find("(/maps/0/objects/2"), std::string::npos) << lines;
}

}  // namespace
}  // namespace slicecast
