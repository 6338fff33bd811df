// Bodies among portals: a box with an eye, which sees through portals and goes through them.
//
//           |plane                  The eye decides where a body is. While it is before a portal, the parts of the box that reach through are tested against
//      +----|--+                    what is on the other side, and those before the portal against this side. The moment that the eye crosses the plane, the
//      |  o |::|    o  the eye      whole body is carried to the other side; from then on until it has left the plane behind, the parts still before it are
//      |    |::|    ::  tested      tested against where it came from (`behind`). So a body that fits through gets through, whatever stands around the exit
//      +----|--+        beyond      tile, and no body is inside anything on either side.
//
// A portal face acts on an eye that goes through its rectangle into its block, a portal tile on one
// that goes into the tile at any height. A block with a portal is open to a body only while its eye
// is right in front of that portal: in the tile before the face and between its bottom and top, or
// above (below) it in the same tile; else it is solid. Portals side by side that lead on side by
// side are one wide portal. What would not fit beyond the plane stops there, as at any wall: so it
// is with a body that would reach past the sides of the exit tile into something. Where two portals
// are within a body's reach, the one it passed last counts.
//
//     Traveller body = {.map = 0, .box = box, .eye = eye};
//     const Travelled way = slide(world, body, x, y, step);            // may be in another map now: body.turn, body.leaps
#pragma once

#include "base/coordinate.h"
#include "world/collision.h"
#include "world/portal.h"

namespace slicecast {

struct World;

struct Traveller {
    int map = 0;   // index into World::maps
    Box box;       // at most 1/2 wide and deep
    Position eye;  // its x and y are those of the box's middle
    Threshold behind;
    bool floats = false;  // water is solid to it
    int turn = 0;   // quarter turns clockwise by all portals passed so far; headings and velocities
                    // turn with it
    int leaps = 0;  // portals passed so far
};

// What a way met: along the axes of the map that the traveller is in at its end.
struct Travelled {
    Coordinate rise;  // how much of the box's move upwards was steps; the eye stays at its height
    bool stoppedX = false;
    bool stoppedY = false;
};

// True if nothing solid reaches into the box, on whatever side of a portal.
bool isFree(const World& world, const Traveller& body);

// As sweepZ, isSupported in collision.h: nothing is moved.
Coordinate sweepZ(const World& world, const Traveller& body, Coordinate distance);
bool isSupported(const World& world, const Traveller& body);

// Moves a free body sideways through whatever portals there are on its way, like slide in
// collision.h. The result is free.
Travelled slide(const World& world, Traveller& body, Coordinate distanceX, Coordinate distanceY,
                Coordinate step);

// Moves a free body and its eye up or down, until something stops it. False if it did not get all
// the way.
bool rise(const World& world, Traveller& body, Coordinate distance);

// Moves the eye alone up or down; where it passes a portal the body goes with it. False if
// something stopped it, which then is just before it.
bool moveEye(const World& world, Traveller& body, Coordinate distance);

}  // namespace slicecast
