// The lifts of the shipped scenes take people where they are to go.
#include "scenes/shipped.h"

#include "session/session.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

struct Ride {
    const char* scene;
    double x, y, feet;  // where one gets on, with the lift down
    double top;         // of the feet when it is up
    double heading;     // in which one gets off there
    double steps;       // it takes to get off, in units
};
constexpr Ride kRides[] = {
    {"castle", 23.5, 25.0, 6.2, 8.0, 0.0, 0.8},
    {"hill-abbey", 30.5, 16.5, 4.2, 8.0, 270.0, 1.2},
    {"hill-abbey", 29.5, 8.5, 8.2, 15.0, 90.0, 1.6},
    {"library", 11.0, 22.0, 0.2, 4.0, 90.0, 2.3},
};

TEST(Lifts, TakePeopleUpAndLetThemOff) {
    for (const Ride& ride : kRides) {
        SCOPED_TRACE(ride.scene);
        Session session(shippedWorld(ride.scene));
        ASSERT_TRUE(session.setEye({.map = 0,
                                    .x = toCoordinate(ride.x),
                                    .y = toCoordinate(ride.y),
                                    .z = toCoordinate(ride.feet) + kCrouchedEye}));
        session.setFlying(false);
        session.setHeading(ride.heading);
        const Mover* lift = nullptr;
        for (const Mover& mover : session.world().movers) {
            if (mover.west <= ride.x && ride.x <= mover.east + 1 && mover.north <= ride.y &&
                ride.y <= mover.south + 1)
                lift = &mover;
        }
        ASSERT_NE(lift, nullptr);
        const int period =
            session.world().motions[static_cast<std::size_t>(lift->motion)].periodSteps;
        for (int step = 0; step < period / 2; ++step) session.step({});
        EXPECT_TRUE(session.player().onGround);
        EXPECT_NEAR(session.player().z.value(), ride.top, 1e-4);
        for (int step = 0;
             step < static_cast<int>(ride.steps / kWalkingPace.move * kStepsPerSecond) + 20; ++step)
            session.step({.forward = 1.0});
        // It goes down again without them.
        for (int step = 0; step < period / 2; ++step) session.step({});
        EXPECT_NEAR(session.player().z.value(), ride.top, 0.3);
        EXPECT_TRUE(session.player().onGround);
        EXPECT_EQ(lift->offset, Coordinate{});
    }
}

}  // namespace
}  // namespace slicecast
