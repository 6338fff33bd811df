#include "tours/tours.h"

#include "render/renderer.h"
#include "sanitized.h"
#include "scenes/shipped.h"
#include "session/recording_text.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace slicecast {
namespace {

const char* const kMakeAnew = "; if the way may change: slicecast-tours assets";

std::string tourText(const std::string& name) {
    std::ifstream file(assetsFolder() / "tours" / (name + ".txt"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Recording shippedTour(const std::string& name) {
    ReadRecording read = readRecording(tourText(name), name + ".txt");
    for (const Fault& fault : read.faults) ADD_FAILURE() << describe(fault);
    return read.recording.value_or(Recording{});
}

TEST(Tours, AreTheGuidesOwn) {
    for (const Tour& tour : allTours()) {
        SCOPED_TRACE(tour.scene);
        Guide guide(shippedWorld(tour.scene), tour.scene);
        tour.give(guide);
        EXPECT_EQ(guide.trouble(), "");
        // Not EXPECT_EQ, which would print both.
        EXPECT_TRUE(writeRecording(guide.finish()) == tourText(tour.scene))
            << "the guide goes another way than assets/tours says" << kMakeAnew;
    }
}

TEST(Tours, EveryFileIsOneOfThem) {
    std::set<std::string> names;
    for (const Tour& tour : allTours()) names.insert(tour.scene);
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(assetsFolder() / "tours"))
        files.insert(entry.path().stem().string());
    EXPECT_EQ(files, names);
    EXPECT_GE(names.size(), 5u);
}

TEST(Tours, LeadWhereTheyLed) {
    for (const Tour& tour : allTours()) {
        SCOPED_TRACE(tour.scene);
        const Recording recording = shippedTour(tour.scene);
        EXPECT_EQ(recording.scene, tour.scene);
        Session session(shippedWorld(recording.scene));
        Replay replay(recording);
        while (replay.step(session)) {
        }
        EXPECT_EQ(replay.stepsDone(), recording.steps);
        EXPECT_EQ(session.steps(), recording.steps);
        EXPECT_GE(replay.marks().size(), 5u);
        for (const PassedMark& mark : replay.marks())
            EXPECT_TRUE(mark.isSame) << mark.name << kMakeAnew;
        EXPECT_TRUE(replay.isSame()) << kMakeAnew;
    }
}

// A game that can be won, by walking alone.
TEST(Tours, TheHuntIsPlayedToItsEnd) {
    Session session(shippedWorld("wayhouse-hunt"));
    Replay replay(shippedTour("wayhouse-hunt"));
    std::vector<std::string> found;
    int goals = 0;
    bool wasRefused = false;
    while (replay.step(session)) {
        for (const QuestNews& news : session.takeNews()) {
            EXPECT_EQ(goals, 0) << "the goal comes last";
            if (news.kind == QuestNews::Kind::find) found.push_back(news.name);
            goals += news.kind == QuestNews::Kind::goal;
            wasRefused = wasRefused || news.text.find("is shut") != std::string::npos;
            EXPECT_FALSE(session.player().flying);
        }
    }
    EXPECT_EQ(found, (std::vector<std::string>{"shell", "lantern", "moonflower", "crystal"}));
    EXPECT_EQ(goals, 1);
    EXPECT_TRUE(wasRefused);
    EXPECT_TRUE(session.world().quest.isReached);
    EXPECT_GT(session.world().quest.steps, 20 * kStepsPerSecond);
    EXPECT_LT(session.world().quest.steps, session.steps());
}

constexpr int kLookEvery = 12;     // steps; ten looks a second
constexpr double kNear = 1.4;      // units; a wall of one block's height is taller than the picture
constexpr double kFilled = 0.7;    // share of the picture
constexpr int kLongest = 2 * 120;  // steps

// The share of a picture that shows sides of blocks close before the eye. What is seen through
// portals counts by its whole depth, so one may stand before a gate.
double shareOfNearWalls(Renderer& renderer, const Session& session) {
    constexpr int kWidth = 32;
    constexpr int kHeight = 18;
    int rows = 0;
    for (int column = 1; column < kWidth; column += 2) {
        const SliceTrace trace =
            renderer.trace(session.world(), session.eye(), {}, {kWidth, kHeight, column});
        for (const FilledRows& filled : trace.filled) {
            if (filled.what == FilledRows::What::side && !filled.layer && filled.top.depth < kNear)
                rows += filled.last - filled.first;
        }
    }
    return rows / (kWidth / 2.0 * kHeight);
}

TEST(Tours, NoTwoSecondsWithAWallFillingThePicture) {
    const auto& tours = allTours();
    for (std::size_t number = 0; number < tours.size(); number += kSanitized ? 4 : 1) {
        const Tour& tour = tours[number];
        Session session(shippedWorld(tour.scene));
        Replay replay(shippedTour(tour.scene));
        Renderer renderer;
        int since = -1;
        for (int step = 0; replay.step(session); ++step) {
            if (step % kLookEvery != 0) continue;
            const bool isFilled = shareOfNearWalls(renderer, session) > kFilled;
            if (isFilled && since < 0) since = step;
            if (isFilled) continue;
            if (since >= 0) {
                const Player& player = session.player();
                EXPECT_LT(step - since, kLongest)
                    << tour.scene << ": a wall fills the picture from second " << since / 120.0
                    << " to " << step / 120.0 << ", at " << player.x.value() << ", "
                    << player.y.value() << " in " << player.map;
            }
            since = -1;
        }
    }
}

// What a tour is for: all ways of moving are in it.
TEST(Tours, TogetherTheyDoEverything) {
    bool walks = false, runs = false, strafes = false, jumps = false, crouches = false,
         turns = false, looks = false, flies = false, climbs = false, rides = false, opens = false;
    for (const Tour& tour : allTours()) {
        Session session(shippedWorld(tour.scene));
        Replay replay(shippedTour(tour.scene));
        const Coordinate start = session.player().z;
        Coordinate feetBefore = start;
        while (replay.step(session)) {
            const Player& player = session.player();
            const double speed = session.state().speed;
            walks = walks || (speed > 2.5 && speed < 3.1 && player.onGround);
            runs = runs || (speed > 5.0 && player.onGround);
            jumps = jumps || player.velocityZ > 3.5;
            crouches = crouches || player.crouched;
            flies = flies || player.flying;
            for (const Mover& mover : session.world().movers) {
                const Coordinate rise = mover.offset - mover.previousOffset;
                rides = rides ||
                        (rise > Coordinate{0} && player.onGround && player.z - feetBefore == rise);
            }
            feetBefore = player.z;
            climbs = climbs || (player.onGround && player.z.value() > start.value() + 4.0);
        }
        for (const RecordedEntry& entry : replay.recording().entries) {
            const auto* steps = std::get_if<RecordedSteps>(&entry);
            if (steps == nullptr) continue;
            strafes = strafes || steps->input.strafe != 0;
            turns = turns || (steps->input.turn != 0 && steps->input.turnDegrees == 0);
            looks = looks || steps->input.lookHeights != 0;
            opens = opens || steps->input.use;
        }
    }
    EXPECT_TRUE(walks);
    EXPECT_TRUE(runs);
    EXPECT_TRUE(strafes);
    EXPECT_TRUE(jumps);
    EXPECT_TRUE(crouches);
    EXPECT_TRUE(turns);
    EXPECT_TRUE(looks);
    EXPECT_TRUE(flies);
    EXPECT_TRUE(climbs);
    EXPECT_TRUE(rides);
    EXPECT_TRUE(opens);
}

}  // namespace
}  // namespace slicecast
