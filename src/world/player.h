// The player: a body that walks, swims or flies through a map, one fixed step at a time.
//
//         top  +-----+   0.72 standing; 0.35 crouched, flying or swimming
//              |     |
//              |     |
//         eye  |  o  |   0.50 standing; 0.25 crouched, flying or swimming
//              |     |
//              |     |   0.40 wide and deep; x, y: the middle of the body
//        feet  +-----+   z: the bottom of the body
//
// Units are blocks, seconds and degrees.
//
// Walking has weight: gravity, acceleration, jumps, steps up to 0.5 at once while the eye follows
// smoothly. Flying has none, but stops at blocks too. Water slows down waders. In water deeper than
// kSwimDepth the player swims, drifts up to the surface and dives by a key; getting out is possible
// where the ground rises, or onto a bank at most kClimbOut above the surface. A free body stays
// free: no step and no change of mode puts it into something solid (see collision.h). A body that
// is stuck (a tool may put an eye anywhere) flies through everything until it is free.
//
// The player goes through a portal the moment that the eye does, with the same speed and the same
// view (see traveller.h).
#pragma once

#include "base/coordinate.h"
#include "world/collision.h"
#include "world/time_step.h"
#include "world/traveller.h"
#include "world/world.h"

#include <cstdint>

namespace slicecast {

// The body.
inline constexpr Coordinate kBodyHalfWidth = toCoordinate(0.2);
inline constexpr Coordinate kStandingHeight = toCoordinate(0.72);
inline constexpr Coordinate kStandingEye = toCoordinate(0.5);
inline constexpr Coordinate kCrouchedHeight = toCoordinate(0.35);
inline constexpr Coordinate kCrouchedEye = toCoordinate(0.25);
// The eye stays at least this far above the feet while it catches up with them.
inline constexpr Coordinate kLowestEye = toCoordinate(0.02);
// The highest step up or down without a jump.
inline constexpr Coordinate kStepHeight = toCoordinate(0.5);

// Speeds of a mode in units, degrees and screen heights per second; `fast` and `slow` multiply all
// of them.
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
inline constexpr double kCrouchedPace = 0.5;  // times the walking speed

// Walking, in units per second or per second squared.
inline constexpr double kGroundAcceleration = 24.0;
inline constexpr double kGroundBraking = 30.0;  // without input
inline constexpr double kAirAcceleration = 10.0;
inline constexpr double kAirBraking = 2.0;
inline constexpr double kGravity = 10.0;
inline constexpr double kJumpSpeed = 4.0;      // a jump rises 4 * 4 / (2 * 10) = 0.8
inline constexpr double kGreatestFall = 20.0;  // fastest fall
inline constexpr int kLateJumpSteps = 12;  // a jump still works this long after leaving the ground
inline constexpr int kEarlyJumpSteps =
    12;  // and is remembered this long before landing (0.1 s each)

// Water, see world/water.h. In units, units per second or per second squared.
inline constexpr Coordinate kSwimDepth = toCoordinate(0.45);  // of the feet; beyond it a body swims
// A swimmer stands up where the ground is at most this deep.
inline constexpr Coordinate kStandDepth = toCoordinate(0.4);
// The highest bank above the surface that a swimmer climbs.
inline constexpr Coordinate kClimbOut = toCoordinate(0.5);
inline constexpr Coordinate kFloatingEye = toCoordinate(0.12);  // above the surface
inline constexpr double kWadingPace = 0.5;    // times the walking speed, in the deepest water
inline constexpr double kSwimmingPace = 0.6;  // times the walking speed
inline constexpr double kSwimRise = 1.5;      // up and down, by keys
inline constexpr double kBuoyancy = 0.3;      // upward, without keys
inline constexpr double kSwimResponse = 4.0;  // part of the full speed, per second
inline constexpr double kFloating = 4.0;      // part of the way to the surface, per second
inline constexpr double kBobHeight = 0.03;    // amplitude of a swimmer's eye
inline constexpr int kBobSteps = 312;         // period of the bobbing

// Flying and turning reach their full speed in a tenth of a second.
inline constexpr double kFlyingResponse = 10.0;  // part of the full speed, per second
inline constexpr double kTurningResponse = 10.0;

// After a step or a crouch the eye follows the body like a critically damped spring; it takes about
// 4 / kEyeResponse seconds.
inline constexpr double kEyeResponse = 12.0;

// Limit of looking up and down, in screen heights of the horizon.
inline constexpr double kLookLimit = 1.5;

// Range of PlayerInput::speed.
inline constexpr double kLeastSpeed = 0.1;
inline constexpr double kGreatestSpeed = 4.0;

// What the player wants to do during one step. Axes are -1 to 1; values beyond are clamped, NaN
// counts as 0.
struct PlayerInput {
    double forward = 0.0;  // positive walks ahead
    double strafe = 0.0;   // positive to the right
    double turn = 0.0;     // positive turns right (clockwise)
    double look = 0.0;     // positive looks up
    double fly =
        0.0;  // flying and swimming: positive rises, negative sinks; walking: negative crouches
    double turnDegrees = 0.0;  // turned at once, for a mouse; positive right
    double lookHeights = 0.0;  // looked up at once, screen heights
    bool jump = false;         // held; each press is one jump; swimming: rises
    bool fast = false;
    bool slow = false;   // wins over fast
    double speed = 1.0;  // multiplies moving (not turning), kLeastSpeed to kGreatestSpeed
    bool bob = true;     // bob on the water
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
    Coordinate
        eyeLag;  // height of the eye above its place in the body; decays after a step or a crouch
    double eyeLagRate = 0.0;  // units per second
    bool flying = false;
    bool swimming = false;
    bool crouched = false;
    bool onGround = false;
    bool jumpHeld = false;
    int lateJumpSteps = 0;   // steps left to jump after leaving the ground
    int earlyJumpSteps = 0;  // steps left for a remembered jump
    int bobStep = 0;         // swimming: 0 to kBobSteps - 1
    int leaps = 0;           // portals passed so far; pictures must not interpolate across one
    Threshold behind;        // the portal through which the body still reaches back

    friend bool operator==(const Player&, const Player&) = default;
};

// A body of this height, standing at this point.
Box bodyBox(Coordinate x, Coordinate y, Coordinate feet, Coordinate height);
Box bodyBox(const Player& player);

// The body with its eye, for moving through portals.
Traveller travellerOf(const Player& player);

// True if a player has room to stand with the feet there.
bool fitsStanding(const World& world, int map, Coordinate x, Coordinate y, Coordinate feet);

// The height of the eye, which is always inside the body's space.
Coordinate eyeHeight(const Player& player);

// A player at rest at the world's start: crouched without room to stand, flying without room at
// all.
Player playerAtStart(const World& world);

// A flying player at rest with the eye at that place, which may be anywhere.
Player playerWithEye(int map, Coordinate x, Coordinate y, Coordinate eyeZ, double headingDegrees,
                     double look);

// One step of kStepSeconds.
void stepPlayer(const World& world, Player& player, const PlayerInput& input);

// Moves the body sideways, as far as there is room; its velocity stays.
void nudge(const World& world, Player& player, Coordinate x, Coordinate y);

// Changes the mode; the eye stays where it is. To walk, a body that is not free rises around the
// eye, which may have been low on a step; where that does not free it, it keeps flying.
void setFlying(const World& world, Player& player, bool flying);

// Looks level; a flying player also comes down until the eye is at standing height above the
// ground.
void levelLook(const World& world, Player& player);

// Faces a heading at once.
void setHeading(Player& player, double degrees);

}  // namespace slicecast
