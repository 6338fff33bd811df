// Going to any step of a replay: bounded in memory and in the steps that it plays, and the state is
// the one that all steps lead to. tests/scenes/seek_test.cpp does the same with the shipped scenes.
#include "session/recording.h"
#include "session/session.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A meadow with a post, with notices to read.
World makeMeadow(std::size_t notices = 0, std::size_t letters = 0) {
    WorldBuilder make;
    make.texture("grey", {128, 128, 128, 255});
    LegendEntry post{"#", 1};
    make.block('#', {.name = "post"});
    make.map("meadow", 20, 20, 2).legend.push_back(post);
    make.put('#', 14, 10);
    make.start(10.5, 10.5);
    for (std::size_t i = 0; i < notices; ++i) {
        make.world.quest.notices.push_back(
            {.map = 0, .area = {}, .near = {}, .text = std::string(letters, 'a')});
    }
    startQuest(make.world);
    return std::move(make.world);
}

// Turns all the time, so that each step has another state.
Recording spinning(std::int64_t steps) {
    Recording recording;
    recording.scene = "meadow";
    recording.entries = {RecordedSteps{steps, {.forward = 64, .turn = 128}}};
    recording.steps = steps;
    return recording;
}

std::uint64_t stateAfter(const Recording& recording, std::int64_t steps) {
    Session session(makeMeadow());
    Replay replay(recording);
    for (std::int64_t i = 0; i < steps; ++i) EXPECT_TRUE(replay.step(session));
    return session.fingerprint();
}

// As many calls as it takes.
void seekInSlices(Replay& replay, Session& session, std::int64_t step, int most) {
    while (!replay.seek(session, step, most)) {
    }
}

TEST(Seek, GoesForthAndBack) {
    const Recording recording = spinning(2000);
    Session session(makeMeadow());
    Replay replay(recording);
    for (const int step : {1500, 200, 0, 1999, 240, 239, 241, 2000, 1, 2000}) {
        seekInSlices(replay, session, step, 7);
        EXPECT_EQ(replay.stepsDone(), step);
        EXPECT_EQ(session.fingerprint(), stateAfter(recording, step)) << step;
    }
    // Beyond the ends
    EXPECT_TRUE(replay.seek(session, -5, 0));
    EXPECT_EQ(replay.stepsDone(), 0);
    seekInSlices(replay, session, 5000, 7);
    EXPECT_EQ(replay.stepsDone(), 2000);
    EXPECT_EQ(session.fingerprint(), stateAfter(recording, 2000));
    EXPECT_FALSE(replay.step(session));
}

TEST(Seek, PlaysFewSteps) {
    Session session(makeMeadow());
    Replay replay(spinning(10'000));
    while (replay.step(session)) {
    }
    // From the nearest moment before, of those that were kept on the way
    EXPECT_TRUE(replay.seek(session, 7321, static_cast<int>(kStepsOfMoment)));
    EXPECT_TRUE(replay.seek(session, 7321 + 100, 100)) << "on from where it is";
    EXPECT_FALSE(replay.seek(session, 7321 + 300, 1));
}

TEST(Seek, TakesBackASessionThatWentOnWithoutIt) {
    const Recording recording = spinning(1000);
    Session session(makeMeadow());
    Replay replay(recording);
    for (int i = 0; i < 500; ++i) replay.step(session);
    replay.leave();
    EXPECT_EQ(session.setCell({0, 0, 3, 3}, "#"), "");
    session.setOption("speed", "3");
    for (int i = 0; i < 100; ++i) session.step({.strafe = 1.0});
    session.reset();
    seekInSlices(replay, session, 500, 50);
    EXPECT_EQ(session.fingerprint(), stateAfter(recording, 500));
    EXPECT_EQ(session.world().maps[0].cell(3, 3, 0), kEmptyCell);
    EXPECT_EQ(session.option("speed"), "1");

    // Before anything was played
    Session fresh(makeMeadow());
    Replay other(recording);
    EXPECT_TRUE(other.seek(fresh, 0, 0));
    other.leave();
    for (int i = 0; i < 100; ++i) fresh.step({.strafe = 1.0});
    EXPECT_TRUE(other.seek(fresh, 0, 0));
    EXPECT_EQ(fresh.fingerprint(), stateAfter(recording, 0));
}

TEST(Seek, KeepsWhatIsSetBetweenSteps) {
    Recording recording = spinning(600);
    recording.entries = {RecordedOption{"speed", "2"},
                         RecordedSteps{250, {.forward = 256}},
                         RecordedCell{0, 0, 5, 5, "#"},
                         RecordedFlying{true},
                         RecordedMark{"here", 1},
                         RecordedSteps{200, {.fly = 256, .use = true}},
                         RecordedReset{},
                         RecordedSteps{150, {.strafe = 256}},
                         RecordedCell{0, 0, 6, 6, "#"}};
    Session session(makeMeadow());
    Replay replay(recording);
    while (replay.step(session)) {
    }
    EXPECT_EQ(session.world().maps[0].cell(6, 6, 0), 1) << "after the last step";
    for (const int step : {600, 250, 480, 100, 451, 450, 0, 251}) {
        seekInSlices(replay, session, step, 50);
        EXPECT_EQ(session.fingerprint(), stateAfter(recording, step)) << step;
        EXPECT_EQ(replay.marks().size(), step > 250 ? 1u : 0u) << step;
        EXPECT_EQ(replay.isSame(), step <= 250) << step;
    }
}

TEST(Seek, KeepsABoundedNumberOfMoments) {
    const auto steps = static_cast<std::int64_t>(kMostMoments) * kStepsOfMoment * 5;
    const Recording recording = spinning(steps);
    Session session(makeMeadow());
    Replay replay(recording);
    std::uint64_t inTheMiddle = 0;
    std::size_t most = 0;
    while (replay.step(session)) {
        most = std::max(most, replay.moments());
        if (replay.stepsDone() == steps / 2 + 77) inTheMiddle = session.fingerprint();
    }
    EXPECT_EQ(most, kMostMoments);
    EXPECT_GE(replay.moments(), kMostMoments / 2);
    EXPECT_TRUE(replay.seek(session, steps / 2 + 77, static_cast<int>(8 * kStepsOfMoment)));
    EXPECT_EQ(session.fingerprint(), inTheMiddle);
}

TEST(Seek, KeepsABoundedNumberOfBytes) {
    constexpr std::size_t kNotices = 100;
    constexpr std::size_t kLetters = 10'000;  // a moment takes a megabyte
    Session session(makeMeadow(kNotices, kLetters));
    Replay replay(spinning(60 * kStepsOfMoment));
    while (replay.step(session)) {
        EXPECT_LE(replay.moments(), kMostMomentBytes / (kNotices * kLetters) + 1);
    }
    EXPECT_GE(replay.moments(), 4u);
    EXPECT_TRUE(replay.seek(session, 3000, static_cast<int>(16 * kStepsOfMoment)));
}

TEST(Seek, DropsNewsThatNobodyTook) {
    World world = makeMeadow(1, 5);
    world.quest.notices[0].area = {tileEdge(11), tileEdge(12), tileEdge(10),
                                   tileEdge(11), {},           tileEdge(1)};
    startQuest(world);
    Session session(std::move(world));
    Replay replay(spinning(400));
    const SessionMoment start = session.moment();
    while (replay.step(session)) {
    }
    EXPECT_FALSE(session.world().quest.notices.empty());
    session.restore(start);
    EXPECT_TRUE(session.takeNews().empty());
    EXPECT_FALSE(session.world().quest.hasBegun);
}

}  // namespace
}  // namespace slicecast
