#include "world/player.h"

#include "base/angle.h"
#include "world/water.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr double kGreatestTurnDegrees = 360.0;  // by the mouse in one step
constexpr double kEyeAtRest = 1.0 / 4096.0;     // units; a smaller lag of the eye is invisible
constexpr Coordinate kEyeDrop = kStandingEye - kCrouchedEye;

double within(double value, double least, double greatest, double ifNaN) {
    if (std::isnan(value)) return ifNaN;
    return std::min(std::max(value, least), greatest);
}

// Clamps every number to its range, and the direction to full speed.
PlayerInput withinRanges(const PlayerInput& input) {
    PlayerInput wish = input;
    for (double PlayerInput::*axis : {&PlayerInput::forward, &PlayerInput::strafe,
                                      &PlayerInput::turn, &PlayerInput::look, &PlayerInput::fly}) {
        wish.*axis = within(input.*axis, -1.0, 1.0, 0.0);
    }
    wish.turnDegrees = within(input.turnDegrees, -kGreatestTurnDegrees, kGreatestTurnDegrees, 0.0);
    wish.lookHeights = within(input.lookHeights, -2.0 * kLookLimit, 2.0 * kLookLimit, 0.0);
    wish.speed = within(input.speed, kLeastSpeed, kGreatestSpeed, 1.0);
    const double length = std::sqrt(wish.forward * wish.forward + wish.strafe * wish.strafe);
    if (length > 1.0) {
        wish.forward /= length;
        wish.strafe /= length;
    }
    return wish;
}

// `value` moved towards `target` by at most `change`.
double approach(double value, double target, double change) {
    return value < target ? std::min(value + change, target) : std::max(value - change, target);
}

struct Vector {
    double x;
    double y;
};

// The same for a vector; it moves by a length of at most `change`.
Vector approach(Vector value, Vector target, double change) {
    const Vector difference = {target.x - value.x, target.y - value.y};
    const double length = std::sqrt(difference.x * difference.x + difference.y * difference.y);
    if (length <= change) return target;
    const double part = change / length;
    return {value.x + difference.x * part, value.y + difference.y * part};
}

// The rate one step later, nearer to its target. It grows from 0 to `full` within 1 / response
// seconds; a rate above `full` changes faster in proportion.
double respond(double rate, double target, double full, double response) {
    return approach(rate, target, std::max(full, std::abs(rate)) * response * kStepSeconds);
}

double gear(const Pace& pace, const PlayerInput& wish) {
    return wish.slow ? pace.slow : wish.fast ? pace.fast : 1.0;
}

// The wanted velocity along the ground.
Vector wishedVelocity(const Player& player, const PlayerInput& wish, double speed) {
    const SineCosine heading = sineCosineDegrees(player.headingDegrees);
    return {speed * (wish.forward * heading.cosine - wish.strafe * heading.sine),
            speed * (wish.forward * heading.sine + wish.strafe * heading.cosine)};
}

void turnAndLook(Player& player, const PlayerInput& wish) {
    const Pace& pace = player.flying ? kFlyingPace : kWalkingPace;
    const double factor = gear(pace, wish);
    player.turnRate = respond(player.turnRate, wish.turn * pace.turn * factor, pace.turn * factor,
                              kTurningResponse);
    player.lookRate = respond(player.lookRate, wish.look * pace.look * factor, pace.look * factor,
                              kTurningResponse);
    player.headingDegrees =
        wrapDegrees(player.headingDegrees + player.turnRate * kStepSeconds + wish.turnDegrees);
    const double look = player.look + player.lookRate * kStepSeconds + wish.lookHeights;
    player.look = within(look, -kLookLimit, kLookLimit, 0.0);
    if (player.look != look) player.lookRate = 0.0;
}

Coordinate eyeAboveFeet(const Player& player) {
    return player.flying || player.swimming || player.crouched ? kCrouchedEye : kStandingEye;
}

// Puts the player where the body has arrived. Portals turn everything that has a direction.
void put(Player& player, const Traveller& body) {
    player.map = body.map;
    player.x = body.eye.x;
    player.y = body.eye.y;
    player.z = body.box.bottom;
    player.eyeLag = body.eye.z - body.box.bottom - eyeAboveFeet(player);
    player.behind = body.behind;
    player.leaps += body.leaps;
    if (body.turn == 0) return;
    player.headingDegrees = wrapDegrees(player.headingDegrees + 90.0 * body.turn);
    turnArrow(body.turn, player.velocityX, player.velocityY);
}

// Moves the eye towards its place, but keeps it above the feet and below any block above the body.
void moveEyeTo(const World& world, Player& player, Coordinate wantedLag) {
    Traveller body = travellerOf(player);
    // Feet may be below a floor of water; the eye must stay above the floor.
    Coordinate lag =
        std::max(wantedLag, kLowestEye - eyeAboveFeet(player) - std::min(player.z, Coordinate{0}));
    if (lag.raw > 0) lag = sweepZ(world, body, lag);
    const bool arrived = moveEye(world, body, lag - player.eyeLag);
    put(player, body);
    if (!arrived || lag != wantedLag) player.eyeLagRate = 0.0;
}

// One step of a critically damped spring by the implicit Euler method, which never overshoots.
void easeEye(const World& world, Player& player) {
    constexpr double kPart = kEyeResponse * kStepSeconds;
    const double lag = player.eyeLag.value();
    player.eyeLagRate =
        (player.eyeLagRate - kPart * kEyeResponse * lag) / (1.0 + 2.0 * kPart + kPart * kPart);
    Coordinate wantedLag = toCoordinate(lag + player.eyeLagRate * kStepSeconds);
    if (std::abs(lag) < kEyeAtRest && std::abs(player.eyeLagRate) < kEyeAtRest * kEyeResponse) {
        wantedLag = {};
        player.eyeLagRate = 0.0;
    }
    moveEyeTo(world, player, wantedLag);
}

// Slides sideways by the velocity, over steps of at most `step`. Obstacles cancel the velocity on
// their axis, cuts of halves what is across them. On steps the eye lags behind.
Travelled slidePlayer(const World& world, Player& player, Coordinate step) {
    Traveller body = travellerOf(player);
    const Travelled way = slide(world, body, toCoordinate(player.velocityX * kStepSeconds),
                                toCoordinate(player.velocityY * kStepSeconds), step);
    put(player, body);
    if (way.stoppedX) player.velocityX = 0.0;
    if (way.stoppedY) player.velocityY = 0.0;
    if (way.slip != 0 && !way.stoppedX && !way.stoppedY) {
        player.velocityX = 0.5 * (player.velocityX + way.slip * player.velocityY);
        player.velocityY = way.slip * player.velocityX;
    }
    return way;
}

// Moves up or down (negative) by `distance`. False if something stopped the body earlier.
bool rise(const World& world, Player& player, Coordinate distance) {
    Traveller body = travellerOf(player);
    const bool arrived = rise(world, body, distance);
    put(player, body);
    return arrived;
}

// True if there is room to stand with the feet at a height without moving the eye.
bool canStand(const World& world, const Player& player, Coordinate feet) {
    Traveller body = travellerOf(player);
    body.box = bodyBox(player.x, player.y, feet, kStandingHeight);
    return isFree(world, body);
}

void crouchOrStand(const World& world, Player& player, bool crouch) {
    if (crouch == player.crouched) return;
    if (!crouch && !canStand(world, player, player.z)) return;
    player.crouched = crouch;
    player.eyeLag = crouch ? player.eyeLag + kEyeDrop : player.eyeLag - kEyeDrop;
}

// A press shortly before landing still counts, and so does one shortly after leaving the ground.
// Holding the key does not jump again.
void jumpIfAsked(Player& player, bool pressed) {
    if (pressed && !player.jumpHeld) player.earlyJumpSteps = kEarlyJumpSteps;
    player.jumpHeld = pressed;
    if (player.onGround) player.lateJumpSteps = kLateJumpSteps;
    if (player.earlyJumpSteps > 0 && player.lateJumpSteps > 0) {
        player.earlyJumpSteps = 0;
        player.lateJumpSteps = 0;
        player.velocityZ = kJumpSpeed;
        player.onGround = false;
        return;
    }
    player.earlyJumpSteps = std::max(0, player.earlyJumpSteps - 1);
    player.lateJumpSteps = std::max(0, player.lateJumpSteps - 1);
}

// Steps down as far as kStepHeight; where the ground lies deeper, the body starts to fall.
void followGround(const World& world, Player& player) {
    Traveller body = travellerOf(player);
    body.box = moved(body.box, {.x = {}, .y = {}, .z = sweepZ(world, body, {-kStepHeight.raw})});
    if (isSupported(world, body)) {
        put(player, body);
    } else {
        player.onGround = false;
        player.velocityZ = 0.0;
    }
}

void fall(const World& world, Player& player) {
    const double distance = (player.velocityZ - 0.5 * kGravity * kStepSeconds) * kStepSeconds;
    player.velocityZ = std::max(player.velocityZ - kGravity * kStepSeconds, -kGreatestFall);
    if (!rise(world, player, toCoordinate(distance))) {
        player.onGround = distance < 0.0;
        player.velocityZ = 0.0;
    }
}

void walk(const World& world, Player& player, const PlayerInput& wish) {
    crouchOrStand(world, player, wish.fly < 0.0);
    jumpIfAsked(player, wish.jump);

    const double deep = waterDepth(world, travellerOf(player)).value() / kSwimDepth.value();
    const double speed = kWalkingPace.move * gear(kWalkingPace, wish) * wish.speed *
                         (player.crouched ? kCrouchedPace : 1.0) *
                         (1.0 - (1.0 - kWadingPace) * std::min(deep, 1.0));
    const Vector target = wishedVelocity(player, wish, speed);
    const bool resting = target.x == 0.0 && target.y == 0.0;
    const double acceleration = player.onGround ? (resting ? kGroundBraking : kGroundAcceleration)
                                                : (resting ? kAirBraking : kAirAcceleration);
    const Fall downhill = player.onGround ? fallOf(world, travellerOf(player)) : Fall{};
    const double steepness = downhill.x * downhill.x + downhill.y * downhill.y;  // squared
    const Vector velocity =
        approach({player.velocityX, player.velocityY}, target,
                 (steepness > 0.0 ? kAirBraking : acceleration) * wish.speed * kStepSeconds);
    player.velocityX = velocity.x;
    player.velocityY = velocity.y;
    if (steepness > 0.0) {  // gravity acts along the slope
        const double pull = kGravity * kStepSeconds / (1.0 + steepness);
        player.velocityX += pull * downhill.x;
        player.velocityY += pull * downhill.y;
    }

    slidePlayer(world, player, player.onGround ? kStepHeight : Coordinate{0});
    if (player.onGround) followGround(world, player);
    if (!player.onGround) fall(world, player);
}

void chooseFlyingVelocity(Player& player, const PlayerInput& wish) {
    const double factor = gear(kFlyingPace, wish) * wish.speed;
    const double speed = kFlyingPace.move * factor;
    const double now =
        std::sqrt(player.velocityX * player.velocityX + player.velocityY * player.velocityY);
    const Vector velocity =
        approach({player.velocityX, player.velocityY}, wishedVelocity(player, wish, speed),
                 std::max(speed, now) * kFlyingResponse * kStepSeconds);
    player.velocityX = velocity.x;
    player.velocityY = velocity.y;
    player.velocityZ = respond(player.velocityZ, wish.fly * kFlyingPace.rise * factor,
                               kFlyingPace.rise * factor, kFlyingResponse);
}

void fly(const World& world, Player& player) {
    slidePlayer(world, player, {});
    if (!rise(world, player, toCoordinate(player.velocityZ * kStepSeconds))) player.velocityZ = 0.0;
}

// Moves a stuck body, which nothing stops.
void drift(Player& player) {
    player.x = toCoordinate(player.x.value() + player.velocityX * kStepSeconds);
    player.y = toCoordinate(player.y.value() + player.velocityY * kStepSeconds);
    player.z = std::max(toCoordinate(player.z.value() + player.velocityZ * kStepSeconds),
                        kLowestEye - kCrouchedEye);
    player.eyeLag = {};
    player.eyeLagRate = 0.0;
    player.behind = {};
}

// Starts `mode`, flying or swimming: the body becomes a low one around the eye, which stays where
// it is. The low body needs no space beyond that of the old body and its eye.
void shrinkToEye(Player& player, bool Player::*mode) {
    const Coordinate eye = eyeHeight(player);
    player.z = std::max(player.z, eye - kCrouchedEye);
    player.flying = player.swimming = player.crouched = false;
    player.*mode = true;
    player.onGround = false;
    player.eyeLag = eye - player.z - kCrouchedEye;
}

// The same for a body that is free. Just after the eye has passed a portal, there may be no room
// around it: then the body stays, and the eye comes down to it.
void bringBodyToEye(const World& world, Player& player, bool Player::*mode) {
    const Coordinate feet = player.z;
    shrinkToEye(player, mode);
    if (isFree(world, travellerOf(player))) return;
    const Coordinate eye = eyeHeight(player);
    player.z = feet;
    player.eyeLag = eye - feet - kCrouchedEye;
    moveEyeTo(world, player, {});
}

// Frees a body whose lower part is in something, if the eye is above that.
bool riseAroundEye(const World& world, Player& player) {
    Player risen = player;
    const Coordinate up = leastRise(world, player.map, bodyBox(player), kCrouchedEye - kLowestEye)
                              .value_or(Coordinate{});
    risen.z = player.z + up;
    risen.eyeLag = player.eyeLag - up;
    if (!isFree(world, travellerOf(risen))) return false;
    player = risen;
    return true;
}

// Ends flying or swimming: extends the legs by at most `mostLegs`, as far as there is room, and
// crouches if the player cannot stand there. The eye stays where it is.
void standUp(const World& world, Player& player, Coordinate mostLegs) {
    const Coordinate eye = eyeHeight(player);
    const Coordinate legs = sweepZ(world, travellerOf(player), {-mostLegs.raw});
    player.crouched = !canStand(world, player, player.z + legs);
    if (!player.crouched) player.z = player.z + legs;
    player.flying = player.swimming = false;
    player.earlyJumpSteps = 0;
    player.lateJumpSteps = 0;
    player.eyeLag = eye - player.z - eyeAboveFeet(player);
    moveEyeTo(world, player, player.eyeLag);
}

// True if a swimmer can stand up: the ground is close to the surface. `depth` is that of the water
// above the swimmer's feet.
bool reachesGround(const World& world, const Player& player, Coordinate depth) {
    Traveller body = travellerOf(player);
    const Coordinate legs = sweepZ(world, body, {-kEyeDrop.raw});
    if (depth - legs > kStandDepth || !canStand(world, player, player.z + legs)) return false;
    body.box = moved(body.box, {.x = {}, .y = {}, .z = legs});
    return isSupported(world, body);
}

// Starts and stops swimming by the depth of the water.
void swimOrStand(const World& world, Player& player) {
    const Coordinate depth = waterDepth(world, travellerOf(player));
    if (!player.swimming) {
        if (depth <= kSwimDepth) return;
        bringBodyToEye(world, player, &Player::swimming);
        player.bobStep = 0;
    } else if (depth.raw == 0) {
        standUp(world, player, {});
    } else if (reachesGround(world, player, depth)) {
        standUp(world, player, kEyeDrop);
    }
    if (!player.swimming) player.onGround = isSupported(world, travellerOf(player));
}

// The upward speed that gets a swimmer onto a bank, or 0 if there is none. The bank must have
// `stopped` the way along the main direction of `wished`, and be at most `highest` above the feet.
double climbingSpeed(const World& world, const Player& player, Vector wished, Travelled stopped,
                     Coordinate highest) {
    const double x = std::abs(wished.x);
    const double y = std::abs(wished.y);
    const bool slipped = stopped.slip != 0;
    if (!((stopped.stoppedX || slipped) && x > y) && !((stopped.stoppedY || slipped) && y > x))
        return 0.0;
    Traveller climber = travellerOf(player);
    const Coordinate way = kLongestSlide;
    const Travelled climbed =
        x > y ? slide(world, climber, {wished.x < 0.0 ? -way.raw : way.raw}, {}, highest)
              : slide(world, climber, {}, {wished.y < 0.0 ? -way.raw : way.raw}, highest);
    if (climbed.rise.raw == 0) return 0.0;
    constexpr double kToSpare = 0.06;  // units above the bank
    return std::sqrt(2.0 * kGravity * (climbed.rise.value() + kToSpare));
}

void swim(const World& world, Player& player, const PlayerInput& wish) {
    player.jumpHeld = wish.jump;
    const Coordinate surface = player.z + waterDepth(world, travellerOf(player));
    const double factor = gear(kWalkingPace, wish) * wish.speed;

    // Vertical
    player.bobStep = (player.bobStep + 1) % kBobSteps;
    const double bob =
        wish.bob ? kBobHeight * sineCosineDegrees(player.bobStep * (360.0 / kBobSteps)).sine : 0.0;
    const Coordinate eye = eyeHeight(player);
    const double up = std::min(wish.fly + (wish.jump ? 1.0 : 0.0), 1.0) * kSwimRise * factor;
    const double toFloat = kFloating * ((surface + kFloatingEye - eye).value() + bob);
    const double target = up < 0.0 ? up : within(toFloat, -kSwimRise, std::max(up, kBuoyancy), 0.0);
    player.velocityZ =
        respond(player.velocityZ, target, std::max(kSwimRise, std::abs(up)), kSwimResponse);

    // Horizontal
    const Vector wished = wishedVelocity(player, wish, kWalkingPace.move * kSwimmingPace * factor);
    const Vector velocity = approach({player.velocityX, player.velocityY}, wished,
                                     kWalkingPace.move * factor * kSwimResponse * kStepSeconds);
    player.velocityX = velocity.x;
    player.velocityY = velocity.y;
    // The eye follows low steps smoothly; a higher bank is climbed.
    const Coordinate lowStep = {std::max(0, (eye - player.z - kLowestEye).raw)};
    const Player before = player;
    const Travelled way = slidePlayer(world, player, lowStep);
    if (eye >= surface && up >= 0.0 && way.rise.raw == 0 && player.leaps == before.leaps) {
        const double climb =
            climbingSpeed(world, before, wished, way, surface + kClimbOut - before.z);
        if (climb > 0.0) player.velocityZ = std::max(player.velocityZ, climb);
    }
    if (!rise(world, player, toCoordinate(player.velocityZ * kStepSeconds))) player.velocityZ = 0.0;
}

}  // namespace

Box bodyBox(Coordinate x, Coordinate y, Coordinate feet, Coordinate height) {
    return {x - kBodyHalfWidth, x + kBodyHalfWidth, y - kBodyHalfWidth, y + kBodyHalfWidth, feet,
            feet + height};
}

Box bodyBox(const Player& player) {
    return bodyBox(
        player.x, player.y, player.z,
        player.flying || player.swimming || player.crouched ? kCrouchedHeight : kStandingHeight);
}

Traveller travellerOf(const Player& player) {
    return {.map = player.map,
            .box = bodyBox(player),
            .eye = {player.x, player.y, eyeHeight(player)},
            .behind = player.behind};
}

bool fitsStanding(const World& world, int map, Coordinate x, Coordinate y, Coordinate feet) {
    return isFree(world, {.map = map,
                          .box = bodyBox(x, y, feet, kStandingHeight),
                          .eye = {x, y, feet + kStandingEye},
                          .behind = {}});
}

Coordinate eyeHeight(const Player& player) {
    return player.z + eyeAboveFeet(player) + player.eyeLag;
}

Player playerAtStart(const World& world) {
    const Start& start = world.start;
    Player player;
    player.map = start.map;
    player.x = start.x;
    player.y = start.y;
    player.z = start.z;
    player.crouched = !fitsStanding(world, start.map, start.x, start.y, start.z);
    setHeading(player, start.headingDegrees);
    player.look = within(start.look, -kLookLimit, kLookLimit, 0.0);
    const Traveller body = travellerOf(player);
    if (isFree(world, body)) {
        player.onGround = isSupported(world, body);
    } else {
        player.crouched = false;
        player.flying = true;
    }
    return player;
}

Player playerWithEye(int map, Coordinate x, Coordinate y, Coordinate eyeZ, double headingDegrees,
                     double look) {
    Player player;
    player.map = map;
    player.x = x;
    player.y = y;
    player.z = eyeZ - kCrouchedEye;
    player.flying = true;
    setHeading(player, headingDegrees);
    player.look = look;
    return player;
}

void stepPlayer(const World& world, Player& player, const PlayerInput& input) {
    const PlayerInput wish = withinRanges(input);
    turnAndLook(player, wish);
    const bool free = isFree(world, travellerOf(player));
    if (free && !player.flying) {
        swimOrStand(world, player);
        player.swimming ? swim(world, player, wish) : walk(world, player, wish);
    } else {
        player.jumpHeld = wish.jump;
        if (!player.flying) shrinkToEye(player, &Player::flying);
        chooseFlyingVelocity(player, wish);
        if (!free) return drift(player);
        fly(world, player);
    }
    easeEye(world, player);
}

void nudge(const World& world, Player& player, Coordinate x, Coordinate y) {
    Traveller body = travellerOf(player);
    if (!isFree(world, body)) return;
    slide(world, body, x, y, player.onGround ? kStepHeight : Coordinate{0});
    put(player, body);
}

void setFlying(const World& world, Player& player, bool flying) {
    if (flying == player.flying) return;
    const bool isFreeNow = isFree(world, travellerOf(player));
    if (flying) {
        if (isFreeNow) {
            bringBodyToEye(world, player, &Player::flying);
        } else {
            shrinkToEye(player, &Player::flying);
        }
        player.velocityZ = 0.0;
        return;
    }
    if (!isFreeNow && !riseAroundEye(world, player)) return;
    bringBodyToEye(world, player, &Player::flying);
    standUp(world, player, kEyeDrop);
}

void levelLook(const World& world, Player& player) {
    player.look = 0.0;
    player.lookRate = 0.0;
    if (!player.flying || !isFree(world, travellerOf(player))) return;
    player.velocityZ = 0.0;
    player.eyeLagRate = 0.0;
    moveEyeTo(world, player, {});
    // Down to the ground, or onto the water below; a body that is in water sinks through it.
    Traveller body = travellerOf(player);
    body.floats = true;
    body.floats = isFree(world, body);
    rise(world, body, {-kMaxBodyHeight.raw});
    put(player, body);
    rise(world, player, kEyeDrop);
}

void setHeading(Player& player, double degrees) {
    player.headingDegrees = std::isfinite(degrees) ? wrapDegrees(degrees) : 0.0;
    player.turnRate = 0.0;
}

}  // namespace slicecast
