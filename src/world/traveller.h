// Bodies among portals: a box with an eye, which sees and goes through portals.
//
//           |plane
//      +----|--+
//      |  o |::|    o  the eye
//      |    |::|    ::  tested beyond
//      +----|--+
//
// The eye decides where a body is. While it is in front of a portal, the parts of the box that
// reach through are tested against the other side, the rest against this side. The moment that the
// eye crosses the plane, the whole body is carried to the other side; until it has left the plane,
// the parts still before it are tested against the side that it came from (`behind`). So a body
// that fits through the portal gets through, whatever is around the exit tile, and is never inside
// anything on either side.
//
// A portal face acts on an eye that enters its block through the face's rectangle, a portal tile on
// an eye that enters the tile at any height. A block with a portal is open to a body only while its
// eye is right in front of that portal: in the tile before the face and between its bottom and top,
// or above (below) it in the same tile; else it is solid. Adjacent portals that lead to adjacent
// places are one wide portal. A body that does not fit beyond the plane stops there, as at any
// wall; this includes one that would reach past the sides of the exit tile into something. If a
// body reaches two portals, the one it passed last counts.
//
//     Traveller body = {.map = 0, .box = box, .eye = eye};
//     const Travelled way = slide(world, body, x, y, step);   // see body.turn and body.leaps
#pragma once

#include "base/coordinate.h"
#include "world/collision.h"
#include "world/motion.h"
#include "world/portal.h"

namespace slicecast {

struct World;

struct Traveller {
    int map = 0;   // index into World::maps
    Box box;       // at most 1/2 wide and deep
    Position eye;  // its x and y are the middle of the box
    Threshold behind;
    bool floats = false;  // water is solid for it
    int turn = 0;   // quarter turns clockwise by all portals passed so far; headings and velocities
                    // turn equally
    int leaps = 0;  // portals passed so far
};

// The result of a move. Axes are of the map at its end.
struct Travelled {
    Coordinate rise;  // part of the box's upward move that was steps; the eye stays at its height
    bool stoppedX = false;
    bool stoppedY = false;
    int slip = 0;  // see Slide
};

// True if nothing solid reaches into the box, on either side of a portal.
bool isFree(const World& world, const Traveller& body);

// Like sweepZ and isSupported in collision.h; nothing moves.
Coordinate sweepZ(const World& world, const Traveller& body, Coordinate distance);
bool isSupported(const World& world, const Traveller& body);

// The same along x or y, among what is on this side of all portals that the body does not reach
// into.
Coordinate sweepSideways(const World& world, const Traveller& body, Axis axis, Coordinate distance);

// Where a body slides that rests on slopes steeper than kSteepest and on nothing else: how far they
// fall per unit along x and y, eastward and southward positive. 0 elsewhere.
struct Fall {
    double x = 0.0;
    double y = 0.0;
};
Fall fallOf(const World& world, const Traveller& body);

// Moves a free body sideways, through portals on its way, like slide in collision.h. The result is
// free.
Travelled slide(const World& world, Traveller& body, Coordinate distanceX, Coordinate distanceY,
                Coordinate step);

// Moves a free body and its eye up or down until something stops it. False if something did.
bool rise(const World& world, Traveller& body, Coordinate distance);

// Moves only the eye up or down; if it passes a portal, the body goes along. False if something
// stopped it; it then is just before that.
bool moveEye(const World& world, Traveller& body, Coordinate distance);

}  // namespace slicecast
