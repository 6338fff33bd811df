// Portals in the shipped scenes, gone through on foot: each leads where it should, and the picture
// does not jump on the way.
#include "scenes/shipped.h"

#include "base/angle.h"
#include "sanitized.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr int kWayWidth = 320;
constexpr int kWayHeight = 180;
constexpr int kWayPatience = 10 * kStepsPerSecond;

// A way through a portal: a player at a place of one map goes along `heading`, and comes out on the
// exit tile of another map, going along another heading. Units: blocks and degrees.
struct Way {
    const char* scene;
    const char* what;
    const char* from;
    double x, y, feet;
    double heading;
    const char* to;
    double exitX, exitY, exitFeet;  // the middle of the exit tile, and the ground behind it
    double exitHeading;
};

// clang-format off
const std::vector<Way> kWays = {
    {"hill-abbey", "into the crypt", "hill", 8.5, 17.5, 4, 270, "crypt", 6.5, 11.5, 0, 270},
    {"hill-abbey", "out of the crypt", "crypt", 6.5, 10.4, 0, 90, "hill", 8.5, 16.5, 4, 90},
    {"wayhouse", "not turned", "hall", 3.5, 2.0, 0, 270, "shore", 15.5, 19.5, 4, 270},
    {"wayhouse", "and back", "shore", 15.5, 18.5, 4, 90, "hall", 3.5, 1.5, 0, 90},
    {"wayhouse", "turned by 90 degrees", "hall", 2.0, 3.5, 0, 180, "moor", 15.5, 22.5, 0, 270},
    {"wayhouse", "and back", "moor", 15.5, 21.5, 0, 90, "hall", 1.5, 3.5, 0, 0},
    {"wayhouse", "turned by 180 degrees", "hall", 9.5, 2.0, 0, 270, "night", 13.5, 3.5, 0, 90},
    {"wayhouse", "and back", "night", 13.5, 4.5, 0, 270, "hall", 9.5, 1.5, 0, 90},
    {"wayhouse", "turned by 270 degrees", "hall", 11.0, 3.5, 0, 0, "deep", 12.5, 20.5, 1, 270},
    {"wayhouse", "and back", "deep", 12.5, 19.5, 1, 90, "hall", 11.5, 3.5, 0, 180},
    {"wayhouse", "at the edge of a wide gate", "hall", 2.25, 2.0, 0, 270, "shore", 14.5, 19.5, 4, 270},
    {"wayhouse", "between two tiles of a wide gate", "hall", 3.0, 2.0, 0, 270, "shore", 15.5, 19.5, 4, 270},
    {"wayhouse", "up two levels", "hall", 6.5, 16.0, 0, 90, "court", 15.5, 1.5, 2, 90},
    {"wayhouse", "between the pale stones, one way", "moor", 10.5, 18.8, 0, 270, "night", 13.5, 21.5, 0, 270},
    {"wayhouse", "into the hut", "court", 21.5, 15.8, 2, 270, "hut", 8.5, 15.5, 0, 270},
    {"wayhouse", "out of the hut", "hut", 8.5, 15.0, 0, 90, "court", 21.5, 15.5, 2, 90},
    {"wayhouse", "into the corridor", "court", 1.8, 8.5, 2, 180, "corridor", 4.5, 1.5, 0, 90},
    {"wayhouse", "around the corridor", "corridor", 8.0, 2.0, 0, 0, "corridor", 1.5, 2.5, 0, 0},
    {"wayhouse", "around the corridor the other way", "corridor", 2.0, 1.5, 0, 180, "corridor", 8.5, 1.5, 0, 180},
    {"wayhouse", "up the stairs", "stairs", 9.3, 2.0, 3, 0, "stairs", 2.5, 2.5, 1.25, 0},
    {"wayhouse", "down the stairs", "stairs", 2.7, 1.5, 1.25, 180, "stairs", 9.5, 1.5, 3, 180},
    {"wayhouse", "along the lane", "street", 11.3, 5.0, 0, 0, "street", 2.5, 5.5, 0, 0},
    {"wayhouse", "along the lane the other way", "street", 2.7, 5.9, 0, 180, "street", 11.5, 5.5, 0, 180},
    {"wayhouse", "down the well", "court", 8.5, 13.3, 2.375, 270, "deep", 12.5, 7.5, 1, 270},
};
// clang-format on

using Pixels = std::vector<Pixel>;

Pixels drawn(Session& session) {
    Pixels pixels(static_cast<std::size_t>(kWayWidth) * kWayHeight);
    EXPECT_TRUE(session.draw(
        {.pixels = pixels.data(), .width = kWayWidth, .height = kWayHeight, .pitch = kWayWidth}));
    return pixels;
}

// The mean over all pixels and channels.
double difference(const Pixels& a, const Pixels& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Colour one = toColour(a[i]);
        const Colour other = toColour(b[i]);
        sum += std::abs(one.r - other.r) + std::abs(one.g - other.g) + std::abs(one.b - other.b);
    }
    return sum / (3.0 * static_cast<double>(a.size()));
}

bool putAt(Session& session, const Way& way) {
    const std::vector<Map>& maps = session.world().maps;
    const auto map = std::find_if(maps.begin(), maps.end(),
                                  [&](const Map& each) { return each.name == way.from; });
    if (map == maps.end()) return false;
    const Coordinate eye = toCoordinate(way.feet) + kStandingEye;
    if (!session.setEye({static_cast<int>(map - maps.begin()), toCoordinate(way.x),
                         toCoordinate(way.y), eye, way.heading, 0.0}))
        return false;
    session.setFlying(false);
    return !session.player().flying && !session.player().crouched;
}

const std::string& mapName(const Session& session) {
    return session.world().maps[static_cast<std::size_t>(session.player().map)].name;
}

TEST(WaysThrough, LeadWhereTheyShouldWithoutAJump) {
    std::map<std::string, World> worlds;
    for (std::size_t number = 0; number < kWays.size(); number += kSanitized ? 3 : 1) {
        const Way& way = kWays[number];
        SCOPED_TRACE(std::string(way.scene) + ", " + way.what + ", from " + way.from);
        if (worlds.count(way.scene) == 0) worlds.emplace(way.scene, shippedWorld(way.scene));
        Session session(worlds.at(way.scene).copy());
        ASSERT_TRUE(putAt(session, way));

        // Ahead until through
        Pixels before = drawn(session);
        Pixels now = before;
        const auto walk = [&] {
            before = std::move(now);
            session.step({.forward = 1.0});
            now = drawn(session);
        };
        double usual = 0.0;
        int steps = 0;
        const int leaps = session.player().leaps;
        const auto isThrough = [&] { return session.player().leaps != leaps; };
        double jump = 0.0;
        double speedBefore = 0.0;
        while (!isThrough() && steps++ < kWayPatience) {
            speedBefore = session.state().speed;
            walk();
            jump = difference(before, now);
            if (!isThrough()) usual = std::max(usual, jump);
        }
        ASSERT_TRUE(isThrough()) << "stopped at " << session.player().x.value() << ", "
                                 << session.player().y.value();
        EXPECT_EQ(session.player().leaps, leaps + 1);
        EXPECT_GE(session.state().speed, speedBefore - 0.01);
        EXPECT_EQ(mapName(session), way.to);
        EXPECT_DOUBLE_EQ(session.player().headingDegrees, way.exitHeading);
        EXPECT_LE(std::abs(session.player().x.value() - way.exitX), 0.5);
        EXPECT_LE(std::abs(session.player().y.value() - way.exitY), 0.5);

        // Going on looks as it did before
        for (int i = 0; i < 6; ++i) {
            walk();
            usual = std::max(usual, difference(before, now));
        }
        EXPECT_LE(jump, 1.25 * usual + 0.25) << "the picture jumps";
        for (int i = 0; i < 2 * kStepsPerSecond && !session.player().onGround; ++i)
            session.step({});
        EXPECT_NEAR(session.player().z.value(), way.exitFeet, 0.26);
        EXPECT_EQ(session.player().leaps, leaps + 1);
    }
}

}  // namespace
}  // namespace slicecast
