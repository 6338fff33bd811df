#include "app/step_clock.h"

#include "app/frame_meter.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(StepClock, PlaysAsManyStepsAsTimePasses) {
    for (const double rate : {24.0, 59.94, 60.0, 75.0, 120.0, 144.0, 240.0, 999.0}) {
        StepClock clock;
        int steps = clock.advance(1000.0);
        EXPECT_EQ(steps, 0);
        const int frames = static_cast<int>(10.0 * rate);
        for (int i = 1; i <= frames; ++i) {
            steps += clock.advance(1000.0 + i / rate);
            EXPECT_GE(clock.fraction(), 0.0);
            EXPECT_LE(clock.fraction(), 1.0);
        }
        EXPECT_NEAR(steps, 120.0 * frames / rate, 1.0) << rate;
    }
}

TEST(StepClock, TheFractionIsTheTimeSinceTheLastStep) {
    StepClock clock;
    clock.advance(0.0);
    EXPECT_EQ(clock.advance(2.25 / 120), 2);
    EXPECT_NEAR(clock.fraction(), 0.25, 1e-9);
    EXPECT_EQ(clock.advance(2.75 / 120), 0);
    EXPECT_NEAR(clock.fraction(), 0.75, 1e-9);
}

TEST(StepClock, ALongFrameIsCutShort) {
    StepClock clock;
    clock.advance(5.0);
    EXPECT_EQ(clock.advance(500.0), 12);
    EXPECT_EQ(clock.advance(500.0 + 1.01 / 120), 1);
}

TEST(StepClock, TimeDoesNotPassWhileStopped) {
    StepClock clock;
    clock.advance(0.0);
    clock.advance(1.5 / 120);
    clock.stop();
    EXPECT_EQ(clock.advance(60.0), 0);
    EXPECT_NEAR(clock.fraction(), 0.5, 1e-9) << "and the picture does not move";
    EXPECT_EQ(clock.advance(60.0 + 0.75 / 120), 1);
}

TEST(StepClock, AClockGoingBackwardsIsHarmless) {
    StepClock clock;
    clock.advance(10.0);
    EXPECT_EQ(clock.advance(9.0), 0);
    EXPECT_EQ(clock.advance(9.0 + 1.01 / 120), 1);
}

TEST(FrameMeter, CountsTwiceASecond) {
    FrameMeter meter;
    int times = 0;
    for (int i = 0; i <= 190; ++i) {
        const double late = i == 150 ? 0.015 : 0.0;
        if (!meter.add(i / 100.0 + late, 0.004)) continue;
        ++times;
        EXPECT_NEAR(meter.rates().framesPerSecond, 100.0, 4.0);
        EXPECT_NEAR(meter.rates().drawMilliseconds, 4.0, 1e-9);
        EXPECT_NEAR(meter.rates().longestMilliseconds, times == 3 ? 25.0 : 10.0, 1e-6);
    }
    EXPECT_EQ(times, 3);
}

TEST(FrameMeter, APauseIsNotALongFrame) {
    FrameMeter meter;
    for (int i = 0; i < 30; ++i) meter.add(i / 100.0, 0.001);
    meter.skip();
    for (int i = 0; i <= 50; ++i) meter.add(60.0 + i / 100.0, 0.001);
    EXPECT_NEAR(meter.rates().framesPerSecond, 100.0, 1e-6);
    EXPECT_NEAR(meter.rates().longestMilliseconds, 10.0, 1e-6);
}

}  // namespace
}  // namespace slicecast
