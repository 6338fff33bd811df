// The sky of a map: one colour, a gradient or a panorama, and over it stars, a sun, a moon and
// clouds. What each pixel of it shows is defined in web/docs/picture.md.
#pragma once

#include "base/image.h"
#include "slicecast/colour.h"
#include "world/cloud_cover.h"

#include <cstdint>
#include <memory>

namespace slicecast {

// What stands in the sky is made of squares: so many around the full circle, and so many for a
// slope (height / distance) of 1, which makes them square at the horizon.
inline constexpr int kSkyColumns = 2048;
inline constexpr int kSkyRowsPerSlope = 326;
inline constexpr int kMaxSkyRow = 4095;

inline constexpr double kMaxDiscSize = 30.0;      // degrees
inline constexpr double kMaxGlow = 90.0;          // degrees
inline constexpr double kMaxDiscAltitude = 80.0;  // degrees; above, it is outside all pictures
inline constexpr double kMaxCloudSpeed = 60.0;    // degrees per second
inline constexpr double kNormalStars = 0.25;      // density

// The sun or the moon.
struct SkyDisc {
    double size = 0.0;       // degrees across, up to kMaxDiscSize; 0 for none
    double azimuth = 225.0;  // degrees, a heading
    double altitude = 30.0;  // degrees, 0 to kMaxDiscAltitude
    double glow = 0.0;       // degrees from its middle to where its light ends, up to kMaxGlow
    Colour colour = {255, 251, 232, 255};

    friend bool operator==(const SkyDisc&, const SkyDisc&) = default;
};

struct SkyStars {
    double density = 0.0;  // share of the places for stars that have one, 0 to 1; 0 for no stars
    std::uint32_t seed = 0;
    double brightness = 1.0;  // 0 to 1
    Colour colour = {255, 255, 255, 255};

    friend bool operator==(const SkyStars&, const SkyStars&) = default;
};

struct SkyClouds {
    std::shared_ptr<const CloudCover> shape;  // null for no clouds
    double cover = 0.4;                       // 0 for hardly any, 1 for a sky that they close
    double speed = 0.5;    // degrees per second clockwise, at most kMaxCloudSpeed either way
    double opacity = 1.0;  // 0 to 1
    Colour colour = {255, 255, 255, 255};
    Colour shade = {196, 206, 219, 255};  // of their undersides
};

// The background of rays that rise or run level. Never lit, never in fog.
struct Sky {
    enum class Kind : std::uint8_t { colour, gradient, panorama };
    Kind kind = Kind::colour;
    Colour low = {150, 190, 230, 255};  // the colour; the gradient's colour at the horizon
    Colour high = {};                   // the gradient's colour at `slope` and above
    double slope = 1.0;   // upward slope (height / distance) of the gradient's end or the
                          // panorama's upper edge, > 0
    Image panorama = {};  // any size; wraps around the full circle clockwise, starting in the east
    SkyStars stars = {};
    SkyDisc sun = {};
    SkyDisc moon = {.colour = {226, 232, 240, 255}};
    SkyClouds clouds = {};

    bool hasLayers() const {
        return stars.density > 0.0 || sun.size > 0.0 || moon.size > 0.0 || clouds.shape != nullptr;
    }
};

}  // namespace slicecast
