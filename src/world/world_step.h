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

// Shows movers and moving objects at `fraction` (0 to 1) of the way between the last two steps; at
// 1, where they are. Bring them back to 1 before the next step.
void showBetween(World& world, double fraction);

// The same for as long as this lives.
class ShownBetween {
public:
    ShownBetween(World& world, double fraction) : world_(world) { showBetween(world, fraction); }
    ~ShownBetween() { showBetween(world_, 1.0); }
    ShownBetween(const ShownBetween&) = delete;
    ShownBetween& operator=(const ShownBetween&) = delete;

private:
    World& world_;
};

// Movers and gates return to their initial states.
void resetWorld(World& world);

// Hashes everything that the next step depends on.
void addTo(Hash& hash, const World& world);

}  // namespace slicecast
