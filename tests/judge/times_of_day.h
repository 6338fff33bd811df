// Random worlds at other times of day than their own: under the light presets.
#pragma once

#include "random_scene.h"
#include "render/renderer.h"

#include <cstdint>

namespace slicecast::judge {

// A random world that has seen one time of day, and is now at another. The judge sees it by the
// definition of presets.
Scene timesScene(std::uint64_t seed, int width, int height);

// Draws it at all of its times, and returns the last picture.
Image drawTimes(Renderer& renderer, Scene& scene);

}  // namespace slicecast::judge
