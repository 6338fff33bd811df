// Times of day that a viewer may lay over the maps' own light: a preset takes the place of a map's
// light, fog, haze and sky, in all maps.
#pragma once

#include "slicecast/colour.h"
#include "world/map.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast {

enum class LightPreset : std::uint8_t {
    map,    // as each map has it
    day,    // bright to the horizon
    dusk,   // a low sun: warm haze, dark blue above
    night,  // a lamp's reach around the eye, then darkness
    fog,    // the world fades into one colour
};

struct LightWishes {
    LightPreset preset = LightPreset::map;
    std::optional<double> intensity = std::nullopt;   // instead of the preset's or the map's
    std::optional<double> multiplier = std::nullopt;  // units
    std::optional<Colour> haze =
        std::nullopt;  // colour of fog and far floor; with the fog preset of the sky too
};

// Keeps what the maps came with, so that it comes back.
class MapLights {
public:
    explicit MapLights(const std::vector<Map>& maps);

    // Gives these maps, the same ones each time, the light that is wished for.
    void apply(const LightWishes& wishes, std::vector<Map>& maps);

private:
    struct Own {
        Light light;
        Fog fog;
        Colour haze;
        Sky sky;  // while a preset is on; else the map itself has it
    };
    std::vector<Own> own_;
    LightPreset applied_ = LightPreset::map;
};

}  // namespace slicecast
