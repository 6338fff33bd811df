#include "times_of_day.h"

#include "base/random.h"
#include "draw.h"
#include "session/light_presets.h"

#include <algorithm>
#include <vector>

namespace slicecast::judge {
namespace {

bool isSunny(const BakedLight& baked) {
    return baked.sun.r > 0 || baked.sun.g > 0 || baked.sun.b > 0;
}

// The numbers of a preset: what plain maps show of them.
struct Numbers {
    explicit Numbers(LightPreset preset) {
        std::vector<Map> maps;
        for (int i = 0; i < 3; ++i) maps.push_back(makeMap("plain", 1, 1, 1, 0));
        maps[0].sky.kind = Sky::Kind::gradient;
        for (const std::size_t i : {1, 2}) {
            maps[i].baked.on = true;
            maps[i].baked.sun = {1, 1, 1, 255};
            maps[i].baked.altitude = i == 1 ? 0.0 : 90.0;
        }
        MapLights(maps).apply({.preset = preset}, maps);
        open = maps[0];
        low = maps[1].baked;
        high = maps[2].baked;
    }
    Map open;
    BakedLight low;  // of a sun at the horizon
    BakedLight high;
};

// What the definition says of a map at a time of day.
void define(Map& map, const LightWishes& time) {
    const bool isWhole = time.preset == LightPreset::map;
    const Sky own = map.sky;
    const Colour ownHaze = map.haze;
    const Numbers numbers(isWhole ? LightPreset::day : time.preset);
    if (!isWhole) {
        map.light = numbers.open.light;
        map.fog = numbers.open.fog;
        map.haze = numbers.open.haze;
        map.sky = numbers.open.sky;
        if (map.baked.on) map.light.on = false;
        if (map.baked.on && isSunny(map.baked)) {
            map.baked.sun = numbers.low.sun;
            map.baked.ambient = numbers.low.ambient;
            map.baked.lampStrength = numbers.low.lampStrength;
            map.baked.altitude =
                std::clamp(map.baked.altitude, numbers.low.altitude, numbers.high.altitude);
        }
    }
    if (time.intensity) map.light.intensity = *time.intensity;
    if (time.multiplier) map.light.multiplier = *time.multiplier;
    if (time.haze) map.haze = *time.haze;
    if (isWhole) return;
    SkyDisc& disc = map.sky.moon.size > 0.0 ? map.sky.moon : map.sky.sun;
    if (own.kind == Sky::Kind::colour) {
        map.sky.stars = {};
        map.sky.sun = map.sky.moon = {};
        map.sky.clouds = {};
    } else if (isSunny(map.baked)) {
        disc.azimuth = map.baked.azimuth;
        disc.altitude = std::min(disc.altitude, map.baked.altitude);
    } else if (own.sun.size > 0.0) {
        disc.azimuth = own.sun.azimuth;
    }
    if (time.preset == LightPreset::fog || (own.kind == Sky::Kind::colour && own.low == ownHaze))
        map.sky.low = map.sky.high = map.haze;
}

LightWishes anyTime(Random& random) {
    LightWishes time;
    time.preset = static_cast<LightPreset>(random.below(5));
    if (random.oneIn(4)) time.intensity = random.between(0.3, 3.0);
    if (random.oneIn(4)) time.multiplier = random.between(1.0, 10.0);
    if (random.oneIn(4)) time.haze = anyColour(random);
    return time;
}

bool hasBakedLight(const World& world) {
    return std::ranges::any_of(world.maps, [](const Map& map) { return map.baked.on; });
}

}  // namespace

Scene timesScene(std::uint64_t seed, int width, int height) {
    Random random(seed ^ 0x74696d65u);
    // Most are lit: of other worlds a preset changes less
    Scene scene = randomScene(seed, width, height);
    for (std::uint64_t i = 1; i < 6 && !hasBakedLight(scene.world); ++i)
        scene = randomScene(seed + i * 10'000'000, width, height);
    scene.view.light = scene.view.fog = scene.view.baked = true;
    for (Map& map : scene.world.maps) {
        map.baked.lampStrength = 1.0;  // as in all scenes
        if (random.oneIn(4)) map.sky.kind = Sky::Kind::colour;
        if (random.oneIn(2)) map.haze = map.sky.low;
        if (random.oneIn(4)) map.baked.sun = {0, 0, 0, 255};
    }
    if (random.oneIn(2)) {  // to where the sun or the moon stands, most of the time
        const Map& map = scene.world.maps[static_cast<std::size_t>(scene.view.map)];
        scene.view.headingDegrees = map.baked.azimuth + random.between(-20.0, 20.0);
        scene.view.look = random.between(0.0, 0.5);
    }
    for (int i = random.below(3); i >= 0; --i) scene.times.push_back(anyTime(random));
    scene.defined = scene.world.copy();
    for (Map& map : scene.defined->maps) define(map, scene.times.back());
    return scene;
}

Image drawTimes(Renderer& renderer, Scene& scene) {
    if (scene.times.empty()) return draw(renderer, scene.world, scene.view);
    MapLights lights(scene.world.maps);
    Image image;
    for (const LightWishes& time : scene.times) {
        lights.apply(time, scene.world.maps);
        image = draw(renderer, scene.world, scene.view);
    }
    return image;
}

}  // namespace slicecast::judge
