// Tells whether a player who stands at a place can walk away from it.
#pragma once

#include "base/coordinate.h"

namespace slicecast {

struct World;

// The highest step that a jump reaches, slightly less than speed and gravity allow.
inline constexpr Coordinate kJumpHeight = toCoordinate(0.79);

// True if a body that falls from this point can get into another tile, crouched and by jumps if
// needed, or through a portal. Moving blocks and gates nearby count as a way out. A map of one tile
// needs none.
bool hasWayOut(const World& world, int map, Coordinate x, Coordinate y, Coordinate feet);

}  // namespace slicecast
