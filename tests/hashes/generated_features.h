// What generated worlds have beyond blocks: a second and a third map, see-through textures and
// sheets, mirrors, portals, objects that stand and move, blocks that move, gates.
#pragma once

#include "base/random.h"
#include "world/world.h"

namespace slicecast {

// To a world with one map. The same from every compiler. Some blocks with slopes move too if asked
// for.
void addFeatures(Random& random, World& world, bool withRamps);

// Thin blocks, halves of tiles, slopes; after everything that moves or leads elsewhere.
void addShapes(Random& random, World& world);

// A sun, light from the sky, and lamps.
void addLight(Random& random, World& world);

// Stars, sun, moon and clouds; ripples on mirrors.
void addSkyAndRipples(Random& random, World& world);

}  // namespace slicecast
