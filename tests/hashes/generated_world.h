// Worlds and views that nobody has made: every seed gives another one, the same from every
// compiler. They hold what shipped scenes have little of: blocks of all shapes in great number, all
// kinds of sky, ceilings with holes, fog, a near end of the floor, eyes anywhere; every other one
// has what generated_features.h lists.
#pragma once

#include "render/eye.h"
#include "render/options.h"
#include "world/world.h"

#include <cstdint>

namespace slicecast {

// From this seed on, some of what moves has slopes, so that the worlds before stay what they are.
inline constexpr std::uint64_t kFirstWithRamps = 97;

World generatedWorld(std::uint64_t seed);

struct GeneratedView {
    Eye eye;
    RenderOptions options;
    int width = 0;  // pixels
    int height = 0;
};

// A view of that world: inside blocks, on borders, above the map and outside it too.
GeneratedView generatedView(const World& world, std::uint64_t seed);

}  // namespace slicecast
