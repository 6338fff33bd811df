// Moving objects: they wander about, pace to and fro, fly in circles, stand or patrol, 1/120 s at a
// time; and some greet, follow or flee the player while they are alert.
//
// A moving object is a body (see traveller.h) as wide as its picture, within limits, and as high,
// with its eye halfway up. A free body stays free. Walkers climb steps like the player and turn at
// obstacles, ledges and water deeper than half their height; without ground they fall. Floating
// ones cross water like ground. Flyers reverse. All go through portals. Ways are sums of
// coordinates, so they are the same on every machine. Still objects cost nothing here.
//
//     startObjects(world);            once the world is complete
//     stepObjects(world, &player);    1/120 s
//     resetObjects(world);            back to the start
#pragma once

#include "base/coordinate.h"
#include "base/random.h"
#include "world/object.h"
#include "world/portal.h"

#include <array>
#include <cstdint>
#include <optional>
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

// A place on a map.
struct GroundPoint {
    Coordinate x;
    Coordinate y;

    friend bool operator==(const GroundPoint&, const GroundPoint&) = default;
};

// An answer to the question for the nearest portal that leads from a map to another one.
struct NearestPortal {
    int map = -1;
    int toMap = -1;
    GroundPoint near;
    std::optional<GroundPoint> middle;  // of the portal's tile; none if there is no such portal
};

// Where an object is on its map.
struct ObjectPlace {
    Coordinate x;
    Coordinate y;
    Coordinate z;
};

struct ObjectMotion {
    enum class Kind : std::uint8_t {
        wander,  // walks ahead and changes its heading now and then; bounces off obstacles, axis by
                 // axis
        pace,    // walks to and fro along a line
        circle,  // flies clockwise around a point, at its height
        stand,   // stays at home, or walks back there
        patrol,  // walks along a path, see PathPoint
    };
    // What it does instead while it is alert: from when it sees the player within `near` until
    // `calmSteps` after it last did.
    enum class Reaction : std::uint8_t {
        none,
        greet,   // stops and turns to the player
        follow,  // walks to the player, also through portals, and stops `keep` away
        flee,    // walks away from the player
    };
    Kind kind = Kind::wander;
    int map = 0;                  // index into World::maps
    int object = 0;               // index into the map's objects
    double speed = 0.5;           // units per second, > 0
    double headingDegrees = 0.0;  // the present heading
    Coordinate reach;  // wander: distance from home along each axis, 0 for no limit; pace: length
                       // of the way; circle: radius
    Random random{0};  // its own
    Reaction reaction = Reaction::none;
    Coordinate near;          // units, > 0
    Coordinate keep;          // follow: between the middles
    double alertSpeed = 1.0;  // units per second, > 0
    int calmSteps = 0;
    bool solid = false;  // does not walk into others that are, nor into the player; see crowd.h
    int path = -1;       // index into MovingObjects::paths
    bool loops = true;   // patrol: from the last point to the first; else back along the path
    // Sprites while it walks, and while it stands alert; its own while it stands calm.
    std::optional<SpriteId> walking;
    std::optional<SpriteId> alert;

    // For pictures between steps. Through a portal it leaps: then it was where it came out.
    ObjectPlace before;  // the last step
    ObjectPlace now;     // only while another place is shown

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

    // Of actors only.
    SpriteId standing = 0;
    int lookSteps = 0;   // until it looks for the player again
    int alertSteps = 0;  // until it is calm; 0 while it is
    GroundPoint seen;    // where the player was last, in its map, while it was alert
    bool isWalking = false;
    int point = 0;         // patrol: of the path, that it walks to
    int waitSteps = 0;     // patrol: at a point
    int liftSteps = 0;     // patrol: for which it has waited for a lift
    NearestPortal portal;  // patrol: that it walks to
    int blockedSteps = 0;
    int detours = 0;      // since it last came nearer
    int detourSteps = 0;  // of the present one, until it ends
    int crowdSteps = 0;   // for which others have been in its way
    int crowdBody = -1;   // index into MovingObjects::crowd, of the present step
    int veer = 0;         // flee: eighths of a turn off the straight way
    int veerSteps = 0;    // flee: until it runs straight again

    // True for those that need more than the first three ways to move. The others keep the states
    // that they have always had.
    bool isActor() const {
        return kind > Kind::circle || reaction != Reaction::none || solid || walking || alert;
    }
};

// A point of a path. Its map need not be the one before: the way leads through the nearest portal.
struct PathPoint {
    int map = 0;
    GroundPoint place;
    std::optional<Coordinate> feet;  // reached only at this height: waits for a lift
    int waitSteps = 0;
};

// A body among others, see crowd.h.
struct CrowdBody {
    int map = 0;
    int motion = -1;  // index into the motions; -1 is the player
    Coordinate x;
    Coordinate y;
    Coordinate half;
    Coordinate bottom;
    Coordinate top;
    int tileX = 0;  // where it was when it was listed
    int tileY = 0;
};

// An object that has left its map's list. Its place there stays until closeGaps.
struct GoneObject {
    int map = 0;
    int object = 0;
    int toMap = 0;      // where it is now
    int toObject = -1;  // -1 for nowhere
};

// So many answers are kept: those who follow the player ask alike.
inline constexpr std::size_t kKeptPortals = 8;
// Pairs of an object that patrols and a portal that a step compares. Where there may be more, the
// objects ask for the nearest portal in turn.
inline constexpr std::size_t kMostPortalLooks = 1 << 17;

// The moving objects of a world, and their initial states.
struct MovingObjects {
    std::vector<ObjectMotion> motions;
    std::vector<ObjectMotion> motionsAtStart;
    std::vector<std::vector<Object>> objectsAtStart;  // by map; empty if nothing moves or is found
    std::vector<std::vector<PathPoint>> paths;
    std::vector<GoneObject> gone;      // of the present step
    std::vector<GoneObject> goneRoom;  // to sort them
    std::array<NearestPortal, kKeptPortals> nearest;
    std::size_t nextNearest = 0;  // that is forgotten next
    std::size_t turn = 0;         // of those that patrol: counts steps
    bool anySolid = false;
    bool areBetween = false;           // shown elsewhere than they are
    std::vector<CrowdBody> crowd;      // of the present step, by map, row and tile
    std::vector<CrowdBody> crowdRoom;  // to sort them
    std::int64_t crowdLooks = 0;       // so often one has looked at another in the present step
};

// How often an actor looks for the player.
inline constexpr int kLookSteps = 12;

// The space of an object's body.
Box objectBody(const Object& object);
// What it counts as in kMaxMovingLevels.
inline int levelsOf(const Object& object) {
    return 2 * (Coordinate{object.height.raw - 1}.tile() + 1);
}

// Where an object starts that was placed at `put`: there, or on its circle around it.
GroundPoint beginning(const ObjectMotion& motion, GroundPoint put);

// Puts circling objects onto their circles (their x and y being the centre), and stores the initial
// states.
void startObjects(World& world);

// Without a player nobody is alert.
void stepObjects(World& world, const Body* player = nullptr);

// In so many steps each object that patrols asks once for the nearest portal: 1 if all may in each.
std::size_t turnsOfPatrols(const World& world);

void resetObjects(World& world);

// What a moment keeps of the objects, see world_moment.h: all that moves, and of each map the
// objects that differ from those at the same place of its list at the start.
struct ChangedObject {
    int map = 0;
    int object = 0;
    Object now;
};
struct ObjectsMoment {
    std::vector<ObjectMotion> motions;
    std::vector<int> counts;  // of objects, by map; empty if nothing moves or is found
    std::vector<ChangedObject> changed;
    std::array<NearestPortal, kKeptPortals> nearest;
    std::size_t nextNearest = 0;
    std::size_t turn = 0;
};
ObjectsMoment momentOfObjects(const World& world);
void restoreObjects(World& world, const ObjectsMoment& moment);

// Notes where all moving objects are, before anything of a step moves them.
void noteObjects(World& world);
// Shows them at a part of the way from there: see showBetween.
void showObjects(World& world, double part);

// addBodies lists the bodies of all moving objects in a fixed order for movers and gates;
// liftObjects applies how these have lifted them.
void addBodies(const World& world, std::vector<Body>& bodies);
void liftObjects(World& world, std::span<const Body> bodies);

// Hashes the states of all moving objects.
void addMovingObjects(Hash& hash, const World& world);

}  // namespace slicecast
