// Whether somebody who stands at a place can walk away from it.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

struct World;

// The greatest height that a jump gets onto, a little below what speed and gravity allow.
inline constexpr Coordinate kJumpHeight = toCoordinate(0.79);

// True if a body with the middle of its feet there comes down to somewhere from where it can get
// into another tile, crouched and by jumps if need be, or through a portal. Where something beside
// it moves or opens it is taken for a way out. A map of one tile has nowhere else to go, and needs
// none.
bool hasWayOut(const World& world, int map, Coordinate x, Coordinate y, Coordinate feet);

}  // namespace slicecast
