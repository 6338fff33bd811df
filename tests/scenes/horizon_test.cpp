// At the horizon of the shipped scenes, floor, haze and sky meet without an edge. From the highest
// place that can be flown to, the floor goes on almost as far as one can look.
#include "scenes/shipped.h"

#include "render/renderer.h"
#include "sanitized.h"
#include "session/light_presets.h"
#include "world/collision.h"
#include "world/player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace slicecast {
namespace {

constexpr int kHorizonWidth = 683;
constexpr int kHorizonHeight = 384;
constexpr int kHorizon = kHorizonHeight / 2;

// Fog that ends nearer than this is a mist that a scene wants: what lies behind it is not to be
// seen.
constexpr double kMistEnd = 100.0;

// Bounds, in levels of a colour channel.
constexpr int kLargestEdge = 4;      // between the floor's last row and the sky's first, any column
constexpr double kLargestStep = 26;  // between the means of two rows of the floor, near the horizon
constexpr int kMostPlainRows = kHorizonHeight * 9 / 100;  // of the floor, all haze

struct Horizon {
    int edge = 0;
    double step = 0.0;
    int plainRows = 0;
};

int difference(Pixel a, Pixel b) {
    const Colour p = toColour(a);
    const Colour q = toColour(b);
    return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

double stepBetween(const Pixel* above, const Pixel* below) {
    double sums[3] = {};
    for (int x = 0; x < kHorizonWidth; ++x) {
        const Colour p = toColour(above[x]);
        const Colour q = toColour(below[x]);
        sums[0] += p.r - q.r;
        sums[1] += p.g - q.g;
        sums[2] += p.b - q.b;
    }
    double largest = 0.0;
    for (const double sum : sums) largest = std::max(largest, std::fabs(sum) / kHorizonWidth);
    return largest;
}

// Looks level, so the floor begins in the middle row of the picture.
Horizon look(const World& world, const Eye& eye) {
    std::vector<Pixel> pixels(static_cast<std::size_t>(kHorizonWidth) * kHorizonHeight);
    Renderer renderer;
    EXPECT_TRUE(renderer.draw(world, eye, {},
                              {pixels.data(), kHorizonWidth, kHorizonHeight, kHorizonWidth}));
    const auto row = [&](int y) {
        return pixels.data() + static_cast<std::ptrdiff_t>(y) * kHorizonWidth;
    };
    const Pixel haze = toPixel(world.maps[static_cast<std::size_t>(eye.map)].haze);
    Horizon seen;
    for (int x = 0; x < kHorizonWidth; ++x)
        seen.edge = std::max(seen.edge, difference(row(kHorizon - 1)[x], row(kHorizon)[x]));
    for (int y = kHorizon; y < kHorizon + kHorizonHeight / 4; ++y)
        seen.step = std::max(seen.step, stepBetween(row(y), row(y + 1)));
    const auto isPlain = [&](int y) {
        return std::all_of(row(y), row(y) + kHorizonWidth,
                           [&](Pixel pixel) { return difference(pixel, haze) <= 3; });
    };
    for (int y = kHorizon; y < kHorizonHeight && isPlain(y); ++y) ++seen.plainRows;
    return seen;
}

bool isOpenToTheSky(const Map& map) {
    return map.ceiling.tiles.empty() ||
           std::find(map.ceiling.tiles.begin(), map.ceiling.tiles.end(), kNoTexture) !=
               map.ceiling.tiles.end();
}

Eye highestEye(const World& world, int map) {
    const Map& m = world.maps[static_cast<std::size_t>(map)];
    Eye eye;
    eye.map = map;
    eye.x = {m.width * 32768};
    eye.y = {m.depth * 32768};
    eye.z = kMaxBodyHeight - kCrouchedHeight + kCrouchedEye;  // as one flies
    return eye;
}

const std::vector<double> kHeadingsSeen =
    kSanitized ? std::vector{10.0} : std::vector{10.0, 100.0, 190.0, 280.0};

// Calls seen(where, map, what) for views from the highest place of each map that has an open sky.
template <typename Seen>
int fromTheHighestPlaces(LightPreset preset, Seen seen) {
    int maps = 0;
    for (const std::string& name : shippedScenes()) {
        World world = shippedWorld(name);
        MapLights(world.maps).apply({.preset = preset}, world.maps);
        for (int i = 0; i < static_cast<int>(world.maps.size()); ++i) {
            const Map& map = world.maps[static_cast<std::size_t>(i)];
            if (!isOpenToTheSky(map)) continue;
            ++maps;
            Eye eye = highestEye(world, i);
            for (const double heading : kHeadingsSeen) {
                eye.headingDegrees = heading;
                seen(name + ", " + map.name + ", heading " + std::to_string(heading), map,
                     look(world, eye));
            }
        }
    }
    return maps;
}

void expectNoEdge(LightPreset preset) {
    const int maps = fromTheHighestPlaces(
        preset, [](const std::string& where, const Map& map, const Horizon& seen) {
            EXPECT_LE(seen.edge, kLargestEdge) << where;
            EXPECT_LE(seen.step, kLargestStep) << where;
            const bool misty = map.fog.on && map.fog.end <= kMistEnd;
            if (!misty) {
                EXPECT_LE(seen.plainRows, kMostPlainRows) << where;
            }
        });
    EXPECT_GE(maps, 14);
}

TEST(Horizon, FloorAndSkyMeetWithoutAnEdge) {
    expectNoEdge(LightPreset::map);
}

TEST(Horizon, FloorAndSkyMeetWithoutAnEdgeByDay) {
    expectNoEdge(LightPreset::day);
}

TEST(Horizon, FloorAndSkyMeetWithoutAnEdgeAtDusk) {
    expectNoEdge(LightPreset::dusk);
}

TEST(Horizon, FloorAndSkyMeetWithoutAnEdgeAtNight) {
    expectNoEdge(LightPreset::night);
}

TEST(Horizon, FloorAndSkyMeetWithoutAnEdgeInTheFog) {
    expectNoEdge(LightPreset::fog);
}

// What the tests above take for the highest place is where one comes to when one flies up.
TEST(Horizon, TheHighestPlaceIsWhereFlyingEnds) {
    const World world = shippedWorld("castle");
    Player player = playerAtStart(world);
    setFlying(world, player, true);
    for (int step = 0; step < 120 * 90; ++step) {
        PlayerInput up;
        up.fly = 1.0;
        stepPlayer(world, player, up);
    }
    EXPECT_EQ(eyeHeight(player), highestEye(world, 0).z);
}

}  // namespace
}  // namespace slicecast
