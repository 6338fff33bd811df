#include "world/object_motion.h"

#include "base/angle.h"
#include "base/hash.h"
#include "world/collision.h"
#include "world/player.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr int kShortestWay = kStepsPerSecond / 2;  // steps that a wanderer goes one way
constexpr int kLongestWay = kStepsPerSecond * 4;
constexpr double kWidestTurn = 70.0;  // degrees, at the end of a way
constexpr double kTurnAtLedge = 60.0;  // to either side of straight back
constexpr Coordinate kFallPerStep = toCoordinate(kGravity * kStepSeconds * kStepSeconds);
constexpr Coordinate kFastestFall = toCoordinate(kGreatestFall * kStepSeconds);
constexpr double kPhases = 4294967296.0;  // of a turn
constexpr double kPi = 3.14159265358979323846;

Object& movedObject(World& world, const ObjectMotion& motion) {
    return world.maps[static_cast<std::size_t>(motion.map)].objects[static_cast<std::size_t>(motion.object)];
}

Coordinate middle(Coordinate low, Coordinate high) {
    return {low.raw + (high.raw - low.raw) / 2};
}

void putBody(Object& object, const Box& box) {
    object.x = middle(box.west, box.east);
    object.y = middle(box.north, box.south);
    object.z = box.bottom;
}

void face(ObjectMotion& motion, double degrees) {
    motion.headingDegrees = wrapDegrees(degrees);
    const SineCosine heading = sineCosineDegrees(motion.headingDegrees);
    motion.wayX = toCoordinate(heading.cosine * motion.speed * kStepSeconds);
    motion.wayY = toCoordinate(heading.sine * motion.speed * kStepSeconds);
}

// A step of a body on the ground.
struct Walk {
    Box box;
    bool stoppedX = false;
    bool stoppedY = false;
    bool ledge = false;  // it would have gone over one, and has not
};

// Where a body comes to rest on the ground, if there is any within a step below it.
bool comeDown(const World& world, int map, Box& box) {
    const Coordinate drop = sweepZ(world, map, box, {-kStepHeight.raw});
    const Box down = moved(box, {.x = {}, .y = {}, .z = drop});
    if (drop.raw == -kStepHeight.raw && !isSupported(world, map, down)) return false;
    box = down;
    return true;
}

// Straight down.
void fall(const World& world, ObjectMotion& motion, Object& object) {
    motion.fallen = std::min(motion.fallen + kFallPerStep, kFastestFall);
    const Coordinate drop = sweepZ(world, motion.map, objectBody(object), {-motion.fallen.raw});
    motion.onGround = drop.raw > -motion.fallen.raw;
    if (motion.onGround) motion.fallen = {};
    object.z = object.z + drop;
}

// One step sideways and, over stairs, up or down. What has lost the ground under its feet begins to fall.
Walk walk(const World& world, ObjectMotion& motion, const Box& box, Coordinate x, Coordinate y) {
    const Slide way = slide(world, motion.map, box, x, y, kStepHeight);
    Walk result = {.box = way.box, .stoppedX = way.stoppedX, .stoppedY = way.stoppedY};
    if (comeDown(world, motion.map, result.box)) return result;
    result = {.box = box};
    motion.onGround = comeDown(world, motion.map, result.box);
    result.ledge = motion.onGround;
    return result;
}

bool isOutward(Coordinate from, Coordinate way, Coordinate reach) {
    return reach.raw > 0 && (way.raw > 0 ? from > reach : way.raw < 0 && from.raw < -reach.raw);
}

void wander(const World& world, ObjectMotion& motion, Object& object) {
    if (!motion.onGround) return fall(world, motion, object);
    if (--motion.steps <= 0) {
        motion.steps = motion.random.between(kShortestWay, kLongestWay);
        face(motion, motion.headingDegrees + motion.random.between(-kWidestTurn, kWidestTurn));
    }
    const Walk way = walk(world, motion, objectBody(object), motion.wayX, motion.wayY);
    putBody(object, way.box);
    if (way.ledge) {
        face(motion, motion.headingDegrees + 180.0 + motion.random.between(-kTurnAtLedge, kTurnAtLedge));
        return;
    }
    if (way.stoppedX || isOutward(object.x - motion.homeX, motion.wayX, motion.reach)) face(motion, 180.0 - motion.headingDegrees);
    if (way.stoppedY || isOutward(object.y - motion.homeY, motion.wayY, motion.reach)) face(motion, -motion.headingDegrees);
}

void turnBack(ObjectMotion& motion) {
    motion.back = !motion.back;
    motion.headingDegrees = wrapDegrees(motion.headingDegrees + 180.0);
}

void pace(const World& world, ObjectMotion& motion, Object& object) {
    if (!motion.onGround) return fall(world, motion, object);
    const Box box = objectBody(object);
    const int sign = motion.back ? -1 : 1;
    const Walk way = walk(world, motion, box, {sign * motion.wayX.raw}, {sign * motion.wayY.raw});
    if (way.stoppedX || way.stoppedY || way.ledge) {
        // It keeps to its line, whatever it came along sideways.
        Box here = box;
        comeDown(world, motion.map, here);
        putBody(object, here);
        turnBack(motion);
        return;
    }
    putBody(object, way.box);
    if (!motion.onGround) return;
    motion.steps += sign;
    const double length = motion.steps * motion.speed * kStepSeconds;
    if (motion.back ? motion.steps <= 0 : length >= motion.reach.value()) turnBack(motion);
}

GroundPoint onCircle(GroundPoint centre, Coordinate radius, std::uint32_t phase) {
    const SineCosine at = sineCosineDegrees(phase * (360.0 / kPhases));
    return {toCoordinate(centre.x.value() + radius.value() * at.cosine), toCoordinate(centre.y.value() + radius.value() * at.sine)};
}

// Of one that flies clockwise along that heading.
std::uint32_t phaseOf(double headingDegrees) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(wrapDegrees(headingDegrees - 90.0) / 360.0 * kPhases));
}

void faceAlongCircle(ObjectMotion& motion) {
    motion.headingDegrees = wrapDegrees(motion.phase * (360.0 / kPhases) + (motion.back ? -90.0 : 90.0));
}

void circle(const World& world, ObjectMotion& motion, Object& object) {
    const double turns = motion.speed * kStepSeconds / (2.0 * kPi * motion.reach.value());
    const auto turned = static_cast<std::uint32_t>(std::min(turns, 0.25) * kPhases);
    const std::uint32_t phase = motion.back ? motion.phase - turned : motion.phase + turned;
    const GroundPoint next = onCircle({motion.homeX, motion.homeY}, motion.reach, phase);
    const Slide way = slide(world, motion.map, objectBody(object), next.x - object.x, next.y - object.y, {});
    if (way.stoppedX || way.stoppedY) {
        motion.back = !motion.back;
    } else {
        putBody(object, way.box);
        motion.phase = phase;
    }
    faceAlongCircle(motion);
}

}  // namespace

Box objectBody(const Object& object) {
    const Coordinate half = {std::clamp(object.width, kNarrowestBody, kWidestBody).raw / 2};
    return {object.x - half, object.x + half, object.y - half, object.y + half, object.z, object.z + object.height};
}

GroundPoint beginning(const ObjectMotion& motion, GroundPoint put) {
    return motion.kind == ObjectMotion::Kind::circle ? onCircle(put, motion.reach, phaseOf(motion.headingDegrees)) : put;
}

void startObjects(World& world) {
    MovingObjects& moving = world.movingObjects;
    if (moving.motions.empty()) return;
    for (ObjectMotion& motion : moving.motions) {
        Object& object = movedObject(world, motion);
        motion.homeX = object.x;
        motion.homeY = object.y;
        const GroundPoint begins = beginning(motion, {object.x, object.y});
        object.x = begins.x;
        object.y = begins.y;
        if (motion.kind == ObjectMotion::Kind::circle) {
            motion.phase = phaseOf(motion.headingDegrees);
            faceAlongCircle(motion);
        } else {
            face(motion, motion.headingDegrees);
            if (motion.kind == ObjectMotion::Kind::wander) motion.steps = motion.random.between(kShortestWay, kLongestWay);
            motion.onGround = isSupported(world, motion.map, objectBody(object));
        }
    }
    moving.motionsAtStart = moving.motions;
    moving.objectsAtStart.clear();
    for (const Map& map : world.maps) moving.objectsAtStart.push_back(map.objects);
}

void stepObjects(World& world) {
    for (ObjectMotion& motion : world.movingObjects.motions) {
        Object& object = movedObject(world, motion);
        switch (motion.kind) {
            case ObjectMotion::Kind::wander:
                wander(world, motion, object);
                break;
            case ObjectMotion::Kind::pace:
                pace(world, motion, object);
                break;
            case ObjectMotion::Kind::circle:
                circle(world, motion, object);
                break;
        }
    }
}

void resetObjects(World& world) {
    MovingObjects& moving = world.movingObjects;
    moving.motions = moving.motionsAtStart;
    for (std::size_t i = 0; i < moving.objectsAtStart.size(); ++i) world.maps[i].objects = moving.objectsAtStart[i];
}

void addMovingObjects(Hash& hash, const World& world) {
    for (const ObjectMotion& motion : world.movingObjects.motions) {
        const Object& object = world.maps[static_cast<std::size_t>(motion.map)].objects[static_cast<std::size_t>(motion.object)];
        Random next = motion.random;
        for (const std::int64_t number :
             {std::int64_t{motion.map}, std::int64_t{motion.object}, std::int64_t{object.x.raw}, std::int64_t{object.y.raw}, std::int64_t{object.z.raw},
              std::int64_t{motion.wayX.raw}, std::int64_t{motion.wayY.raw}, std::int64_t{motion.fallen.raw}, std::int64_t{motion.onGround},
              std::int64_t{motion.back}, std::int64_t{motion.steps}, std::int64_t{motion.phase}, static_cast<std::int64_t>(next.next())}) {
            hash.add(number);
        }
        hash.add(motion.headingDegrees);
    }
}

}  // namespace slicecast
