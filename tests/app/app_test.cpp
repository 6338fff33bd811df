#include "app/app.h"

#include "answers/hits_json.h"
#include "base/random.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A screen that notes down what it is told.
class NoteShell : public Shell {
public:
    double nowSeconds() const override { return now += secondsPerLook; }
    void show(SDL_Surface& picture) override {
        ++shown;
        const auto* pixels = static_cast<const Pixel*>(picture.pixels);
        last.assign(pixels, pixels + static_cast<std::size_t>(picture.w) *
                                         static_cast<std::size_t>(picture.h));
    }
    void askForFrame() override { ++asked; }
    void tell(News what, bool yes) override { news.emplace_back(what, yes); }
    void tellShown(bool isMoved) override {
        ++toldShown;
        moved += isMoved ? 1 : 0;
    }
    void tellPortal(const std::string& from, const std::string& to) override {
        portals.emplace_back(from, to);
    }
    void tellRates(const FrameRates& told) override { rates.push_back(told); }
    void tellSize(int width, int height) override { sizes.emplace_back(width, height); }
    void tellHits(Session& game, int width, int height, int column) override {
        hits.push_back(hitsJson(game, "", width, height, column));
    }
    void leave() override { ++left; }

    mutable double now = 100.0;
    double secondsPerLook = 0.0;
    int shown = 0;
    int asked = 0;
    int toldShown = 0;
    int moved = 0;
    int left = 0;
    std::vector<Pixel> last;
    std::vector<std::pair<News, bool>> news;
    std::vector<FrameRates> rates;
    std::vector<std::string> hits;
    std::vector<std::pair<int, int>> sizes;
    std::vector<std::pair<std::string, std::string>> portals;
};

// An open field with a row of blocks far in the east.
World makeField() {
    Random random(1);
    Image speckled(8, 8);
    for (Pixel& pixel : speckled.pixels) pixel = static_cast<Pixel>(random.next()) | 0xff000000u;
    WorldBuilder make;
    make.texture("speckled", speckled);
    make.block('#', {.name = "block"});
    make.map("field", 40, 40, 2);
    for (int y = 0; y < 40; ++y) make.put('#', 30, y);
    make.start(20.5, 20.5);
    return std::move(make.world);
}

class AppTest : public testing::Test {
protected:
    AppTest() : app(shell) {
        app.resize(80, 50);
        app.play(std::make_unique<Session>(makeField()));
        app.frame(shell.now);
    }

    // Plays for a while at 60 pictures a second.
    void play(double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds * 60.0)); ++i) {
            shell.now += 1.0 / 60.0;
            app.frame(shell.now);
        }
    }

    void press(SDL_Scancode scancode, bool repeated = false) { app.keyDown(scancode, repeated); }
    void release(SDL_Scancode scancode) { app.keyUp(scancode); }
    double x() { return app.game()->player().x.value(); }
    double heading() { return app.game()->player().headingDegrees; }
    int count(News what) const {
        int times = 0;
        for (const auto& [news, yes] : shell.news) times += news == what;
        return times;
    }

    NoteShell shell;
    App app;
};

TEST_F(AppTest, ShowsAndReportsTheFirstPicture) {
    EXPECT_EQ(shell.shown, 1);
    EXPECT_EQ(shell.news.front(), (std::pair{News::ready, true}));
    EXPECT_EQ(shell.sizes, (std::vector{std::pair{80, 50}}));
    play(0.5);
    EXPECT_EQ(count(News::ready), 1);
    EXPECT_EQ(shell.sizes.size(), 1u);
}

// A slow machine: each look at the clock finds 3 ms gone.
TEST_F(AppTest, DrawsTheFirstPictureInSlices) {
    app.resize(640, 40);
    shell.secondsPerLook = 0.003;
    app.play(std::make_unique<Session>(makeField()));
    const int shown = shell.shown;
    int slices = 0;
    while (shell.shown == shown) {
        ASSERT_LT(++slices, 20);
        EXPECT_TRUE(app.wantsFrame());
        EXPECT_TRUE(app.isBeginning());
        const double begin = shell.now;
        app.frame(shell.now);
        EXPECT_LT(shell.now - begin, 0.03) << "the whole picture takes twice as long";
        EXPECT_EQ(app.game()->steps(), 0) << "time stands still";
    }
    EXPECT_GE(slices, 3);
    EXPECT_FALSE(app.isBeginning());
    std::vector<Pixel> whole(640 * 40);
    ASSERT_TRUE(app.game()->draw({whole.data(), 640, 40, 640}));
    EXPECT_EQ(shell.last, whole);
    play(0.5);
    EXPECT_GT(app.game()->steps(), 30);
}

// Blocks of all heights under a bright sky, from above: their light takes longer than a first
// picture may.
World fieldOfHeights() {
    Random random(1);
    World world = makeField();
    world.maps[0] = makeMap("heights", 160, 160, 3, 0);
    Map& map = world.maps[0];
    map.baked.on = true;
    map.baked.sun = {200, 200, 200, 255};
    map.baked.ambient = {90, 90, 90, 255};
    for (int i = 0; i < 40; ++i) {
        CellBlueprint& block = world.blueprints.emplace_back(world.blueprints[1]);
        block.top = Coordinate{random.between(20'000, 65'536)};
        for (int n = 0; n < 400; ++n)
            map.setCell(random.below(160), random.below(160), random.below(3),
                        static_cast<BlueprintId>(world.blueprints.size() - 1));
    }
    world.start = {.map = 0,
                   .x = toCoordinate(2.5),
                   .y = toCoordinate(2.5),
                   .z = tileEdge(9),
                   .headingDegrees = 45.0};
    return world;
}

TEST_F(AppTest, ShowsAFirstPictureWhoseLightIsLate) {
    app.resize(640, 400);
    app.play(std::make_unique<Session>(fieldOfHeights()));
    for (const int shown = shell.shown; shell.shown == shown;) app.frame(shell.now);
    EXPECT_GT(app.game()->report().unlit, 0);
    const std::vector<Pixel> first = shell.last;
    // The rest comes with later pictures, at most some light in each
    app.keyDown(SDL_SCANCODE_P, false);
    for (int i = 0; i < 200 && app.wantsFrame(); ++i) {
        app.frame(shell.now);
        EXPECT_LT(app.game()->report().lightWork, 2 * kLightOfPicture);
    }
    EXPECT_EQ(app.game()->report().unlit, 0);
    std::vector<Pixel> whole(640 * 400);
    ASSERT_TRUE(app.game()->draw({whole.data(), 640, 400, 640}));
    EXPECT_TRUE(shell.last == whole);
    EXPECT_TRUE(first != whole);
}

TEST_F(AppTest, ShowsTheLightOfBeforeUntilItIsMadeAnew) {
    app.resize(160, 100);
    app.keyDown(SDL_SCANCODE_P, false);
    const auto drawAll = [&] {
        for (int i = 0; i < 400 && app.wantsFrame(); ++i) app.frame(shell.now);
        ASSERT_EQ(app.game()->report().lateLight, 0);
    };
    app.play(std::make_unique<Session>(fieldOfHeights()));
    drawAll();
    const std::vector<Pixel> before = shell.last;

    auto next = std::make_unique<Session>(fieldOfHeights());
    next->keepLightOf(*app.game());
    app.play(std::move(next));
    const int shown = shell.shown;
    app.frame(shell.now);
    EXPECT_EQ(shell.shown, shown + 1) << "at once";
    EXPECT_EQ(app.game()->report().unlit, 0);
    EXPECT_TRUE(shell.last == before);
    drawAll();

    // A change far away, which is not seen
    ASSERT_EQ(app.game()->setCell({0, 0, 0, 159}, "."), "");
    app.redraw();
    app.frame(shell.now);
    EXPECT_EQ(app.game()->report().unlit, 0);
    drawAll();
    EXPECT_TRUE(shell.last == before);
}

// What changes in between is in all of the picture.
TEST_F(AppTest, BeginsTheFirstPictureAnewWhenSomethingChanges) {
    app.resize(640, 40);
    shell.secondsPerLook = 0.003;
    app.play(std::make_unique<Session>(makeField()));
    app.frame(shell.now);
    app.game()->setOption("fov", 90.0);
    app.redraw();
    const int shown = shell.shown;
    for (int i = 0; i < 20 && shell.shown == shown; ++i) app.frame(shell.now);
    std::vector<Pixel> whole(640 * 40);
    ASSERT_TRUE(app.game()->draw({whole.data(), 640, 40, 640}));
    EXPECT_EQ(shell.last, whole);
}

TEST_F(AppTest, ASecondIsAHundredAndTwentySteps) {
    play(1.0);
    EXPECT_NEAR(static_cast<double>(app.game()->steps()), 120.0, 1.0);
    EXPECT_EQ(shell.shown, 61);
}

TEST_F(AppTest, AHeldKeyWalksAndAReleasedOneStops) {
    press(SDL_SCANCODE_W);
    play(1.0);
    const double after = x();
    EXPECT_GT(after, 22.0);
    release(SDL_SCANCODE_W);
    play(1.0);
    const double stopped = x();
    EXPECT_LT(stopped, after + 0.5);
    play(1.0);
    EXPECT_EQ(x(), stopped);
}

TEST_F(AppTest, LostFocusReleasesTheKeys) {
    press(SDL_SCANCODE_W);
    play(0.5);
    app.releaseKeys();
    play(0.5);
    const double stopped = x();
    play(1.0);
    EXPECT_EQ(x(), stopped);
}

TEST_F(AppTest, AHiddenScreenNeitherJumpsNorSticks) {
    press(SDL_SCANCODE_W);
    play(0.5);
    const double before = x();
    const int shown = shell.shown;
    app.setHidden(true);
    play(2.0);
    EXPECT_EQ(shell.shown, shown);
    shell.now += 3600.0;
    app.setHidden(false);
    app.frame(shell.now);
    EXPECT_EQ(x(), before);
    play(1.0);
    EXPECT_LT(x(), before + 0.5) << "the key went up unseen";
}

TEST_F(AppTest, WhilePausedItWantsAFrameOnlyForAChange) {
    app.setPaused(true);
    app.frame(shell.now);
    EXPECT_FALSE(app.wantsFrame());

    const auto asksForOne = [&] {
        const bool isAsked = shell.asked > 0 && app.wantsFrame();
        shell.asked = 0;
        const int shown = shell.shown;
        play(0.1);
        return isAsked && shell.shown == shown + 1 && !app.wantsFrame() && shell.asked == 0;
    };
    shell.asked = 0;
    app.redraw();
    EXPECT_TRUE(asksForOne());
    app.resize(60, 40);
    EXPECT_TRUE(asksForOne());
    app.step({});
    EXPECT_TRUE(asksForOne());
    press(SDL_SCANCODE_V);
    EXPECT_TRUE(asksForOne());
    app.setHidden(true);
    EXPECT_FALSE(app.wantsFrame());
    EXPECT_EQ(shell.asked, 0);
    app.redraw();
    EXPECT_EQ(shell.asked, 0) << "nobody would see it";
    app.setHidden(false);
    EXPECT_TRUE(asksForOne());

    app.setPaused(false);
    EXPECT_GT(shell.asked, 0);
    play(0.1);
    EXPECT_TRUE(app.wantsFrame());
    app.setHidden(true);
    EXPECT_FALSE(app.wantsFrame());
}

TEST_F(AppTest, AStepWhilePausedIsDrawnWithoutInterpolation) {
    app.setPaused(true);
    const double before = x();
    for (int i = 0; i < 30; ++i) app.step({.forward = 1.0});
    EXPECT_GT(x(), before + 0.5);
    app.frame(shell.now);
    std::vector<Pixel> pixels(80 * 50);
    ASSERT_TRUE(app.game()->draw({pixels.data(), 80, 50, 80}, 1.0));
    EXPECT_EQ(shell.last, pixels);
    EXPECT_EQ(app.game()->steps(), 30);
}

TEST_F(AppTest, ReportsThePictureAndAMovedEye) {
    EXPECT_EQ(shell.toldShown, 1);
    EXPECT_EQ(shell.moved, 1) << "there was no picture before";
    play(0.5);
    EXPECT_EQ(shell.toldShown, shell.shown);
    EXPECT_EQ(shell.moved, 1) << "nobody has moved";
    press(SDL_SCANCODE_RIGHT);
    play(0.5);
    EXPECT_GT(shell.moved, 20);
}

TEST_F(AppTest, ReportsAPortal) {
    World world = makeField();
    Map cellar = makeMap("cellar", 40, 40, 2, 0);
    world.maps.push_back(std::move(cellar));
    world.portals.push_back(
        {.fromMap = 0, .fromX = 22, .fromY = 20, .toMap = 1, .toX = 10, .toY = 20});
    world.maps[0].tilePortals.assign(world.maps[0].occupied.size(), kNoPortal);
    world.maps[0].tilePortals[world.maps[0].tileIndex(22, 20)] = 0;
    markPortals(world);
    app.play(std::make_unique<Session>(std::move(world)));
    press(SDL_SCANCODE_W);
    play(2.0);
    EXPECT_EQ(app.game()->player().map, 1);
    EXPECT_EQ(shell.portals, (std::vector{std::pair<std::string, std::string>{"field", "cellar"}}));
    app.game()->reset();
    play(0.1);
    EXPECT_EQ(shell.portals.size(), 1u) << "nobody has gone through it";
}

TEST_F(AppTest, ASlowScreenDropsTime) {
    const std::int64_t before = app.game()->steps();
    shell.now += 30.0;
    app.frame(shell.now);
    EXPECT_EQ(app.game()->steps() - before, 12);
}

TEST_F(AppTest, APauseStopsTimeAndDrawsOnlyChanges) {
    play(0.1);
    press(SDL_SCANCODE_P);
    EXPECT_TRUE(app.paused());
    press(SDL_SCANCODE_P, true);
    EXPECT_TRUE(app.paused()) << "a key that repeats is one press";
    play(0.1);
    const int shown = shell.shown;
    const std::int64_t steps = app.game()->steps();
    press(SDL_SCANCODE_W);
    play(1.0);
    EXPECT_EQ(shell.shown, shown);
    EXPECT_EQ(app.game()->steps(), steps);

    app.resize(60, 40);
    play(0.1);
    EXPECT_EQ(shell.shown, shown + 1);
    press(SDL_SCANCODE_M);
    play(0.1);
    EXPECT_EQ(shell.shown, shown + 2);

    app.setPaused(false);
    play(0.5);
    EXPECT_GT(x(), 20.5);
    EXPECT_EQ(count(News::pause), 2);
}

TEST_F(AppTest, KeysChangeModes) {
    press(SDL_SCANCODE_V);
    play(0.1);
    EXPECT_TRUE(app.game()->player().flying);
    EXPECT_EQ(shell.news.back(), (std::pair{News::fly, true}));
    press(SDL_SCANCODE_M);
    play(0.1);
    EXPECT_TRUE(app.game()->options().minimap);
    EXPECT_EQ(shell.news.back(), (std::pair{News::overlay, true}));
    press(SDL_SCANCODE_KP_1);
    EXPECT_EQ(heading(), 135.0);
    press(SDL_SCANCODE_UP);
    play(0.5);
    EXPECT_GT(app.game()->player().look, 0.0);
    release(SDL_SCANCODE_UP);
    press(SDL_SCANCODE_R);
    EXPECT_EQ(app.game()->player().look, 0.0);
}

TEST_F(AppTest, PassesKeysForTheScreenToTheShell) {
    press(SDL_SCANCODE_H);
    press(SDL_SCANCODE_I);
    press(SDL_SCANCODE_F);
    press(SDL_SCANCODE_ESCAPE);
    press(SDL_SCANCODE_H, true);
    EXPECT_EQ(count(News::help), 1);
    EXPECT_EQ(count(News::rate), 1);
    EXPECT_EQ(count(News::fullscreen), 1);
    EXPECT_EQ(shell.left, 1);
}

TEST_F(AppTest, MirrorsAreSetInStepsWithinTheirRange) {
    const auto mirrors = [&] { return app.game()->options().render.mirrors; };
    press(SDL_SCANCODE_KP_PLUS);
    EXPECT_NEAR(mirrors(), 1.1, 1e-9);
    press(SDL_SCANCODE_MINUS);
    press(SDL_SCANCODE_KP_MINUS, true);
    EXPECT_NEAR(mirrors(), 0.9, 1e-9);
    press(SDL_SCANCODE_LSHIFT);
    for (int i = 0; i < 20; ++i) press(SDL_SCANCODE_EQUALS, true);
    EXPECT_EQ(mirrors(), kGreatestMirrors);
    for (int i = 0; i < 40; ++i) press(SDL_SCANCODE_MINUS, true);
    EXPECT_EQ(mirrors(), 0.0);
}

TEST_F(AppTest, TheLightIsSetInStepsFromTheMapsOwn) {
    const double own = app.game()->state().intensity;
    press(SDL_SCANCODE_INSERT);
    EXPECT_NEAR(app.game()->state().intensity, own + 0.1, 1e-9);
    press(SDL_SCANCODE_INSERT, true);
    EXPECT_NEAR(app.game()->state().intensity, own + 0.2, 1e-9);
    press(SDL_SCANCODE_LSHIFT);
    press(SDL_SCANCODE_DELETE);
    EXPECT_NEAR(app.game()->state().intensity, own - 0.1, 1e-9);
    release(SDL_SCANCODE_LSHIFT);
    const double reach = app.game()->state().multiplier;
    press(SDL_SCANCODE_LCTRL);
    press(SDL_SCANCODE_HOME);
    EXPECT_NEAR(app.game()->state().multiplier, reach + 0.1, 1e-9);
    for (int i = 0; i < 1000; ++i) press(SDL_SCANCODE_END, true);
    EXPECT_EQ(app.game()->state().multiplier, 0.0);
}

TEST_F(AppTest, TheMouseTurnsOnlyWhileItIsHeld) {
    app.pointerMoved(100.0, 0.0);
    play(0.1);
    EXPECT_EQ(heading(), 0.0);
    app.pointerHeld(true);
    app.pointerMoved(100.0, 0.0);
    play(0.1);
    EXPECT_NEAR(heading(), 100.0 * kDefaultDegreesPerPixel, 1e-9);
    play(0.5);
    EXPECT_NEAR(heading(), 100.0 * kDefaultDegreesPerPixel, 1e-9) << "moved once, turned once";
    EXPECT_EQ(shell.news.back(), (std::pair{News::pointer, true}));
}

TEST_F(AppTest, TheMouseLooksUpOrInvertedDown) {
    app.pointerHeld(true);
    app.pointerMoved(0.0, -50.0);
    play(0.1);
    const double up = app.game()->player().look;
    EXPECT_GT(up, 0.0);
    app.setMouse(kDefaultDegreesPerPixel, true);
    app.pointerMoved(0.0, -50.0);
    play(0.1);
    EXPECT_NEAR(app.game()->player().look, 0.0, 1e-9);
    app.setMouse(2.0 * kDefaultDegreesPerPixel, false);
    app.pointerMoved(10.0, 0.0);
    play(0.1);
    EXPECT_NEAR(heading(), 20.0 * kDefaultDegreesPerPixel, 1e-9);
}

TEST_F(AppTest, MovementDuringAPauseIsForgotten) {
    app.pointerHeld(true);
    app.setPaused(true);
    app.pointerMoved(100.0, 100.0);
    app.setPaused(false);
    play(0.1);
    EXPECT_EQ(heading(), 0.0);
}

TEST_F(AppTest, APadWalksTurnsAndActsOnceForEachPress) {
    Gamepad gamepad;
    gamepad.left = {0.0, -1.0};
    gamepad.buttons = kPadFly;
    app.setGamepad(gamepad);
    play(0.5);
    app.setGamepad(gamepad);
    play(0.1);
    EXPECT_TRUE(app.game()->player().flying) << "held, not pressed again";
    EXPECT_GT(x(), 21.0);
    app.setGamepad({});
    app.setGamepad(gamepad);
    EXPECT_FALSE(app.game()->player().flying);
    gamepad = {};
    gamepad.right = {1.0, 0.0};
    app.setGamepad(gamepad);
    play(0.5);
    EXPECT_GT(heading(), 10.0);
    app.setGamepad({});
    play(0.5);
    const double rested = heading();
    play(0.5);
    EXPECT_EQ(heading(), rested);
    gamepad.buttons = kPadPause;
    app.setGamepad(gamepad);
    EXPECT_TRUE(app.paused());
}

TEST_F(AppTest, ThumbsWalkAndDrag) {
    app.setThumbs({.forward = 1.0});
    app.dragged(100.0, 0.0);
    play(0.5);
    EXPECT_GT(x(), 21.0);
    EXPECT_NEAR(heading(), 100.0 * kDefaultDegreesPerPixel, 1e-9);
    app.releaseKeys();
    play(0.5);
    const double stopped = x();
    play(0.5);
    EXPECT_EQ(x(), stopped);
}

TEST_F(AppTest, TheCursorSteersWhileItIsOn) {
    app.cursorAt(1.0, 0.0);
    play(0.2);
    EXPECT_EQ(heading(), 0.0);
    press(SDL_SCANCODE_N);
    EXPECT_TRUE(app.cursorSteers());
    EXPECT_EQ(shell.news.back(), (std::pair{News::cursor, true}));
    app.cursorAt(0.2, -0.2);
    play(0.2);
    EXPECT_EQ(heading(), 0.0) << "within the dead zone";
    EXPECT_EQ(app.game()->player().look, 0.0);
    app.cursorAt(1.0, -1.0);
    play(0.5);
    EXPECT_GT(heading(), 10.0);
    EXPECT_GT(app.game()->player().look, 0.05);
    app.cursorLeft();
    play(0.5);
    const double rested = heading();
    app.cursorAt(-1.0, 0.0);
    app.pointerHeld(true);
    EXPECT_FALSE(app.cursorSteers()) << "the mouse is held, it has no place";
    play(0.5);
    EXPECT_EQ(heading(), rested);
    app.setCursorSteering(true);
    app.releaseKeys();
    EXPECT_FALSE(app.cursorSteers());
}

TEST_F(AppTest, ReplaysWhatItRecords) {
    app.play(std::make_unique<Session>(makeField()));
    app.record("field");
    EXPECT_TRUE(app.isRecording());
    press(SDL_SCANCODE_W);
    play(0.5);
    release(SDL_SCANCODE_W);
    press(SDL_SCANCODE_V);
    app.pointerHeld(true);
    app.pointerMoved(37.0, -11.0);
    play(0.5);
    app.pointerHeld(false);
    const std::uint64_t end = app.game()->fingerprint();
    const std::optional<Recording> recording = app.takeRecording();
    EXPECT_FALSE(app.isRecording());
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->scene, "field");
    EXPECT_NEAR(static_cast<double>(recording->steps), 120.0, 4.0);
    EXPECT_FALSE(app.takeRecording());
    play(0.2);

    app.play(std::make_unique<Session>(makeField()));
    app.replay(*recording);
    EXPECT_EQ(shell.news.back(), (std::pair{News::replay, true}));
    while (app.game()->steps() < recording->steps) {
        shell.now += 1.0 / 250.0;
        app.frame(shell.now);
    }
    EXPECT_EQ(app.game()->steps(), recording->steps);
    EXPECT_EQ(app.game()->fingerprint(), end);
    play(0.5);
    EXPECT_EQ(app.replayed(), nullptr);
    EXPECT_EQ(shell.news.back(), (std::pair{News::replay, false}));
}

TEST_F(AppTest, AnyMovementEndsAReplay) {
    Recording recording;
    recording.scene = "field";
    recording.entries = {RecordedSteps{1000, {.forward = 256}}};
    recording.steps = 1000;
    app.replay(recording);
    play(0.5);
    EXPECT_GT(x(), 21.0);
    ASSERT_NE(app.replayed(), nullptr);
    press(SDL_SCANCODE_LSHIFT);
    play(0.1);
    EXPECT_NE(app.replayed(), nullptr) << "faster is no way";
    press(SDL_SCANCODE_RIGHT);
    play(0.1);
    EXPECT_EQ(app.replayed(), nullptr);
    play(0.5);
    const double stopped = x();
    play(0.5);
    EXPECT_EQ(x(), stopped);

    app.replay(recording);
    press(SDL_SCANCODE_V);
    EXPECT_EQ(app.replayed(), nullptr);
    press(SDL_SCANCODE_F9);
    EXPECT_EQ(count(News::record), 1);
}

TEST_F(AppTest, GoesToAnyMomentOfAReplay) {
    Recording recording;
    recording.scene = "field";
    recording.entries = {RecordedSteps{1000, {.forward = 256, .turn = 128}}};
    recording.steps = 1000;
    const auto stateAfter = [&](std::int64_t steps) {
        Session session(makeField());
        Replay replay(recording);
        while (replay.stepsDone() < steps) replay.step(session);
        return session.fingerprint();
    };
    const auto arrive = [&] {
        while (app.isSeeking()) app.frame(shell.now);
    };
    EXPECT_FALSE(app.seek(10)) << "there is no recording";
    app.play(std::make_unique<Session>(makeField()));
    app.replay(recording);
    play(0.5);

    // Paused it stays there, and shows exactly that step
    app.setPaused(true);
    for (const int step : {700, 100, 0}) {
        EXPECT_TRUE(app.seek(step));
        EXPECT_TRUE(app.wantsFrame());
        arrive();
        EXPECT_EQ(app.replayed()->stepsDone(), step);
        EXPECT_EQ(app.game()->fingerprint(), stateAfter(step)) << step;
        std::vector<Pixel> expected(shell.last.size());
        ASSERT_TRUE(app.game()->draw({expected.data(), app.width(), app.height(), app.width()}));
        EXPECT_EQ(shell.last, expected);
    }
    // Playing it goes on from there
    app.setPaused(false);
    EXPECT_TRUE(app.seek(500));
    arrive();
    EXPECT_EQ(app.replayed()->stepsDone(), 500);
    play(0.5);
    EXPECT_EQ(app.game()->fingerprint(), stateAfter(app.replayed()->stepsDone()));

    // Back from where somebody has taken over, and from behind the end
    press(SDL_SCANCODE_RIGHT);
    play(0.2);
    release(SDL_SCANCODE_RIGHT);
    EXPECT_EQ(app.replayed(), nullptr);
    EXPECT_TRUE(app.seek(300));
    EXPECT_EQ(shell.news.back(), (std::pair{News::replay, true}));
    arrive();
    EXPECT_EQ(app.game()->fingerprint(), stateAfter(300));
    EXPECT_TRUE(app.seek(5000));
    arrive();
    EXPECT_EQ(app.game()->fingerprint(), stateAfter(1000));
    play(0.5);
    EXPECT_EQ(app.replayed(), nullptr);
    EXPECT_TRUE(app.seek(200));
    arrive();
    EXPECT_EQ(app.game()->fingerprint(), stateAfter(200));

    // A step of somebody else ends it on the way
    EXPECT_TRUE(app.seek(900));
    app.step({});
    EXPECT_FALSE(app.isSeeking());
    app.record("field");
    EXPECT_FALSE(app.seek(10)) << "while recording";
    app.takeRecording();
    app.play(std::make_unique<Session>(makeField()));
    EXPECT_FALSE(app.seek(10)) << "that was another game";
}

TEST_F(AppTest, ALongWayIsGoneInSlices) {
    constexpr std::int64_t kSteps = 400'000;
    Recording recording;
    recording.scene = "field";
    recording.entries = {RecordedSteps{kSteps, {.forward = 256, .turn = 128}}};
    recording.steps = kSteps;
    app.play(std::make_unique<Session>(makeField()));
    app.replay(recording);
    play(0.1);
    shell.secondsPerLook = 0.003;
    const int shown = shell.shown;
    EXPECT_TRUE(app.seek(5000));
    int slices = 0;
    for (; app.isSeeking(); ++slices) {
        EXPECT_EQ(shell.shown, shown) << "none on the way";
        const double begin = shell.now;
        app.frame(begin);
        if (app.isSeeking()) {
            ASSERT_LT(shell.now - begin, kSliceSeconds + 0.01);
        }
    }
    EXPECT_GT(slices, 10);
    EXPECT_GT(shell.shown, shown);
    EXPECT_EQ(app.replayed()->stepsDone(), 5000);
}

TEST_F(AppTest, SizesAreClamped) {
    app.resize(0, 1 << 20);
    EXPECT_EQ(app.width(), 1);
    EXPECT_EQ(app.height(), kLargestPictureSide);
}

TEST_F(AppTest, TheSurfaceShowsWhatTheSessionDraws) {
    app.resize(33, 21);
    app.setPaused(true);
    app.frame(shell.now);
    std::vector<Pixel> expected(33 * 21);
    ASSERT_TRUE(app.game()->draw({expected.data(), 33, 21, 33}));
    EXPECT_EQ(shell.last, expected);
}

TEST_F(AppTest, ReportsRatesTwiceASecond) {
    play(2.2);
    ASSERT_EQ(shell.rates.size(), 4u);
    EXPECT_NEAR(shell.rates.back().framesPerSecond, 60.0, 0.1);
}

TEST_F(AppTest, AnotherGameBeginsFromItsOwnStart) {
    press(SDL_SCANCODE_V);
    play(0.5);
    World world = makeField();
    world.start.x = toCoordinate(10.5);
    app.play(std::make_unique<Session>(std::move(world)));
    EXPECT_EQ(x(), 10.5);
    EXPECT_EQ(shell.news.back(), (std::pair{News::fly, false}));
}

TEST_F(AppTest, AReboundKeyActsAndTheOldOneDoesNot) {
    press(SDL_SCANCODE_W);
    KeyBindings keys;
    EXPECT_EQ(keys.read("forward=ArrowUp,fly=KeyW"), "");
    app.setKeys(keys);
    const double before = x();
    play(0.5);
    EXPECT_EQ(x(), before) << "no key is held any more";
    press(SDL_SCANCODE_UP);
    play(0.5);
    EXPECT_GT(x(), before);
    EXPECT_FALSE(app.game()->player().flying);
    press(SDL_SCANCODE_W);
    EXPECT_TRUE(app.game()->player().flying);
}

TEST(App, DoesNothingWithoutAGame) {
    NoteShell shell;
    App app(shell);
    for (const KeyPosition& key : allPositions()) {
        app.keyDown(key.scancode, false);
        app.keyUp(key.scancode);
    }
    app.pointerHeld(true);
    app.pointerMoved(1.0, 1.0);
    EXPECT_FALSE(app.frame(1.0));
    EXPECT_EQ(shell.shown, 0);
}

TEST_F(AppTest, KeysSwitchTheOverlaysOnAndOff) {
    const std::pair<SDL_Scancode, const char*> switches[] = {
        {SDL_SCANCODE_M, "minimap"},      {SDL_SCANCODE_B, "minimapTurns"},
        {SDL_SCANCODE_O, "minimapRays"},  {SDL_SCANCODE_J, "playerPanel"},
        {SDL_SCANCODE_U, "processPanel"}, {SDL_SCANCODE_G, "inspector"},
        {SDL_SCANCODE_K, "grid"},         {SDL_SCANCODE_Y, "slow"}};
    for (const auto& [scancode, option] : switches) {
        EXPECT_EQ(app.game()->option(option), "off") << option;
        press(scancode);
        press(scancode, true);
        EXPECT_EQ(app.game()->option(option), "on") << option;
        play(0.1);
        EXPECT_EQ(shell.news.back(), (std::pair{News::overlay, true})) << option;
        press(scancode);
        EXPECT_EQ(app.game()->option(option), "off") << option;
        play(0.1);
        EXPECT_EQ(shell.news.back(), (std::pair{News::overlay, false})) << option;
    }
}

// In one frame the page switches the minimap on, and a key switches it off.
TEST_F(AppTest, TellsWhatAKeyTakesBack) {
    play(0.1);
    app.game()->setOption("minimap", "on");
    press(SDL_SCANCODE_M);
    play(0.1);
    EXPECT_EQ(app.game()->option("minimap"), "off");
    ASSERT_GE(shell.news.size(), 2u);
    EXPECT_EQ(shell.news.back(), (std::pair{News::overlay, false}));
}

TEST_F(AppTest, AKeyCyclesThroughTheTimesOfDay) {
    for (const char* preset : {"day", "dusk", "night", "fog", "map", "day"}) {
        press(SDL_SCANCODE_L);
        EXPECT_EQ(app.game()->option("lightPreset"), preset);
    }
}

TEST_F(AppTest, TheNumberRowGoesToMaps) {
    World world = makeField();
    world.maps.push_back(makeMap("cellar", 9, 5, 1, 0));
    app.play(std::make_unique<Session>(std::move(world)));
    press(SDL_SCANCODE_1);
    EXPECT_EQ(app.game()->player().map, 1);
    EXPECT_EQ(x(), 4.5);
    press(SDL_SCANCODE_2);
    EXPECT_EQ(app.game()->player().map, 1) << "there is no such map";
    press(SDL_SCANCODE_0);
    EXPECT_EQ(app.game()->player().map, 0);
    EXPECT_EQ(x(), 20.5);
}

TEST_F(AppTest, KeysMoveTheInspectedSlice) {
    press(SDL_SCANCODE_F2);
    EXPECT_EQ(app.game()->option("inspectorColumn"), "41") << "from the middle";
    press(SDL_SCANCODE_F1);
    press(SDL_SCANCODE_F1, true);
    EXPECT_EQ(app.game()->option("inspectorColumn"), "39");
    press(SDL_SCANCODE_LSHIFT);
    press(SDL_SCANCODE_F2, true);
    EXPECT_EQ(app.game()->option("inspectorColumn"), "49");
    for (int i = 0; i < 10; ++i) press(SDL_SCANCODE_F2, true);
    EXPECT_EQ(app.game()->option("inspectorColumn"), "79") << "the last one";
}

TEST_F(AppTest, AKeyListsTheHitsOfTheInspectedSlice) {
    app.game()->setOption("inspectorColumn", "7");
    press(SDL_SCANCODE_T);
    ASSERT_EQ(shell.hits.size(), 1u);
    EXPECT_EQ(shell.hits[0], hitsJson(*app.game(), "", 80, 50, 7));
    EXPECT_NE(shell.hits[0].find("\"column\":7,"), std::string::npos);
}

TEST_F(AppTest, KeysChooseTheLevelOfTheMinimap) {
    const auto level = [&] { return app.game()->option("minimapLevel"); };
    press(SDL_SCANCODE_RIGHTBRACKET);
    EXPECT_EQ(level(), "1") << "above the player's";
    press(SDL_SCANCODE_RIGHTBRACKET);
    EXPECT_EQ(level(), "1") << "the highest of the map";
    press(SDL_SCANCODE_LEFTBRACKET);
    EXPECT_EQ(level(), "0");
    press(SDL_SCANCODE_LEFTBRACKET);
    EXPECT_EQ(level(), "-1") << "the player's";
}

TEST_F(AppTest, KeysChangeTheRateOfSlowDrawing) {
    press(SDL_SCANCODE_F4);
    EXPECT_EQ(app.game()->option("slowSlices"), "2");
    for (int i = 0; i < 4; ++i) press(SDL_SCANCODE_F3, true);
    EXPECT_EQ(app.game()->option("slowSlices"), "-2");
}

TEST_F(AppTest, TheProcessPanelGetsAClock) {
    press(SDL_SCANCODE_U);
    app.resize(320, 200);
    play(0.3);
    const std::vector<Pixel> before = shell.last;
    play(0.4);
    EXPECT_NE(shell.last, before) << "times instead of dashes";
}

}  // namespace
}  // namespace slicecast
