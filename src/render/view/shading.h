// Light and fog at a depth. For glowing faces, and with the light off, the clamped falloff is 1.
//
//     falloff = intensity * multiplier / t
//     factor  = min(256, floor(256 * clamp(falloff, darkest, brightest) * faceLight + 0.5))
//     channel = (c * factor + 128) >> 8    on the bytes as stored
//     fog     = floor(255 * clamp((t - start) / (end - start), 0, 1) + 0.5)
//     channel = (haze * fog + channel * (255 - fog) + 127) / 255    in integers
#pragma once

#include "render/options.h"
#include "slicecast/colour.h"
#include "world/map.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace slicecast {

inline constexpr double kFullBrightness = 256.0;

struct Shade {
    std::uint32_t factor = 256;  // 0 to 256
    std::uint32_t fog = 0;       // 0 to 255
};

// The water around the eye: its colour and sight replace every map's haze and fog.
struct EyeWater {
    const CellBlueprint* water = nullptr;  // null if the eye is not in water
    std::int32_t surface = 0;              // above the eye, 1/65536 units
};

// A map's light after the options.
struct Lighting {
    bool lit = true;
    bool foggy = false;
    bool inWater = false;
    // Above the eye, 1/65536 units; no fog on the way above it.
    std::int32_t surface = std::numeric_limits<std::int32_t>::max();
    double strength = 1.0;  // intensity * multiplier, units
    double darkest = 0.1;
    double brightest = 1.0;
    double fogStart = 0.0;
    double fogLength = 1.0;
    Pixel haze = 0;

    Lighting() = default;
    Lighting(const Map& map, const RenderOptions& options)
        : lit(map.light.on && options.light),
          foggy(map.fog.on && options.fog),
          strength(map.light.intensity * map.light.multiplier),
          darkest(map.light.darkest),
          brightest(map.light.brightest),
          fogStart(map.fog.start),
          fogLength(map.fog.end - map.fog.start),
          haze(toPixel(map.haze)) {}

    // Mirrored rays come from below and do not leave the water.
    void putInWater(const EyeWater& eye, bool mirrored) {
        if (eye.water == nullptr) return;
        foggy = inWater = true;
        if (!mirrored) surface = eye.surface;
        fogStart = 0.0;
        fogLength = eye.water->waterSight;
        haze = toPixel(eye.water->waterColour);
    }

    // 256 times the light at a depth, without the face's own factor.
    // #region light
    double brightnessAt(double depth) const {
        if (!lit) return kFullBrightness;
        const double falloff = strength / depth;
        return 256.0 * std::min(std::max(falloff, darkest), brightest);
    }
    static std::uint32_t factorOf(double brightness, double faceLight) {
        const double bright = brightness * faceLight + 0.5;
        return bright >= 256.0 ? 256u : static_cast<std::uint32_t>(bright);
    }
    std::uint32_t factorAt(double depth, double faceLight, bool glow) const {
        return factorOf(glow ? kFullBrightness : brightnessAt(depth), faceLight);
    }

    std::uint32_t fogAt(double depth) const {
        if (!foggy) return 0;
        const double share = (depth - fogStart) / fogLength;
        return static_cast<std::uint32_t>(255.0 * std::min(std::max(share, 0.0), 1.0) + 0.5);
    }
    // #endregion

    Shade at(double depth, double faceLight, bool glow = false) const {
        return {factorAt(depth, faceLight, glow), fogAt(depth)};
    }
};

}  // namespace slicecast
