// The sky of a map: its colours or panorama, and stars, sun, moon and clouds over them.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr NumberRange kSlope = {0.0, kMaxSkySlope, true, "a number above 0 and at most 1000"};
constexpr NumberRange kDiscSize = {0.0, kMaxDiscSize, true,
                                   "a number above 0 and at most 30, in degrees"};
constexpr NumberRange kGlowSize = {0.0, kMaxGlow, false, "a number from 0 to 90, in degrees"};
constexpr NumberRange kDiscAltitude = {0.0, kMaxDiscAltitude, false,
                                       "a number from 0 to 80, in degrees"};
constexpr NumberRange kCloudSpeed = {-kMaxCloudSpeed, kMaxCloudSpeed, false,
                                     "a number from -60 to 60, in degrees per second"};
constexpr NumberRange kCloudSize = {kMinCloudSize, kMaxCloudSize, false, "a number from 0.1 to 10"};
constexpr NumberRange kSkySeed = {0.0, 1.0e9, false, "a whole number from 0 to 1000000000"};
static_assert(kMaxSkySlope == 1000.0 && kMaxDiscSize == 30.0 && kMaxGlow == 90.0 &&
                  kMaxDiscAltitude == 80.0 && kMaxCloudSpeed == 60.0 && kMinCloudSize == 0.1 &&
                  kMaxCloudSize == 10.0,
              "as the words say");

// "sun" or "moon"; `normal` has what is not given.
void readDisc(Checker& checker, JsonValue value, const SkyDisc& normal, SkyDisc& disc) {
    const auto fields =
        checker.fields(value, {"azimuth", "altitude", "size", "glow", "colour"},
                       "an object such as { \"azimuth\": 225, \"altitude\": 20 }"_onFault);
    if (!fields) return;
    disc.azimuth = fields->number("azimuth", kHeadingRange, normal.azimuth);
    disc.altitude = fields->number("altitude", kDiscAltitude, normal.altitude);
    disc.size = fields->number("size", kDiscSize, normal.size);
    disc.glow = fields->number("glow", kGlowSize, normal.glow);
    disc.colour = fields->colour("colour", normal.colour);
}

std::uint32_t readSeed(const Fields& fields) {
    return static_cast<std::uint32_t>(fields.wholeNumber("seed", kSkySeed, 0));
}

void readStars(Checker& checker, JsonValue value, SkyStars& stars) {
    const auto fields = checker.fields(value, {"density", "seed", "brightness", "colour"},
                                       "an object such as { \"density\": 0.3 }"_onFault);
    if (!fields) return;
    stars.density = fields->number("density", kUnitRange, kNormalStars);
    stars.seed = readSeed(*fields);
    stars.brightness = fields->number("brightness", kUnitRange, stars.brightness);
    stars.colour = fields->colour("colour", stars.colour);
}

// Maps whose clouds have one seed and one size share them.
std::shared_ptr<const CloudCover> shapeOf(Reading& reading, JsonValue value, std::uint32_t seed,
                                          double size) {
    for (const ReadClouds& known : reading.clouds) {
        if (known.seed == seed && known.size == size) return known.shape;
    }
    if (reading.clouds.size() == kMaxCloudShapes) {
        reading.checker.add(value, {"clouds of more than "_later, kMaxCloudShapes, " shapes"},
                            {"at most ", kMaxCloudShapes,
                             " in a scene; equal \"seed\" and \"size\" are one"_later});
        return nullptr;
    }
    reading.clouds.push_back({seed, size, makeCloudCover(seed, size)});
    return reading.clouds.back().shape;
}

void readClouds(Reading& reading, JsonValue value, SkyClouds& clouds) {
    const auto fields = reading.checker.fields(
        value, {"cover", "size", "seed", "speed", "opacity", "colour", "shade"},
        "an object such as { \"cover\": 0.4, \"speed\": 0.5 }"_onFault);
    if (!fields) return;
    clouds.cover = fields->number("cover", kUnitRange, clouds.cover);
    clouds.speed = fields->number("speed", kCloudSpeed, clouds.speed);
    clouds.opacity = fields->number("opacity", kUnitRange, clouds.opacity);
    clouds.colour = fields->colour("colour", clouds.colour);
    clouds.shade = fields->colour("shade", clouds.shade);
    const std::uint32_t seed = readSeed(*fields);
    clouds.shape = shapeOf(reading, value, seed, fields->number("size", kCloudSize, 1.0));
}

// Without places of its own, the sun stands where the map's light comes from.
void readLayers(Reading& reading, const Fields& fields, Map& map) {
    Checker& checker = reading.checker;
    Sky& sky = map.sky;
    SkyDisc sun = {.size = 4.0, .glow = 30.0};
    if ((map.baked.sun.r | map.baked.sun.g | map.baked.sun.b) != 0) {
        sun.azimuth = map.baked.azimuth;
        sun.altitude = std::min(map.baked.altitude, kMaxDiscAltitude);
    }
    const SkyDisc moon = {.size = 3.5, .azimuth = 45.0, .glow = 10.0, .colour = sky.moon.colour};
    if (const auto value = fields.find("stars")) readStars(checker, *value, sky.stars);
    if (const auto value = fields.find("sun")) readDisc(checker, *value, sun, sky.sun);
    if (const auto value = fields.find("moon")) readDisc(checker, *value, moon, sky.moon);
    if (const auto value = fields.find("clouds")) readClouds(reading, *value, sky.clouds);
}

}  // namespace

void readSky(Reading& reading, JsonValue value, std::size_t mapIndex, Map& map) {
    Checker& checker = reading.checker;
    Sky& sky = map.sky;
    if (value.isText()) {
        sky.kind = Sky::Kind::colour;
        sky.low = checker.colour(value).value_or(Colour{});
        return;
    }
    // The keys show which kind is meant, even misspelt ones.
    bool isPanorama = false;
    if (value.isObject()) {
        for (const JsonValue member : value)
            isPanorama = isPanorama || !nearestName(member.key(), {"panorama"}).empty();
    }
    const auto fields =
        isPanorama
            ? checker.fields(value, {"panorama", "slope", "stars", "sun", "moon", "clouds"},
                             ""_onFault)
            : checker.fields(value, {"low", "high", "slope", "stars", "sun", "moon", "clouds"},
                             "a colour, an object with \"low\" and \"high\", "
                             "or one with \"panorama\""_onFault);
    if (!fields) return;
    sky.slope = fields->number("slope", kSlope, 1.0);
    readLayers(reading, *fields, map);
    if (isPanorama) {
        sky.kind = Sky::Kind::panorama;
        const auto panorama = fields->find("panorama");
        if (!panorama) return;
        if (auto file = readFileName(checker, *panorama)) {
            reading.description.panoramas.push_back(
                {mapIndex, referTo(checker, *panorama, std::move(*file))});
        }
        return;
    }
    sky.kind = Sky::Kind::gradient;
    if (const auto low = fields->require("low", "the colour at the horizon"))
        sky.low = checker.colour(*low).value_or(Colour{});
    if (const auto high = fields->require("high", "the colour above"))
        sky.high = checker.colour(*high).value_or(Colour{});
}

}  // namespace slicecast
