// What a trace tells is what the picture shows: its texels are those of the picture, its depths
// those of the definition, and no row is missing.
#include "answers/trace_json.h"

#include "answers/hits_json.h"
#include "base/angle.h"
#include "session/hall.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

using Json = rapidjson::Value;

constexpr int kTraceWidth = 120;
constexpr int kTraceHeight = 90;

World glassHall() {
    World world = hall("glass", numbered(16, 200, 120), numbered(16, 250));
    world.maps[0].floor.mirror = 255;
    world.maps[0].fog = {.on = true, .start = 2.0, .end = 12.0};
    BakedLight& baked = world.maps[0].baked;
    baked.on = true;
    baked.sun = {200, 180, 120, 255};
    baked.azimuth = 200.0;
    baked.altitude = 40.0;
    baked.ambient = {90, 110, 150, 255};
    baked.lamps.push_back({toCoordinate(8.5), toCoordinate(5.5), toCoordinate(1.2), {}});
    return world;
}

class TraceJsonTest : public testing::Test {
protected:
    TraceJsonTest() : session(glassHall()) {
        set("mirrors", "0");
        EXPECT_TRUE(session.setEye({.map = 0,
                                    .x = toCoordinate(2.3),
                                    .y = toCoordinate(5.2),
                                    .z = toCoordinate(0.6),
                                    .headingDegrees = 5.0,
                                    .look = 0.05}));
    }
    void set(const char* option, const char* value) {
        EXPECT_EQ(session.setOption(option, value), "");
    }

    rapidjson::Document parsed(const std::string& text) {
        rapidjson::Document json;
        EXPECT_FALSE(json.Parse<rapidjson::kParseFullPrecisionFlag>(text.c_str()).HasParseError())
            << text;
        return json;
    }
    rapidjson::Document trace(int column) {
        return parsed(traceJson(session, "scene", kTraceWidth, kTraceHeight, column));
    }

    std::vector<Pixel> picture() {
        std::vector<Pixel> pixels(static_cast<std::size_t>(kTraceWidth * kTraceHeight));
        EXPECT_TRUE(session.draw({pixels.data(), kTraceWidth, kTraceHeight, kTraceWidth}));
        return pixels;
    }

    // The texture's own texel.
    Colour texelOf(const Json& run, const Json& texel) const {
        const World& world = session.world();
        const std::string name = run["texture"].GetString();
        const auto detail = texel["detail"].GetUint();
        for (const Sprite& sprite : world.sprites) {
            if (sprite.name != name) continue;
            const SpriteLevel& level = sprite.frames[0][detail];
            EXPECT_EQ(texel["size"][0].GetInt(), level.width);
            return toColour(level.texels.at(
                texel["u"].GetUint() * static_cast<unsigned>(level.height) + texel["v"].GetUint()));
        }
        for (const Texture& texture : world.textures) {
            if (texture.name != name) continue;
            const TextureLevel& level = texture.levels[detail];
            EXPECT_EQ(texel["size"][0].GetInt(), level.size);
            EXPECT_EQ(texel["size"][1].GetInt(), level.size);
            return toColour(
                level.texels.at((texel["u"].GetUint() << level.bits) + texel["v"].GetUint()));
        }
        ADD_FAILURE() << name;
        return {};
    }

    Session session;
};

// Rows over which nothing is laid.
std::vector<bool> bareRows(const Json& trace) {
    std::vector<bool> bare(kTraceHeight, true);
    for (const Json& run : trace["runs"].GetArray()) {
        if (!run["layer"].GetBool()) continue;
        for (int row = run["first"].GetInt(); row <= run["last"].GetInt(); ++row)
            bare[static_cast<std::size_t>(row)] = false;
    }
    return bare;
}

TEST_F(TraceJsonTest, TexelsEqualThePictures) {
    for (const bool isLit : {false, true}) {
        set("light", isLit ? "on" : "off");
        set("fog", isLit ? "on" : "off");
        set("baked", isLit ? "on" : "off");
        std::set<int> lights;
        const std::vector<Pixel> pixels = picture();
        std::map<std::string, int> compared;
        int finest = 99;
        int coarsest = 0;
        for (int column = 0; column < kTraceWidth; ++column) {
            const rapidjson::Document json = trace(column);
            const std::vector<bool> bare = bareRows(json);
            for (const Json& run : json["runs"].GetArray()) {
                for (const Json& texel : run["texels"].GetArray()) {
                    const int row = texel["row"].GetInt();
                    if (run["layer"].GetBool() || !bare[static_cast<std::size_t>(row)]) continue;
                    const Colour own = texelOf(run, texel);
                    const Colour haze = session.world().maps[run["map"] == "hall" ? 0 : 1].haze;
                    const auto shown = [&](int channel, unsigned number, int hazeChannel) {
                        const int baked = texel["baked"][number].GetInt();
                        lights.insert(baked);
                        const int under = (channel * baked + 128) >> 8;
                        const int lit = (under * texel["light"].GetInt() + 128) >> 8;
                        const int fog = texel["fog"].GetInt();
                        return (hazeChannel * fog + lit * (255 - fog) + 127) / 255;
                    };
                    const Colour is =
                        toColour(pixels[static_cast<std::size_t>(row * kTraceWidth + column)]);
                    ASSERT_EQ(shown(own.r, 0, haze.r), is.r)
                        << "column " << column << ", row " << row << ", "
                        << run["what"].GetString();
                    ASSERT_EQ(shown(own.g, 1, haze.g), is.g)
                        << "column " << column << ", row " << row << ", "
                        << run["what"].GetString();
                    ASSERT_EQ(shown(own.b, 2, haze.b), is.b)
                        << "column " << column << ", row " << row << ", "
                        << run["what"].GetString();
                    if (!isLit) {
                        EXPECT_EQ(texel["light"].GetInt(), 256);
                        EXPECT_EQ(texel["fog"].GetInt(), 0);
                    }
                    ++compared[run["what"].GetString()];
                    finest = std::min(finest, texel["detail"].GetInt());
                    coarsest = std::max(coarsest, texel["detail"].GetInt());
                }
            }
        }
        for (const char* what : {"side", "roof", "underside", "floor", "ceiling"})
            EXPECT_GT(compared[what], 10) << what;
        EXPECT_EQ(finest, 0);
        EXPECT_GT(coarsest, 1);
        if (isLit) {
            EXPECT_GT(lights.size(), 100u);
        } else {
            EXPECT_EQ(lights, std::set<int>{256});
        }
    }
}

TEST_F(TraceJsonTest, LightFogAndDetailFollowTheDepth) {
    const Light& light = session.world().maps[0].light;
    int texels = 0;
    for (int column = 0; column < kTraceWidth; column += 7) {
        const rapidjson::Document json = trace(column);
        const double d = json["projectionDistance"].GetDouble();
        for (const Json& run : json["runs"].GetArray()) {
            if (run["map"] != "hall") continue;
            for (const Json& texel : run["texels"].GetArray()) {
                const double depth = texel["depth"].GetDouble();
                const double falloff = std::clamp(light.intensity * light.multiplier / depth,
                                                  light.darkest, light.brightest);
                EXPECT_NEAR(texel["light"].GetInt(), std::floor(256.0 * falloff + 0.5), 1.0);
                EXPECT_NEAR(texel["fog"].GetInt(),
                            255.0 * std::clamp((depth - 2.0) / 10.0, 0.0, 1.0), 0.51);
                // Each level halves the texels: the shown one has at most one of them for each
                // pixel, unless it is the finest.
                const double perPixel = depth * texel["size"][1].GetDouble() / d;
                EXPECT_LE(perPixel, 1.0 + 1e-9);
                EXPECT_GT(2.0 * perPixel, texel["detail"].GetInt() > 0 ? 1.0 - 1e-9 : 0.0);
                ++texels;
            }
        }
    }
    EXPECT_GT(texels, 100);
}

TEST_F(TraceJsonTest, TheWalkFollowsItsNumbers) {
    const double eye[] = {toCoordinate(2.3).value(), toCoordinate(5.2).value()};
    for (int column = 0; column < kTraceWidth; column += 11) {
        const rapidjson::Document json = trace(column);
        const double d = json["projectionDistance"].GetDouble();
        EXPECT_NEAR(d, kTraceWidth / 2.0 / tanDegrees(30.0), 1e-9);
        const Json& walk = json["walk"];
        const Json& tiles = json["tiles"];
        ASSERT_EQ(walk.Size(), tiles.Size());
        ASSERT_GT(walk.Size(), 3u);
        EXPECT_TRUE(walk[0]["axis"].IsNull());
        for (rapidjson::SizeType i = 0; i < walk.Size(); ++i) {
            EXPECT_EQ(walk[i]["tile"][0], tiles[i][0]);
            EXPECT_EQ(walk[i]["tile"][1], tiles[i][1]);
            EXPECT_EQ(walk[i]["depth"].GetDouble(), tiles[i][2].GetDouble());
            if (i == 0 || walk[i]["portals"] != walk[i - 1]["portals"] || walk[i]["map"] != "hall")
                continue;
            const int axis = walk[i]["axis"] == "x" ? 0 : 1;
            const double ray = json["ray"][axis].GetDouble();
            const int tile = walk[i]["tile"][axis].GetInt();
            EXPECT_DOUBLE_EQ(walk[i]["distance"].GetDouble(),
                             ray > 0.0 ? tile - eye[axis] : eye[axis] - (tile + 1));
            EXPECT_NEAR(walk[i]["speed"].GetDouble(), d * std::fabs(ray), 1e-9);
            EXPECT_EQ(walk[i]["along"].GetDouble(),
                      walk[i]["distance"].GetDouble() / walk[i]["speed"].GetDouble());
            EXPECT_EQ(walk[i]["depth"].GetDouble(), walk[i]["along"].GetDouble() * d);
            const Json& next = walk[i - 1]["next"];
            EXPECT_EQ(walk[i]["along"].GetDouble(), next[axis].GetDouble());
            EXPECT_LE(next[axis].GetDouble(), next[1 - axis].GetDouble());
        }
    }
}

// The wall at x = 12 is 9.7 units away in every column: no fish eye.
TEST_F(TraceJsonTest, DepthsAndRowsFollowTheDefinition) {
    ASSERT_TRUE(session.setEye(
        {.map = 0, .x = toCoordinate(2.3), .y = toCoordinate(2.6), .z = toCoordinate(0.6)}));
    const double depth = 12.0 - toCoordinate(2.3).value();
    int walls = 0;
    for (const int column : {0, 30, 59, 90}) {
        const rapidjson::Document json = trace(column);
        EXPECT_EQ(json["eye"]["x"].GetDouble(), toCoordinate(2.3).value());
        EXPECT_EQ(json["column"].GetInt(), column);
        EXPECT_EQ(json["horizonRow"].GetDouble(), kTraceHeight / 2.0);
        for (const Json& run : json["runs"].GetArray()) {
            if (run["what"] != "side" || run["face"] != "west" || run["map"] != "hall" ||
                json["hits"][run["hit"].GetUint()]["tile"][0].GetInt() != 12)
                continue;
            const Json& hit = json["hits"][run["hit"].GetUint()];
            EXPECT_EQ(hit["blueprint"], "wall");
            EXPECT_EQ(run["texture"], "stone");
            EXPECT_NEAR(run["texels"][0]["depth"].GetDouble(), depth, 1e-9);
            const double sideways =
                (column + 0.5 - kTraceWidth / 2.0) / json["projectionDistance"].GetDouble();
            EXPECT_NEAR(hit["rawDepth"].GetDouble(), depth * std::sqrt(1.0 + sideways * sideways),
                        1e-9);
            const double rows = json["projectionDistance"].GetDouble() / depth;
            EXPECT_NEAR(hit["topFrontRow"].GetDouble(),
                        kTraceHeight / 2.0 - (1.0 - toCoordinate(0.6).value()) * rows, 1e-9);
            EXPECT_NEAR(hit["bottomFrontRow"].GetDouble(),
                        kTraceHeight / 2.0 + toCoordinate(0.6).value() * rows, 1e-9);
            // Which texel, by the definition: along y on a western side, from the top of the level
            // downwards.
            const double y = hit["point"][1].GetDouble();
            const int size = run["texels"][0]["size"][0].GetInt();
            EXPECT_EQ(run["texels"][0]["u"].GetInt(), static_cast<int>((y - std::floor(y)) * size));
            for (const Json& texel : run["texels"].GetArray()) {
                const double height = toCoordinate(0.6).value() +
                                      (kTraceHeight / 2.0 - (texel["row"].GetInt() + 0.5)) / rows;
                EXPECT_EQ(texel["v"].GetInt(), static_cast<int>((1.0 - height) * size));
            }
            ++walls;
        }
    }
    EXPECT_GE(walls, 2);
}

TEST_F(TraceJsonTest, OpaqueRunsHoldEveryRowOnce) {
    bool throughPortal = false;
    for (int column = 0; column < kTraceWidth; ++column) {
        const rapidjson::Document json = trace(column);
        std::vector<int> times(kTraceHeight, 0);
        for (const Json& run : json["runs"].GetArray()) {
            throughPortal |= run["portals"].GetInt() > 0;
            if (run["layer"].GetBool()) continue;
            for (int row = run["first"].GetInt(); row <= run["last"].GetInt(); ++row)
                ++times.at(static_cast<std::size_t>(row));
        }
        ASSERT_EQ(times, std::vector<int>(kTraceHeight, 1)) << "column " << column;
    }
    ASSERT_TRUE(session.setEye({.map = 0,
                                .x = toCoordinate(2.3),
                                .y = toCoordinate(3.4),
                                .z = toCoordinate(0.6),
                                .headingDegrees = -20.0}));
    for (int column = 0; column < kTraceWidth; ++column)
        throughPortal |= trace(column)["portals"].Size() > 0;
    EXPECT_TRUE(throughPortal);
}

TEST_F(TraceJsonTest, GlassAndObjectsAreLayers) {
    std::map<std::string, int> layers;
    for (int column = 0; column < kTraceWidth; ++column) {
        const rapidjson::Document json = trace(column);
        for (const Json& run : json["runs"].GetArray()) {
            if (!run["layer"].GetBool()) continue;
            ++layers[run["texture"].GetString()];
            EXPECT_EQ(run["object"].IsNull(), run["what"] != "object");
            EXPECT_EQ(run["hit"].IsNull(), run["what"] == "object");
            EXPECT_EQ(run["texels"].Size(), 2u);
            texelOf(run, run["texels"][0]);
        }
    }
    EXPECT_GT(layers["glass"], 10);
    EXPECT_GT(layers["lamp"], 3);
    EXPECT_EQ(layers.size(), 2u);
}

// The lamp is opaque, so where it is the last layer its own texels are seen.
TEST_F(TraceJsonTest, AnObjectsTexelsEqualThePictures) {
    set("baked", "off");
    set("light", "off");
    set("fog", "off");
    const std::vector<Pixel> pixels = picture();
    int compared = 0;
    for (int column = 0; column < kTraceWidth; ++column) {
        const rapidjson::Document json = trace(column);
        for (const Json& run : json["runs"].GetArray()) {
            if (run["what"] != "object") continue;
            for (const Json& texel : run["texels"].GetArray()) {
                const Colour own = texelOf(run, texel);
                const Colour is = toColour(
                    pixels[texel["row"].GetUint() * kTraceWidth + static_cast<unsigned>(column)]);
                EXPECT_EQ(own.r, is.r) << column;
                EXPECT_EQ(own.g, is.g) << column;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 6);
}

// A mirror of full strength shows nothing but what is in it.
TEST_F(TraceJsonTest, TheReflectionsTexelsEqualThePictures) {
    set("mirrors", "1");
    set("baked", "off");
    set("light", "off");
    set("fog", "off");
    ASSERT_TRUE(session.setEye({.map = 0,
                                .x = toCoordinate(2.3),
                                .y = toCoordinate(5.2),
                                .z = toCoordinate(0.6),
                                .headingDegrees = 5.0,
                                .look = -0.3}));
    const std::vector<Pixel> pixels = picture();
    std::map<std::string, int> compared;
    for (int column = 0; column < kTraceWidth; ++column) {
        const rapidjson::Document json = trace(column);
        std::vector<int> mirrored(kTraceHeight, 0);
        for (const Json& mirror : json["mirrors"].GetArray()) {
            EXPECT_EQ(mirror["strength"].GetInt(), 255);
            for (int row = mirror["first"].GetInt(); row <= mirror["last"].GetInt(); ++row)
                ++mirrored[static_cast<std::size_t>(row)];
        }
        ASSERT_FALSE(json["reflection"].IsNull());
        const Json& reflection = json["reflection"];
        const std::vector<bool> bare = bareRows(reflection);
        const std::vector<bool> bareBefore = bareRows(json);
        std::vector<int> filled(kTraceHeight, 0);
        for (const Json& run : reflection["runs"].GetArray()) {
            if (run["layer"].GetBool()) continue;
            for (int row = run["first"].GetInt(); row <= run["last"].GetInt(); ++row)
                ++filled.at(static_cast<std::size_t>(row));
            for (const Json& texel : run["texels"].GetArray()) {
                const int row = texel["row"].GetInt();
                if (!bare[static_cast<std::size_t>(row)] ||
                    !bareBefore[static_cast<std::size_t>(row)])
                    continue;
                const Colour own = texelOf(run, texel);
                const Colour is =
                    toColour(pixels[static_cast<std::size_t>(row * kTraceWidth + column)]);
                ASSERT_EQ(own.r, is.r)
                    << "column " << column << ", row " << row << ", " << run["what"].GetString();
                ASSERT_EQ(own.g, is.g)
                    << "column " << column << ", row " << row << ", " << run["what"].GetString();
                ++compared[run["what"].GetString()];
            }
        }
        ASSERT_EQ(filled, mirrored) << "column " << column;
    }
    for (const char* what : {"side", "ceiling"}) EXPECT_GT(compared[what], 10) << what;
    set("mirrors", "0");
    EXPECT_TRUE(trace(60)["reflection"].IsNull());
}

TEST_F(TraceJsonTest, IncludesTheHits) {
    const rapidjson::Document whole = trace(70);
    const rapidjson::Document hits =
        parsed(hitsJson(session, "scene", kTraceWidth, kTraceHeight, 70));
    ASSERT_GT(hits.MemberCount(), 10u);
    for (const auto& member : hits.GetObject()) {
        ASSERT_TRUE(whole.HasMember(member.name)) << member.name.GetString();
        EXPECT_EQ(whole[member.name], member.value) << member.name.GetString();
    }
}

TEST_F(TraceJsonTest, APicturesTraceIsTheSumOfItsColumns) {
    const rapidjson::Document frame =
        parsed(frameTraceJson(session, "scene", kTraceWidth, kTraceHeight));
    double layers = 0.0;
    double texels = 0.0;
    double textured = 0.0;
    for (int column = 0; column < kTraceWidth; ++column) {
        const auto at = static_cast<rapidjson::SizeType>(column);
        const rapidjson::Document json = trace(column);
        const Json& columns = frame["columns"];
        EXPECT_EQ(columns["tiles"][at].GetUint(), json["tiles"].Size());
        EXPECT_EQ(columns["hits"][at].GetUint(), json["hits"].Size());
        double nearest = 1e9;
        std::map<std::string, int> rows;
        int laid = 0;
        for (const Json& run : json["runs"].GetArray()) {
            const int count = run["last"].GetInt() + 1 - run["first"].GetInt();
            if (run["layer"].GetBool()) {
                laid += count;
            } else {
                rows[run["what"].GetString()] += count;
            }
            if (run["texels"].Size() > 0) textured += count;
            if (run["hit"].IsNull() && run["object"].IsNull()) continue;
            for (const Json& texel : run["texels"].GetArray())
                nearest = std::min(nearest, texel["depth"].GetDouble());
        }
        if (nearest < 1e9) {
            EXPECT_EQ(columns["nearest"][at].GetDouble(), nearest);
        } else {
            EXPECT_TRUE(columns["nearest"][at].IsNull());
        }
        EXPECT_EQ(columns["layers"][at].GetInt(), laid);
        layers += laid;
        int sum = 0;
        for (const auto& kind : columns["rows"].GetObject()) {
            EXPECT_EQ(kind.value[at].GetInt(), rows[kind.name.GetString()])
                << kind.name.GetString();
            sum += kind.value[at].GetInt();
        }
        EXPECT_EQ(sum, kTraceHeight);
    }
    for (const Json& texture : frame["textures"].GetArray()) {
        for (const Json& number : texture["texels"].GetArray()) texels += number.GetDouble();
    }
    EXPECT_EQ(texels, textured);
    EXPECT_EQ(frame["textures"].Size(), 4u) << "stone, glass, ground and the lamp";
    // A trace tells of layers that nobody sees, too: holes, and what opaque texels hide.
    EXPECT_LE(frame["totals"]["rowsFilled"].GetDouble(), kTraceWidth * kTraceHeight + layers);
    EXPECT_GT(frame["totals"]["rowsFilled"].GetDouble(), kTraceWidth * kTraceHeight);
    EXPECT_GT(frame["totals"]["tilesWalked"].GetInt(), kTraceWidth);
    EXPECT_TRUE(frame["times"].IsNull()) << "nobody measures";
}

TEST_F(TraceJsonTest, TimesAreListedIfMeasured) {
    double now = 0.0;
    session.setClock([&now] { return now += 0.125; });
    for (int i = 0; i < 12; ++i) picture();
    const rapidjson::Document frame =
        parsed(frameTraceJson(session, "scene", kTraceWidth, kTraceHeight));
    EXPECT_NEAR(frame["times"]["viewMilliseconds"].GetDouble(), 125.0, 1.0);
}

}  // namespace
}  // namespace slicecast
