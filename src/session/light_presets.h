// Times of day that replace the light, fog, haze and sky of all maps.
#pragma once

#include "slicecast/colour.h"
#include "world/map.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace slicecast {

enum class LightPreset : std::uint8_t {
    map,    // each map's own
    day,    // bright up to the horizon
    dusk,   // a low sun: warm haze, dark blue above
    night,  // a lamp lights the surroundings of the eye; darkness beyond
    fog,    // the world fades into one colour
};

struct LightWishes {
    LightPreset preset = LightPreset::map;
    std::optional<double> intensity = std::nullopt;   // replaces the preset's or the map's
    std::optional<double> multiplier = std::nullopt;  // units
    // Colour of the fog and the far floor; with the fog preset also of the sky.
    std::optional<Colour> haze = std::nullopt;
};

// Applies presets, and remembers the maps' own light to restore it.
class MapLights {
public:
    explicit MapLights(const std::vector<Map>& maps);

    // Lights the maps as wished. `maps` must be the same maps each time.
    void apply(const LightWishes& wishes, std::vector<Map>& maps);

private:
    struct Own {
        Light light;
        Fog fog;
        Colour haze;
        Sky sky;  // moved here while a preset is on
        Colour sun;
        double altitude;
        Colour ambient;
    };
    std::vector<Own> own_;
    std::shared_ptr<const CloudCover> clouds_;  // of all presets, made when first needed
    LightPreset applied_ = LightPreset::map;
};

}  // namespace slicecast
