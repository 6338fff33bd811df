// What of a world changes by itself from step to step: movers, then gates. The player's step comes
// after it.
#pragma once

#include "world/body.h"
#include "world/gate.h"

#include <cstdint>
#include <span>

namespace slicecast {

struct World;
class Hash;

// True if nothing of the world changes by itself: a step has nothing to do.
bool isStill(const World& world);

// One step of kStepSeconds. Bodies ride, and are not crushed: one that was free in the world as it
// was is free in the world as it is.
void stepWorld(World& world, std::span<Body> bodies, const GateAsk& ask);

// Movers and gates as they were in the beginning.
void resetWorld(World& world);

// Everything that the next step depends on.
void addTo(Hash& hash, const World& world);

}  // namespace slicecast
