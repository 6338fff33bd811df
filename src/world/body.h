// Bodies as moving blocks and gates see them: whoever must not be crushed, and who rides on what moves.
//
//     bodies.push_back({.map = player.map, .box = bodyBox(player), .rides = player.onGround});
//     stepWorld(world, bodies, ask);
//     player.z = player.z + bodies[0].lift;
#pragma once

#include "base/coordinate.h"
#include "world/collision.h"

namespace slicecast {

struct Body {
    int map = 0;         // index into World::maps
    Box box = {};        // higher than a moving block gets in a step; moved along by the step
    bool rides = false;  // stands with its weight: goes down with what it stands on too
    Coordinate lift = {};  // by how much a step has moved it up; negative is down

    // Of no meaning outside the step.
    bool straddles = false;  // reaches into a portal
    bool isMet = false;      // may be met by the mover at hand
    Coordinate push = {};    // by how much that mover takes it up; negative is down
};

}  // namespace slicecast
