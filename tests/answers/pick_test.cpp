// pick names the texel that the picture has at a pixel, and project finds that pixel again from the
// point that pick names.
#include "answers/pick.h"

#include "sanitized.h"
#include "session/hall.h"
#include "world_builder.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

using Json = rapidjson::Value;

constexpr int kPickWidth = 96;
constexpr int kPickHeight = 72;
constexpr int kPickEvery = kSanitized ? 3 : 1;  // column in a row

World fencedHall() {
    World world = hall("fence", numbered(16, 200, 255, true), numbered(16, 250, 255, true));
    world.blueprints[3].textureRise = toCoordinate(0.35);
    world.maps[0].objects[0].y = toCoordinate(4.75);
    return world;
}

class PickTest : public testing::Test {
protected:
    explicit PickTest(World world = fencedHall()) : session(std::move(world)) {
        EXPECT_EQ(session.setOption("light", "off"), "");
        EXPECT_EQ(session.setOption("fog", "off"), "");
        look(-12.0);
    }
    void look(double heading, double look = 0.05) {
        EXPECT_TRUE(session.setEye({.map = 0,
                                    .x = toCoordinate(2.3),
                                    .y = toCoordinate(5.2),
                                    .z = toCoordinate(0.6),
                                    .headingDegrees = heading,
                                    .look = look}));
    }
    const rapidjson::Document& pick(int column, int row) {
        JsonText text;
        writePick(text, session, kPickWidth, kPickHeight, column, row);
        json.Parse<rapidjson::kParseFullPrecisionFlag>(text.str().c_str());
        EXPECT_FALSE(json.HasParseError()) << text.str();
        return json;
    }
    std::vector<Pixel> picture() {
        std::vector<Pixel> pixels(static_cast<std::size_t>(kPickWidth * kPickHeight));
        EXPECT_TRUE(session.draw({pixels.data(), kPickWidth, kPickHeight, kPickWidth}));
        return pixels;
    }
    void expectTexelsOfPictures();
    void expectPointsInTheirPixels();
    bool isDivider(int column) const {
        const double share = session.options().compare;
        return share > 0.0 && std::abs(column + 0.5 - share * kPickWidth) < 4.0;
    }
    Colour texelOf(const Json& picked) const {
        const World& world = session.world();
        const std::string name = picked["texture"].GetString();
        const auto detail = picked["texel"]["detail"].GetUint();
        const auto u = picked["texel"]["u"].GetUint();
        const auto v = picked["texel"]["v"].GetUint();
        for (const Sprite& sprite : world.sprites) {
            if (sprite.name != name) continue;
            const SpriteLevel& level = sprite.frames[0][detail];
            return toColour(level.texels[u * static_cast<unsigned>(level.height) + v]);
        }
        for (const Texture& texture : world.textures) {
            if (texture.name != name) continue;
            const TextureLevel& level = texture.levels[detail];
            return toColour(level.texels[(u << level.bits) + v]);
        }
        ADD_FAILURE() << name;
        return {};
    }

    Session session;
    rapidjson::Document json;
};

// Compares every pixel of pictures with the texel that is picked there, by the method of the
// options.
void PickTest::expectTexelsOfPictures() {
    std::map<std::string, int> seen;
    int behindPortals = 0;
    int throughHoles = 0;
    for (const double heading : {-12.0, 5.0, 40.0}) {
        look(heading);
        const std::vector<Pixel> pixels = picture();
        for (int row = 0; row < kPickHeight; ++row) {
            for (int column = row % kPickEvery; column < kPickWidth; column += kPickEvery) {
                const Json& picked = pick(column, row);
                const std::string what = picked["what"].GetString();
                ++seen[what];
                ASSERT_EQ(picked["column"].GetInt(), column);
                ASSERT_EQ(picked["row"].GetInt(), row);
                if (what == "sky" || what == "haze") {
                    EXPECT_TRUE(picked["point"].IsNull() && picked["texel"].IsNull());
                    continue;
                }
                behindPortals += picked["portals"].GetInt();
                // Texels that mix holes with colours, and the divider, have other colours.
                if (picked["alpha"].GetInt() < 255 || isDivider(column)) continue;
                const Pixel pixel = pixels[static_cast<std::size_t>(row * kPickWidth + column)];
                ASSERT_EQ(toColour(pixel), texelOf(picked)) << what << column << "," << row;
                const SliceTrace trace = session.trace(kPickWidth, kPickHeight, column, row);
                if (trace.seen.size() > 1 && picked["texture"] != "fence" &&
                    picked["texture"] != "lamp")
                    ++throughHoles;
            }
        }
    }
    for (const char* what : {"side", "roof", "floor", "ceiling", "sky", "object", "underside"})
        EXPECT_GT(seen[what] * kPickEvery, 4) << what;
    EXPECT_GT(behindPortals * kPickEvery, 50);
    EXPECT_GT(throughHoles * kPickEvery, 20);
}

TEST_F(PickTest, EveryPixelShowsThePickedTexel) {
    expectTexelsOfPictures();
}

TEST_F(PickTest, EveryPixelOfTheClassicMethodShowsThePickedTexel) {
    EXPECT_EQ(session.setOption("method", "classic"), "");
    expectTexelsOfPictures();
    EXPECT_EQ(session.setOption("method", "exact"), "");
    EXPECT_EQ(session.setOption("compare", "0.6"), "");
    // Columns near the divider are not compared: it is drawn over them.
    expectTexelsOfPictures();
}

TEST_F(PickTest, EveryPixelOfAnOldWayShowsThePickedTexel) {
    EXPECT_EQ(session.setOption("method", "classic"), "");
    for (const auto& [name, value] : std::map<const char*, const char*>{
             {"classic.projection", "equalAngles"},
             {"classic.painter", "on"},
             {"classic.mirroredTextures", "on"},
             {"classic.pixelSize", "3"},
         }) {
        const std::string before = session.option(name);
        EXPECT_EQ(session.setOption(name, value), "");
        expectTexelsOfPictures();
        EXPECT_EQ(session.setOption(name, before), "");
    }
}

TEST_F(PickTest, APointIsProjectedIntoThePixelThatShowsIt) {
    expectPointsInTheirPixels();
}

TEST_F(PickTest, APointOfTheClassicMethodIsProjectedIntoThePixelThatShowsIt) {
    EXPECT_EQ(session.setOption("compare", "0.5"), "");
    expectPointsInTheirPixels();
}

void PickTest::expectPointsInTheirPixels() {
    int points = 0;
    for (int row = 0; row < kPickHeight; ++row) {
        for (int column = 0; column < kPickWidth; ++column) {
            const Json& picked = pick(column, row);
            if (picked["point"].IsNull()) continue;
            const Json& point = picked["point"];
            const int map = picked["map"] == "hall" ? 0 : 1;
            const auto back =
                project(session, session.eye(),
                        {point[0].GetDouble(), point[1].GetDouble(), point[2].GetDouble()}, map,
                        kPickWidth, kPickHeight);
            if (map == 1) {
                EXPECT_FALSE(back.has_value()) << "in another map";
                continue;
            }
            if (picked["portals"].GetInt() > 0) continue;
            ++points;
            ASSERT_TRUE(back.has_value());
            ASSERT_NEAR(back->depth, picked["depth"].GetDouble(), 1e-9);
            ASSERT_NEAR(back->x, column + 0.5, 1e-6) << row;
            // Planes too: the point is where the ray meets the plane's exact height.
            ASSERT_NEAR(back->y, row + 0.5, 1e-6) << column;
        }
    }
    EXPECT_GT(points, 3000);
}

TEST_F(PickTest, FindsTileLevelFaceAndObject) {
    look(5.0);
    std::map<std::string, int> faces;
    for (int row = 0; row < kPickHeight; ++row) {
        for (int column = 0; column < kPickWidth; ++column) {
            const Json& picked = pick(column, row);
            if (picked["map"] != "hall") continue;
            const std::string what = picked["what"].GetString();
            EXPECT_EQ(picked["object"].IsNull(), what != "object");
            const bool isBlock = what == "side" || what == "roof" || what == "underside";
            EXPECT_EQ(picked["level"].IsNull(), !isBlock);
            EXPECT_EQ(picked["tile"].IsNull(), !isBlock && what != "floor" && what != "ceiling");
            if (!isBlock) continue;
            const Map& map = session.world().maps[0];
            const BlueprintId id = map.cell(picked["tile"][0].GetInt(), picked["tile"][1].GetInt(),
                                            picked["level"].GetInt());
            ASSERT_EQ(picked["blueprint"], session.world().blueprints[id].name.c_str());
            const std::string face = picked["face"].GetString();
            ++faces[face];
            const double x = picked["point"][0].GetDouble() - picked["tile"][0].GetInt();
            const double y = picked["point"][1].GetDouble() - picked["tile"][1].GetInt();
            EXPECT_GE(x, -1e-9);
            EXPECT_LE(x, 1.0 + 1e-9);
            if (face == "west") {
                EXPECT_NEAR(x, 0.0, 1e-9);
            }
            if (face == "north") {
                EXPECT_NEAR(y, 0.0, 1e-9);
            }
            if (face == "south") {
                EXPECT_NEAR(y, 1.0, 1e-9);
            }
        }
    }
    EXPECT_GT(faces["west"], 100);
    EXPECT_GT(faces["top"], 10);
    EXPECT_GT(faces["bottom"], 0);
}

class PickMirrorTest : public PickTest {
protected:
    PickMirrorTest()
        : PickTest([] {
              World world = fencedHall();
              world.maps[0].floor.mirror = 255;
              return world;
          }()) {}
    void expectReflections();
};

TEST_F(PickMirrorTest, FindsReflections) {
    expectReflections();
}

TEST_F(PickMirrorTest, FindsReflectionsOfTheClassicMethod) {
    EXPECT_EQ(session.setOption("method", "classic"), "");
    expectReflections();
}

TEST_F(PickMirrorTest, FlippedReflectionsHaveNoRay) {
    EXPECT_EQ(session.setOption("method", "classic"), "");
    EXPECT_EQ(session.setOption("classic.flippedMirrors", "on"), "");
    int floors = 0;
    for (int row = 0; row < kPickHeight; ++row) {
        const Json& picked = pick(10, row);
        if (picked["what"] == "floor") ++floors;
        EXPECT_TRUE(picked["reflection"].IsNull());
    }
    EXPECT_GT(floors, 10);
}

void PickMirrorTest::expectReflections() {
    look(5.0);
    const std::vector<Pixel> pixels = picture();
    int reflected = 0;
    for (int row = 0; row < kPickHeight; ++row) {
        for (int column = 0; column < kPickWidth; ++column) {
            const Json& picked = pick(column, row);
            const Json& reflection = picked["reflection"];
            EXPECT_EQ(reflection.IsNull(), picked["what"] != "floor" || picked["map"] != "hall");
            if (reflection.IsNull() || reflection["point"].IsNull()) continue;
            if (reflection["alpha"].GetInt() < 255) continue;
            ++reflected;
            EXPECT_EQ(reflection["row"].GetInt(), row);
            ASSERT_EQ(toColour(pixels[static_cast<std::size_t>(row * kPickWidth + column)]),
                      texelOf(reflection));
            // At height 0 the ray is reflected: it rises as steeply as it fell.
            const double depth = reflection["depth"].GetDouble();
            EXPECT_GT(depth, picked["depth"].GetDouble());
            const double mirrored = 0.6 * (depth / picked["depth"].GetDouble() - 1.0);
            if (reflection["portals"].GetInt() == 0) {
                ASSERT_NEAR(reflection["point"][2].GetDouble(), mirrored, 1e-4);
            }
        }
    }
    EXPECT_GT(reflected, 300);
}

TEST_F(PickTest, PointsBehindTheEyeAreNotProjected) {
    look(0.0, 0.0);
    EXPECT_FALSE(
        project(session, session.eye(), {2.2, 5.2, 0.6}, 0, kPickWidth, kPickHeight).has_value());
    EXPECT_FALSE(project(session, session.eye(), {session.eye().x.value(), 9.0, 0.6}, 0, kPickWidth,
                         kPickHeight));
    const auto ahead = project(
        session, session.eye(),
        {session.eye().x.value() + 2.0, session.eye().y.value(), session.eye().z.value() + 1.0}, 0,
        kPickWidth, kPickHeight);
    ASSERT_TRUE(ahead.has_value());
    EXPECT_DOUBLE_EQ(ahead->x, kPickWidth / 2.0);
    EXPECT_DOUBLE_EQ(ahead->depth, 2.0);
    // d = (W / 2) / tan(fov / 2), and a unit at depth 2 is d / 2 rows high.
    const double distance = kPickWidth / 2.0 / std::tan(30.0 * M_PI / 180.0);
    EXPECT_NEAR(ahead->y, kPickHeight / 2.0 - distance / 2.0, 1e-9);
}

// From the front nothing of it is seen.
TEST(PickSprite, LooksAtTheSideThatIsShown) {
    WorldBuilder make;
    make.texture("grey", {200, 200, 200, 255});
    make.block('#');
    make.map("room", 1, R"(
########
#......#
#......#
########
)");
    Image sheet(8, 32);
    for (std::size_t i = 8 * 8; i < sheet.pixels.size(); ++i)
        sheet.pixels[i] = toPixel({255, 255, 255, 255});
    make.world.sprites.push_back(makeSprite("figure", sheet, 1, 0.0, 4));
    make.object(4.5, 2.0, 0.0, 0.8, 0.9);
    make.start(2.5, 2.0);
    Session session(std::move(make.world));
    const auto seen = [&](int facing) {
        const_cast<Map&>(session.world().maps[0]).objects[0].facingX = tileEdge(facing);
        const SliceTrace trace = session.trace(kPickWidth, kPickHeight, kPickWidth / 2, 44);
        return nearestSeen(session.world(), trace).rows->what;
    };
    for (const char* method : {"exact", "classic"}) {
        EXPECT_EQ(session.setOption("method", method), "");
        EXPECT_EQ(seen(1), FilledRows::What::object) << "its back, by the method " << method;
        EXPECT_NE(seen(-1), FilledRows::What::object) << method;
    }
}

// The floor before it and behind it is one run, which is found before the object.
TEST(Pick, FindsAnObjectOnAnOpenPlane) {
    WorldBuilder make;
    make.texture("grey", {128, 128, 128, 255});
    make.block('#', {.name = "wall"});
    make.map("plane", 1, R"(
..........
..........
..........
..........
)");
    make.world.sprites.push_back(makeSprite("figure", imageOf({250, 220, 40, 255}), 1));
    make.object(5.5, 2.0, 0.0, 0.8, 0.9);
    make.start(2.5, 2.0);
    Session session(std::move(make.world));
    const auto seen = [&](int row) {
        const SliceTrace trace = session.trace(kPickWidth, kPickHeight, kPickWidth / 2, row);
        return nearestSeen(session.world(), trace).rows->what;
    };
    EXPECT_EQ(seen(kPickHeight / 2 + 4), FilledRows::What::object);
    EXPECT_EQ(seen(kPickHeight - 1), FilledRows::What::floor);
}

}  // namespace
}  // namespace slicecast
