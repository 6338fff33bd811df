// Levels that are filled or repeated, and maps that give their size.
#include "base/random.h"
#include "scene/limits.h"
#include "scene/scene_files.h"
#include "world/blueprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace slicecast {
namespace {

// The cells of the first map, level by level, as rows of '#', 's' and '.'.
std::vector<std::vector<std::string>> cellsOf(const World& world) {
    const Map& map = world.maps[0];
    std::vector<std::vector<std::string>> levels;
    for (int level = 0; level < map.levels; ++level) {
        levels.emplace_back();
        for (int y = 0; y < map.depth; ++y) {
            std::string row;
            for (int x = 0; x < map.width; ++x) {
                const BlueprintId id = map.cell(x, y, level);
                EXPECT_EQ(map.isOccupied(x, y, level), id != kEmptyCell);
                row += id == kEmptyCell ? '.' : world.blueprints[id].name == "wall" ? '#' : 's';
            }
            levels.back().push_back(row);
        }
    }
    return levels;
}

std::string sceneOf(const std::string& levels, const std::string& more = "") {
    std::string text = smallScene(levels, R"("legend": { "s": "slab" })" + more);
    text.insert(text.rfind("1.5 }") + 3, ", \"z\": 40");  // above all blocks
    const std::string wall = R"("wall": { "faces": "brick" })";
    return text.insert(text.find(wall), R"("slab": { "top": 0.25, "faces": "brick" }, )");
}

std::vector<std::vector<std::string>> read(const std::string& levels,
                                           const std::string& more = "") {
    const LoadedScene loaded = loadText(sceneOf(levels, more));
    EXPECT_EQ(inWords(loaded.faults), "");
    if (!loaded.world) return {};
    return cellsOf(*loaded.world);
}

using Levels = std::vector<std::vector<std::string>>;

TEST(Levels, AreFilledByOneCharacter) {
    EXPECT_EQ(read(R"([[], { "fill": "s" }])", R"(, "size": [3, 2])"),
              (Levels{{"...", "..."}, {"sss", "sss"}}));
    EXPECT_EQ(read(R"([{ "fill": "." }, { "fill": " " }])", R"(, "size": [3, 3])"),
              (Levels{{"...", "...", "..."}, {"...", "...", "..."}}));
}

TEST(Levels, AreFilledByRectanglesInTheirOrder) {
    const std::string fill = R"({ "fill": [
        { "character": "#", "x": 0, "y": 0, "width": 4, "depth": 3 },
        { "character": ".", "x": 1, "y": 1, "width": 2 },
        { "character": "s", "x": 2, "y": 1 }] })";
    EXPECT_EQ(read("[" + fill + "]", R"(, "size": [5, 4])"),
              (Levels{{"####.", "#.s#.", "####.", "....."}}));
}

TEST(Levels, HaveRowsOverWhatFillsThem) {
    EXPECT_EQ(read(R"([{ "fill": "#", "rows": ["    ", " .. ", " .s "] }])"),
              (Levels{{"####", "#..#", "#.s#"}}));
    EXPECT_EQ(read(R"([{ "fill": [], "rows": ["###", "#. "] }, { "fill": "s", "rows": [] }])"),
              (Levels{{"###", "#.."}, {"sss", "sss"}}));
}

TEST(Levels, AreRepeatedUpward) {
    EXPECT_EQ(
        read(R"([["###", "..."], { "repeat": 2, "levels": [{ "fill": "s" }, [], ["#..", "   "]] },
                 ["..#", "..."]])"),
        (Levels{{"###", "..."},
                {"sss", "sss"},
                {"...", "..."},
                {"#..", "..."},
                {"sss", "sss"},
                {"...", "..."},
                {"#..", "..."},
                {"..#", "..."}}));
    EXPECT_EQ(read(R"([["...", "..."], { "repeat": 1, "levels": [["###", "..."]] }])").size(), 2u);
}

TEST(Levels, AreTheSameAsTheirRows) {
    Random random(7);
    for (int round = 0; round < 40; ++round) {
        const int width = random.between(3, 9);
        const int depth = random.between(3, 9);
        Levels rows;
        std::string text;
        for (int level = random.between(1, 5); level > 0; --level) {
            const char base = ".s#"[random.below(3)];
            std::vector<std::string> whole(static_cast<std::size_t>(depth),
                                           std::string(static_cast<std::size_t>(width), base));
            std::string over;
            for (std::string& row : whole) {
                std::string line(row.size(), ' ');
                for (std::size_t x = 0; x < row.size(); ++x) {
                    if (random.oneIn(3)) row[x] = line[x] = ".s#"[random.below(3)];
                }
                over += (over.empty() ? "\"" : ", \"") + line + "\"";
            }
            const int times = random.between(1, 3);
            for (int i = 0; i < times; ++i) rows.push_back(whole);
            const std::string filled =
                R"({ "fill": ")" + std::string(1, base) + R"(", "rows": [)" + over + "] }";
            text += (text.empty() ? "" : ", ") + (times == 1
                                                      ? filled
                                                      : R"({ "repeat": )" + std::to_string(times) +
                                                            R"(, "levels": [)" + filled + "] }");
        }
        const LoadedScene loaded = loadText(sceneOf("[" + text + "]"));
        ASSERT_TRUE(loaded.world) << inWords(loaded.faults);
        EXPECT_EQ(cellsOf(*loaded.world), rows) << text;
    }
}

TEST(Levels, CountAfterTheyAreRepeated) {
    const std::string levels = R"([{ "repeat": 3, "levels": [{ "fill": "s" }, []] }])";
    const auto portal = [&](int level) {
        return parseScene(
                   sceneOf(levels,
                           R"(, "size": [4, 4], "portals": [{ "x": 2, "y": 2,
            "level": )" + std::to_string(level) +
                               R"(, "face": "top", "to": { "x": 3, "y": 3, "level": 5 } }])"),
                   "test.json")
            .faults;
    };
    EXPECT_EQ(inWords(portal(4)), "");
    const std::vector<Fault> none = portal(5);
    ASSERT_EQ(none.size(), 1u);
    EXPECT_EQ(none[0].found, "no block at x 2, y 2, level 5");
}

TEST(Levels, AreAtMostSoMany) {
    const auto faults = [](int times) {
        return parseScene(sceneOf(R"([[], { "repeat": )" + std::to_string(times) +
                                      R"(, "levels": [[]] }])",
                                  R"(, "size": [3, 3])"),
                          "test.json")
            .faults;
    };
    EXPECT_EQ(inWords(faults(kMaxLevels - 1)), "");
    ASSERT_EQ(faults(kMaxLevels).size(), 1u);
    EXPECT_EQ(faults(kMaxLevels)[0].found, "33 levels");
}

TEST(Levels, FillAtMostSoManyCells) {
    const auto faults = [](const std::string& levels, int width, int depth) {
        const std::string size =
            R"(, "size": [)" + std::to_string(width) + ", " + std::to_string(depth) + "]";
        return inWords(parseScene(sceneOf(levels, size), "test.json").faults);
    };
    EXPECT_EQ(faults("[[]]", 500, 500), "");
    EXPECT_NE(faults("[[]]", 500, 501), "");
    EXPECT_EQ(faults(R"([{ "fill": "s" }])", 500, 500), "");
    EXPECT_EQ(faults(R"([{ "repeat": 10, "levels": [{ "fill": "s" }] }])", 250, 100), "");
    EXPECT_NE(faults(R"([{ "repeat": 11, "levels": [{ "fill": "s" }] }])", 250, 100), "");
    EXPECT_EQ(faults(R"([{ "repeat": 32, "levels": [[]] }])", 500, 500), "") << "empty ones";
    // What a text spells out is not bound by this
    std::string rows;
    for (int y = 0; y < 600; ++y) rows += (y > 0 ? ",\"" : "\"") + std::string(600, '.') + "\"";
    EXPECT_EQ(inWords(parseScene(smallScene("[[" + rows + "]]"), "test.json").faults), "");
    EXPECT_NE(
        inWords(parseScene(smallScene("[" + (R"({ "repeat": 2, "levels": [[)" + rows) + "]] }]"),
                           "test.json")
                    .faults),
        "");
}

// A hostile text: nothing is allocated for it, and it is read at once.
TEST(Levels, AreCountedBeforeTheyAreMade) {
    std::string many = R"({ "repeat": 32, "levels": [)";
    for (int i = 0; i < 10'000; ++i) many += (i > 0 ? ",[]" : "[]");
    const std::vector<Fault> faults =
        parseScene(sceneOf("[" + many + "] }, " + many + "] }]", R"(, "size": [4096, 4096])"),
                   "test.json")
            .faults;
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].found, "640000 levels");
}

}  // namespace
}  // namespace slicecast
