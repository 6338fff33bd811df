// What a column meets behind a portal, in a mirror, and of objects, as JSON.
#include "answers/hits_json.h"
#include "world_builder.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <utility>

namespace slicecast {
namespace {

Image plain() {
    Image image(8, 8);
    for (Pixel& pixel : image.pixels) pixel = toPixel({200, 180, 90, 255});
    return image;
}

// Seen from (1.5, 1.5) to the east: a portal tile at (3, 1) that leads to the northern edge of (2,
// 0) in the cellar, turned by 90 degrees and two levels up. There stand a post three tiles on,
// which goes south, and a lamp before it; both floors reflect.
World portalWorld() {
    WorldBuilder make;
    make.texture("plain", plain());
    make.world.sprites.push_back(makeSprite("lamp", plain()));
    make.block('p', {.name = "post", .top = 0.5});
    make.map("hall", 6, 3, 1).floor.mirror = 128;
    make.map("cellar", 5, 9, 4);
    make.put('p', 2, 3, 2);
    make.object(2.5, 1.5, 2.25, 0.5, 0.25);
    make.tilePortal({.fromMap = 0,
                     .fromX = 3,
                     .fromY = 1,
                     .toMap = 1,
                     .toX = 2,
                     .toY = 0,
                     .turn = 1,
                     .levels = 2});
    markPortals(make.world);
    markSeeThrough(make.world);
    make.start(1.5, 1.5);
    return std::move(make.world);
}

rapidjson::Document hitsOf(int column, const char* mirrors = "1") {
    Session session(portalWorld());
    EXPECT_EQ(session.setOption("mirrors", mirrors), "");
    EXPECT_TRUE(session.setEye(
        {.map = 0, .x = toCoordinate(1.5), .y = toCoordinate(1.5), .z = toCoordinate(0.5)}));
    rapidjson::Document json;
    const std::string text = hitsJson(session, "scene", 101, 80, column);
    EXPECT_FALSE(json.Parse<rapidjson::kParseFullPrecisionFlag>(text.c_str()).HasParseError())
        << text;
    return json;
}

TEST(HitsJson, ListsThePortalsThatRowsPassed) {
    const rapidjson::Document json = hitsOf(50);
    ASSERT_EQ(json["portals"].Size(), 1u);
    const auto& portal = json["portals"][0];
    EXPECT_EQ(portal["portals"].GetInt(), 0);
    EXPECT_EQ(portal["from"]["map"], "hall");
    EXPECT_EQ(portal["from"]["tile"][0].GetInt(), 3);
    EXPECT_EQ(portal["from"]["tile"][1].GetInt(), 1);
    EXPECT_EQ(portal["to"]["map"], "cellar");
    EXPECT_EQ(portal["to"]["tile"][0].GetInt(), 2);
    EXPECT_EQ(portal["to"]["tile"][1].GetInt(), 0);
    EXPECT_EQ(portal["turn"].GetInt(), 90);
    EXPECT_EQ(portal["levels"].GetInt(), 2);
    EXPECT_NEAR(portal["depth"].GetDouble(), 1.5, 1e-12);
    EXPECT_EQ(portal["first"].GetInt(), 0);
    EXPECT_EQ(portal["last"].GetInt(), json["planes"][0]["first"].GetInt() - 1)
        << "the floor before it did not";
    EXPECT_EQ(json["planes"][0]["map"], "hall");
    const auto& beyond = json["planes"][json["planes"].Size() - 1];
    EXPECT_EQ(beyond["map"], "cellar");
}

TEST(HitsJson, NamesTheMapOfEachHit) {
    const rapidjson::Document json = hitsOf(50);
    EXPECT_EQ(json["tiles"][0][3], "hall");
    EXPECT_EQ(json["tiles"][json["tiles"].Size() - 1][3], "cellar");
    ASSERT_EQ(json["hits"].Size(), 1u);
    const auto& hit = json["hits"][0];
    EXPECT_EQ(hit["map"], "cellar");
    EXPECT_EQ(hit["portals"].GetInt(), 1);
    EXPECT_EQ(hit["face"], "north");
    EXPECT_EQ(hit["point"][1].GetDouble(), 3.0);
    EXPECT_EQ(hit["top"].GetDouble(), 2.5);
    EXPECT_NEAR(hit["depth"].GetDouble(), 4.5, 1e-9);
}

TEST(HitsJson, ListsObjects) {
    const rapidjson::Document json = hitsOf(50);
    ASSERT_EQ(json["objects"].Size(), 1u);
    const auto& object = json["objects"][0];
    EXPECT_EQ(object["map"], "cellar");
    EXPECT_EQ(object["portals"].GetInt(), 1);
    EXPECT_EQ(object["sprite"], "lamp");
    EXPECT_EQ(object["point"][0].GetDouble(), 2.5);
    EXPECT_EQ(object["point"][1].GetDouble(), 1.5);
    EXPECT_EQ(object["bottom"].GetDouble(), 2.25);
    EXPECT_EQ(object["top"].GetDouble(), 2.5);
    EXPECT_EQ(object["width"].GetDouble(), 0.5);
    EXPECT_NEAR(object["depth"].GetDouble(), 3.0, 1e-4);
    // Its rows lie from eye height down by 0.25 / 3 of the distance to the projection plane.
    const double rows = 0.25 / 3.0 * json["projectionDistance"].GetDouble();
    EXPECT_EQ(object["first"].GetInt(), 40);
    EXPECT_NEAR(object["last"].GetInt() + 1 - object["first"].GetInt(), rows, 1.0);
    EXPECT_EQ(hitsOf(0)["objects"].Size(), 0u);
}

TEST(HitsJson, ListsMirrors) {
    const rapidjson::Document json = hitsOf(50);
    ASSERT_EQ(json["mirrors"].Size(), 1u);
    const auto& mirror = json["mirrors"][0];
    EXPECT_EQ(mirror["map"], "hall");
    EXPECT_EQ(mirror["height"].GetDouble(), 0.0);
    EXPECT_EQ(mirror["strength"].GetInt(), 128);
    EXPECT_EQ(mirror["first"].GetInt(), json["planes"][0]["first"].GetInt());
    EXPECT_EQ(mirror["last"].GetInt(), 79);
    EXPECT_EQ(hitsOf(50, "0.5")["mirrors"][0]["strength"].GetInt(), 64)
        << "as strong as the option makes it";
    EXPECT_EQ(hitsOf(50, "0")["mirrors"].Size(), 0u);
}

}  // namespace
}  // namespace slicecast
