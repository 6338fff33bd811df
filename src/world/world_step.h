// The parts of a world that change by themselves: movers, then gates. The player's step comes after
// them.
#pragma once

#include "world/body.h"
#include "world/gate.h"

#include <cstdint>
#include <span>

namespace slicecast {

struct World;
class Hash;

// True if the world has neither movers nor gates, so that a step does nothing.
bool isStill(const World& world);

// One step of kStepSeconds. Carries bodies and never crushes one: a body that was free stays free.
void stepWorld(World& world, std::span<Body> bodies, const GateAsk& ask);

// Movers and gates return to their initial states.
void resetWorld(World& world);

// Hashes everything that the next step depends on.
void addTo(Hash& hash, const World& world);

}  // namespace slicecast
