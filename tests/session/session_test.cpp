#include "session/session.h"

#include "base/image.h"
#include "base/random.h"
#include "drawn.h"
#include "overlay/minimap.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// Two walled yards alike, each with a half block; the player starts in the west of the first and
// looks east.
World yards() {
    WorldBuilder make;
    make.world.title = "Yards";
    make.texture("squares", squaresImage());
    make.block('#');
    make.block('-', {.top = 0.5});
    for (const char* name : {"first", "second"}) {
        make.map(name, 2, R"(
############
#..........#
#..........#
#..........#
#.....-#...#
#..........#
#..........#
#..........#
############
)");
    }
    make.world.maps[1].light.intensity = 0.75;
    make.start(2.5, 4.5);
    return std::move(make.world);
}

TEST(Session, BeginsAtTheStart) {
    const Session session(yards());
    const SessionState state = session.state();
    EXPECT_EQ(state.title, "Yards");
    EXPECT_EQ(state.map, "first");
    EXPECT_EQ(state.x, 2.5);
    EXPECT_EQ(state.y, 4.5);
    EXPECT_EQ(state.z, 0.5);
    EXPECT_EQ(state.feet, 0.0);
    EXPECT_EQ(state.headingDegrees, 0.0);
    EXPECT_EQ(state.speed, 0.0);
    EXPECT_FALSE(state.flying);
    EXPECT_TRUE(state.onGround);
    EXPECT_EQ(state.intensity, Light{}.intensity);
    EXPECT_EQ(state.steps, 0);
    EXPECT_EQ(session.eye().x, toCoordinate(2.5));
}

TEST(Session, PassesEveryInputToThePlayer) {
    const auto after = [](const Input& input, int steps = 60) {
        Session session(yards());
        for (int i = 0; i < steps; ++i) session.step(input);
        return session;
    };
    const auto flown = [](const Input& input) {
        Session session(yards());
        session.setFlying(true);
        for (int i = 0; i < 60; ++i) session.step(input);
        return session.state();
    };
    const double walked = after({.forward = 1.0}).state().x;
    EXPECT_GT(walked, 3.5);
    EXPECT_GT(after({.forward = 1.0, .fast = true}).state().x, walked + 0.5);
    EXPECT_LT(after({.forward = 1.0, .slow = true}).state().x, walked - 0.5);
    EXPECT_GT(after({.strafe = 1.0}).state().y, 5.5);
    EXPECT_GT(after({.turn = 1.0}).state().headingDegrees, 30.0);
    EXPECT_GT(after({.look = 1.0}).state().look, 0.1);
    EXPECT_TRUE(after({.fly = -1.0}).state().crouched);
    EXPECT_EQ(after({.turnDegrees = 1.5}).state().headingDegrees, 90.0);
    EXPECT_NEAR(after({.lookHeights = 0.01}).state().look, 0.6, 1e-12);
    EXPECT_GT(after({.jump = true}, 30).state().feet, 0.5);
    EXPECT_GT(flown({.fly = 1.0}).z, 0.8);
    EXPECT_EQ(after({.forward = 1.0}).steps(), 60);
}

TEST(Session, DrawsBetweenTheLastTwoSteps) {
    Session session(yards());
    for (int i = 0; i < 30; ++i) session.step({.forward = 1.0, .turn = 1.0, .look = 0.5});
    const Eye first = session.eye(0.0);
    const Eye last = session.eye(1.0);
    const Eye middle = session.eye(0.5);
    EXPECT_LT(first.x, last.x);
    EXPECT_NEAR(middle.x.value(), (first.x.value() + last.x.value()) / 2.0, 1.0 / 65536.0);
    EXPECT_NEAR(middle.y.value(), (first.y.value() + last.y.value()) / 2.0, 1.0 / 65536.0);
    EXPECT_NEAR(middle.headingDegrees, (first.headingDegrees + last.headingDegrees) / 2.0, 1e-9);
    EXPECT_NEAR(middle.look, (first.look + last.look) / 2.0, 1e-12);
    EXPECT_EQ(session.eye(7.0).x, last.x);
    EXPECT_EQ(session.eye(-7.0).x, first.x);
    EXPECT_EQ(session.eye(std::numeric_limits<double>::quiet_NaN()).x, last.x);
    EXPECT_NE(drawn(session, 0.0).pixels, drawn(session, 1.0).pixels);
}

TEST(Session, TurnsTheShortWayRoundBetweenSteps) {
    for (const double turn : {20.0, -20.0}) {
        Session session(yards());
        session.setHeading(turn > 0 ? 350.0 : 10.0);
        session.step({.turnDegrees = turn});
        EXPECT_NEAR(std::cos(session.eye(0.5).headingDegrees * 3.14159265358979 / 180.0), 1.0,
                    1e-9);
    }
}

TEST(Session, DoesNotInterpolateAcrossALeap) {
    Session session(yards());
    const auto still = [&session] {
        const Eye a = session.eye(0.25);
        const Eye b = session.eye(1.0);
        return a.x == b.x && a.y == b.y && a.z == b.z && a.headingDegrees == b.headingDegrees &&
               a.look == b.look;
    };
    session.step({.forward = 1.0, .turnDegrees = 30.0, .lookHeights = 0.3});
    EXPECT_FALSE(still());
    ASSERT_TRUE(session.setEye({.map = 1,
                                .x = toCoordinate(5.25),
                                .y = toCoordinate(2.5),
                                .z = toCoordinate(0.75),
                                .headingDegrees = 77.0,
                                .look = 0.25}));
    EXPECT_TRUE(still());
    session.step({.forward = 1.0, .turnDegrees = 30.0, .lookHeights = 0.3});
    session.reset();
    EXPECT_TRUE(still());
    session.step({.lookHeights = 0.3});
    session.levelLook();
    EXPECT_TRUE(still());
    session.step({.turnDegrees = 30.0});
    session.setHeading(180.0);
    EXPECT_TRUE(still());
}

TEST(Session, PutsTheEyeAnywhereThatItCanSeeFrom) {
    Session session(yards());
    const Eye inWall = {.map = 1,
                        .x = toCoordinate(0.123),
                        .y = toCoordinate(4.5),
                        .z = toCoordinate(0.01),
                        .headingDegrees = 12.5,
                        .look = -kMaxLook};
    ASSERT_TRUE(session.setEye(inWall));
    const Eye eye = session.eye();
    EXPECT_EQ(eye.map, 1);
    EXPECT_EQ(eye.x, inWall.x);
    EXPECT_EQ(eye.y, inWall.y);
    EXPECT_EQ(eye.z, inWall.z);
    EXPECT_EQ(eye.headingDegrees, 12.5);
    EXPECT_EQ(eye.look, -kMaxLook);
    EXPECT_EQ(session.state().map, "second");
    drawn(session);

    const auto refused = [&](Eye other) {
        return !session.setEye(other) && session.eye().x == inWall.x && session.eye().map == 1;
    };
    Eye other = inWall;
    other.x = toCoordinate(3.0);
    other.map = 2;
    EXPECT_TRUE(refused(other));
    other.map = -1;
    EXPECT_TRUE(refused(other));
    other.map = 0;
    other.z = {};
    EXPECT_TRUE(refused(other));
    other.z = {1};
    other.look = kMaxLook * 1.01;
    EXPECT_TRUE(refused(other));
    other.look = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(refused(other));
    other.look = 0.0;
    other.headingDegrees = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(refused(other));
    other.headingDegrees = -90.0;
    EXPECT_TRUE(session.setEye(other));
    EXPECT_EQ(session.eye().headingDegrees, 270.0);
}

// Also while the eye still rises after a step up, where a body would not fit below it.
TEST(Session, AnEyeThatStaysOnlyTurns) {
    Session walker(yards());
    Session turned(yards());
    for (int step = 0; step < 200; ++step) {
        const Input input = {.forward = 1.0};
        walker.step(input);
        turned.step(input);
        Eye eye = turned.eye();
        eye.look = 0.1;
        ASSERT_TRUE(turned.setEye(eye));
        ASSERT_FALSE(turned.player().flying);
        eye = turned.eye();
        ASSERT_EQ(eye.look, 0.1);
        ASSERT_EQ(eye.x, walker.eye().x);
        ASSERT_EQ(eye.z, walker.eye().z);
    }
    Eye higher = turned.eye();
    higher.z = higher.z + toCoordinate(0.01);
    ASSERT_TRUE(turned.setEye(higher));
    EXPECT_TRUE(turned.player().flying);
}

TEST(Session, ResetKeepsTheOptions) {
    Session session(yards());
    session.setOption("fov", "75");
    session.setFlying(true);
    for (int i = 0; i < 50; ++i) session.step({.forward = 1.0, .fly = 1.0});
    session.reset();
    const SessionState state = session.state();
    EXPECT_EQ(state.x, 2.5);
    EXPECT_EQ(state.z, 0.5);
    EXPECT_FALSE(state.flying);
    EXPECT_EQ(state.speed, 0.0);
    EXPECT_EQ(session.option("fov"), "75");
}

TEST(Session, LightFollowsItsOptionsAndGoesBackToTheMapsOwn) {
    Session session(yards());
    const Image before = drawn(session);
    EXPECT_EQ(session.setOption("intensity", "0.2"), "");
    EXPECT_EQ(session.setOption("multiplier", "2"), "");
    EXPECT_EQ(session.state().intensity, 0.2);
    EXPECT_EQ(session.state().multiplier, 2.0);
    EXPECT_EQ(session.world().maps[1].light.intensity, 0.2);
    EXPECT_NE(drawn(session).pixels, before.pixels);
    session.setOption("intensity", "map");
    session.setOption("multiplier", "map");
    EXPECT_EQ(session.world().maps[1].light.intensity, 0.75);
    EXPECT_EQ(drawn(session).pixels, before.pixels);
}

TEST(Session, OptionsChangeThePictureAndTheSpeed) {
    Session session(yards());
    const Image before = drawn(session);
    EXPECT_EQ(session.setOption("fov", "90"), "");
    EXPECT_NE(drawn(session).pixels, before.pixels);
    EXPECT_NE(session.setOption("fov", "1000"), "");
    EXPECT_EQ(session.option("fov"), "90");
    session.setOption("fov", "60");
    session.setOption("textures", "off");
    EXPECT_NE(drawn(session).pixels, before.pixels);
    session.setOption("textures", "on");
    EXPECT_EQ(drawn(session).pixels, before.pixels);
    session.setOption("speed", "2");
    for (int i = 0; i < 60; ++i) session.step({.forward = 1.0});
    EXPECT_NEAR(session.state().speed, 2.0 * kWalkingPace.move, 1e-9);
}

TEST(Session, MirrorsAreAdjustableWhileItRuns) {
    World world = yards();
    world.maps[0].floor.mirror = 100;
    Session plain(yards());
    Session session(std::move(world));
    const Image usual = drawn(session);
    EXPECT_NE(usual.pixels, drawn(plain).pixels);
    EXPECT_EQ(session.setOption("mirrors", "0"), "");
    EXPECT_EQ(drawn(session).pixels, drawn(plain).pixels);
    EXPECT_EQ(session.setOption("mirrors", "2"), "");
    EXPECT_NE(drawn(session).pixels, usual.pixels);
    EXPECT_FALSE(isRecordedOption("mirrors")) << "it bears on pictures alone";
}

TEST(Session, DrawsTheMinimapInItsCornerWhenAsked) {
    Session session(yards());
    const Image without = drawn(session, 1.0, 320, 200);
    session.setOption("minimap", "on");
    const Image with = drawn(session, 1.0, 320, 200);
    const MinimapLayout layout = layoutMinimap(320, 200);
    int changed = 0;
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 320; ++x) {
            if (with.at(x, y) == without.at(x, y)) continue;
            ++changed;
            EXPECT_TRUE(x < layout.left + layout.side && y < layout.top + layout.side);
        }
    }
    EXPECT_GT(changed, layout.side * layout.side / 2);
    session.setOption("minimapLevel", "1");
    EXPECT_NE(drawn(session, 1.0, 320, 200).pixels, with.pixels);
}

TEST(Session, RefusesPicturesThatCannotBeDrawn) {
    Session session(yards());
    Pixel pixel = 0;
    EXPECT_FALSE(session.draw({&pixel, 0, 1, 1}));
    EXPECT_FALSE(session.draw({&pixel, 1, 0, 1}));
    EXPECT_EQ(pixel, 0u);
    EXPECT_TRUE(session.draw({&pixel, 1, 1, 1}));
    EXPECT_EQ(pixel >> 24, 255u);
}

TEST(Session, EveryRowOfEverySliceIsFilledOnce) {
    Session session(yards());
    for (int i = 0; i < 40; ++i) {
        session.step({.forward = 1.0, .turn = 1.0, .look = i < 20 ? 1.0 : -1.0});
        drawn(session);
        EXPECT_EQ(session.report().rowsFilled, 96 * 60);
        EXPECT_GT(session.report().spansDrawn, 96);
        EXPECT_LE(session.report().spansDrawn, 96 * 60);
    }
}

TEST(Session, TracesAColumnOfWhatItDraws) {
    Session session(yards());
    const SliceTrace trace = session.trace(96, 60, 48);
    EXPECT_EQ(trace.column, 48);
    ASSERT_FALSE(trace.hits.empty());
    EXPECT_EQ(trace.hits.front().tileX, 6) << "the half block ahead";
}

// The fingerprint after a game of walking, flying and random input.
std::uint64_t fingerprintOfAGame(int steps) {
    Session session(yards());
    Random random(2025);
    Input input;
    for (int step = 0; step < steps; ++step) {
        if (step % 24 == 0) {
            input = {.forward = random.between(-1.0, 1.5),
                     .strafe = random.between(-1.0, 1.0),
                     .turn = random.between(-1.0, 1.0),
                     .look = random.between(-1.0, 1.0),
                     .fly = random.between(-1.0, 1.0),
                     .turnDegrees = random.between(-2.0, 2.0),
                     .lookHeights = 0.0,
                     .jump = random.oneIn(2),
                     .fast = random.oneIn(3),
                     .slow = random.oneIn(5)};
        }
        if (step % 500 == 499) session.setFlying(!session.player().flying);
        if (step % 700 == 699) session.levelLook();
        session.step(input);
    }
    return session.fingerprint();
}

TEST(Session, TheSameInputsGiveTheSameFingerprintEverywhere) {
    EXPECT_EQ(fingerprintOfAGame(5000), fingerprintOfAGame(5000));
    EXPECT_NE(fingerprintOfAGame(5000), fingerprintOfAGame(5001));
    EXPECT_EQ(fingerprintOfAGame(5000), 0x767d1bcb9c5e70bau);
}

TEST(Session, DifferentStatesHaveDifferentFingerprints) {
    const std::uint64_t start = Session(yards()).fingerprint();
    Session session(yards());
    EXPECT_EQ(session.fingerprint(), start);
    session.setHeading(1e-9);
    EXPECT_NE(session.fingerprint(), start);
    session.reset();
    EXPECT_EQ(session.fingerprint(), start);
    session.setOption("speed", "1.5");
    EXPECT_NE(session.fingerprint(), start);
}

TEST(Session, GoesIntoEveryMap) {
    Session session(yards());
    session.setHeading(123.0);
    EXPECT_FALSE(session.goToMap(2));
    EXPECT_FALSE(session.goToMap(-1));
    EXPECT_EQ(session.state().map, "first");
    ASSERT_TRUE(session.goToMap(1));
    // The middle of the second yard holds a half block: the player stands on it.
    SessionState state = session.state();
    EXPECT_EQ(state.map, "second");
    EXPECT_EQ(state.x, 6.5);
    EXPECT_EQ(state.y, 4.5);
    EXPECT_EQ(state.feet, 0.5);
    EXPECT_EQ(state.headingDegrees, 123.0);
    EXPECT_FALSE(state.flying);
    for (int i = 0; i < 30; ++i) session.step({});
    EXPECT_EQ(session.state().feet, 0.5);
    EXPECT_TRUE(session.state().onGround);
    ASSERT_TRUE(session.goToMap(0));
    state = session.state();
    EXPECT_EQ(state.map, "first");
    EXPECT_EQ(state.x, 2.5);
    EXPECT_EQ(state.headingDegrees, 0.0) << "as at the start";
}

TEST(Session, GoingIntoAMapIsRecorded) {
    Session played(yards());
    Recorder recorder("yards");
    played.record(&recorder);
    for (int i = 0; i < 30; ++i) played.step({.forward = 1.0, .turn = 0.3});
    played.goToMap(1);
    for (int i = 0; i < 30; ++i) played.step({.forward = 1.0});
    Session again(yards());
    Replay replay(recorder.finish(played));
    while (replay.step(again)) {
    }
    EXPECT_TRUE(replay.isSame());
    EXPECT_EQ(again.state().map, "second");
    EXPECT_EQ(again.fingerprint(), played.fingerprint());
}

TEST(Session, AnInspectedColumnIsOneOfThePicture) {
    Session session(yards());
    EXPECT_EQ(session.inspectedColumn(96), 48);
    session.setOption("inspectorColumn", "7");
    EXPECT_EQ(session.inspectedColumn(96), 7);
    session.setOption("inspectorColumn", "500");
    EXPECT_EQ(session.inspectedColumn(96), 95);
}

// Each overlay changes about this many pixels on its side of the picture. Switching it off restores
// the picture.
TEST(Session, OverlaysAreDrawnWhenAsked) {
    Session session(yards());
    const Image plain = drawn(session, 1.0, 640, 400);
    const auto changed = [&](const char* option) {
        EXPECT_EQ(session.setOption(option, "on"), "");
        const Image with = drawn(session, 1.0, 640, 400);
        session.setOption(option, "off");
        EXPECT_EQ(drawn(session, 1.0, 640, 400).pixels, plain.pixels) << option;
        int left = 0;
        int right = 0;
        for (int y = 0; y < 400; ++y) {
            for (int x = 0; x < 640; ++x)
                (x < 320 ? left : right) += with.at(x, y) != plain.at(x, y);
        }
        return std::pair{left, right};
    };
    EXPECT_GT(changed("playerPanel").second, 10'000);
    EXPECT_EQ(changed("playerPanel").first, 0);
    EXPECT_GT(changed("processPanel").second, 14'000);
    EXPECT_EQ(changed("processPanel").first, 0);
    EXPECT_GT(changed("inspector").first, 30'000);
    EXPECT_GT(changed("grid").first, 10'000);
    EXPECT_GT(changed("grid").second, 10'000);
    EXPECT_GT(changed("slow").second, 100'000);
}

TEST(Session, SlowDrawingGivesTheSamePictureInTheEnd) {
    Session session(yards());
    const Image plain = drawn(session);
    session.setOption("slow", "on");
    session.setOption("slowSlices", "12");
    Image slow;
    for (int i = 0; i < 96 / 12; ++i) {
        slow = drawn(session);
        EXPECT_EQ(slow.at(12 * (i + 1) - 1, 30), plain.at(12 * (i + 1) - 1, 30));
        EXPECT_EQ(slow.at(95, 30) == toPixel(kNotYetDrawn), i < 7);
    }
    for (int y = 0; y < 60; ++y) {
        for (int x = 1; x < 96; ++x) ASSERT_EQ(slow.at(x, y), plain.at(x, y));
    }
    // Switched off and on, it begins again.
    session.setOption("slow", "off");
    session.setOption("slow", "on");
    EXPECT_EQ(drawn(session).at(95, 30), toPixel(kNotYetDrawn));
}

TEST(Session, TimesOfDayChangeThePictureAndGoBack) {
    Session session(yards());
    const Image own = drawn(session);
    EXPECT_EQ(session.setOption("lightPreset", "night"), "");
    const Image night = drawn(session);
    EXPECT_NE(night.pixels, own.pixels);
    session.setOption("lightPreset", "fog");
    session.setOption("hazeColour", "#c80a14");
    const Image fog = drawn(session);
    EXPECT_EQ(toColour(fog.at(95, 2)), (Colour{200, 10, 20, 255})) << "the sky";
    session.setOption("hazeColour", "map");
    session.setOption("lightPreset", "map");
    EXPECT_EQ(drawn(session).pixels, own.pixels);
}

TEST(Session, AClockChangesNothingButTheProcessPanel) {
    Session with(yards());
    Session without(yards());
    double now = 0.0;
    with.setClock([&now] { return now += 0.02; });
    for (int i = 0; i < 60; ++i) {
        with.step({.forward = 1.0});
        without.step({.forward = 1.0});
        EXPECT_EQ(drawn(with).pixels, drawn(without).pixels);
    }
    EXPECT_EQ(with.fingerprint(), without.fingerprint());
    for (Session* session : {&with, &without}) session->setOption("processPanel", "on");
    EXPECT_NE(drawn(with, 1.0, 640, 400).pixels, drawn(without, 1.0, 640, 400).pixels);
}

Eye eyeAt(double x, double y, double z) {
    return {.map = 0, .x = toCoordinate(x), .y = toCoordinate(y), .z = toCoordinate(z)};
}

TEST(Session, LandsWhereTheEyeIs) {
    Session session(yards());
    for (const auto& [z, landing] :
         {std::pair{0.5, Landing::stands}, std::pair{0.50043, Landing::stands},
          std::pair{0.9, Landing::stands}, std::pair{1.6, Landing::falls}}) {
        ASSERT_TRUE(session.setEye(eyeAt(3.25, 5.5, z)));
        EXPECT_EQ(session.land(), landing) << z;
        EXPECT_FALSE(session.player().flying) << z;
        EXPECT_EQ(session.eye().z, toCoordinate(z)) << z;
    }
}

// Someone has just stepped onto the half block: the eye is still low.
TEST(Session, LandsOnAStepWithALowEye) {
    Session session(yards());
    ASSERT_TRUE(session.setEye(eyeAt(6.5, 4.5, 0.6)));
    EXPECT_EQ(session.land(), Landing::stands);
    EXPECT_EQ(session.eye().z, toCoordinate(0.6));
    EXPECT_EQ(session.state().feet, 0.5);
    for (int step = 0; step < 240; ++step) session.step({});
    EXPECT_EQ(session.state().z, 1.0);
    EXPECT_FALSE(session.player().flying);
}

TEST(Session, LandsOnTheNearestGround) {
    Session session(yards());
    for (const Eye& eye : {eyeAt(-40.0, 4.5, 0.5), eyeAt(0.5, 4.5, 0.5), eyeAt(3.5, 4.5, 900.0)}) {
        ASSERT_TRUE(session.setEye(eye));
        EXPECT_EQ(session.land(), Landing::moved);
        const SessionState state = session.state();
        EXPECT_FALSE(state.flying);
        EXPECT_EQ(state.z - state.feet, 0.5);
        for (int step = 0; step < 24; ++step) session.step({});
        EXPECT_EQ(session.state().z, state.z);
    }
}

TEST(Session, KeepsPartsOfThePictureFreeOfPanels) {
    Session session(yards());
    Image plain(400, 300);
    Image shown(400, 300);
    session.draw({plain.pixels.data(), 400, 300, 400});
    for (const char* name : {"minimap", "playerPanel", "processPanel"})
        session.setOption(name, "on");
    session.setOption("overlayTop", "0.2");
    session.setOption("overlayBottom", "0.1");
    session.draw({shown.pixels.data(), 400, 300, 400});
    int first = 300;
    int last = -1;
    for (int y = 0; y < 300; ++y) {
        const auto row = static_cast<std::ptrdiff_t>(y) * 400;
        if (std::equal(plain.pixels.begin() + row, plain.pixels.begin() + row + 400,
                       shown.pixels.begin() + row))
            continue;
        first = std::min(first, y);
        last = y;
    }
    EXPECT_GE(first, 60);
    EXPECT_LT(first, 70);
    EXPECT_LT(last, 270);
    EXPECT_GT(last, 150);
    session.setOption("overlayTop", "1");
    session.setOption("overlayBottom", "1");
    EXPECT_TRUE(session.draw({shown.pixels.data(), 400, 300, 400}));
    EXPECT_EQ(shown.pixels, plain.pixels);
}

}  // namespace
}  // namespace slicecast
