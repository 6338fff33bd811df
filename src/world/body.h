// Bodies as moving blocks and gates see them: whoever must not be crushed, and who rides on what
// moves.
//
//     bodies.push_back(bodyOf(travellerOf(player), player.onGround));
//     stepWorld(world, bodies, ask);
//     player.z = player.z + bodies[0].lift;
#pragma once

#include "base/coordinate.h"
#include "world/traveller.h"

namespace slicecast {

struct Body {
    int map = 0;         // index into World::maps
    Box box = {};        // higher than a moving block gets in a step; moved along by the step
    bool rides = false;  // stands with its weight: goes down with what it stands on too
    Position eye = {};   // as of a Traveller; of no meaning in a world without portals
    Threshold behind = {};
    bool floats = false;   // as of a Traveller
    Coordinate lift = {};  // by how much a step has moved it up; negative is down

    // Of no meaning outside the step.
    bool straddles = false;  // reaches into a portal
    bool isMet = false;      // may be met by the mover at hand
    Coordinate push = {};    // by how much that mover takes it up; negative is down
};

inline Body bodyOf(const Traveller& traveller, bool rides) {
    return {.map = traveller.map,
            .box = traveller.box,
            .rides = rides,
            .eye = traveller.eye,
            .behind = traveller.behind,
            .floats = traveller.floats};
}

// The same, so far up.
inline Traveller travellerOf(const Body& body, Coordinate up = {}) {
    const Position eye = {body.eye.x, body.eye.y, body.eye.z + up};
    return {.map = body.map,
            .box = moved(body.box, {.x = {}, .y = {}, .z = up}),
            .eye = eye,
            .behind = body.behind,
            .floats = body.floats};
}

}  // namespace slicecast
