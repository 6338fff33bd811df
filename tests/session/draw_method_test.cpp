// Which renderer makes a session's pictures.
#include "base/image.h"
#include "render/classic/draw_classic.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A yard of chequered blocks with a pillar of two in it, which a piece of ceiling pierces.
World yard() {
    World world;
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x)
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(100 + 15 * x),
                                      static_cast<std::uint8_t>(60 + 20 * y), 90, 255});
    }
    world.textures.push_back(makeTexture("squares", image));
    CellBlueprint block;
    for (FaceBlueprint& face : block.faces) face.texture = 0;
    world.blueprints.push_back(block);
    Map map = makeMap("yard", 12, 9, 2, 0);
    for (int x = 0; x < 12; ++x) {
        for (int y = 0; y < 9; ++y) {
            if (x == 0 || y == 0 || x == 11 || y == 8 || (x == 7 && y == 4))
                map.setCell(x, y, 0, 1);
        }
    }
    map.setCell(7, 4, 1, 1);
    map.ceiling.height = toCoordinate(1.3);
    map.ceiling.tiles.assign(12 * 9, kNoTexture);
    map.ceiling.tiles[map.tileIndex(7, 4)] = 0;
    world.maps.push_back(std::move(map));
    world.start = {.map = 0,
                   .x = toCoordinate(2.5),
                   .y = toCoordinate(3.7),
                   .z = {},
                   .headingDegrees = 10.0,
                   .look = 0.0};
    return world;
}

std::vector<Pixel> drawn(Session& session) {
    Image image(96, 60);
    EXPECT_TRUE(session.draw({image.pixels.data(), 96, 60, 96}));
    return image.pixels;
}

TEST(DrawMethod, ClassicDrawsWithItsOptions) {
    Session session(yard());
    const std::vector<Pixel> exact = drawn(session);
    EXPECT_EQ(session.setOption("classic.pixelSize", "6"), "");
    EXPECT_EQ(session.setOption("classic.projection", "equalAngles"), "");
    EXPECT_EQ(drawn(session), exact) << "the fast renderer knows nothing of it";

    EXPECT_EQ(session.setOption("method", "classic"), "");
    Image expected(96, 60);
    ASSERT_TRUE(drawClassic(session.world(), session.eye(), session.options().render,
                            {.projection = ClassicProjection::equalAngles, .pixelSize = 6},
                            {expected.pixels.data(), 96, 60, 96}));
    EXPECT_EQ(drawn(session), expected.pixels);
    EXPECT_NE(expected.pixels, exact);

    EXPECT_EQ(session.setOption("method", "exact"), "");
    EXPECT_EQ(drawn(session), exact);
}

TEST(DrawMethod, EveryClassicOptionReachesThePicture) {
    for (const OptionInfo& option : knownOptions()) {
        const std::string_view name = option.name;
        if (name.substr(0, 8) != "classic.") continue;
        Session session(yard());
        session.setOption("method", "classic");
        if (name == "classic.step" || name == "classic.reach")
            session.setOption("classic.march", "on");
        if (name == "classic.march") session.setOption("classic.step", "0.3");
        session.setEye({.map = 0,
                        .x = toCoordinate(2.5),
                        .y = toCoordinate(3.7),
                        .z = toCoordinate(0.6),
                        .headingDegrees = 10.0,
                        .look = 0.1});
        const std::vector<Pixel> before = drawn(session);
        std::string value = "3";
        if (option.kind == OptionKind::onOff) value = "on";
        if (option.kind == OptionKind::choice) value = "equalAngles";
        if (name == "classic.step") value = "0.3";
        EXPECT_EQ(session.setOption(name, value), "");
        EXPECT_NE(drawn(session), before) << name;
    }
}

TEST(DrawMethod, OverlaysAndStateStayTheSame) {
    Session session(yard());
    const std::uint64_t state = session.fingerprint();
    session.setOption("method", "classic");
    EXPECT_EQ(session.fingerprint(), state) << "how it is drawn does not bear on the game";
    const std::vector<Pixel> bare = drawn(session);
    session.setOption("minimap", "on");
    EXPECT_NE(drawn(session), bare);
    Image refused(4, 4);
    EXPECT_FALSE(session.draw({refused.pixels.data(), 0, 4, 4}));
}

}  // namespace
}  // namespace slicecast
