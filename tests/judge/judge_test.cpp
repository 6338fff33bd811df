// The renderer before the judge: random worlds and eyes, not one pixel that the tracer does not
// see.
#include "sanitized.h"
#include "suite.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <utility>

namespace slicecast::judge {
namespace {

constexpr int kShare = kSanitized ? 10 : 1;
constexpr int kRarer = kSanitized ? 8 : 1;  // in few pictures rare things may be rarer still

void expectNoComplaint(const Verdict& verdict) {
    for (const std::string& complaint : verdict.complaints) ADD_FAILURE() << complaint;
    EXPECT_EQ(verdict.unexcused, 0);
}

void report(const char* suite, const Verdict& verdict) {
    std::printf("%s: %lld pixels judged, %lld unexcused, %lld excused\n", suite,
                static_cast<long long>(verdict.pixels), static_cast<long long>(verdict.unexcused),
                static_cast<long long>(verdict.excused));
}

void expectWithinBounds(const Verdict& verdict) {
    expectNoComplaint(verdict);
    EXPECT_LE(static_cast<double>(verdict.excused),
              kExcusedShareOfSuite * static_cast<double>(verdict.pixels));
    EXPECT_EQ(verdict.crowded, 0) << "pictures with too many excused pixels";
}

// What the suite must have seen, in a stated least number of pixels: a fault in something that is
// never seen would not be found.
struct Seen {
    const char* what;
    std::int64_t pixels;
};

void expectSeen(const Verdict& verdict, std::initializer_list<Seen> all) {
    for (const Seen& seen : all) {
        if (kShare > 1 && seen.pixels < 20'000) continue;  // a handful of pictures holds these
        const auto found = verdict.coverage.find(seen.what);
        EXPECT_GE((found == verdict.coverage.end() ? 0 : found->second) * kShare * kRarer,
                  seen.pixels)
            << seen.what;
    }
}

TEST(Judge, SmallPictures) {
    const Verdict verdict = judgeAll(randomScene, 1, 1600 / kShare, kSmallSizes);
    report("small pictures", verdict);
    expectWithinBounds(verdict);
    EXPECT_GE(verdict.pixels * kShare, 10'000'000);
    expectSeen(verdict, {{"north", 50000},
                         {"east", 50000},
                         {"south", 50000},
                         {"west", 50000},
                         {"roof", 50000},
                         {"underside", 50000},
                         {"north from inside", 10000},
                         {"east from inside", 10000},
                         {"south from inside", 10000},
                         {"west from inside", 10000},
                         {"roof from inside", 10000},
                         {"underside from inside", 10000},
                         {"north smaller", 2000},
                         {"east smaller", 2000},
                         {"south smaller", 2000},
                         {"west smaller", 2000},
                         {"roof smaller", 2000},
                         {"underside smaller", 2000},
                         {"floor", 100000},
                         {"floor smaller", 5000},
                         {"floor outside", 100000},
                         {"floor outside last level", 10000},
                         {"ceiling", 50000},
                         {"ceiling smaller", 1000},
                         {"haze", 20000},
                         {"north see-through", 20000},
                         {"east see-through", 20000},
                         {"south see-through", 20000},
                         {"west see-through", 20000},
                         {"roof see-through", 20000},
                         {"underside see-through", 20000},
                         {"north from inside see-through", 20000},
                         {"east from inside see-through", 20000},
                         {"south from inside see-through", 20000},
                         {"west from inside see-through", 20000},
                         {"roof from inside see-through", 10000},
                         {"underside from inside see-through", 10000},
                         {"floor see-through", 20000},
                         {"ceiling see-through", 10000},
                         {"glow", 100000},
                         {"animated", 500000},
                         {"object", 100000},
                         {"object smaller", 1000},
                         {"object's side 1", 2000},
                         {"object's side 2", 2000},
                         {"object's side 3", 2000},
                         {"hole", 20000},
                         {"1 layers", 100000},
                         {"2 layers", 100000},
                         {"4 layers", 20000},
                         {"8 layers", 10000},
                         {"sky colour", 50000},
                         {"sky gradient", 50000},
                         {"sky panorama", 50000},
                         {"star", 5000},
                         {"sun", 20000},
                         {"moon", 20000},
                         {"cloud", 20000},
                         {"rippled mirror", 20000},
                         {"rippled to the end of a mirror", 2000},
                         {"face portal", 10000},
                         {"face portal turned by 90", 10000},
                         {"face portal turned by 180", 5000},
                         {"face portal turned by 270", 10000},
                         {"tile portal", 20000},
                         {"tile portal turned by 90", 20000},
                         {"tile portal turned by 180", 20000},
                         {"tile portal turned by 270", 20000},
                         {"north portal", 5000},
                         {"east portal", 4000},
                         {"south portal", 5000},
                         {"west portal", 5000},
                         {"top portal", 10000},
                         {"bottom portal", 8000},
                         {"levels shifted", 40000},
                         {"three portals", 3000},
                         {"portal within a map", 50000},
                         {"portal at once", 5000},
                         {"portal in glass", 10000},
                         {"face at the limit", 4000},
                         {"tile at the limit", 4000},
                         {"below the floor", 5000},
                         {"out inside a block", 500},
                         {"face at the exit", 5000},
                         {"face behind the exit", 5000},
                         {"tile at the exit", 10000},
                         {"left through a portal", 10000},
                         {"joined by a portal", 500},
                         {"side behind a portal", 50000},
                         {"roof behind a portal", 10000},
                         {"underside behind a portal", 8000},
                         {"floor behind a portal", 40000},
                         {"ceiling behind a portal", 5000},
                         {"sky behind a portal", 50000},
                         {"sky turned", 20000},
                         {"haze behind a portal", 15000},
                         {"object behind a portal", 8000},
                         {"joined mover", 3000},
                         {"risen texture", 100000},
                         {"joined kin", 3000},
                         {"whole mover", 3000},
                         {"whole slider", 3000},
                         {"inside a mover", 3000},
                         {"empty mover", 100000},
                         {"floor mirror", 300000},
                         {"roof mirror", 20000},
                         {"joined mirror", 300},
                         {"mirror outside", 150000},
                         {"eye in water", 300000},
                         {"out of the water", 50000},
                         {"sky through water", 20000},
                         {"mirror through water", 3000},
                         {"no face", 30000},
                         {"plan entered", 60000},
                         {"plan left", 30000},
                         {"plan missed", 500000},
                         {"cut entered", 20000},
                         {"cut left", 10000},
                         {"side of a block with slopes", 20000},
                         {"sloped roof", 20000},
                         {"sloped underside", 5000},
                         {"slope from inside", 5000},
                         {"moved slope", 20000},
                         {"shifted slope", 5000},
                         {"cut slope", 1000},
                         {"slid side", 15000},
                         {"slid plane", 15000},
                         {"sloped roof above the horizon", 500},
                         {"sloped underside below the horizon", 300},
                         {"mirror behind a portal", 5000},
                         {"portal behind a mirror", 3000},
                         {"mirrored side", 50000},
                         {"mirrored roof", 8000},
                         {"mirrored underside", 10000},
                         {"mirrored ceiling", 10000},
                         {"mirrored sky", 200000},
                         {"mirrored object", 5000},
                         {"lit side", 500000},
                         {"lit roof", 100000},
                         {"lit underside", 100000},
                         {"lit floor", 250000},
                         {"lit ceiling", 50000},
                         {"lit object", 40000},
                         {"smooth side", 1000000},
                         {"smooth roof", 200000},
                         {"smooth underside", 200000},
                         {"smooth floor", 500000},
                         {"smooth ceiling", 100000},
                         {"smooth lit side", 200000},
                         {"smooth lit roof", 60000},
                         {"smooth lit underside", 60000},
                         {"smooth lit floor", 90000},
                         {"smooth lit ceiling", 10000},
                         {"smooth across a border side", 200000},
                         {"smooth across a border roof", 50000},
                         {"smooth across a border underside", 50000},
                         {"smooth across a border floor", 100000},
                         {"smooth across a border ceiling", 20000},
                         {"smooth beside a hole", 100000},
                         {"smooth on what moves", 100000},
                         {"smooth slope", 50000},
                         {"pictures with tinted light", 70},
                         {"pictures with nodes partly linked", 60},
                         {"pictures with a square of other nodes", 50},
                         {"pictures with a lit slope", 20},
                         {"pictures with a lit cut", 9},
                         {"pictures with light that goes on with a slope or cut", 18},
                         {"pictures with light that goes on in another level", 9},
                         {"pictures with a slope that dips below the floor", 3},
                         {"pictures with light between parts of a mover that do not join", 5},
                         {"pictures with light on a face that is not shown", 14}});
}

TEST(Judge, FullSizePictures) {
    const int pictures = kShare > 1 ? 2 : 14;
    const Verdict verdict = judgeAll(randomScene, 100'000, pictures, kLargeSizes);
    report("full-size pictures", verdict);
    expectWithinBounds(verdict);
    EXPECT_GE(verdict.pixels * kShare, 10'000'000);
}

TEST(Judge, PicturesAtOtherTimesOfDay) {
    const Verdict verdict = judgeAll(timesScene, 1, 40 / kShare, kOddSizes);
    report("pictures at other times of day", verdict);
    expectWithinBounds(verdict);
    expectSeen(verdict, {{"lit side", 10000},
                         {"lit floor", 10000},
                         {"lit roof", 3000},
                         {"haze", 2000},
                         {"sky gradient", 20000},
                         {"star", 50},
                         {"sun", 300},
                         {"moon", 50},
                         {"cloud", 2000}});
}

// Many rays meet borders and edges exactly here, where either side may be right by the tracer's
// neighbours; these count apart.
TEST(Judge, PicturesMadeToTie) {
    const Verdict verdict = judgeAll(tieScene, 1, 600 / kShare, kSmallSizes);
    report("pictures made to tie", verdict);
    expectNoComplaint(verdict);
    EXPECT_LE(static_cast<double>(verdict.excused), 0.005 * static_cast<double>(verdict.pixels));
}

// In the middle column every neighbour of a point shows another tile, so nearly all could be
// excused: there must be next to none.
TEST(Judge, PicturesAlongBorders) {
    const Verdict verdict = judgeAll(alongBorderScene, 1, 1200 / kShare, kOddSizes);
    report("pictures along borders", verdict);
    expectNoComplaint(verdict);
    EXPECT_LE(static_cast<double>(verdict.excused), 0.00002 * static_cast<double>(verdict.pixels));
}

TEST(Judge, PicturesOfWideLand) {
    const Verdict verdict = judgeAll(wideLandScene, 1, 600 / kShare, kSmallSizes);
    report("pictures of wide land", verdict);
    expectWithinBounds(verdict);
}

TEST(Judge, PicturesOfLargeTextures) {
    // All of them under sanitizers too: a tenth would be 20 pictures.
    const Verdict verdict = judgeAll(largeTextureScene, 1, 200, kSmallSizes);
    report("pictures of large textures", verdict);
    expectWithinBounds(verdict);
    expectSeen(verdict, {{"large texture", 100000},
                         {"large texture, smooth", 20000},
                         {"large texture, lit", 6000}});
}

// More see-through things than a column can show.
TEST(Judge, PicturesOfCrowds) {
    const Verdict verdict = judgeAll(crowdedScene, 1, 130 / kShare, kCrowdSizes);
    report("pictures of crowds", verdict);
    expectNoComplaint(verdict);
    expectSeen(verdict, {{"without the farthest layers", 300}});
}

// Each was wrong once: light beside a slope that had moved; a face left out behind a portal,
// because the block before it would have joined if it filled its tile; for an eye within a sloped
// block, the underside of the next part of the same mover; mirrors on see-through blocks behind
// more see-through things than can be shown.
TEST(Judge, PicturesThatWereWrongOnce) {
    Verdict verdict = judgeAll(randomScene, 3408, 1, kSmallSizes);
    for (const std::uint64_t seed : {9702, 13108})
        verdict.add(judgeAll(alongBorderScene, seed, 1, kOddSizes));
    verdict.add(judgeAll(crowdedScene, 361, 1, kCrowdSizes));
    report("pictures that were wrong once", verdict);
    expectNoComplaint(verdict);
}

// Two faces in one plane that look alike, one behind the other: each has its own light.
TEST(Judge, ACeilingBehindAnUndersideOfItsLook) {
    WorldBuilder make;
    make.texture("grey", {200, 200, 200, 255});
    make.block('#');
    Map& map = make.map("hall", 4, 4, 2);
    make.put('#', 1, 2, 1);
    make.ceiling(1.0, 0, 2, 3);
    for (int x = 1; x < 4; ++x) map.ceiling.tiles[map.tileIndex(x, 2)] = kNoTexture;
    map.light.on = false;
    map.baked.on = true;
    map.baked.lamps.push_back(
        {toCoordinate(2.5), toCoordinate(2.2), toCoordinate(0.5), {.radius = tileEdge(8)}});
    View view;
    view.x = toCoordinate(2.9);
    view.y = toCoordinate(3.6);
    view.z = toCoordinate(0.3);
    view.headingDegrees = 220.0;
    view.look = 0.5;
    view.width = 320;
    view.height = 200;
    Renderer renderer;
    const Image image = draw(renderer, make.world, view);
    const Verdict verdict = judge(make.world, view, image.pixels.data(), image.width, "hall");
    expectNoComplaint(verdict);
    EXPECT_GE(verdict.coverage.at("lit underside"), 100);
    EXPECT_GE(verdict.coverage.at("lit ceiling"), 100);
}

// The judge itself must be able to say no: one pixel of another colour is found.
TEST(Judge, FindsOneWrongPixel) {
    Renderer renderer;
    const Scene scene = randomScene(3, 97, 53);
    Image image = draw(renderer, scene.world, scene.view);
    const Colour before = toColour(image.at(40, 20));
    image.at(40, 20) =
        toPixel({static_cast<std::uint8_t>(before.r ^ 0x80), before.g, before.b, 255});
    const Verdict verdict =
        judge(scene.world, scene.view, image.pixels.data(), image.width, "spoilt");
    EXPECT_EQ(verdict.unexcused, 1);
    ASSERT_EQ(verdict.complaints.size(), 1u);
    EXPECT_NE(verdict.complaints[0].find("pixel 40,20"), std::string::npos)
        << verdict.complaints[0];
}

// A hall full of panes, each with two faces: clear ones, and behind them red ones.
Scene hallOfPanes(int clear, int red) {
    WorldBuilder make;
    make.texture("grey", {90, 90, 90, 255});
    make.texture("clear", {90, 90, 90, 1});
    make.texture("red", {255, 0, 0, 200});
    make.block('c', {.name = "clear", .texture = 1});
    make.block('r', {.name = "red", .texture = 2});
    for (CellBlueprint& block : make.world.blueprints) block.join = false;
    make.map("hall", 3, 2 + clear + red, 1);
    for (int i = 0; i < clear + red; ++i) {
        for (int x = 0; x < 3; ++x) make.put(i < clear ? 'c' : 'r', x, 2 + i);
    }
    markSeeThrough(make.world);
    View view;
    view.x = toCoordinate(1.5);
    view.y = toCoordinate(0.5);
    view.z = toCoordinate(0.5);
    view.headingDegrees = 90.0;  // south
    view.width = 96;
    view.height = 33;  // the middle row looks far along the hall
    return {std::move(make.world), view};
}

Verdict verdictOf(const Scene& scene, const Image& image) {
    return judge(scene.world, scene.view, image.pixels.data(), image.width, "hall");
}

// These are more than a column can show: the red ones are missing.
TEST(Judge, TheFarthestLayersOfAFullColumnMayBeMissing) {
    Renderer renderer;
    const Scene scene = hallOfPanes(110, 20);
    Image image = draw(renderer, scene.world, scene.view);
    const Verdict verdict = verdictOf(scene, image);
    expectNoComplaint(verdict);
    EXPECT_GT(verdict.coverage.at("without the farthest layers"), 0);
    image.at(48, 16) ^= 0x80;
    EXPECT_EQ(verdictOf(scene, image).unexcused, 1);
}

TEST(Judge, NoLayerOfAnotherColumnMayBeMissing) {
    Renderer renderer;
    const Scene scene = hallOfPanes(15, 5);
    Verdict verdict = verdictOf(scene, draw(renderer, scene.world, scene.view));
    expectNoComplaint(verdict);
    EXPECT_EQ(verdict.coverage.count("without the farthest layers"), 0u);
    const Scene without = hallOfPanes(15, 0);
    verdict = verdictOf(scene, draw(renderer, without.world, scene.view));
    EXPECT_GT(verdict.unexcused, 0);
}

}  // namespace
}  // namespace slicecast::judge
