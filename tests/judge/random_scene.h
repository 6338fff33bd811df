// Random worlds and eyes for the judge, the same for the same seed everywhere.
#pragma once

#include "base/random.h"
#include "session/light_presets.h"
#include "tracer.h"
#include "world/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast::judge {

struct Scene {
    World world;
    View view;
    // The times of day at which it is drawn, one after another; the last picture is judged. Empty
    // for the world as it is.
    std::vector<LightWishes> times = {};
    // The world as the definition has it after its steps, or at the last of its times; else the
    // judge sees `world`.
    std::optional<World> defined = {};
};

Colour anyColour(Random& random);  // opaque

// Anything goes: all block shapes, eyes at any height, inside blocks, outside the grid, looking far
// up and down. `width` and `height` are the picture's.
Scene randomScene(std::uint64_t seed, int width, int height);

// Made to tie: eyes on borders, corners and edges, quarter and eighth turns, a field of view of 90
// degrees, so that many rays meet borders exactly.
Scene tieScene(std::uint64_t seed, int width, int height);

// Eyes on borders that look along them, but for a rounding; for pictures of an odd width, whose
// middle column runs along the border.
Scene alongBorderScene(std::uint64_t seed, int width, int height);

// Some textures have 256 or 512 texels a side, in a narrow view.
Scene largeTextureScene(std::uint64_t seed, int width, int height);

// A long hall full of see-through blocks, most of which do not join: many columns meet more of them
// than can be shown.
Scene crowdedScene(std::uint64_t seed, int width, int height);

// Wide land with a block, another floor, a piece of ceiling or an object here and there.
Scene wideLandScene(std::uint64_t seed, int width, int height);

}  // namespace slicecast::judge
