// All that can be asked about a picture: traces, hits, casts and picks, of both renderers, over the
// shipped scenes and random worlds, in pictures from 1 to 1600 pixels wide. Asks that rows add up,
// that numbers name what exists, and, with the sanitizers, that nothing else is read or written.
#include "answers/cast_json.h"
#include "answers/hits_json.h"
#include "answers/pick.h"
#include "answers/trace_json.h"
#include "base/random.h"
#include "base/words.h"
#include "judge/draw.h"
#include "sanitized.h"
#include "scenes/shipped.h"
#include "session/session.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

using What = FilledRows::What;

// Around the widths of strips and vectors, and those of screens.
constexpr auto kWidths =
    std::to_array({1,   2,   3,   4,   5,   7,   8,   9,    15,   16,   17,   24,   31,  32,
                   33,  47,  48,  63,  64,  65,  100, 127,  128,  129,  160,  255,  256, 320,
                   333, 511, 640, 799, 800, 960, 999, 1024, 1279, 1280, 1440, 1599, 1600});
constexpr auto kHeights = std::to_array({1, 2, 3, 5, 8, 13, 16, 21});

// Some of a picture's columns are also asked for one by one.
constexpr int kSingleColumns = 4;

template <typename List>
bool has(const List& list, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

bool isOfMap(const World& world, int map, int x, int y) {
    return has(world.maps, map) && world.maps[static_cast<std::size_t>(map)].contains(x, y);
}

// A texel of its texture or sprite, at a depth in front of the eye.
void checkTexel(const World& world, const FilledRows& run, const TracedTexel& texel) {
    ASSERT_TRUE(std::isfinite(texel.depth));
    ASSERT_GT(texel.depth, 0.0);
    ASSERT_LE(texel.light, 256u);
    ASSERT_LE(texel.fog, 255u);
    for (const std::int32_t baked : texel.baked) {
        ASSERT_GE(baked, 0);
        ASSERT_LE(baked, 256);
    }
    int width = 0;
    int height = 0;
    if (run.what == What::object) {
        ASSERT_TRUE(has(world.sprites, run.texture));
        const auto& levels = world.sprites[run.texture].frames[0];
        ASSERT_TRUE(has(levels, texel.detail));
        width = levels[static_cast<std::size_t>(texel.detail)].width;
        height = levels[static_cast<std::size_t>(texel.detail)].height;
    } else {
        ASSERT_TRUE(has(world.textures, run.texture));
        const auto& levels = world.textures[run.texture].levels;
        ASSERT_TRUE(has(levels, texel.detail));
        width = height = levels[static_cast<std::size_t>(texel.detail)].size;
    }
    ASSERT_TRUE(texel.u >= 0 && texel.u < width) << texel.u << " of " << width;
    ASSERT_TRUE(texel.v >= 0 && texel.v < height) << texel.v << " of " << height;
}

void checkRun(const World& world, const SliceTrace& trace, const FilledRows& run) {
    ASSERT_LT(static_cast<std::size_t>(run.what), FilledRows::kWhats);
    ASSERT_TRUE(has(world.maps, run.map));
    ASSERT_EQ(run.hit >= 0, run.what <= What::underside);
    ASSERT_EQ(run.object >= 0, run.what == What::object);
    if (run.hit >= 0) {
        ASSERT_TRUE(has(trace.hits, run.hit));
    }
    if (run.object >= 0) {
        ASSERT_TRUE(has(trace.objects, run.object));
    }
    if (run.texture == kNoTexture) return;
    checkTexel(world, run, run.top);
    checkTexel(world, run, run.bottom);
    int rows = 0;
    for (const std::uint16_t ofDetail : run.rowsOfDetail) rows += ofDetail;
    ASSERT_EQ(rows, run.last - run.first);
}

// How often the opaque runs cover each row.
std::vector<int> coveredBy(const SliceTrace& trace, int height) {
    std::vector<int> times(static_cast<std::size_t>(height));
    for (const FilledRows& run : trace.filled) {
        EXPECT_TRUE(0 <= run.first && run.first < run.last && run.last <= height);
        if (run.layer || run.first < 0 || run.last > height) continue;
        for (int row = run.first; row < run.last; ++row) ++times[static_cast<std::size_t>(row)];
    }
    return times;
}

void checkThings(const World& world, const SliceTrace& trace) {
    for (const WalkedTile& tile : trace.tiles) ASSERT_TRUE(has(world.maps, tile.map));
    for (const Hit& hit : trace.hits) {
        ASSERT_TRUE(isOfMap(world, hit.map, hit.tileX, hit.tileY));
        ASSERT_TRUE(has(world.blueprints, hit.blueprint));
        ASSERT_TRUE(hit.depth >= 0.0 && hit.depth <= hit.backDepth);
    }
    for (const SeenObject& seen : trace.objects) {
        ASSERT_TRUE(has(world.maps, seen.map));
        ASSERT_TRUE(has(world.maps[static_cast<std::size_t>(seen.map)].objects, seen.object));
        ASSERT_GT(seen.depth, 0.0);
    }
    for (const PassedPortal& passed : trace.portals) ASSERT_TRUE(has(world.portals, passed.portal));
    for (const FilledRows& run : trace.filled) ASSERT_NO_FATAL_FAILURE(checkRun(world, trace, run));
}

void checkTrace(const World& world, const SliceTrace& trace, int height) {
    ASSERT_NO_FATAL_FAILURE(checkThings(world, trace));
    ASSERT_EQ(coveredBy(trace, height), std::vector<int>(static_cast<std::size_t>(height), 1));
    // What one row shows; its pick reads the world's texels
    ASSERT_FALSE(trace.seen.empty());
    for (const SeenPoint& point : trace.seen) ASSERT_TRUE(has(trace.filled, point.run));
    nearestSeen(world, trace);
    for (const SliceTrace& reflection : trace.reflection)
        ASSERT_NO_FATAL_FAILURE(checkThings(world, reflection));
}

// The rows of all kinds add up to the height, in each column.
void checkFrame(const std::string& text, int width, int height) {
    rapidjson::Document parsed;
    ASSERT_FALSE(parsed.Parse(text.c_str()).HasParseError());
    const rapidjson::Value& json = parsed;
    std::vector<double> sums(static_cast<std::size_t>(width));
    for (const auto& kind : json["columns"]["rows"].GetObject()) {
        ASSERT_EQ(kind.value.Size(), sums.size()) << kind.name.GetString();
        for (rapidjson::SizeType i = 0; i < kind.value.Size(); ++i)
            sums[i] += kind.value[i].GetDouble();
    }
    ASSERT_EQ(sums, std::vector<double>(sums.size(), height));
    const double most = static_cast<double>(width) * height * 1000.0;
    for (const auto& texture : json["textures"].GetArray()) {
        for (const auto& rows : texture["texels"].GetArray()) {
            ASSERT_TRUE(rows.GetDouble() >= 0.0 && rows.GetDouble() < most) << rows.GetDouble();
        }
    }
}

// Asks everything about the session's picture of this size.
void askAll(Session& session, Random& random, int width, int height) {
    SCOPED_TRACE(words(width, "x", height, " ", session.option("method")));
    const World& world = session.world();
    std::vector<int> columns(static_cast<std::size_t>(width));
    for (int i = 0; i < width; ++i) columns[static_cast<std::size_t>(i)] = i;
    int told = 0;
    session.trace(
        {.width = width, .height = height, .columns = columns, .watchedRow = random.below(height)},
        [&](const SliceTrace& trace) {
            ++told;
            if (!testing::Test::HasFatalFailure()) checkTrace(world, trace, height);
        });
    ASSERT_EQ(told, width);
    ASSERT_FALSE(testing::Test::HasFatalFailure());
    ASSERT_NO_FATAL_FAILURE(checkFrame(frameTraceJson(session, "", width, height), width, height));

    PackedValues packed;
    std::vector<int> some;
    for (int i = 0; i < kSingleColumns; ++i) some.push_back(random.below(width));
    packHits(session, "", width, height, some, packed);
    packTraces(session, "", width, height, some, packed);
    ASSERT_FALSE(hitsJson(session, "", width, height, some[0]).empty());
    ASSERT_FALSE(traceJson(session, "", width, height, some[0]).empty());
    for (const int column : some) {
        JsonText json;
        writePick(json, session, width, height, column, random.below(height));
        ASSERT_FALSE(json.str().empty());
    }

    // Rays in plan, also from where the eye is
    const Eye eye = session.eye();
    for (const bool hasHeight : {false, true}) {
        JsonText json;
        CastFrom from = {
            .map = eye.map,
            .x = eye.x,
            .y = eye.y,
            .z = {},
            .headingDegrees = random.oneIn(2) ? eye.headingDegrees : 45.0 * random.below(8)};
        if (hasHeight) from.z = eye.z;
        writeCast(json, world, from);
        ASSERT_FALSE(json.str().empty());
    }
}

// Sets each of the old ways, or none.
void setOldWays(Session& session, Random& random) {
    for (const OptionInfo& option : knownOptions()) {
        if (std::string_view(option.name).substr(0, 8) != "classic.") continue;
        if (option.kind == OptionKind::onOff)
            session.setOption(option.name, random.oneIn(3) ? "on" : "off");
    }
    constexpr auto kProjections = std::to_array({"plane", "equalAngles", "equalAnglesCorrected"});
    session.setOption("classic.projection",
                      kProjections[static_cast<std::size_t>(random.below(3))]);
    session.setOption("classic.roofs", random.oneIn(3) ? "flat" : "textured");
    session.setOption("classic.step", "0.1");
    session.setOption("classic.sineSteps", random.oneIn(2) ? 0.0 : random.between(1, 400));
    session.setOption("classic.pixelSize", random.oneIn(2) ? 1.0 : random.between(1, 64));
}

// Both renderers, and half a picture of each; the old one with its defaults and with old ways.
void askBoth(Session& session, Random& random, int width, int height) {
    for (const char* method : {"exact", "classic"}) {
        session.setOption("method", method);
        ASSERT_NO_FATAL_FAILURE(askAll(session, random, width, height));
    }
    setOldWays(session, random);
    session.setOption("compare", random.oneIn(2) ? "0" : "0.5");
    ASSERT_NO_FATAL_FAILURE(askAll(session, random, width, height));
    for (const OptionInfo& option : knownOptions()) {
        if (std::string_view(option.name).substr(0, 7) == "classic")
            session.setOption(option.name, option.standard);
    }
    session.setOption("compare", "0");
}

Eye anyEye(Random& random, const World& world) {
    const int map = random.below(static_cast<int>(world.maps.size()));
    const Map& grid = world.maps[static_cast<std::size_t>(map)];
    return {.map = map,
            .x = {random.between(0, grid.width * 65536 - 1)},
            .y = {random.between(0, grid.depth * 65536 - 1)},
            .z = {random.between(1, (grid.levels + 1) * 65536)},
            .headingDegrees = random.oneIn(3) ? 45.0 * random.below(8) : random.between(0.0, 360.0),
            .look = random.oneIn(2) ? 0.0 : random.between(-0.5, 0.5)};
}

class TracesOfScene : public testing::TestWithParam<std::string> {};

TEST_P(TracesOfScene, SayWhatThePictureShows) {
    const auto all = shippedScenes();
    const auto number =
        static_cast<std::size_t>(std::find(all.begin(), all.end(), GetParam()) - all.begin());
    Session session(shippedWorld(GetParam()));
    Random random(number + 1);
    constexpr std::size_t kViews = kSanitized ? 4 : 10;
    for (std::size_t view = 0; view < kViews; ++view) {
        if (view > 0) session.setEye(anyEye(random, session.world()));
        // All scenes together have all widths, narrow and wide ones in turn
        const std::size_t turn = number * kViews + view;
        const int width = kWidths[turn * 7 % kWidths.size()];
        ASSERT_NO_FATAL_FAILURE(
            askBoth(session, random, width, kHeights[turn * 3 % kHeights.size()]));
        for (int step = 0; step < 20; ++step) session.step({.use = step == 0});
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, TracesOfScene, testing::ValuesIn(shippedScenes()),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(Traces, OfRandomWorldsSayWhatThePictureShows) {
    using MakeScene = judge::Scene (*)(std::uint64_t, int, int);
    constexpr auto kKinds = std::to_array<MakeScene>(
        {judge::randomScene, judge::randomScene, judge::tieScene, judge::alongBorderScene,
         judge::largeTextureScene, judge::wideLandScene});
    constexpr std::uint64_t kWorlds = kSanitized ? 160 : 480;
    for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
        SCOPED_TRACE(words("seed ", seed));
        // Most pictures are narrow, so that many worlds are seen
        const std::size_t most = seed % 8 == 0 ? kWidths.size() : 20;
        const int width = kWidths[seed * 7 % most];
        const int height = kHeights[seed * 3 % kHeights.size()];
        judge::Scene scene = kKinds[seed % kKinds.size()](seed, width, height);
        const judge::View view = scene.view;
        Session session(std::move(scene.world));
        session.setOption("fov", view.fovDegrees);
        session.setOption("mirrors", view.mirrors);
        session.setOption("detail", view.detail ? "on" : "off");
        session.setEye(judge::eyeOf(view));
        Random random(seed);
        ASSERT_NO_FATAL_FAILURE(askBoth(session, random, width, height));
    }
}

}  // namespace
}  // namespace slicecast
