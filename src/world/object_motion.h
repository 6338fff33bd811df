// Objects that move: they wander about, pace to and fro or fly in circles, 1/120 s at a time.
//
// A moving object is a body (see traveller.h) as wide as its picture, within limits, and as high,
// with its eye halfway up. One that is free stays free. Walkers take steps up and down like the
// player and turn at whatever they meet, ledges and water deeper than half their height among it;
// with no ground under them they fall. What floats goes over water as over ground. Flyers turn
// back. All of them go through portals. Ways are sums of coordinates, so they are the same
// everywhere. What stands still costs nothing here.
//
//     startObjects(world);      once the world is complete
//     stepObjects(world);       1/120 s
//     resetObjects(world);      everything back to where it was at first
#pragma once

#include "base/coordinate.h"
#include "base/random.h"
#include "world/object.h"
#include "world/portal.h"

#include <cstdint>
#include <span>
#include <vector>

namespace slicecast {

class Hash;
struct Body;
struct Box;
struct World;

// The body's width; a narrower or wider picture has one of these.
inline constexpr Coordinate kNarrowestBody =
    toCoordinate(0.125);  // wider than collision.h's kLongestSlide
inline constexpr Coordinate kWidestBody = toCoordinate(0.4);  // as wide as the player

struct ObjectMotion {
    enum class Kind : std::uint8_t {
        wander,  // walks ahead, now and then another way; is thrown back, axis by axis, by what it
                 // meets
        pace,    // walks to and fro along a line
        circle,  // flies clockwise around a point, at its height
    };
    Kind kind = Kind::wander;
    int map = 0;                  // index into World::maps
    int object = 0;               // index into its objects: the one that moves
    double speed = 0.5;           // units per second, > 0
    double headingDegrees = 0.0;  // where it goes at the moment
    Coordinate reach;  // wander: how far it goes from home along each axis, 0 for no limit; pace:
                       // length of the way; circle: radius
    Random random{0};  // its own

    // Set by startObjects, and by every step.
    Coordinate homeX;  // where it began; of a circle, the middle
    Coordinate homeY;
    Coordinate eye;    // above the feet
    Threshold behind;  // see traveller.h
    Coordinate wayX;   // of each step; not of a circle
    Coordinate wayY;
    Coordinate fallen;  // by the last step, if it is in the air
    bool onGround = false;
    bool back = false;        // pace: on the way back; circle: counterclockwise
    int steps = 0;            // wander: before it goes another way; pace: from home
    std::uint32_t phase = 0;  // circle: where it is, in 2^-32 turns, clockwise from the east
};

// What moves in a world, and how it all was at first.
struct MovingObjects {
    std::vector<ObjectMotion> motions;
    std::vector<ObjectMotion> motionsAtStart;
    std::vector<std::vector<Object>> objectsAtStart;  // by map; empty where nothing moves
};

// The space that an object's body takes up.
Box objectBody(const Object& object);

// A place on a map.
struct GroundPoint {
    Coordinate x;
    Coordinate y;
};

// Where an object begins that was put there: in the same place, or to fly in a circle on it.
GroundPoint beginning(const ObjectMotion& motion, GroundPoint put);

// Puts those that fly in circles onto them (their x and y being the middle), and notes how
// everything stands.
void startObjects(World& world);

void stepObjects(World& world);

void resetObjects(World& world);

// What moves, as moving blocks and gates see it, in a fixed order; and how they have taken it
// along.
void addBodies(const World& world, std::vector<Body>& bodies);
void liftObjects(World& world, std::span<const Body> bodies);

// Mixes in where everything that moves is, and what it will do.
void addMovingObjects(Hash& hash, const World& world);

}  // namespace slicecast
