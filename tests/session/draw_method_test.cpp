// Which renderer makes a session's pictures.
#include "base/image.h"
#include "classic/draw_classic.h"
#include "drawn.h"
#include "session/session.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A yard of chequered blocks with a pillar of two in it, which a piece of ceiling pierces; before
// it a low block and a figure, behind it another; a portal with a beam before it; a floor that
// mirrors. The eye stands on a step.
World chequeredYard() {
    WorldBuilder make;
    make.texture("squares", squaresImage());
    make.world.sprites.push_back(makeSprite("figure", squaresImage()));
    make.block('#');
    make.block('-', {.top = 0.2});
    make.block('=', {.bottom = 0.4, .top = 0.6});
    make.block('|').faces[static_cast<std::size_t>(Face::west)].portal = 0;
    make.map("yard", 2, R"(
############
#..........#
#..........#
#.-........#
#....-.#...#
#........=.|
#..........#
#..........#
############
)")
        .floor.mirror = 100;
    make.put('#', 7, 4, 1);
    make.ceiling(1.3, kNoTexture, 0, 0);
    Map& map = make.world.maps[0];
    map.ceiling.tiles[map.tileIndex(7, 4)] = 0;
    make.object(6.2, 4.4, 0.0, 0.8, 1.4);
    make.world.portals.push_back(
        {.fromMap = 0, .fromX = 11, .fromY = 5, .toMap = 0, .toX = 2, .toY = 6, .turn = 1});
    markPortals(make.world);
    make.start(2.5, 3.7, 0.2, 10.0);
    return std::move(make.world);
}

// Light that comes late does so for both methods' parts of the picture.
TEST(DrawMethod, TheReportIsThatOfTheLastPicture) {
    World world = chequeredYard();
    world.maps[0].baked.on = true;
    world.maps[0].baked.ambient = {90, 90, 90, 255};
    Session session(std::move(world));
    Image image(96, 60);
    const Picture picture{image.pixels.data(), 96, 60, 96};
    ASSERT_TRUE(session.draw(picture, 1.0, 1));
    const FrameReport exact = session.report();
    EXPECT_GT(exact.lateLight, 0);
    EXPECT_EQ(session.setOption("method", "classic"), "");
    ASSERT_TRUE(session.draw(picture, 1.0, 1));
    EXPECT_GT(session.report().lateLight, 0);
    EXPECT_NE(session.report().spansDrawn, exact.spansDrawn);
    ASSERT_TRUE(session.draw(picture));
    EXPECT_EQ(session.report().lateLight, 0);
    EXPECT_EQ(session.setOption("compare", "0.5"), "");
    session.setEye({.map = 0,
                    .x = toCoordinate(5.5),
                    .y = toCoordinate(3.7),
                    .z = toCoordinate(0.6),
                    .headingDegrees = 200.0,
                    .look = 0.0});
    ASSERT_TRUE(session.draw(picture, 1.0, 1));
    EXPECT_GT(session.report().lateLight, 0);
    EXPECT_LE(session.report().lightWork, 2000) << "both methods share what is allowed";
}

TEST(DrawMethod, ClassicDrawsWithItsOptions) {
    Session session(chequeredYard());
    const std::vector<Pixel> exact = drawn(session).pixels;
    EXPECT_EQ(session.setOption("classic.pixelSize", "6"), "");
    EXPECT_EQ(session.setOption("classic.projection", "equalAngles"), "");
    EXPECT_EQ(drawn(session).pixels, exact) << "the fast renderer knows nothing of it";

    EXPECT_EQ(session.setOption("method", "classic"), "");
    Image expected(96, 60);
    LitMaps lit;
    ASSERT_TRUE(drawClassic(session.world(), session.eye(), session.options().render,
                            {.projection = ClassicProjection::equalAngles, .pixelSize = 6}, lit,
                            {expected.pixels.data(), 96, 60, 96}));
    EXPECT_EQ(drawn(session).pixels, expected.pixels);
    EXPECT_NE(expected.pixels, exact);

    EXPECT_EQ(session.setOption("method", "exact"), "");
    EXPECT_EQ(drawn(session).pixels, exact);
}

TEST(DrawMethod, EveryClassicOptionReachesThePicture) {
    for (const OptionInfo& option : knownOptions()) {
        const std::string_view name = option.name;
        if (name.substr(0, 8) != "classic.") continue;
        Session session(chequeredYard());
        session.setOption("method", "classic");
        if (name == "classic.step" || name == "classic.reach")
            session.setOption("classic.march", "on");
        if (name == "classic.march") session.setOption("classic.step", "0.3");
        session.setEye({.map = 0,
                        .x = toCoordinate(2.5),
                        .y = toCoordinate(name == "classic.portalsOverdrawn" ? 5.5 : 3.7),
                        .z = toCoordinate(0.6),
                        .headingDegrees = name == "classic.portalsOverdrawn" ? 0.0 : 10.0,
                        .look = name == "classic.noOwnCell" ? -0.8 : -0.1});
        const std::vector<Pixel> before = drawn(session).pixels;
        std::string value = "3";
        if (option.kind == OptionKind::onOff) value = "on";
        if (name == "classic.projection") value = "equalAngles";
        if (name == "classic.roofs") value = "flat";
        if (name == "classic.step") value = "0.3";
        EXPECT_EQ(session.setOption(name, value), "");
        EXPECT_NE(drawn(session).pixels, before) << name;
    }
}

TEST(DrawMethod, OverlaysAndStateStayTheSame) {
    Session session(chequeredYard());
    const std::uint64_t state = session.fingerprint();
    session.setOption("method", "classic");
    EXPECT_EQ(session.fingerprint(), state) << "how it is drawn does not bear on the game";
    const std::vector<Pixel> bare = drawn(session).pixels;
    session.setOption("minimap", "on");
    EXPECT_NE(drawn(session).pixels, bare);
    Image refused(4, 4);
    EXPECT_FALSE(session.draw({refused.pixels.data(), 0, 4, 4}));
}

// The left of a comparison is the classic method's picture, the right the exact one's; between them
// is a line.
TEST(DrawMethod, ComparesBothMethods) {
    Session session(chequeredYard());
    session.setOption("classic.projection", "equalAngles");
    const std::vector<Pixel> exact = drawn(session).pixels;
    session.setOption("method", "classic");
    const std::vector<Pixel> classic = drawn(session).pixels;
    for (const char* method : {"exact", "classic"}) {
        session.setOption("method", method);
        EXPECT_EQ(session.setOption("compare", "0.25"), "");
        const std::vector<Pixel> both = drawn(session).pixels;
        for (int i = 0; i < 96 * 60; ++i) {
            const int x = i % 96;
            const auto at = static_cast<std::size_t>(i);
            if (x < 24 - 3) {
                EXPECT_EQ(both[at], classic[at]) << i;
            } else if (x >= 24 + 3) {
                EXPECT_EQ(both[at], exact[at]) << i;
            }
        }
        EXPECT_NE(both[30 * 96 + 23], classic[30 * 96 + 23]) << "the line";
        session.setOption("compare", "1");
        EXPECT_EQ(drawn(session).pixels, classic);
        session.setOption("compare", "0");
    }
    EXPECT_EQ(drawn(session).pixels, classic);
    EXPECT_NE(session.setOption("compare", "1.1"), "");
}

// Only what it draws costs the time of the classic method.
TEST(DrawMethod, AComparisonDrawsNoMoreThanItsColumns) {
    const World world = chequeredYard();
    const Session session{chequeredYard()};
    Image image(96, 60);
    const Picture picture = {image.pixels.data(), 96, 60, 96};
    LitMaps lit;
    const std::optional<FrameReport> all = drawClassic(world, session.eye(), {}, {}, lit, picture);
    const std::optional<FrameReport> part =
        drawClassic(world, session.eye(), {}, {}, lit, picture, 24);
    ASSERT_TRUE(all && part);
    EXPECT_EQ(all->rowsFilled, 96 * 60);
    EXPECT_EQ(part->rowsFilled, 24 * 60);
    EXPECT_LT(part->tilesWalked, all->tilesWalked / 2);
}

// Nor does the exact one draw what the other draws over; what it draws is the same to the byte.
TEST(DrawMethod, TheExactMethodDrawsFromAColumnOn) {
    const World world = chequeredYard();
    const Session session{chequeredYard()};
    Renderer renderer;
    Image whole(96, 60);
    ASSERT_TRUE(renderer.draw(world, session.eye(), {}, {whole.pixels.data(), 96, 60, 96}));
    const std::int64_t tiles = renderer.report().tilesWalked;
    for (const int first : {0, 1, 16, 25, 72, 95, 96}) {
        Image image(96, 60);
        const Pixel untouched = toPixel({1, 2, 3, 4});
        std::fill(image.pixels.begin(), image.pixels.end(), untouched);
        ASSERT_TRUE(
            renderer.draw(world, session.eye(), {}, {image.pixels.data(), 96, 60, 96}, first));
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < 96; ++x)
                ASSERT_EQ(image.at(x, y), x < first ? untouched : whole.at(x, y)) << x << "," << y;
        }
        if (first >= 72) {
            EXPECT_LT(renderer.report().tilesWalked, tiles / 2);
        }
    }
}

// Of each column, by the method that draws it.
TEST(DrawMethod, TracesAreOfTheMethodThatDraws) {
    Session session(chequeredYard());
    const SliceTrace exact = session.trace(96, 60, 10);
    session.setOption("classic.march", "on");
    session.setOption("classic.step", "0.3");
    EXPECT_EQ(session.trace(96, 60, 10).tiles.size(), exact.tiles.size());
    session.setOption("method", "classic");
    const SliceTrace marched = session.trace(96, 60, 10);
    ASSERT_GT(marched.tiles.size(), 1u);
    // Where a march comes to stand, no border is.
    const double steps = marched.tiles[1].depth *
                         std::sqrt(marched.rayX * marched.rayX + marched.rayY * marched.rayY) / 0.3;
    EXPECT_NEAR(steps, std::floor(steps + 0.5), 1e-9);
    EXPECT_GT(marched.tiles[1].depth, exact.tiles[1].depth);
    EXPECT_EQ(session.measure(96, 60).rowsFilled, 96 * 60);
    EXPECT_GT(session.measure(96, 60).tilesWalked, 96 * 20) << "one every step";

    session.setOption("compare", "0.5");
    EXPECT_EQ(session.trace(96, 60, 10).tiles[1].depth, marched.tiles[1].depth);
    session.setOption("method", "exact");
    EXPECT_EQ(session.trace(96, 60, 10).tiles[1].depth, marched.tiles[1].depth);
    const SliceTrace right = session.trace(96, 60, 70);
    session.setOption("compare", "0");
    EXPECT_EQ(session.trace(96, 60, 70).tiles[1].depth, right.tiles[1].depth);
}

}  // namespace
}  // namespace slicecast
