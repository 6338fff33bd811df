// Worlds with portals to walk in.
#pragma once

#include "walking.h"

#include "world/portal.h"

namespace slicecast {

// How many random worlds a test tries.
#ifdef SLICECAST_SANITIZED
inline constexpr int kPortalSeeds = 60;
#else
inline constexpr int kPortalSeeds = 600;
#endif

// A portal of a tile; the list of tile portals is made where there is none yet.
void putTilePortal(World& world, const Portal& portal);

// Gives a face of the block in the portal's tile a portal; the block gets a blueprint of its own.
void putFacePortal(World& world, const Portal& portal, int level, Face face);

// Appends a map like that one, but turned clockwise and on a ground of whole blocks, `levels` high.
// Gives the portal from tile (0, 0) to its place in the copy; `portalAt` moves it to other tiles.
Portal appendCopy(World& world, int map, int turn, int levels);
Portal portalAt(const Portal& portal, int x, int y);

}  // namespace slicecast
