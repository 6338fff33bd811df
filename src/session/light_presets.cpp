#include "session/light_presets.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace slicecast {
namespace {

struct Preset {
    Light light;
    Fog fog;
    Colour low;  // of the haze and of the sky at the horizon, so that the two meet without an edge
    Colour high;
    double slope;
    // In maps with baked light and a sun; maps without one lie indoors and keep theirs.
    Colour sun;
    double altitude;  // of the sun, if it stands higher; degrees
    Colour ambient;
    double lamps;         // see BakedLight::lampStrength
    double lowest = 0.0;  // altitude of the sun, if it stands lower
    // In maps whose own sky is not just one colour. Sun and moon stand where the map's baked light
    // comes from, but no higher than this, so that they are seen.
    SkyDisc disc;
    bool isMoon = false;
    SkyStars stars = {};
    // Of its clouds
    double cover = 0.0;
    double opacity = 1.0;
    Colour cloud = {255, 255, 255, 255};
    Colour shade = {196, 206, 219, 255};
};

constexpr Preset kDay = {
    .light = {.on = true, .intensity = 1.5, .multiplier = 16.0, .darkest = 0.72, .brightest = 1.0},
    .fog = {.on = true, .start = 60.0, .end = 1500.0},
    .low = {212, 224, 217, 255},
    .high = {91, 143, 199, 255},
    .slope = 0.9,
    .sun = {255, 244, 224, 255},
    .altitude = 90.0,
    .ambient = {132, 146, 168, 255},
    .lamps = 0.3,  // for rooms
    .lowest = 35.0,
    .disc = {.size = 3.5, .altitude = 30.0, .glow = 30.0, .colour = {255, 250, 232, 255}},
    .cover = 0.42};
constexpr Preset kDusk = {
    .light = {.on = true, .intensity = 1.0, .multiplier = 5.0, .darkest = 0.32, .brightest = 0.85},
    .fog = {.on = true, .start = 12.0, .end = 1500.0},
    .low = {232, 150, 98, 255},
    .high = {58, 56, 104, 255},
    .slope = 0.7,
    .sun = {236, 132, 70, 255},
    .altitude = 14.0,
    .ambient = {110, 96, 132, 255},
    .lamps = 0.6,
    .disc = {.size = 4.5, .altitude = 7.0, .glow = 42.0, .colour = {255, 217, 160, 255}},
    .stars = {.density = 0.1, .seed = 1, .brightness = 0.5},
    .cover = 0.45,
    .cloud = {240, 168, 120, 255},
    .shade = {112, 78, 112, 255}};
constexpr Preset kNight = {
    .light = {.on = true, .intensity = 0.8, .multiplier = 5.0, .darkest = 0.2, .brightest = 0.8},
    .fog = {.on = true, .start = 8.0, .end = 1500.0},
    .low = {26, 33, 58, 255},
    .high = {6, 8, 20, 255},
    .slope = 0.8,
    .sun = {44, 56, 92, 255},
    .altitude = 50.0,
    .ambient = {40, 48, 76, 255},
    .lamps = 1.0,
    .disc = {.size = 3.5, .altitude = 13.0, .glow = 10.0, .colour = {226, 232, 240, 255}},
    .isMoon = true,
    .stars = {.density = kNormalStars, .seed = 1},
    .cover = 0.3,
    .opacity = 0.6,
    .cloud = {51, 65, 92, 255},
    .shade = {24, 31, 54, 255}};
constexpr Preset kFog = {
    .light = {.on = true, .intensity = 1.2, .multiplier = 10.0, .darkest = 0.6, .brightest = 0.95},
    .fog = {.on = true, .start = 0.5, .end = 16.0},
    .low = {198, 204, 206, 255},
    .high = {198, 204, 206, 255},
    .slope = 1.0,
    .sun = {60, 62, 64, 255},
    .altitude = 90.0,
    .ambient = {176, 182, 186, 255},
    .lamps = 0.6,
    .disc = {}};

bool hasSun(const BakedLight& baked) {
    return (baked.sun.r | baked.sun.g | baked.sun.b) != 0;
}

void shine(BakedLight& baked, const Preset& preset) {
    baked.sun = preset.sun;
    baked.altitude = std::clamp(baked.altitude, preset.lowest, preset.altitude);
    baked.ambient = preset.ambient;
    baked.lampStrength = preset.lamps;
}

// `own` is the map's sky without the preset.
Sky skyOf(const Preset& preset, const Sky& own, const BakedLight& baked,
          const std::shared_ptr<const CloudCover>& clouds) {
    Sky sky = {
        .kind = Sky::Kind::gradient, .low = preset.low, .high = preset.high, .slope = preset.slope};
    if (own.kind == Sky::Kind::colour) return sky;
    SkyDisc& disc = preset.isMoon ? sky.moon : sky.sun;
    disc = preset.disc;
    if (hasSun(baked)) {
        disc.azimuth = baked.azimuth;
        disc.altitude = std::min(baked.altitude, disc.altitude);
    } else if (own.sun.size > 0.0) {
        disc.azimuth = own.sun.azimuth;
    }
    sky.stars = preset.stars;
    if (preset.cover > 0.0) {
        sky.clouds = {.shape = clouds,
                      .cover = preset.cover,
                      .opacity = preset.opacity,
                      .colour = preset.cloud,
                      .shade = preset.shade};
    }
    return sky;
}

const Preset* findPreset(LightPreset preset) {
    switch (preset) {
        case LightPreset::map:
            break;
        case LightPreset::day:
            return &kDay;
        case LightPreset::dusk:
            return &kDusk;
        case LightPreset::night:
            return &kNight;
        case LightPreset::fog:
            return &kFog;
    }
    return nullptr;
}

}  // namespace

MapLights::MapLights(const std::vector<Map>& maps) {
    for (const Map& map : maps)
        own_.push_back({map.light,
                        map.fog,
                        map.haze,
                        {},
                        map.baked.sun,
                        map.baked.altitude,
                        map.baked.ambient});
}

void MapLights::apply(const LightWishes& wishes, std::vector<Map>& maps) {
    const Preset* preset = findPreset(wishes.preset);
    for (std::size_t i = 0; i < own_.size(); ++i) {
        Map& map = maps[i];
        Own& own = own_[i];

        // Moves the sky, because it may hold a large image.
        if (applied_ == LightPreset::map && preset != nullptr) own.sky = std::move(map.sky);
        if (applied_ != LightPreset::map && preset == nullptr) map.sky = std::move(own.sky);
        map.light = preset != nullptr ? preset->light : own.light;
        map.fog = preset != nullptr ? preset->fog : own.fog;
        map.haze = wishes.haze.value_or(preset != nullptr ? preset->low : own.haze);
        map.baked.sun = own.sun;
        map.baked.altitude = own.altitude;
        map.baked.ambient = own.ambient;
        map.baked.lampStrength = 1.0;
        if (preset != nullptr && map.baked.on) {
            map.light.on = false;
            if (hasSun(map.baked)) shine(map.baked, *preset);
        }
        map.light.intensity = wishes.intensity.value_or(map.light.intensity);
        map.light.multiplier = wishes.multiplier.value_or(map.light.multiplier);
        if (preset == nullptr) continue;
        if (clouds_ == nullptr) clouds_ = makeCloudCover(0, 1.0);
        map.sky = skyOf(*preset, own.sky, map.baked, clouds_);
        // A sky in the colour of the haze hides where the last portal ends.
        const bool isHaze = own.sky.kind == Sky::Kind::colour && own.sky.low == own.haze;
        if (wishes.preset == LightPreset::fog || isHaze) map.sky.low = map.sky.high = map.haze;
    }
    applied_ = wishes.preset;
}

}  // namespace slicecast
