// How the shipped scenes begin: the player stands on firm ground with room around, and sees
// something.
#include "scenes/shipped.h"

#include "session/session.h"
#include "world/water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr int kStartWidth = 320;
constexpr int kStartHeight = 180;
constexpr int kFirstWalk = 8 * kStepsPerSecond;

TEST(Starts, ThePlayerStandsOnTheGround) {
    for (const std::string& scene : shippedScenes()) {
        Session session(shippedWorld(scene));
        const Player atStart = session.player();
        EXPECT_FALSE(atStart.flying) << scene;
        EXPECT_FALSE(atStart.crouched) << scene;
        for (int i = 0; i < kStepsPerSecond; ++i) session.step({});
        EXPECT_TRUE(session.player().onGround) << scene;
        EXPECT_EQ(session.player().z.raw, atStart.z.raw)
            << scene << ": the start is above the ground";
    }
}

// These begin at the edge of the water that mirrors what is beyond it.
bool beginsByTheWater(const std::string& scene) {
    return scene == "harbour-town" || scene == "night-works" || scene == "water-palace";
}

bool eyeIsInWater(const Session& session) {
    const Player& player = session.player();
    const Map& map = session.world().maps[static_cast<std::size_t>(player.map)];
    return waterAt(session.world(), map, player.x.tile(), player.y.tile(), eyeHeight(player))
               .water != nullptr;
}

// A first-time player tends to hold the key that walks ahead.
TEST(Starts, StraightAheadNobodyGetsUnderWater) {
    for (const std::string& scene : shippedScenes()) {
        if (beginsByTheWater(scene)) continue;
        Session session(shippedWorld(scene));
        int step = 0;
        for (; step < kFirstWalk && !eyeIsInWater(session); ++step) session.step({.forward = 1.0});
        EXPECT_EQ(step, kFirstWalk) << scene << ": the steps until the eye is under water";
    }
}

// It is the one that the page opens with.
TEST(Starts, InTheCastleStraightAheadLeadsThroughTheGate) {
    Session session(shippedWorld("castle"));
    for (int i = 0; i < kFirstWalk; ++i) session.step({.forward = 1.0});
    constexpr double kGateX = 24.0;
    constexpr double kCourt = 6.0;
    EXPECT_LT(session.player().x.value(), kGateX);
    EXPECT_EQ(session.player().z.value(), kCourt);
}

// Colours counted to an eighth of their range, so that texture and light do not make a bare wall
// look rich.
TEST(Starts, TheFirstViewIsNotMostlyOneColour) {
    for (const std::string& scene : shippedScenes()) {
        Session session(shippedWorld(scene));
        std::vector<Pixel> pixels(static_cast<std::size_t>(kStartWidth) * kStartHeight);
        ASSERT_TRUE(session.draw({.pixels = pixels.data(),
                                  .width = kStartWidth,
                                  .height = kStartHeight,
                                  .pitch = kStartWidth}));
        std::map<Pixel, int> counts;
        for (const Pixel pixel : pixels) ++counts[pixel & 0xe0e0e0u];
        int most = 0;
        for (const auto& entry : counts) most = std::max(most, entry.second);
        EXPECT_LT(most, static_cast<int>(pixels.size()) * 2 / 5) << scene;
        EXPECT_GT(counts.size(), 12u) << scene;
    }
}

}  // namespace
}  // namespace slicecast
