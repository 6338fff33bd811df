// Moving objects: they wander about, pace to and fro or fly in circles, 1/120 s at a time.
//
// A moving object is a body (see traveller.h) as wide as its picture, within limits, and as high,
// with its eye halfway up. A free body stays free. Walkers climb steps like the player and turn at
// obstacles, ledges and water deeper than half their height; without ground they fall. Floating
// ones cross water like ground. Flyers reverse. All go through portals. Ways are sums of
// coordinates, so they are the same on every machine. Still objects cost nothing here.
//
//     startObjects(world);      once the world is complete
//     stepObjects(world);       1/120 s
//     resetObjects(world);      back to the start
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

// Limits of a body's width.
inline constexpr Coordinate kNarrowestBody =
    toCoordinate(0.125);  // wider than collision.h's kLongestSlide
inline constexpr Coordinate kWidestBody = toCoordinate(0.4);  // as wide as the player

struct ObjectMotion {
    enum class Kind : std::uint8_t {
        wander,  // walks ahead and changes its heading now and then; bounces off obstacles, axis by
                 // axis
        pace,    // walks to and fro along a line
        circle,  // flies clockwise around a point, at its height
    };
    Kind kind = Kind::wander;
    int map = 0;                  // index into World::maps
    int object = 0;               // index into the map's objects
    double speed = 0.5;           // units per second, > 0
    double headingDegrees = 0.0;  // the present heading
    Coordinate reach;  // wander: distance from home along each axis, 0 for no limit; pace: length
                       // of the way; circle: radius
    Random random{0};  // its own

    // Set by startObjects, and by every step.
    Coordinate homeX;  // where it began; for a circle, the centre
    Coordinate homeY;
    Coordinate eye;    // above the feet
    Threshold behind;  // see traveller.h
    Coordinate wayX;   // of each step; not used for a circle
    Coordinate wayY;
    Coordinate fallen;  // in the last step, while falling
    bool onGround = false;
    bool back = false;        // pace: on the way back; circle: counterclockwise
    int steps = 0;            // wander: until the next heading; pace: from home
    std::uint32_t phase = 0;  // circle: its angle, in 2^-32 turns, clockwise from the east
};

// The moving objects of a world, and their initial states.
struct MovingObjects {
    std::vector<ObjectMotion> motions;
    std::vector<ObjectMotion> motionsAtStart;
    std::vector<std::vector<Object>> objectsAtStart;  // by map; empty if nothing moves
};

// The space of an object's body.
Box objectBody(const Object& object);

// A place on a map.
struct GroundPoint {
    Coordinate x;
    Coordinate y;
};

// Where an object starts that was placed at `put`: there, or on its circle around it.
GroundPoint beginning(const ObjectMotion& motion, GroundPoint put);

// Puts circling objects onto their circles (their x and y being the centre), and stores the initial
// states.
void startObjects(World& world);

void stepObjects(World& world);

void resetObjects(World& world);

// addBodies lists the bodies of all moving objects in a fixed order for movers and gates;
// liftObjects applies how these have lifted them.
void addBodies(const World& world, std::vector<Body>& bodies);
void liftObjects(World& world, std::span<const Body> bodies);

// Hashes the states of all moving objects.
void addMovingObjects(Hash& hash, const World& world);

}  // namespace slicecast
