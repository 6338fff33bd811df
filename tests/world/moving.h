// Worlds with moving blocks and gates, and somebody in them.
#pragma once

#include "walking.h"
#include "world/body.h"
#include "world/world_step.h"

#include <vector>

namespace slicecast {

// A blueprint that moves; put its cells with setCell, then makeMovers.
BlueprintId addMoving(World& world, Coordinate bottom, Coordinate top, const Motion& motion);

// A blueprint of a gate with a block's full height; put its cells with setCell, then makeGates.
BlueprintId addGate(World& world, const GateKind& kind);

// Moves the player as far as a step of the world has moved the body.
void shift(Player& player, const Body& body);

// A step of the world, then of the player.
void stepBoth(World& world, Player& player, const PlayerInput& input = {}, const GateAsk& ask = {});

// What an eye of the player asks.
GateAsk asks(const Player& player, GateAsk::Wish wish);

// True if the box reaches into a block that is solid at the moment: found anew, cell by cell.
bool reachesIntoSolid(const World& world, int map, const Box& box);

}  // namespace slicecast
