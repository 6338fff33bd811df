// What actors do: moving objects that stand, patrol, or react to the player. See object_motion.h.
#pragma once

#include "world/object_motion.h"

namespace slicecast {

// One step of looking for the player. True if the object is alert; never without a player.
bool watch(const World& world, ObjectMotion& motion, const Body* player);

// One step of an alert object.
void react(World& world, ObjectMotion& motion, const Body& player);

// One step of a calm one.
void stand(World& world, ObjectMotion& motion);
void patrol(World& world, ObjectMotion& motion);

// Chooses the sprite after a step that began at `before`.
void showState(World& world, ObjectMotion& motion, GroundPoint before);

// Hashes what only actors have.
void addActor(Hash& hash, const ObjectMotion& motion, const Object& object);

}  // namespace slicecast
