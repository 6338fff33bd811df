// Worlds with portals to walk in.
#pragma once

#include "walking.h"

#include "sanitized.h"
#include "world/portal.h"

namespace slicecast {

// How many random worlds a test tries.
inline constexpr int kPortalSeeds = kSanitized ? 60 : 600;

// Adds the portal to its tile; makes the map's list of tile portals if it has none yet.
void putTilePortal(World& world, const Portal& portal);

// Adds the portal to a face of the block in its tile. A block without portals first gets a
// blueprint of its own.
void putFacePortal(World& world, const Portal& portal, int level, Face face);

// Appends a copy of a map: turned clockwise by `turn` quarters, and raised by `levels` levels of
// whole blocks. Returns the portal from tile (0, 0) to its place in the copy.
Portal appendCopy(World& world, int map, int turn, int levels);

// That portal, from tile (x, y) to its place in the copy.
Portal portalAt(const Portal& portal, int x, int y);

}  // namespace slicecast
