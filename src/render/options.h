// What a viewer may change about the way a picture is made.
#pragma once

namespace slicecast {

inline constexpr double kMinFovDegrees = 10.0;
inline constexpr double kMaxFovDegrees = 150.0;
inline constexpr double kMaxMirrors = 255.0;
inline constexpr double kMaxLook = 4.0;  // screen heights, either way

struct RenderOptions {
    double fovDegrees = 60.0;      // horizontal field of view
    bool detail = true;            // levels of detail; off, every texel comes from level 0
    double detailThreshold = 1.0;  // level 1 begins where more texels than this fall on a pixel;
                                   // each further level at twice the depth
    bool textures = true;          // off, every texture shows its average colour (its last level)
    bool light = true;             // off, falloff is 1 everywhere
    bool fog = true;               // off, no map has fog (the floor still ends at its `far`)
    double mirrors =
        1.0;  // a mirror's strength r becomes min(255, floor(r * this + 0.5)); 0 to kMaxMirrors
};

}  // namespace slicecast
