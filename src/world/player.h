// The player: a body that walks, swims or flies through a map, one fixed step at a time.
//
//         top  +-----+   0.72 standing, 0.35 crouched or in the air or   x, y: the middle of the
//              |     |   water                                                 body
//              |     |                                                   z:    the feet, i.e. the
//         eye  |  o  |   0.50 standing, 0.25 crouched, flying or               bottom of the body
//              |     |   swimming
//              |     |   0.40 wide and deep                              Units are blocks, seconds
//              and degrees.
//        feet  +-----+   z
//
// Walking has weight: gravity, acceleration, jumps, steps up to 0.5 at once while the eye follows
// smoothly. Flying has none and stops at blocks too. Water slows whoever wades in it; where it is
// deeper than kSwimDepth one swims, drifts up to its surface and dives on purpose. One gets out of
// it where the ground rises, or onto what is at most kClimbOut above the surface. A body that is
// free stays free: no step and no change of mode puts it into something solid (see collision.h).
// One that is not free to begin with (a tool may put an eye anywhere) flies through everything
// until it is.
//
// The player goes through portals the moment that the eye does, with the same speed and the same
// view (see traveller.h).
#pragma once

#include "base/coordinate.h"
#include "world/collision.h"
#include "world/traveller.h"
#include "world/world.h"

#include <cstdint>

namespace slicecast {

inline constexpr int kStepsPerSecond = 120;
inline constexpr double kStepSeconds = 1.0 / kStepsPerSecond;

// The body.
inline constexpr Coordinate kBodyHalfWidth = toCoordinate(0.2);
inline constexpr Coordinate kStandingHeight = toCoordinate(0.72);
inline constexpr Coordinate kStandingEye = toCoordinate(0.5);
inline constexpr Coordinate kCrouchedHeight = toCoordinate(0.35);
inline constexpr Coordinate kCrouchedEye = toCoordinate(0.25);
inline constexpr Coordinate kLowestEye =
    toCoordinate(0.02);  // the eye stays this far above the feet while it catches up with them
inline constexpr Coordinate kStepHeight =
    toCoordinate(0.5);  // the highest step that is taken without a jump, up or down

// Speeds of a mode: units, degrees and screen heights per second; `fast` and `slow` multiply all of
// them.
struct Pace {
    double move;
    double rise;  // flying only
    double turn;
    double look;
    double fast;
    double slow;
};
inline constexpr Pace kWalkingPace = {
    .move = 3.0, .rise = 0.0, .turn = 90.0, .look = 0.5, .fast = 1.8, .slow = 0.4};
inline constexpr Pace kFlyingPace = {
    .move = 5.0, .rise = 1.0, .turn = 60.0, .look = 1.0 / 3.0, .fast = 3.0, .slow = 0.2};
inline constexpr double kCrouchedPace = 0.5;  // of the walking speed

// Walking. Units per second, or per second squared.
inline constexpr double kGroundAcceleration = 24.0;
inline constexpr double kGroundBraking = 30.0;  // with no way asked for
inline constexpr double kAirAcceleration = 10.0;
inline constexpr double kAirBraking = 2.0;
inline constexpr double kGravity = 10.0;
inline constexpr double kJumpSpeed = 4.0;      // rises by 4 * 4 / (2 * 10) = 0.8
inline constexpr double kGreatestFall = 20.0;  // fastest fall
inline constexpr int kLateJumpSteps =
    12;  // a jump still counts this long after the ground has gone (0.1 s)
inline constexpr int kEarlyJumpSteps = 12;  // and is remembered this long before landing

// Water: see world/water.h. Units, units per second, or per second squared.
inline constexpr Coordinate kSwimDepth = toCoordinate(0.45);  // feet deeper than that swim
inline constexpr Coordinate kStandDepth =
    toCoordinate(0.4);  // a swimmer whose feet reach the ground at most so deep stands up
inline constexpr Coordinate kClimbOut =
    toCoordinate(0.5);  // of a bank above the surface, onto which a swimmer gets
inline constexpr Coordinate kFloatingEye = toCoordinate(0.12);  // above the surface
inline constexpr double kWadingPace = 0.5;    // of the walking speed, where it is deepest
inline constexpr double kSwimmingPace = 0.6;  // of the walking speed
inline constexpr double kSwimRise = 1.5;      // up and down by keys
inline constexpr double kBuoyancy = 0.3;      // up, without a key
inline constexpr double kSwimResponse = 4.0;  // of the full speed, per second
inline constexpr double kFloating = 4.0;      // of the way to the surface, per second
inline constexpr double kBobHeight = 0.03;    // that a swimmer's eye bobs up and down
inline constexpr int kBobSteps = 312;         // the time it takes

// Flying and turning reach their full speed in a tenth of a second.
inline constexpr double kFlyingResponse = 10.0;  // of the full speed, per second
inline constexpr double kTurningResponse = 10.0;

// After a step or a crouch the eye follows the body like a spring that does not swing: it takes
// about 4 / kEyeResponse seconds.
inline constexpr double kEyeResponse = 12.0;

// Screen heights that the horizon can be moved by looking up and down.
inline constexpr double kLookLimit = 1.5;

// Speeds are multiplied by a value within these.
inline constexpr double kLeastSpeed = 0.1;
inline constexpr double kGreatestSpeed = 4.0;

// What the player asks for during one step. Axes are -1 to 1; values beyond are clamped, NaN counts
// as 0.
struct PlayerInput {
    double forward = 0.0;      // positive walks ahead
    double strafe = 0.0;       // positive to the right
    double turn = 0.0;         // positive turns right (clockwise)
    double look = 0.0;         // positive looks up
    double fly = 0.0;          // flying: positive rises; swimming too, negative dives; walking:
                               // negative crouches
    double turnDegrees = 0.0;  // turned at once, for a mouse; positive right
    double lookHeights = 0.0;  // looked up at once, screen heights
    bool jump = false;         // held; a jump is one press; swimming: rises
    bool fast = false;
    bool slow = false;   // wins over fast
    double speed = 1.0;  // multiplies moving (not turning), kLeastSpeed to kGreatestSpeed
    bool bob = true;     // on the water
};

struct Player {
    int map = 0;  // index into World::maps
    Coordinate x;
    Coordinate y;
    Coordinate z;
    double velocityX = 0.0;  // units per second
    double velocityY = 0.0;
    double velocityZ = 0.0;
    double headingDegrees = 0.0;  // 0 = east, 90 = south, in [0, 360)
    double look = 0.0;            // screen heights, positive up
    double turnRate = 0.0;        // degrees per second, by keys
    double lookRate = 0.0;        // screen heights per second, by keys
    Coordinate eyeLag;  // how far the eye is above its place in the body; dies away after a step or
                        // a crouch
    double eyeLagRate = 0.0;  // units per second
    bool flying = false;
    bool swimming = false;
    bool crouched = false;
    bool onGround = false;
    bool jumpHeld = false;
    int lateJumpSteps = 0;   // left to jump after the ground has gone
    int earlyJumpSteps = 0;  // left for a remembered jump
    int bobStep = 0;         // swimming: of kBobSteps
    int leaps = 0;  // portals passed so far: what is between the places before and after one cannot
                    // be drawn
    Threshold behind;  // of the portal that the body still reaches back through

    friend bool operator==(const Player&, const Player&) = default;
};

// A body of the given height with the middle of its feet at a place.
Box bodyBox(Coordinate x, Coordinate y, Coordinate feet, Coordinate height);
Box bodyBox(const Player& player);

// The body with its eye, as it goes through portals.
Traveller travellerOf(const Player& player);

// True if a player can stand with the feet there.
bool fitsStanding(const World& world, int map, Coordinate x, Coordinate y, Coordinate feet);

// The height of the eye, which is always inside the space that the body has.
Coordinate eyeHeight(const Player& player);

// A player at rest at the world's start, crouched if there is no room to stand and flying if there
// is none at all.
Player playerAtStart(const World& world);

// A flying player at rest whose eye is at that place, which may be anywhere.
Player playerWithEye(int map, Coordinate x, Coordinate y, Coordinate eyeZ, double headingDegrees,
                     double look);

// One step of kStepSeconds.
void stepPlayer(const World& world, Player& player, const PlayerInput& input);

// Changes the mode; the eye stays where it is. A body that is not free goes on flying.
void setFlying(const World& world, Player& player, bool flying);

// Looks level; a flying player also comes down until the eye is at standing height above whatever
// lies below.
void levelLook(const World& world, Player& player);

// Faces a heading at once.
void setHeading(Player& player, double degrees);

}  // namespace slicecast
