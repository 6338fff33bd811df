// Bodies for movers and gates: these must not crush bodies, and movers carry those that stand on
// them.
//
//     bodies.push_back(bodyOf(travellerOf(player), player.onGround));
//     stepWorld(world, bodies, ask);
//     player.z = player.z + bodies[0].shift.z;   // and x and y
#pragma once

#include "base/coordinate.h"
#include "world/traveller.h"

namespace slicecast {

struct Body {
    int map = 0;         // index into World::maps
    Box box = {};        // taller than the way of a mover in a step; the step moves it along
    bool rides = false;  // rests with its weight: also goes down with the ground
    Position eye = {};   // as in Traveller; only used in a world with portals
    Threshold behind = {};
    bool floats = false;  // as in Traveller
    Offset shift = {};    // how far the step has moved it

    // Used only during a step.
    bool straddles = false;  // reaches into a portal
    bool isMet = false;      // the present mover or gate must not get into it
    Coordinate push = {};    // how far the present mover wants to move it along its axis
    Offset way = {};         // and how far it gets
};

inline Body bodyOf(const Traveller& traveller, bool rides) {
    return {.map = traveller.map,
            .box = traveller.box,
            .rides = rides,
            .eye = traveller.eye,
            .behind = traveller.behind,
            .floats = traveller.floats};
}

// The traveller of a body, moved on.
inline Traveller travellerOf(const Body& body, const Offset& by = {}) {
    const Position eye = {body.eye.x + by.x, body.eye.y + by.y, body.eye.z + by.z};
    return {.map = body.map,
            .box = moved(body.box, by),
            .eye = eye,
            .behind = body.behind,
            .floats = body.floats};
}

}  // namespace slicecast
