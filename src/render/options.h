// The options of how a picture is drawn.
#pragma once

#include <cstdint>
#include <limits>

namespace slicecast {

inline constexpr double kMinFovDegrees = 10.0;
inline constexpr double kMaxFovDegrees = 150.0;
inline constexpr double kMaxMirrors = 255.0;
inline constexpr double kMaxLook = 4.0;  // screen heights, up and down

// Work of baked light is counted in cells that light rays pass, and in what takes as long: 20 to
// 60 ns natively in the shipped scenes, more where rays pass many see-through blocks.
using LightWork = std::int64_t;
inline constexpr LightWork kAllLight = std::numeric_limits<LightWork>::max();

struct RenderOptions {
    double fovDegrees = 60.0;      // horizontal field of view
    bool detail = true;            // levels of detail; off: level 0 everywhere
    double detailThreshold = 1.0;  // texels per pixel at which level 1 begins; each further level
                                   // begins at twice the depth
    bool smooth = false;           // blends the texels of faces where they are larger than a pixel
    bool textures = true;          // off: every texture shows its average colour (its last level)
    bool light = true;             // off: brightness is 1 everywhere
    bool fog = true;               // off: no map has fog (the floor still ends at its `far`)
    bool baked = true;             // off: no map has baked light
    // A mirror's strength r becomes min(255, floor(r * this + 0.5)); 0 to kMaxMirrors.
    double mirrors = 1.0;
    // Work of light in one picture. What is beyond it keeps its light of before, or has the ambient
    // light that is everywhere: see FrameReport::lateLight.
    LightWork lightWork = kAllLight;
};

}  // namespace slicecast
