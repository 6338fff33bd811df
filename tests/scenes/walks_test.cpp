// The ways through the shipped scenes, walked: every stair, bridge, tunnel and door on them works.
#include "scenes/shipped.h"

#include "base/angle.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// Units: blocks.
struct Place {
    double x, y, z;
};
// Somewhere to go to in a straight line, and the height of the feet there.
struct Leg {
    double x, y, feet;
};
constexpr double kAfloat = -1.0;  // in place of a height: one swims there
struct Walk {
    const char* scene;
    const char* what;
    std::optional<Place> from;  // the feet; without a place, the scene's start
    std::vector<Leg> legs;
};

// clang-format off
const std::vector<Walk> kWalks = {
    {"harbour-town", "over the bridge and into the inn", {},
     {{18.3, 36.2, 4}, {17.5, 34.5, 4}, {12.5, 34, 4}, {12.5, 24, 4}, {14, 21.7, 4}, {16.5, 21.7, 4}, {21.5, 21.7, 5.5}, {26.5, 21.7, 4},
      {25.5, 19, 4}, {25.5, 14.5, 4}, {28.5, 14.5, 4}, {30.5, 16.7, 4}, {31.5, 17.5, 4}, {32.5, 17.4, 4.25}, {32.5, 13.6, 5}, {29.5, 13.6, 5},
      {26.5, 14.5, 5.25}}},
    {"harbour-town", "up the town wall and the tower", Place{25.5, 18, 4},
     {{25.5, 10, 4}, {34.5, 8, 4}, {39.5, 7, 4}, {39.5, 5.5, 4}, {30.5, 5.5, 6}, {30.5, 4.5, 6}, {21.5, 4.5, 6}, {21.5, 6.5, 6}, {22.5, 6.5, 6.5},
      {22.5, 8.5, 7.5}, {20.5, 8.5, 8.5}, {20.5, 6.5, 9}, {22.5, 6.5, 9}, {22.5, 7.4, 9}}},
    {"harbour-town", "down to the water and under the tower", Place{17.5, 12, 4},
     {{18.5, 13.5, 4}, {18.5, 16.5, 3.25}, {20.5, 16.5, kAfloat}, {21.5, 12, kAfloat}, {21.5, 7.5, kAfloat}, {24.5, 7.5, 3}, {27, 8, 3}}},
    {"harbour-town", "from the sea up the jetty", Place{13, 44, 3},
     {{11.5, 43.5, 3.375}, {10.5, 43.5, 3.75}, {8.5, 43.2, 4}, {8.5, 36.5, 4}, {12, 34.5, 4}}},
    {"castle", "through the gate, over the bridge, through the keep, up the great tower", {},
     {{43, 19.4, 4}, {44.5, 20, 4.5}, {44.5, 24, 4}, {44.5, 20, 4.5}, {43, 18.9, 4}, {30, 19.1, 5}, {22, 19.1, 6}, {22.7, 26, 6}, {22.7, 28.5, 6.25}, {15.5, 28.5, 8}, {14.5, 29.5, 8},
      {12.5, 29.4, 8}, {12.5, 22.5, 8}, {16.5, 22.5, 8}, {16.5, 17.5, 8}, {12, 17.5, 6.4}, {11.6, 18.4, 6.25}, {15, 20, 6}, {18.5, 20, 6},
      {18.5, 27, 6}, {12.5, 27.5, 6}, {10.5, 27.5, 6}, {9.5, 27.5, 6.5}, {8.5, 27.5, 7}, {8.5, 29.5, 8}, {10.5, 29.5, 8}, {10.5, 27.5, 9},
      {8.5, 27.5, 10}, {8.5, 29.5, 11}, {10.5, 29.5, 12}, {10.5, 27.5, 13}, {8.5, 27.5, 14}, {8.5, 29.5, 14}}},
    {"castle", "across the lake, and ashore on either side", Place{43.5, 25.5, 4},
     {{41.5, 25.5, 3.25}, {38, 26.5, kAfloat}, {31.5, 29.5, kAfloat}, {29.4, 29.5, 3.5}, {31.5, 25.5, kAfloat}, {38, 25.5, kAfloat}, {41.5, 25.5, 3.25}, {43, 25.5, 4}}},
    {"castle", "by the cave into the court", Place{13.5, 5, 3},
     {{13.5, 6.5, 3}, {13.5, 9, 3.5}, {13.5, 15.3, 6}, {19, 15.3, 6}}},
    {"castle", "around the wall walk", Place{14.5, 29.5, 8},
     {{22, 29.5, 8}, {24.5, 29.5, 8}, {24.5, 19.5, 8}, {24.5, 10.5, 8}, {13, 10.5, 8}, {9.5, 11.5, 8}, {8.5, 13.5, 8}, {8.5, 26, 8}, {8.5, 26.8, 8},
      {8.5, 27.5, 7}}},
    {"hill-abbey", "over the bridge, through the gate, up the ramps, through the abbey", {},
     {{24, 43.5, 2}, {14, 43.5, 2}, {14, 36.5, 3}, {14, 29.7, 2}, {14, 24.4, 4}, {20, 24.5, 4}, {20, 15.4, 8}, {20, 12.5, 8}, {19.5, 8.5, 8},
      {10.6, 8.5, 8}, {7.5, 8.5, 8}, {4, 7.5, 8}}},
    {"hill-abbey", "through the pool", {}, {{27, 39.5, 1}, {27, 31.5, 1}, {26.5, 30.4, 1.5}, {26.5, 29.6, 2}}},
    {"library", "up the tower of books by the galleries", {},
     {{13.9, 27, 0}, {13.7, 19.5, 0}, {13.5, 18.5, 0.25}, {11.5, 18.5, 0.75}, {11.5, 13.5, 2}, {6.5, 13.5, 2}, {6.5, 3, 2}, {8.5, 2.5, 2},
      {8.4, 1.5, 2}, {16.5, 1.5, 4}, {24.5, 1.5, 4}, {24.5, 16.5, 4}, {16.5, 16.5, 4}, {16.5, 18.5, 4.5}, {14.5, 18.5, 5}, {14.5, 16, 5}}},
    {"library", "up the stairs in the aisle", {},
     {{13.9, 27, 0}, {17, 22, 0}, {20.5, 28.5, 0}, {21.5, 28.4, 0}, {21.5, 19.5, 2}, {22.5, 18.6, 2}, {22.5, 3, 2}, {12, 2.5, 2}}},
    {"library", "over the high bridge", Place{24.5, 4, 4},
     {{24.5, 24.9, 4}, {3.5, 24.9, 4}, {2.5, 3, 4}, {2.5, 28, 4}}},
    {"temple", "up to the shrine, down into the gorge, out of the crypt", {},
     {{20, 30, 4}, {20, 22, 4}, {20, 10.5, 8.5}, {20, 8.2, 8.5}, {20, 10.5, 8.5}, {20, 20.5, 4}, {28, 22.5, 4}, {30.5, 23, 4}, {30.5, 24.4, 4},
      {15.5, 24.5, 2}, {15.5, 16.5, 2}, {17.5, 9, 2}, {19.5, 5.5, 2}, {12.5, 5.5, 5.5}, {12, 14, 5.5}, {11, 18.5, 4}}},
    {"temple", "down the river", Place{32.5, 24.5, 2},
     {{31.5, 26, kAfloat}, {14, 25.9, kAfloat}, {15.5, 24.5, 2}}},
    {"night-works", "through the hall, over the roofs, onto the crane", {},
     {{20.7, 21, 4}, {20.5, 17.5, 4}, {15.9, 15, 4}, {15.9, 11, 4}, {12.5, 8.5, 4}, {9.5, 8.5, 4}, {9.5, 7.5, 4.25}, {16.4, 7.5, 6}, {16.5, 6.5, 6},
      {22.5, 6.5, 6}, {22.5, 9.5, 6}, {29.5, 9.5, 6}, {33, 9.5, 6}, {33, 11, 6}, {31.5, 9.5, 6}, {30.5, 9.5, 6}, {30.5, 17.8, 4.25}, {20, 15, 4},
      {15.5, 19.5, 4}, {14.5, 19.4, 4}, {14.5, 15.5, 6}, {12.5, 15.5, 6.5}, {12.5, 18.5, 8}, {14.5, 18.5, 8.5}, {14.5, 15.5, 9}, {8, 15.5, 9},
      {8, 21, 9}, {8, 27, 9}}},
    {"night-works", "off the pier, past the ship, and up the steps", Place{21.5, 30.5, 4},
     {{25.5, 31.5, kAfloat}, {29.5, 21.5, kAfloat}, {26.5, 21.5, 3.4}, {24.5, 21.5, 3.8}, {24.5, 20.4, 4}}},
    {"night-works", "onto the ship", {},
     {{20.7, 27.5, 4}, {25.5, 27.5, 4.75}, {27.5, 25.5, 4.75}, {30.5, 26.5, 4.75}, {32, 26.5, 4.75}}},
    {"garden", "through the maze, the tree and the pavilion", {},
     {{21, 35.5, 1}, {21, 31.4, 0}, {17, 31, 0}, {16.6, 25.5, 0}, {21.5, 25.5, 0}, {20.5, 25.5, 0}, {20.5, 23.5, 0}, {13.5, 23.5, 0}, {13.5, 21.5, 0},
      {11.5, 21.5, 0}, {11.5, 23.5, 0}, {5.5, 23.5, 0}, {5.5, 15.5, 0}, {8.5, 15.5, 0}, {8.5, 17.5, 0}, {9.5, 17.5, 0}, {9.5, 19.5, 0},
      {12.5, 19.5, 0}, {11.5, 18.4, 0}, {11.5, 17.5, 0.25}, {10.5, 17.5, 0.5}, {10.5, 13.5, 1.5}, {14.5, 13.5, 2.5}, {14.5, 17.5, 3.5},
      {12.5, 17.5, 4}, {11.3, 17.4, 4}, {10.4, 17.4, 4}, {10.4, 14, 4}, {10.5, 13.5, 4}, {18, 13.5, 4}, {21, 15, 4}}},
    {"glassworks", "through the glasshouse and the hall, by the cave behind the waterfall", {},
     {{15, 29.5, 1}, {15, 25, 1}, {15, 21.5, 1.5}, {15, 17, 1.75}, {15, 8, 1.75}, {10.5, 6.5, 1.75}, {10.5, 2.5, 1.75}, {7.5, 2.5, 1.75}, {5, 3, 1.5},
      {5, 5.5, 1.5}, {6.5, 5.5, 1.25}, {6.5, 8.5, 1}, {6.5, 20, 1}, {4.5, 22, kAfloat}, {6.5, 23, 1}, {8.5, 23.5, 1}, {8.5, 20.5, 1.75}, {7.5, 20.5, 1.75},
      {7.5, 17, 1.75}}},
    {"glassworks", "over the grates to the furnace, up the hill, over the rope bridge", Place{22.5, 15, 1.75},
     {{27.5, 15, 1.75}, {29, 13, 1.75}, {32.5, 13, 1.5}, {29, 13, 1.75}, {27.5, 15, 1.75}, {24.5, 15.2, 1.75}, {24.5, 11, 1.75}, {24, 9.5, 2.25},
      {24, 3.5, 5}, {7, 3.5, 5}, {4.5, 3.5, 5}, {2.5, 3.5, 5}, {2.5, 14, 5}, {12, 14, 5}, {27, 14, 5}, {30.5, 12.5, 5}, {31, 9, 5}, {31, 3.5, 5}}},
    {"glassworks", "to the shop and the lava in the garden", {},
     {{20, 30, 1}, {27, 30, 1}, {27, 24, 1}, {24.5, 22.4, 0.85}, {24, 23.5, 1}, {15, 23.5, 1}}},
    {"glassworks", "into the shop, whose door opens", Place{34, 22.5, 1}, {{31, 22.5, 1}, {29.6, 22.5, 1}, {31, 22.4, 1}, {34, 22.4, 1}}},
    {"water-palace", "over the bridge, through the hall, up to the roof", {},
     {{20.5, 41.5, 3.25}, {29.5, 41.5, 3.25}, {30.5, 41.3, 3.25}, {30.5, 24, 3.5}, {30.5, 22.5, 3.5}, {24.5, 22.5, 3.5}, {20.5, 19.2, 3.5},
      {20.5, 16.4, 4}, {17.5, 12.5, 4}, {17.5, 8.6, 4}, {17.5, 12.5, 4}, {20.5, 16.4, 4}, {20.5, 19.4, 3.5}, {28.6, 19.4, 3.5}, {29.5, 18.4, 3.5},
      {29.5, 16.5, 4}, {29.5, 9.4, 7.25}, {27.5, 9.5, 7.25}, {17, 9.4, 7.25}, {17, 12.5, 7.25}, {18.5, 12.5, 7.5}}},
    {"water-palace", "over the pontoons, to the pavilion in the lake", {},
     {{20.5, 41.5, 3.25}, {10.8, 41.5, 3.25}, {10.5, 22.4, 3.5}, {9.6, 20, 3.5}, {9.5, 13.5, 3.5}, {7.4, 13.5, 3.375}, {4.4, 12, 3.375}}},
    {"water-palace", "through the lake to an islet, a float and the landing", Place{20.5, 39.6, 3.25},
     {{20.5, 35, kAfloat}, {8.7, 27, kAfloat}, {4.5, 25.5, 3.375}, {8.5, 33, kAfloat}, {15, 38, kAfloat}, {18.5, 40.5, 3.25}}},
    {"water-palace", "through the atrium's pool", Place{17.5, 12.5, 4},
     {{20.5, 12.5, kAfloat}, {22.6, 14.5, 4}}},
    {"wayhouse", "from table to table", {},
     {{6.5, 11.5, 0}, {6.5, 8, 0}, {3, 7, 0}, {2.4, 6.5, 0}, {6.5, 7, 0}, {10, 6.5, 0}, {6.5, 8, 0}, {6.5, 13, 0}, {9.5, 12.3, 0}, {9.5, 11.5, 0.3}}},
    {"wayhouse-hunt", "from gate to gate in the hall", {},
     {{8.5, 3, 0}, {3.5, 5.5, 0}, {3.5, 10, 0}, {8.5, 9, 0}, {13.5, 10, 0}, {13.5, 5.5, 0}}},
    {"first-walk", "up the stairs into the tower", {},
     {{20, 16.5, 0}, {12, 16.5, 0}, {11, 7, 0}, {1.6, 6.5, 0}, {1.5, 2.5, 0}, {2.5, 2.5, 0.5}, {5.5, 2.5, 2}, {13.5, 2.5, 2}, {14.5, 3.5, 2},
      {13.5, 4.5, 2}}},
    {"first-steps", "over the bridge", {},
     {{6.5, 4.5, 0}, {1.5, 4.5, 0}, {1.5, 1.5, 0.33}, {7.5, 1.5, 1}, {8.5, 2.5, 0}, {8.5, 6.5, 0}}},
};
// clang-format on

constexpr double kNear = 0.12;                      // of a leg's end
constexpr double kSlowWithin = 0.5;                 // of it
constexpr int kWalkPatience = 2 * kStepsPerSecond;  // steps without getting nearer

double distanceTo(const Session& session, const Leg& leg) {
    const double x = leg.x - session.player().x.value();
    const double y = leg.y - session.player().y.value();
    return std::sqrt(x * x + y * y);
}

void faceTowards(Session& session, const Leg& leg) {
    const double degrees =
        std::atan2(leg.y - session.player().y.value(), leg.x - session.player().x.value()) *
        (180.0 / 3.14159265358979);
    session.setHeading(wrapDegrees(degrees));
}

// False if something is in the way.
bool walkTo(Session& session, const Leg& leg) {
    double nearest = distanceTo(session, leg);
    int waited = 0;
    while (distanceTo(session, leg) > kNear) {
        faceTowards(session, leg);
        session.step({.forward = distanceTo(session, leg) < kSlowWithin ? 0.5 : 1.0});
        waited = distanceTo(session, leg) < nearest - 0.01 ? 0 : waited + 1;
        if (waited == 0) nearest = distanceTo(session, leg);
        if (waited > kWalkPatience) return false;
    }
    const auto rests = [&] { return session.player().onGround || session.player().swimming; };
    for (int i = 0; i < kStepsPerSecond && (i < kStepsPerSecond / 6 || !rests()); ++i)
        session.step({});
    return true;
}

// Puts the player down; false if there is no room.
bool putAt(Session& session, const Place& place) {
    const Coordinate eye = toCoordinate(place.z) + kCrouchedEye;
    if (!session.setEye({.map = session.player().map,
                         .x = toCoordinate(place.x),
                         .y = toCoordinate(place.y),
                         .z = eye}))
        return false;
    session.setFlying(false);
    return !session.player().flying && !session.player().crouched;
}

TEST(Walks, EveryWayCanBeWalked) {
    std::map<std::string, World> worlds;
    for (const Walk& walk : kWalks) {
        SCOPED_TRACE(std::string(walk.scene) + ", " + walk.what);
        if (worlds.count(walk.scene) == 0) worlds.emplace(walk.scene, shippedWorld(walk.scene));
        Session session(worlds.at(walk.scene).copy());
        if (walk.from) {
            ASSERT_TRUE(putAt(session, *walk.from));
        }
        for (const Leg& leg : walk.legs) {
            const bool arrived = walkTo(session, leg);
            const Player& player = session.player();
            ASSERT_TRUE(arrived) << "stuck at " << player.x.value() << ", " << player.y.value()
                                 << ", feet at " << player.z.value() << ", on the way to " << leg.x
                                 << ", " << leg.y;
            ASSERT_EQ(player.swimming, leg.feet == kAfloat)
                << "at " << leg.x << ", " << leg.y << ", feet at " << player.z.value();
            if (leg.feet != kAfloat) {
                ASSERT_NEAR(player.z.value(), leg.feet, 0.01) << "at " << leg.x << ", " << leg.y;
            }
        }
    }
}

TEST(Walks, EverySceneHasOne) {
    for (const std::string& scene : shippedScenes()) {
        EXPECT_TRUE(std::any_of(kWalks.begin(), kWalks.end(), [&](const Walk& walk) {
            return walk.scene == scene;
        })) << scene;
    }
}

}  // namespace
}  // namespace slicecast
