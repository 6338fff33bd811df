#include "session/light_presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace slicecast {
namespace {

std::vector<Map> twoMaps() {
    std::vector<Map> maps = {makeMap("first", 4, 4, 1, kNoTexture),
                             makeMap("second", 5, 5, 1, kNoTexture)};
    maps[0].light.intensity = 0.75;
    maps[0].haze = {1, 2, 3, 255};
    maps[1].fog = {.on = true, .start = 3.0, .end = 9.0};
    maps[1].sky.kind = Sky::Kind::panorama;
    maps[1].sky.panorama = Image(64, 16);
    return maps;
}

TEST(LightPresets, ReplaceLightFogHazeAndSkyOfAllMaps) {
    std::vector<Map> maps = twoMaps();
    MapLights lights(maps);
    lights.apply({.preset = LightPreset::night}, maps);
    for (const Map& map : maps) {
        EXPECT_LT(map.light.brightest, 1.0);
        EXPECT_TRUE(map.fog.on);
        EXPECT_EQ(map.sky.kind, Sky::Kind::gradient);
        EXPECT_LT(map.sky.high.r + map.sky.high.g + map.sky.high.b, 60) << "dark above";
    }
    EXPECT_EQ(maps[0].haze, maps[1].haze);
    EXPECT_EQ(maps[0].haze, maps[0].sky.low) << "no edge at the horizon";
    EXPECT_EQ(maps[0].light.intensity, maps[1].light.intensity);
    lights.apply({.preset = LightPreset::day}, maps);
    EXPECT_GT(maps[1].light.darkest, 0.5);
    EXPECT_GT(maps[1].fog.end, 1000.0) << "clear air";
}

TEST(LightPresets, GetDarkerFromDayToNight) {
    std::vector<Map> maps = twoMaps();
    MapLights lights(maps);
    double before = 2.0;
    for (const LightPreset preset : {LightPreset::day, LightPreset::dusk, LightPreset::night}) {
        lights.apply({.preset = preset}, maps);
        const Light& light = maps[0].light;
        const double at10 = std::min(
            std::max(light.intensity * light.multiplier / 10.0, light.darkest), light.brightest);
        EXPECT_LT(at10, before);
        before = at10;
    }
}

TEST(LightPresets, SetSunAndLampsWhereThereIsASun) {
    std::vector<Map> maps = twoMaps();
    for (Map& map : maps) {
        map.baked.on = true;
        map.baked.altitude = 60.0;
        map.baked.ambient = {9, 9, 9, 255};
    }
    maps[0].baked.sun = {200, 100, 50, 255};
    const BakedLight outdoors = maps[0].baked;
    const BakedLight indoors = maps[1].baked;
    MapLights lights(maps);
    double lamps = -1.0;
    for (const LightPreset preset : {LightPreset::day, LightPreset::dusk, LightPreset::night}) {
        lights.apply({.preset = preset}, maps);
        EXPECT_GT(maps[0].baked.lampStrength, lamps) << "lamps light up";
        lamps = maps[0].baked.lampStrength;
        EXPECT_NE(maps[0].baked.sun, outdoors.sun);
        EXPECT_LE(maps[0].baked.altitude, 60.0);
        EXPECT_FALSE(maps[0].light.on) << "light does not fade with distance too";
        EXPECT_EQ(maps[1].baked, indoors);
    }
    EXPECT_LT(maps[0].baked.sun.b, 100) << "a moon";
    maps[0].baked = outdoors;
    maps[0].baked.altitude = 8.0;
    MapLights sunset(maps);
    sunset.apply({.preset = LightPreset::day}, maps);
    EXPECT_EQ(maps[0].baked.altitude, 35.0) << "no day has a sun as low as at sunset";
    maps[0].baked = outdoors;
    lights.apply({.preset = LightPreset::map}, maps);
    EXPECT_EQ(maps[0].baked, outdoors);
    EXPECT_EQ(maps[1].baked, indoors);
}

TEST(LightPresets, ShowWhatStandsInTheSkyWhereThereIsOne) {
    std::vector<Map> maps = twoMaps();
    maps[1].baked.on = true;
    maps[1].baked.sun = {200, 100, 50, 255};
    maps[1].baked.azimuth = 70.0;
    maps[1].baked.altitude = 3.0;
    MapLights lights(maps);
    lights.apply({.preset = LightPreset::day}, maps);
    EXPECT_FALSE(maps[0].sky.hasLayers()) << "a sky of one colour";
    const Sky day = maps[1].sky;
    EXPECT_GT(day.sun.size, 0.0);
    EXPECT_EQ(day.sun.azimuth, 70.0) << "where the light comes from";
    EXPECT_EQ(day.sun.altitude, 30.0);
    EXPECT_EQ(day.stars.density, 0.0);
    EXPECT_NE(day.clouds.shape, nullptr);
    lights.apply({.preset = LightPreset::night}, maps);
    EXPECT_EQ(maps[1].sky.sun.size, 0.0);
    EXPECT_GT(maps[1].sky.moon.size, 0.0);
    EXPECT_GT(maps[1].sky.stars.density, 0.0);
    EXPECT_EQ(maps[1].sky.clouds.shape, day.clouds.shape) << "made once";
    lights.apply({.preset = LightPreset::fog}, maps);
    EXPECT_FALSE(maps[1].sky.hasLayers());
    lights.apply({.preset = LightPreset::map}, maps);
    EXPECT_FALSE(maps[1].sky.hasLayers());
}

TEST(LightPresets, KeepASkyInTheColourOfTheHaze) {
    std::vector<Map> maps = twoMaps();
    maps[0].sky.low = maps[0].haze;
    MapLights lights(maps);
    for (const LightPreset preset : {LightPreset::day, LightPreset::dusk, LightPreset::night}) {
        lights.apply({.preset = preset}, maps);
        EXPECT_EQ(maps[0].sky.low, maps[0].haze);
        EXPECT_EQ(maps[0].sky.high, maps[0].haze);
        EXPECT_NE(maps[1].sky.high, maps[1].haze);
    }
}

TEST(LightPresets, RestoreEachMapsOwn) {
    std::vector<Map> maps = twoMaps();
    const Pixel* panorama = maps[1].sky.panorama.pixels.data();
    MapLights lights(maps);
    for (const LightPreset preset : {LightPreset::dusk, LightPreset::fog, LightPreset::map,
                                     LightPreset::map, LightPreset::day, LightPreset::map}) {
        lights.apply({.preset = preset}, maps);
    }
    EXPECT_EQ(maps[0].light.intensity, 0.75);
    EXPECT_EQ(maps[0].haze, (Colour{1, 2, 3, 255}));
    EXPECT_EQ(maps[0].sky.kind, Sky::Kind::colour);
    EXPECT_FALSE(maps[0].fog.on);
    EXPECT_TRUE(maps[1].fog.on);
    EXPECT_EQ(maps[1].fog.end, 9.0);
    EXPECT_EQ(maps[1].sky.kind, Sky::Kind::panorama);
    EXPECT_EQ(maps[1].sky.panorama.pixels.data(), panorama) << "moved, not copied";
}

TEST(LightPresets, OptionsOverrideThePresets) {
    std::vector<Map> maps = twoMaps();
    MapLights lights(maps);
    lights.apply({.preset = LightPreset::dusk, .intensity = 0.25, .multiplier = 3.0}, maps);
    EXPECT_EQ(maps[1].light.intensity, 0.25);
    EXPECT_EQ(maps[1].light.multiplier, 3.0);
    lights.apply({.preset = LightPreset::dusk}, maps);
    EXPECT_NE(maps[1].light.intensity, 0.25);
}

TEST(LightPresets, TheFogHasTheColourOfTheOption) {
    std::vector<Map> maps = twoMaps();
    MapLights lights(maps);
    const Colour red = {200, 10, 20, 255};
    lights.apply({.preset = LightPreset::fog, .haze = red}, maps);
    EXPECT_TRUE(maps[0].fog.on);
    EXPECT_EQ(maps[0].haze, red);
    EXPECT_EQ(maps[0].sky.low, red) << "the world fades into one colour";
    EXPECT_EQ(maps[0].sky.high, red);
    lights.apply({.haze = red}, maps);
    EXPECT_EQ(maps[0].haze, red) << "without a preset too";
    EXPECT_NE(maps[0].sky.low, red);
    lights.apply({}, maps);
    EXPECT_EQ(maps[0].haze, (Colour{1, 2, 3, 255}));
}

}  // namespace
}  // namespace slicecast
