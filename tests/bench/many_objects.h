// A view with very many objects of which few are seen, and the same view with those alone.
#pragma once

#include "render/eye.h"
#include "world/world.h"

#include <optional>

namespace slicecast {

struct ManyObjects {
    World all;
    World seenOnly;
};

// Spreads `count` objects of the world's sprites over the floor of the eye's map. `seen` of them
// are in sight, wholly or in part, with the usual field of view. The others stand behind blocks,
// beside the picture or behind the eye. Nothing if the map has no room for that.
std::optional<ManyObjects> spreadObjects(const World& world, const Eye& eye, int count, int seen);

}  // namespace slicecast
