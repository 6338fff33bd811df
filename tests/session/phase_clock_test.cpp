#include "session/phase_clock.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

// A picture every 20 ms: two steps of 1 ms, 5 ms for the view, 2 ms for overlays.
void picture(PhaseClock& clock, double& now) {
    for (int i = 0; i < 2; ++i) {
        clock.begin();
        now += 0.001;
        clock.endSteps();
    }
    now += 0.011;
    clock.begin();
    now += 0.005;
    clock.endView();
    now += 0.002;
    clock.endOverlays();
}

TEST(PhaseClock, GivesAveragesPerPicture) {
    PhaseClock clock;
    double now = 5000.0;
    clock.set([&] { return now; });
    EXPECT_EQ(clock.times(), nullptr);
    for (int i = 0; i < 60; ++i) picture(clock, now);
    ASSERT_NE(clock.times(), nullptr);
    EXPECT_NEAR(clock.times()->framesPerSecond, 50.0, 1e-3);
    EXPECT_NEAR(clock.times()->stepMilliseconds, 2.0, 1e-3);
    EXPECT_NEAR(clock.times()->viewMilliseconds, 5.0, 1e-3);
    EXPECT_NEAR(clock.times()->overlayMilliseconds, 2.0, 1e-3);
}

TEST(PhaseClock, APauseDoesNotCount) {
    PhaseClock clock;
    double now = 0.0;
    clock.set([&] { return now; });
    for (int i = 0; i < 30; ++i) picture(clock, now);
    now += 100.0;
    picture(clock, now);
    EXPECT_NEAR(clock.times()->framesPerSecond, 50.0, 1e-3) << "as before the pause";
    for (int i = 0; i < 60; ++i) picture(clock, now);
    EXPECT_NEAR(clock.times()->framesPerSecond, 50.0, 1e-3);
}

TEST(PhaseClock, MeasuresNothingWithoutAClock) {
    PhaseClock clock;
    double now = 0.0;
    for (int i = 0; i < 100; ++i) picture(clock, now);
    EXPECT_EQ(clock.times(), nullptr);
}

}  // namespace
}  // namespace slicecast
