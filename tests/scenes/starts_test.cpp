// How the shipped scenes begin: the player stands on firm ground with room around, and sees
// something.
#include "scenes/shipped.h"

#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;

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

// Colours counted to an eighth of their range, so that texture and light do not make a bare wall
// look rich.
TEST(Starts, TheFirstViewIsNotMostlyOneColour) {
    for (const std::string& scene : shippedScenes()) {
        Session session(shippedWorld(scene));
        std::vector<Pixel> pixels(static_cast<std::size_t>(kWidth) * kHeight);
        ASSERT_TRUE(session.draw(
            {.pixels = pixels.data(), .width = kWidth, .height = kHeight, .pitch = kWidth}));
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
