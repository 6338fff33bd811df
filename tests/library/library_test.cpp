// The library, by its public headers alone.
#include <slicecast/slicecast.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

const std::filesystem::path kCastle = SLICECAST_SOURCE_FOLDER "/tests/frozen/scenes/castle.json";

static_assert(!std::is_copy_constructible_v<Scene> && std::is_nothrow_move_constructible_v<Scene>);
static_assert(!std::is_copy_constructible_v<Game> && std::is_nothrow_move_constructible_v<Game>);

Game castle() {
    LoadResult loaded = loadSceneFile(kCastle);
    for (const Fault& fault : loaded.faults) ADD_FAILURE() << describe(fault);
    return Game(std::move(loaded.scene).value());
}

// A corridor of 8 x 3 tiles to the east, with a wall of half the height across it at x = 5.
struct Corridor {
    SceneBuilder builder{"Corridor"};
    SceneBuilder::Texture grey = builder.colour("grey", {128, 128, 128});
    SceneBuilder::Block wall =
        builder.block({.name = "wall", .texture = grey, .top = 0.5, .sign = "#"});
    SceneBuilder::Map map =
        builder.map({.name = "corridor", .width = 8, .depth = 3, .levels = 2, .floor = grey});

    Corridor() {
        builder.fill(map, {.x = 5, .depth = 3}, wall);
        builder.start(map, {.x = 1.5, .y = 1.5});
    }
    LoadResult build() { return std::move(builder).build(); }
    std::string fault() {
        const LoadResult built = build();
        EXPECT_EQ(built.scene.has_value(), built.faults.empty());
        return built.faults.size() == 1 ? describe(built.faults[0])
                                        : std::to_string(built.faults.size()) + " faults";
    }
};

Game corridor() {
    return Game(std::move(Corridor().build().scene).value());
}

TEST(Library, LoadsAFileOrReturnsFaults) {
    const LoadResult loaded = loadSceneFile(kCastle);
    EXPECT_TRUE(loaded.faults.empty());
    ASSERT_TRUE(loaded.scene.has_value());
    EXPECT_EQ(loaded.scene->title(), "The castle in the lake");
    ASSERT_FALSE(loaded.scene->maps().empty());
    EXPECT_GT(loaded.scene->maps()[0].width, 0);

    const LoadResult missing = loadSceneFile("no-such-scene.json");
    EXPECT_FALSE(missing.scene.has_value());
    ASSERT_EQ(missing.faults.size(), 1u);
    EXPECT_EQ(describe(missing.faults[0]),
              "no-such-scene.json: found a path that does not exist, expected a scene file");
}

TEST(Library, TellsHowFarLoadingIs) {
    std::vector<double> shares;
    const LoadResult loaded =
        loadSceneFile(kCastle, [&](double share) { shares.push_back(share); });
    ASSERT_TRUE(loaded.scene.has_value());
    EXPECT_GT(shares.size(), 30u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GT(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
}

TEST(Library, LoadsATextWithoutADisk) {
    const char* text = R"({ "title": "Text", "textures": { "red": "#c03020" },
  "maps": [{ "name": "plain", "floor": "red", "levels": [["..."]] }], "start": { "x": 1, "y": 0.5 } })";
    LoadResult loaded = loadSceneText(text, "text");
    for (const Fault& fault : loaded.faults) ADD_FAILURE() << describe(fault);
    ASSERT_TRUE(loaded.scene.has_value());
    EXPECT_EQ(Game(std::move(*loaded.scene)).title(), "Text");
    EXPECT_FALSE(loadSceneText("{", "text").scene.has_value());
}

TEST(Library, DrawsTheSameIntoImagesAndIntoPixels) {
    Game game = castle();
    const Image image = game.picture(320, 200);
    ASSERT_FALSE(image.empty());
    EXPECT_TRUE(image.isOpaque());
    std::vector<Pixel> pixels(400 * 200, 7);
    ASSERT_TRUE(game.draw({pixels.data(), 320, 200, 400}));
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 320; ++x) ASSERT_EQ(pixels[y * 400 + x], image.at(x, y));
        for (int x = 320; x < 400; ++x) ASSERT_EQ(pixels[y * 400 + x], 7u) << "beyond the picture";
    }
}

TEST(Library, RefusesInvalidPictures) {
    Game game = corridor();
    for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {8193, 10}, {10, 8193}}) {
        EXPECT_TRUE(game.picture(width, height).empty());
        EXPECT_TRUE(game.hits(width, height, 0).empty());
        EXPECT_FALSE(game.pick(width, height, 0, 0));
        EXPECT_FALSE(game.project(4.0, 1.5, 0.5, width, height));
    }
    EXPECT_FALSE(game.draw({}));
    Image narrow(10, 10);
    EXPECT_FALSE(game.draw({narrow.pixels.data(), 10, 10, 9}));
    for (const int beside : {-1, 64}) {
        EXPECT_TRUE(game.hits(64, 40, beside).empty());
        EXPECT_FALSE(game.pick(64, 40, beside, 0));
        EXPECT_FALSE(game.pick(64, 40, 0, beside));
    }
}

TEST(Library, WalksAndMovesTheCamera) {
    Game game = corridor();
    const Camera start = game.camera();
    EXPECT_EQ(start.x, 1.5);
    for (int step = 0; step < kStepsEachSecond; ++step) game.step({.forward = 1.0});
    EXPECT_EQ(game.steps(), kStepsEachSecond);
    EXPECT_GT(game.camera().x, 2.5);
    game.reset();
    EXPECT_EQ(game.camera().x, 1.5);

    EXPECT_TRUE(game.setCamera({.x = 3.25, .y = 1.0, .z = 0.75, .headingDegrees = -90.0}));
    EXPECT_EQ(game.camera().x, 3.25);
    EXPECT_EQ(game.camera().headingDegrees, 270.0);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const Camera& blind :
         {Camera{.map = 1, .z = 1.0}, Camera{.map = -1, .z = 1.0}, Camera{.z = 0.0},
          Camera{.x = kNan, .z = 1.0}, Camera{.x = 40'000.0, .z = 1.0},
          Camera{.y = -HUGE_VAL, .z = 1.0}, Camera{.z = kNan}, Camera{.z = 1e9},
          Camera{.z = 1.0, .headingDegrees = kNan}, Camera{.z = 1.0, .look = 4.5}}) {
        EXPECT_FALSE(game.setCamera(blind));
        EXPECT_EQ(game.camera().x, 3.25);
    }
    EXPECT_TRUE(game.goToMap(0));
    EXPECT_FALSE(game.goToMap(1));
}

TEST(Library, ReturnsTheHitsOfAColumn) {
    Game game = corridor();
    const std::vector<ColumnHit> hits = game.hits(64, 40, 32);
    ASSERT_EQ(hits.size(), 1u);
    const ColumnHit& hit = hits[0];
    EXPECT_EQ(hit.block, "wall");
    EXPECT_EQ(hit.tileX, 5);
    EXPECT_EQ(hit.tileY, 1);
    EXPECT_EQ(hit.face, Face::west);
    EXPECT_NEAR(hit.depth, 3.5, 1e-9);
    EXPECT_NEAR(hit.backDepth, 4.5, 1e-9);
    EXPECT_EQ(hit.bottom, 0.0);
    EXPECT_EQ(hit.top, 0.5);
    ASSERT_FALSE(hit.rows.empty());
    EXPECT_LT(hit.rows.front().first, hit.rows.back().last);
}

TEST(Library, PicksWhatItProjects) {
    Game game = corridor();
    const auto point = game.project(5.0, 1.5, 0.25, 64, 40);
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(point->depth, 3.5, 1e-9);
    const auto pick = game.pick(64, 40, static_cast<int>(point->x), static_cast<int>(point->y));
    ASSERT_TRUE(pick.has_value());
    EXPECT_EQ(pick->what, Seen::side);
    EXPECT_EQ(pick->block, "wall");
    EXPECT_EQ(pick->texture, "grey");
    EXPECT_EQ(pick->face, Face::west);
    EXPECT_NEAR(pick->x, 5.0, 1e-9);
    EXPECT_NEAR(pick->depth, 3.5, 1e-9);
    EXPECT_FALSE(game.project(0.0, 1.5, 0.5, 64, 40)) << "behind the eye";
    const auto sky = game.pick(64, 40, 32, 0);
    ASSERT_TRUE(sky.has_value());
    EXPECT_EQ(sky->what, Seen::sky);
    EXPECT_EQ(sky->depth, std::numeric_limits<double>::infinity());
}

TEST(Library, TellsWhatThePlayerHears) {
    SceneBuilder builder("Floor");
    const auto boards = builder.colour("old boards", {160, 120, 80});
    const auto room =
        builder.map({.name = "room", .width = 8, .depth = 3, .levels = 1, .floor = boards});
    builder.start(room, {.x = 1.5, .y = 1.5});
    Game game(std::move(*std::move(builder).build().scene));
    const auto steps = [&game] {
        const std::vector<Sound> heard = game.hear();
        return std::count_if(heard.begin(), heard.end(), [](const Sound& sound) {
            return sound.kind == SoundKind::step && sound.material == Material::wood;
        });
    };
    for (int step = 0; step < 120; ++step) game.step({.forward = 1.0});
    EXPECT_EQ(steps(), 0) << "the first call begins to listen";
    for (int step = 0; step < 120; ++step) game.step({.forward = -1.0});
    EXPECT_GT(steps(), 0);
    EXPECT_EQ(steps(), 0) << "each sound once";
}

TEST(Library, TellsHowFarAGameIs) {
    LoadResult loaded = loadSceneFile(SLICECAST_SOURCE_FOLDER "/assets/scenes/wayhouse-hunt.json");
    ASSERT_TRUE(loaded.scene.has_value());
    Game game(std::move(*loaded.scene));
    const GameProgress before = game.progress();
    EXPECT_FALSE(before.aim.empty());
    EXPECT_EQ(before.of, 4);
    ASSERT_EQ(before.finds.size(), 4u);
    EXPECT_EQ(before.finds[0].of, 1);
    EXPECT_TRUE(before.hasGoal);
    game.step();
    EXPECT_EQ(game.progress().steps, 0) << "time waits for the first input";
    for (int step = 0; step < 600; ++step) game.step({.forward = 1.0});
    EXPECT_EQ(game.progress().steps, 600);
    game.takeNews();
    game.step({.use = true});
    const std::vector<GameNews> news = game.takeNews();
    ASSERT_EQ(news.size(), 1u);
    EXPECT_EQ(news[0].kind, GameNews::Kind::message);
    EXPECT_EQ(news[0].text.substr(0, 17), "The last gate is ");
    EXPECT_TRUE(game.takeNews().empty());
    EXPECT_EQ(castle().progress().of, 0);
}

TEST(Library, SetsOptionsAndCells) {
    Game game = corridor();
    EXPECT_EQ(game.setOption("fov", "90"), "");
    EXPECT_EQ(game.option("fov"), "90");
    EXPECT_NE(game.setOption("fov", "many"), "");
    EXPECT_NE(game.setOption("no such option", "1"), "");
    EXPECT_EQ(game.option("no such option"), "");
    EXPECT_EQ(game.setCell(0, 0, 5, 1, "."), "");
    EXPECT_TRUE(game.hits(64, 40, 32).empty());
    EXPECT_EQ(game.setCell(0, 0, 3, 1, "#"), "");
    EXPECT_EQ(game.hits(64, 40, 32).at(0).tileX, 3);
    EXPECT_NE(game.setCell(0, 0, 8, 1, "#"), "");
    EXPECT_NE(game.setCell(1, 0, 0, 0, "#"), "");
    EXPECT_NE(game.setCell(0, 0, 3, 1, "?"), "");
}

TEST(Library, SetsManyCellsOrNone) {
    Game game = corridor();
    const CellChange moved[] = {{0, 5, 1, "."}, {0, 3, 1, "#"}};
    const CellChange faulty[] = {{0, 3, 1, "."}, {0, 2, 1, "?"}};
    EXPECT_EQ(game.setCells(0, moved), "");
    EXPECT_NE(game.setCells(0, faulty), "");
    EXPECT_EQ(game.hits(64, 40, 32).at(0).tileX, 3);
    EXPECT_NE(game.setCells(1, moved), "");
}

TEST(Library, MarksLinesOverThePicture) {
    Game game = corridor();
    const Camera eye = game.camera();
    const Mark line = {0, {eye.x + 1.0, eye.y - 0.5, eye.z}, {eye.x + 1.0, eye.y + 0.5, eye.z}, {}};
    const Image before = game.picture(64, 40);
    ASSERT_TRUE(game.mark({&line, 1}));
    const Image marked = game.picture(64, 40);
    EXPECT_NE(marked.pixels, before.pixels);
    EXPECT_NE(marked.at(32, 20), before.at(32, 20));
    Mark wrong = line;
    wrong.map = 1;
    EXPECT_FALSE(game.mark({&wrong, 1}));
    wrong = line;
    wrong.to.z = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(game.mark({&wrong, 1}));
    EXPECT_FALSE(game.mark(std::vector<Mark>(kMostMarks + 1, line)));
    EXPECT_EQ(game.picture(64, 40).pixels, marked.pixels);
    ASSERT_TRUE(game.mark({}));
    EXPECT_EQ(game.picture(64, 40).pixels, before.pixels);
}

TEST(Library, CopiesASceneWhenAsked) {
    LoadResult built = Corridor().build();
    ASSERT_TRUE(built.scene.has_value());
    Game first(built.scene->copy());
    Game second(std::move(*built.scene));
    EXPECT_EQ(first.setCell(0, 0, 5, 1, "."), "");
    EXPECT_TRUE(first.hits(64, 40, 32).empty());
    EXPECT_FALSE(second.hits(64, 40, 32).empty());
}

TEST(Library, SavesPictures) {
    const auto file = std::filesystem::path(testing::TempDir()) /
                      ("slicecast-saved-" + std::to_string(getpid()) + ".png");
    EXPECT_EQ(saveImage(corridor().picture(64, 40), file), "");
    EXPECT_GT(std::filesystem::file_size(file), 50u);
    std::filesystem::remove(file);
    EXPECT_NE(saveImage({}, file), "");
    EXPECT_NE(saveImage(Image(1, 1), file / "in-no-folder.png"), "");
}

// West of the wall the corridor is blocked by halves, whose cuts the player slides along.
TEST(SceneBuilder, CutsBlocksFromCornerToCorner) {
    Corridor c;
    const SceneBuilder::Block half =
        c.builder.block({.name = "half", .texture = c.grey, .diagonal = Half::southEast});
    c.builder.fill(c.map, {.x = 3, .y = 1}, half);
    Game game(std::move(c.build().scene).value());
    for (int i = 0; i < 240; ++i) game.step({.forward = 1.0});
    EXPECT_GT(game.camera().x, 3.0);
    EXPECT_LT(game.camera().y, 1.0);
}

// The player walks up a slope, and stands on its upper end.
TEST(SceneBuilder, LetsTopsRise) {
    Corridor c;
    const SceneBuilder::Block ramp = c.builder.block(
        {.name = "ramp", .texture = c.grey, .top = 0.5, .rise = SceneBuilder::Rise{Face::east}});
    c.builder.fill(c.map, {.x = 3, .y = 1}, ramp);
    Game game(std::move(c.build().scene).value());
    const double before = game.camera().z;
    double highest = before;
    for (int i = 0; i < 240; ++i) {
        game.step({.forward = 1.0});
        highest = std::max(highest, game.camera().z);
    }
    EXPECT_GT(highest, before + 0.4);
}

// The mean brightness of the corridor's picture.
double brightness(Corridor c) {
    Game game(std::move(c.build().scene).value());
    const Image image = game.picture(64, 40);
    double sum = 0.0;
    for (const Pixel pixel : image.pixels) {
        const Colour colour = toColour(pixel);
        sum += colour.r + colour.g + colour.b;
    }
    return sum / static_cast<double>(image.pixels.size());
}

TEST(SceneBuilder, LightsMaps) {
    const double plain = brightness({});
    Corridor dark;
    dark.builder.light(dark.map, {.colour = {0, 0, 0, 255}, .ambient = {40, 40, 40, 255}});
    Corridor lamp;
    lamp.builder.light(lamp.map, {.colour = {0, 0, 0, 255}, .ambient = {40, 40, 40, 255}});
    lamp.builder.lamp(lamp.map, {.x = 3.5, .y = 1.5, .z = 0.7, .strength = 2.0});
    const double darkened = brightness(std::move(dark));
    const double lit = brightness(std::move(lamp));
    EXPECT_LT(darkened, 0.8 * plain);
    EXPECT_GT(lit, darkened + 5.0);
    EXPECT_LE(lit, plain);
}

TEST(SceneBuilder, ReportsFaults) {
    EXPECT_EQ(Corridor().fault(), "0 faults");
    {
        SceneBuilder empty("Nothing");
        EXPECT_EQ(describe(std::move(empty).build().faults.at(0)),
                  "scene \"Nothing\": found no map, expected at least one");
    }
    {
        Corridor c;
        c.builder.fill(c.map, {.x = 7, .width = 2}, c.wall);
        EXPECT_EQ(c.fault(),
                  "map \"corridor\": found a box of 2x1 tiles and 1 level at x 7, y 0, level 0, "
                  "expected one inside the map's 8x3 tiles and 2 levels");
    }
    {
        Corridor c;
        c.builder.texture("odd", Image(12, 12));
        EXPECT_EQ(c.fault(),
                  "texture \"odd\": found 12x12 pixels, expected a square with 8, 16, 32, 64, 128, "
                  "256, 512 or 1024 pixels a side");
    }
    {
        Corridor c;
        c.builder.block({.name = "flat", .texture = c.grey, .bottom = 0.5, .top = 0.5});
        EXPECT_EQ(c.fault(),
                  "block \"flat\": found a bottom of 0.5 and a top of 0.5, expected 0 <= bottom < "
                  "top <= 1");
    }
}

TEST(SceneBuilder, ChecksEveryRange) {
    const double nan = std::nan("");
    const auto faultOf = [](auto make) {
        Corridor c;
        make(c);
        return c.fault();
    };
    using C = Corridor&;
    for (const std::string& fault : {
             faultOf([](C c) { c.builder.block({.name = "", .texture = c.grey}); }),
             faultOf([](C c) { c.builder.block({.name = "wall", .texture = c.grey}); }),
             faultOf([](C c) { c.builder.block({.name = "bare", .texture = {}}); }),
             faultOf([](C c) { c.builder.block({.name = "b", .texture = c.grey, .light = 1.5}); }),
             faultOf(
                 [&](C c) { c.builder.block({.name = "b", .texture = c.grey, .mirror = nan}); }),
             faultOf([](C c) { c.builder.block({.name = "b", .texture = c.grey, .sign = "#"}); }),
             faultOf([](C c) {
                 c.builder.map({.name = "m", .width = 0, .depth = 1, .floor = c.grey});
             }),
             faultOf([](C c) {
                 c.builder.map({.name = "m", .width = 4097, .depth = 1, .floor = c.grey});
             }),
             faultOf([](C c) {
                 c.builder.map(
                     {.name = "m", .width = 4096, .depth = 4096, .levels = 32, .floor = c.grey});
             }),
             faultOf(
                 [](C c) { c.builder.map({.name = "m", .width = 1, .depth = 1, .floor = {}}); }),
             faultOf([](C c) {
                 c.builder.map({.name = "corridor", .width = 1, .depth = 1, .floor = c.grey});
             }),
             faultOf([](C c) {
                 c.builder.block(
                     {.name = "b", .texture = c.grey, .rise = SceneBuilder::Rise{Face::top, 0.5}});
             }),
             faultOf([](C c) {
                 c.builder.block({.name = "b",
                                  .texture = c.grey,
                                  .top = 0.5,
                                  .rise = SceneBuilder::Rise{Face::east, 0.6}});
             }),
             faultOf([](C c) {
                 c.builder.block({.name = "b",
                                  .texture = c.grey,
                                  .diagonal = Half::northEast,
                                  .rise = SceneBuilder::Rise{Face::east}});
             }),
             faultOf([](C c) { c.builder.light({}, {}); }),
             faultOf([](C c) { c.builder.light(c.map, {.altitudeDegrees = 0.0}); }),
             faultOf([&](C c) { c.builder.light(c.map, {.azimuthDegrees = nan}); }),
             faultOf([](C c) { c.builder.lamp({}, {}); }),
             faultOf([](C c) { c.builder.lamp(c.map, {.x = 8.0, .y = 1.0}); }),
             faultOf([](C c) { c.builder.lamp(c.map, {.x = 1.0, .y = 1.0, .radius = 17.0}); }),
             faultOf([&](C c) { c.builder.lamp(c.map, {.x = 1.0, .y = 1.0, .strength = nan}); }),
             faultOf([](C c) { c.builder.fill({}, {}, c.wall); }),
             faultOf([](C c) { c.builder.fill(c.map, {}, {9}); }),
             faultOf([](C c) { c.builder.fill(c.map, {.width = 2147483647}, c.wall); }),
             faultOf([](C c) { c.builder.start(c.map, {.x = 8.0, .y = 1.5}); }),
             faultOf([&](C c) { c.builder.start(c.map, {.x = nan, .y = 1.5}); }),
             faultOf([](C c) { c.builder.start({}, {.x = 1.0, .y = 1.5}); }),
         }) {
        EXPECT_EQ(fault.find("faults"), std::string::npos) << fault;
        EXPECT_NE(fault.find(", expected "), std::string::npos) << fault;
    }
}

}  // namespace
}  // namespace slicecast
