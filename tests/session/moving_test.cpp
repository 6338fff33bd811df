// Moving blocks and gates in a game: what is drawn of them between steps, the keys, and that a game
// can be played again.
#include "session/recording.h"
#include "session/session.h"

#include "base/image.h"
#include "drawn.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr int kPeriod = 480;

// A platform of 5 x 5 tiles that goes up and down, with the player in its middle, and a gate beside
// it in the east.
World works() {
    WorldBuilder make;
    make.world.title = "Works";
    make.texture("squares", squaresImage());
    make.block('=', {.name = "plate", .top = 0.25}).motion = 0;
    make.block('|', {.name = "gate"}).gate = 0;
    make.world.motions.push_back({.name = "lift",
                                  .edges = MovingEdges::both,
                                  .from = {},
                                  .to = toCoordinate(1.5),
                                  .periodSteps = kPeriod});
    make.world.gateKinds.push_back({.steps = 60, .reach = toCoordinate(2.5)});
    make.map("yard", 3, R"(
............
............
.=====......
.=====......
.=====|.....
.=====......
.=====......
............
............
)");
    make.start(3.5, 4.5, 0.25, 0.0, -1.0);
    EXPECT_TRUE(makeMovers(make.world).empty());
    EXPECT_TRUE(makeGates(make.world).empty());
    makeGateFrames(make.world);
    return std::move(make.world);
}

// A player who rides a platform and looks at it sees the same picture all the way, byte for byte,
// at any moment between steps.
TEST(SessionThatMoves, ShowsARiderThePlatformAtRest) {
    Session session(works());
    const std::vector<Pixel> before = drawn(session, 1.0).pixels;
    for (int step = 0; step < kPeriod; ++step) {
        session.step({});
        ASSERT_TRUE(session.player().onGround);
        for (const double fraction : {0.0, 0.3, 0.71, 1.0})
            ASSERT_EQ(drawn(session, fraction).pixels, before) << step << " " << fraction;
    }
}

TEST(SessionThatMoves, IsNotChangedByDrawing) {
    Session session(works());
    for (int step = 0; step < 100; ++step) session.step({});
    const std::vector<CellBlueprint> blocks = session.world().blueprints;
    const std::vector<std::uint32_t> occupied = session.world().maps[0].occupied;
    drawn(session, 0.25);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        EXPECT_EQ(session.world().blueprints[i].bottom, blocks[i].bottom);
        EXPECT_EQ(session.world().blueprints[i].top, blocks[i].top);
    }
    EXPECT_EQ(session.world().maps[0].occupied, occupied);
}

const Gate& gateOf(const Session& session) {
    return session.world().gates[0];
}

TEST(SessionThatMoves, TakesALongPressForOneWish) {
    Session session(works());
    for (int step = 0; step < 30; ++step) session.step({.use = true});
    EXPECT_EQ(gateOf(session).progress, 30);
    session.step({});
    session.step({.use = true});
    EXPECT_EQ(gateOf(session).progress, 30);
    EXPECT_FALSE(gateOf(session).wantsOpen);
    session.step({.open = true});
    EXPECT_TRUE(gateOf(session).wantsOpen);
    session.step({.open = true, .close = true});
    EXPECT_FALSE(gateOf(session).wantsOpen);
}

TEST(SessionThatMoves, RestartsWhenReset) {
    Session session(works());
    for (int step = 0; step < 200; ++step) session.step({.forward = 0.2, .use = step == 3});
    EXPECT_GT(session.world().movers[0].clock, 0);
    EXPECT_GT(gateOf(session).progress, 0);
    EXPECT_EQ(session.world().steps, 200);
    session.reset();
    EXPECT_EQ(session.world().steps, 0) << "of what is animated";
    EXPECT_EQ(session.world().movers[0].clock, 0);
    EXPECT_EQ(gateOf(session).progress, 0);
    EXPECT_EQ(session.player(), playerAtStart(session.world()));
    session.step({});
    EXPECT_EQ(session.world().steps, 1);
    EXPECT_EQ(session.steps(), 201);
}

TEST(SessionThatMoves, HasAnotherFingerprintForAnotherGateOrMover) {
    Session still(works());
    Session other(works());
    for (int step = 0; step < 3; ++step) {
        still.step({});
        other.step({.use = step == 0});
    }
    EXPECT_EQ(still.player(), other.player());
    EXPECT_NE(still.fingerprint(), other.fingerprint());
}

TEST(SessionThatMoves, CanBePlayedAgain) {
    Recorder recorder("works");
    Session first(works());
    first.record(&recorder);
    for (int step = 0; step < 400; ++step) {
        first.step({.forward = step < 100 ? 0.5 : 1.0,
                    .turnDegrees = step % 7 == 0 ? 3.0 : 0.0,
                    .use = step == 50,
                    .open = step == 120,
                    .close = step == 200});
        if (step == 300) first.reset();
    }
    Session second(works());
    Replay replay(recorder.finish(first));
    while (replay.step(second)) {
    }
    EXPECT_TRUE(replay.isSame());
    EXPECT_EQ(second.fingerprint(), first.fingerprint());
    EXPECT_NE(gateOf(second).progress + second.world().movers[0].clock, 0);
}

}  // namespace
}  // namespace slicecast
