// How a moving object takes a step: shared by all its ways to move. See object_motion.h.
#pragma once

#include "world/object_motion.h"
#include "world/traveller.h"

namespace slicecast {

inline ObjectPlace placeOf(const Object& object) {
    return {object.x, object.y, object.z};
}

Object& movedObject(World& world, const ObjectMotion& motion);
const Object& movedObject(const World& world, const ObjectMotion& motion);

Traveller travellerOf(const ObjectMotion& motion, const Object& object);

// Puts the object where its body has arrived after moving by `way`. Portals turn everything that
// has a direction.
void put(World& world, ObjectMotion& motion, const Traveller& body, GroundPoint way);

// Closes up the lists that objects have left: the others keep their order. What refers to one that
// is nowhere goes too. Once for all that leave in a step, because it looks at every object.
void closeGaps(World& world);

// Turns to a heading, and aims the way of each step there.
void face(World& world, ObjectMotion& motion, double degrees);

// Sets where the object faces, for its picture only.
void setFacing(Object& object, double degrees);

// One step of falling straight down.
void fall(World& world, ObjectMotion& motion);

// The result of a step.
struct WalkStep {
    bool stoppedX = false;
    bool stoppedY = false;
    int slip = 0;          // see Slide
    bool refused = false;  // not moved: at a ledge, or pushed off its line
};

// One step sideways and, over stairs, up or down. Starts to fall if the ground is lost.
WalkStep walk(World& world, ObjectMotion& motion, GroundPoint way);

// The way of one step towards a target, as long as the speed allows and not beyond it.
struct Aim {
    GroundPoint way;
    double x = 0.0;  // direction, of length 1, or 0 at the target
    double y = 0.0;
    bool arrives = false;
};
Aim aimAt(const Object& object, GroundPoint target, double speed);

}  // namespace slicecast
