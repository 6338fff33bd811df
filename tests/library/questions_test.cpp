// What a game tells about its cells, rays and pixels, by the public headers alone.
#include <slicecast/slicecast.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A hall of 8 x 3 tiles and 2 levels, seen to the east: a wall half as high across it at x = 5,
// whose sign is two characters, before it a floor that mirrors, and behind it, on the map's last
// tile, a way to the attic.
Game hall() {
    LoadResult loaded = loadSceneText(R"({
  "title": "Hall", "textures": { "grey": "#808080", "red": "#c03020" },
  "motions": { "down": { "moves": "top", "to": -0.5 } },
  "blueprints": {
    "wall": { "top": 0.5, "faces": { "all": "grey", "top": { "texture": "red", "light": 0.5 } } },
    "ramp": { "top": [0.25, 0.5], "rise": "east", "faces": "grey" },
    "post": { "diagonal": "south-west", "faces": "red" },
    "gate": { "gate": {}, "motion": "down", "faces": "grey" }
  },
  "legend": { "❤️": "wall", "r": "ramp", "p": "post", "g": "gate" },
  "maps": [
    { "name": "hall", "levels": [[".....❤️..", ".....❤️..", ".....❤️.."], [".......r", "........", ".......p"]],
      "floor": { "texture": "grey", "mirror": 0.5 }, "sky": "#aaccff",
      "portals": [{ "x": 7, "y": 1, "to": { "map": "attic", "x": 0, "y": 0 } }] },
    { "name": "attic", "levels": [["..g"]], "floor": "red", "sky": "#aaccff" }
  ],
  "start": { "x": 1.5, "y": 1.5 }
})",
                                      "hall");
    for (const Fault& fault : loaded.faults) ADD_FAILURE() << describe(fault);
    return Game(std::move(loaded.scene).value());
}

TEST(Questions, TellsCellsAndTheirSigns) {
    Game game = hall();
    const std::string heart = "\u2764\ufe0f";
    using Rows = std::vector<std::string>;
    EXPECT_EQ(game.cells(0), (std::vector<Rows>{Rows(3, "....." + heart + ".."),
                                                Rows{".......r", "........", ".......p"}}));
    EXPECT_EQ(game.cell(0, 0, 5, 2), heart);
    EXPECT_EQ(game.cell(0, 0, 4, 2), ".");
    EXPECT_EQ(game.setCell(0, 1, 2, 0, heart), "");
    EXPECT_EQ(game.cells(0)[1][0], ".." + heart + "....r");
    EXPECT_EQ(game.setCell(0, 1, 2, 0, "."), "");
    EXPECT_EQ(game.cell(0, 1, 2, 0), ".");
    EXPECT_NE(game.setCell(0, 1, 2, 0, "\u2764"), "") << "without its second character";
    EXPECT_NE(game.setCell(0, 1, 2, 0, "\xff"), "") << "not UTF-8";
    EXPECT_TRUE(game.cells(2).empty());
    EXPECT_TRUE(game.cells(-1).empty());
    EXPECT_EQ(game.cell(0, 2, 0, 0), "");
    EXPECT_EQ(game.cell(0, 0, 8, 0), "");
    EXPECT_EQ(game.cell(0, 0, 0, -1), "");
    EXPECT_EQ(game.cell(2, 0, 0, 0), "");
}

TEST(Questions, TellsBlueprints) {
    const Game game = hall();
    const std::vector<Blueprint> blocks = game.blueprints(0);
    ASSERT_EQ(blocks.size(), 4u);
    EXPECT_EQ(blocks[0].sign, "\u2764\ufe0f");
    EXPECT_EQ(blocks[0].name, "wall");
    EXPECT_EQ(blocks[0].top, 0.5);
    EXPECT_FALSE(blocks[0].slopes);
    EXPECT_EQ(blocks[0].east, 1.0);
    EXPECT_EQ(blocks[0].diagonal, Half::none);
    const FaceLook& top = blocks[0].faces[static_cast<std::size_t>(Face::top)];
    EXPECT_EQ(top.texture, "red");
    EXPECT_EQ(top.colour, (Colour{0xc0, 0x30, 0x20, 255}));
    EXPECT_EQ(top.light, 0.5);
    EXPECT_EQ(blocks[0].faces[static_cast<std::size_t>(Face::west)].texture, "grey");
    ASSERT_TRUE(blocks[1].slopes);
    EXPECT_TRUE(blocks[1].slopes->alongX);
    EXPECT_EQ(blocks[1].slopes->top, (std::array<double, 2>{0.25, 0.5}));
    EXPECT_EQ(blocks[2].diagonal, Half::southWest);
    EXPECT_FALSE(blocks[2].isGate);
    EXPECT_TRUE(blocks[3].isGate);
    EXPECT_TRUE(game.blueprints(2).empty());
}

TEST(Questions, FollowsFreeRays) {
    const Game game = hall();
    const auto low = game.cast({.x = 1.5, .y = 1.5, .z = 0.25});
    ASSERT_TRUE(low);
    EXPECT_EQ(low->directionX, 1.0);
    EXPECT_EQ(low->directionY, 0.0);
    EXPECT_EQ(low->end, RayEnd::block);
    EXPECT_EQ(low->distance, 3.5);
    EXPECT_EQ(low->x, 5.0);
    EXPECT_EQ(low->tiles.size(), 5u);
    EXPECT_FALSE(low->tiles[0].entered);
    EXPECT_TRUE(low->tiles[1].entered);
    EXPECT_TRUE(low->tiles[1].alongX);
    EXPECT_EQ(low->tiles[1].distance, 0.5);
    EXPECT_EQ(low->tiles[1].nextX, 1.5);
    EXPECT_EQ(low->tiles[1].nextY, kInfinite);
    ASSERT_EQ(low->hits.size(), 1u);
    EXPECT_EQ(low->hits[0].block, "wall");
    EXPECT_EQ(low->hits[0].face, Face::west);
    EXPECT_EQ(low->hits[0].backDistance, 4.5);
    EXPECT_EQ(low->hits[0].top, 0.5);

    const auto over = game.cast({.x = 1.5, .y = 1.5});
    ASSERT_TRUE(over);
    EXPECT_EQ(over->end, RayEnd::edge);
    EXPECT_EQ(over->map, 1);
    ASSERT_EQ(over->portals.size(), 1u);
    EXPECT_EQ(over->portals[0].distance, 5.5);
    EXPECT_EQ(over->portals[0].ends.fromX, 7);
    EXPECT_EQ(over->portals[0].ends.toMap, 1);
    ASSERT_EQ(over->hits.size(), 2u);
    EXPECT_EQ(over->hits[1].block, "gate");
    EXPECT_EQ(over->hits[1].map, 1);
    EXPECT_EQ(over->hits[1].portals, 1);

    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const RayStart& from :
         {RayStart{.map = 2}, RayStart{.map = -1}, RayStart{.x = kNan}, RayStart{.y = 32768.0},
          RayStart{.z = kNan}, RayStart{.headingDegrees = kInfinite}})
        EXPECT_FALSE(game.cast(from));
}

// What the answers say of the same picture agrees.
TEST(Questions, TracesColumns) {
    Game game = hall();
    const std::vector<int> columns = {40, 3, 32};
    const std::vector<ColumnTrace> traces = game.trace(64, 40, columns);
    ASSERT_EQ(traces.size(), 3u);
    for (std::size_t i = 0; i < traces.size(); ++i) {
        const ColumnTrace& trace = traces[i];
        EXPECT_EQ(trace.column, columns[i]);
        EXPECT_EQ(trace.hits.size(), game.hits(64, 40, columns[i]).size());
        std::vector<int> rows(40);
        for (const ColumnRun& run : trace.runs) {
            for (int row = run.rows.first; row < run.rows.last && !run.isLayer; ++row) ++rows[row];
            EXPECT_EQ(run.first.has_value(), !run.texture.empty());
            if (!run.first) continue;
            EXPECT_EQ(run.first->row, run.rows.first);
            EXPECT_EQ(run.last->row, run.rows.last - 1);
            const auto pick = game.pick(64, 40, trace.column, run.rows.first);
            ASSERT_TRUE(pick && pick->texel);
            EXPECT_EQ(pick->what, run.what);
            EXPECT_EQ(pick->texture, run.texture);
            EXPECT_EQ(pick->face, run.face);
            EXPECT_EQ(pick->texel->u, run.first->u);
            EXPECT_EQ(pick->texel->v, run.first->v);
            EXPECT_NEAR(pick->texel->depth, run.first->depth, 1e-9);
        }
        EXPECT_EQ(rows, std::vector<int>(40, 1)) << "column " << trace.column;
    }
    const ColumnTrace& middle = traces[2];
    EXPECT_NEAR(middle.rayX, 1.0, 1e-12);
    ASSERT_GE(middle.tiles.size(), 7u);
    EXPECT_EQ(middle.tiles[4].x, 5);
    EXPECT_NEAR(middle.tiles[4].depth, 3.5, 1e-9);
    EXPECT_NEAR(middle.tiles[4].along * middle.tiles[4].speed, middle.tiles[4].distance, 1e-9);
    ASSERT_FALSE(middle.portals.empty());
    EXPECT_EQ(middle.portals[0].ends.toMap, 1);
    ASSERT_FALSE(middle.mirrors.empty());
    EXPECT_EQ(middle.mirrors[0].height, 0.0);
    ASSERT_EQ(middle.reflection.size(), 1u);
    EXPECT_EQ(middle.reflection[0].column, 32);

    EXPECT_TRUE(game.trace(64, 40, {}).empty());
    EXPECT_TRUE(game.trace(0, 40, columns).empty());
    EXPECT_TRUE(game.trace(40, 40, columns).empty()) << "no column 40";
    EXPECT_TRUE(game.trace(64, 40, std::vector<int>(8193)).empty());
}

TEST(Questions, PicksFloorsAndWhatTheyMirror) {
    Game game = hall();
    // The foot of the wall is mirrored right under it.
    const auto foot = game.project(5.0, 1.5, 0.0, 64, 40);
    ASSERT_TRUE(foot);
    const auto pick = game.pick(64, 40, 32, static_cast<int>(foot->y) + 2);
    ASSERT_TRUE(pick);
    EXPECT_EQ(pick->what, Seen::floor);
    EXPECT_EQ(pick->tileX, static_cast<int>(std::floor(pick->x)));
    EXPECT_EQ(pick->tileY, 1);
    EXPECT_EQ(pick->object, -1);
    EXPECT_EQ(pick->alpha, 255);
    ASSERT_EQ(pick->reflection.size(), 1u);
    EXPECT_EQ(pick->reflection[0].what, Seen::side);
    EXPECT_EQ(pick->reflection[0].block, "wall");
    EXPECT_FALSE(game.pick(64, 40, 32, 0)->texel) << "sky";
}

TEST(Questions, PicksObjects) {
    LoadResult loaded = loadSceneFile(SLICECAST_SOURCE_FOLDER "/tests/frozen/scenes/garden.json");
    ASSERT_TRUE(loaded.scene);
    Game game(std::move(*loaded.scene));
    int seen = 0;
    for (int column = 0; column < 160; column += 4) {
        const std::vector<ColumnTrace> traces = game.trace(160, 100, std::vector{column});
        ASSERT_EQ(traces.size(), 1u);
        for (const ColumnObject& object : traces[0].objects) {
            EXPECT_GT(object.depth, 0.0);
            EXPECT_GT(object.top, object.bottom);
            EXPECT_FALSE(object.sprite.empty());
        }
        for (int row = 0; row < 100; ++row) {
            const auto pick = game.pick(160, 100, column, row);
            ASSERT_TRUE(pick);
            EXPECT_EQ(pick->object >= 0, pick->what == Seen::object);
            if (pick->object < 0) continue;
            ++seen;
            EXPECT_TRUE(std::any_of(traces[0].objects.begin(), traces[0].objects.end(),
                                    [&](const ColumnObject& object) {
                                        return object.object == pick->object &&
                                               object.sprite == pick->texture;
                                    }));
            EXPECT_GE(pick->alpha, 1);
        }
    }
    EXPECT_GT(seen, 20);
}

TEST(Questions, AddsUpAPicture) {
    Game game = hall();
    const auto frame = game.traceFrame(64, 40);
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->columns.size(), 64u);
    std::vector<int> all(64);
    std::iota(all.begin(), all.end(), 0);
    const std::vector<ColumnTrace> traces = game.trace(64, 40, all);
    ASSERT_EQ(traces.size(), 64u);
    std::int64_t texels = 0;
    for (std::size_t column = 0; column < 64; ++column) {
        const ColumnSums& sums = frame->columns[column];
        EXPECT_EQ(std::accumulate(sums.rows.begin(), sums.rows.end(), 0), 40);
        EXPECT_EQ(sums.tiles, static_cast<int>(traces[column].tiles.size()));
        EXPECT_EQ(sums.hits, static_cast<int>(traces[column].hits.size()));
        for (const ColumnRun& run : traces[column].runs)
            if (run.first) texels += run.rows.last - run.rows.first;
    }
    EXPECT_NEAR(frame->columns[32].nearest, 3.5, 0.1);
    EXPECT_EQ(frame->horizonRow, 20.0);
    EXPECT_GT(frame->tilesWalked, 0);
    EXPECT_EQ(frame->deepestPortal, 1);
    EXPECT_GT(frame->mirroredRows, 0);
    ASSERT_EQ(frame->textures.size(), 2u);
    EXPECT_EQ(frame->textures[0].name, "grey");
    EXPECT_FALSE(frame->textures[0].isSprite);
    std::int64_t used = 0;
    for (const TextureUse& use : frame->textures)
        used += std::accumulate(use.rows.begin(), use.rows.end(), std::int64_t{0});
    EXPECT_EQ(used, texels);
    EXPECT_FALSE(game.traceFrame(0, 40));
    EXPECT_FALSE(game.traceFrame(64, 8193));
}

TEST(Questions, ListsOptions) {
    Game game = hall();
    EXPECT_GT(Game::options().size(), 30u);
    for (const OptionInfo& option : Game::options()) {
        EXPECT_EQ(game.option(option.name), option.standard);
        EXPECT_EQ(game.setOption(option.name, option.standard), "");
        EXPECT_EQ(*option.choices != '\0', option.kind == OptionKind::choice) << option.name;
        if (option.kind == OptionKind::number || option.kind == OptionKind::wholeNumber) {
            EXPECT_LT(option.least, option.greatest) << option.name;
        }
    }
}

TEST(Questions, TellsTheVersion) {
    EXPECT_EQ(std::string(SLICECAST_VERSION), std::to_string(SLICECAST_VERSION_MAJOR) + "." +
                                                  std::to_string(SLICECAST_VERSION_MINOR) + "." +
                                                  std::to_string(SLICECAST_VERSION_PATCH));
}

}  // namespace
}  // namespace slicecast
