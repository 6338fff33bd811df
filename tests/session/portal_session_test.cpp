// Games with portals: what is drawn between two steps.
#include "session/session.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicecast {
namespace {

// A corridor along which tile 3 leads to tile 20, turned around.
World corridor() {
    WorldBuilder make;
    make.map("corridor", 30, 1, 1, kNoTexture);
    make.tilePortal({.fromX = 3, .fromY = 0, .toX = 20, .toY = 0, .turn = 2});
    make.start(1.5, 0.5);
    return std::move(make.world);
}

TEST(PortalSession, DoesNotInterpolateBetweenTheSidesWithinOneMapEither) {
    Session session(corridor());
    int between = 0;
    int leaps = 0;
    for (int step = 0; step < 2 * kStepsPerSecond; ++step) {
        const double before = session.player().x.value();
        const int leapsBefore = session.player().leaps;
        session.step({.forward = 1.0});
        const double after = session.player().x.value();
        const double drawn = session.eye(0.5).x.value();
        if (session.player().leaps != leapsBefore) {
            ++leaps;
            EXPECT_EQ(session.eye(0.0).x, session.eye(1.0).x);
            EXPECT_EQ(drawn, after);
            EXPECT_EQ(session.eye(0.5).headingDegrees, 180.0);
        } else if (std::abs(after - before) > 0.001) {
            ++between;
            EXPECT_NEAR(drawn, 0.5 * (before + after), 2.0 / 65536);
        }
    }
    EXPECT_EQ(leaps, 1);
    EXPECT_GT(between, kStepsPerSecond);
    EXPECT_LT(session.player().x.value(), 19.0);
}

// Two players at the same place are in different states while one of them still reaches back
// through a portal.
TEST(PortalSession, TheFingerprintDiffersBetweenTheSides) {
    Session walker(corridor());
    while (walker.player().leaps == 0) walker.step({.forward = 1.0});
    ASSERT_TRUE(walker.player().behind.isOn);
    const std::uint64_t straddling = walker.fingerprint();
    Session same(corridor());
    while (same.player().leaps == 0) same.step({.forward = 1.0});
    EXPECT_EQ(same.fingerprint(), straddling);
    World elsewhere = corridor();
    elsewhere.portals[0].fromX = 4;
    elsewhere.maps[0].tilePortals[3] = kNoPortal;
    elsewhere.maps[0].tilePortals[4] = 0;
    elsewhere.start.x = toCoordinate(2.5);
    Session other(elsewhere.copy());
    while (other.player().leaps == 0) other.step({.forward = 1.0});
    EXPECT_EQ(other.player().x, same.player().x);
    EXPECT_EQ(other.steps(), same.steps());
    EXPECT_NE(other.fingerprint(), straddling);
}

}  // namespace
}  // namespace slicecast
