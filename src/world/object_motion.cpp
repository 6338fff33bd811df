#include "world/object_motion.h"

#include "base/angle.h"
#include "base/hash.h"
#include "world/body.h"
#include "world/player.h"
#include "world/traveller.h"
#include "world/water.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr int kShortestWay = kStepsPerSecond / 2;  // steps for which a wanderer keeps its heading
constexpr int kLongestWay = kStepsPerSecond * 4;
constexpr double kWidestTurn = 70.0;   // degrees, at each change of heading
constexpr double kTurnAtLedge = 60.0;  // degrees to either side of straight back
constexpr Coordinate kFallPerStep = toCoordinate(kGravity * kStepSeconds * kStepSeconds);
constexpr Coordinate kFastestFall = toCoordinate(kGreatestFall * kStepSeconds);
constexpr double kPhases = 4294967296.0;  // per turn
constexpr double kPi = 3.14159265358979323846;

Object& movedObject(World& world, const ObjectMotion& motion) {
    return world.maps[static_cast<std::size_t>(motion.map)]
        .objects[static_cast<std::size_t>(motion.object)];
}

Traveller travellerOf(const ObjectMotion& motion, const Object& object) {
    return {.map = motion.map,
            .box = objectBody(object),
            .eye = {object.x, object.y, object.z + motion.eye},
            .behind = motion.behind,
            .floats = object.floats};
}

// True if the water has become too deep for a walker: deeper than half its height.
bool isTooDeep(const World& world, const Object& object, const Traveller& before,
               const Traveller& body) {
    const Coordinate depth = waterDepth(world, body);
    return depth.raw > object.height.raw / 2 && depth > waterDepth(world, before);
}

// Moves an object from its map's list to the end of another map's; the others keep their order.
void changeMap(World& world, ObjectMotion& motion, int map) {
    std::vector<Object>& from = world.maps[static_cast<std::size_t>(motion.map)].objects;
    std::vector<Object>& to = world.maps[static_cast<std::size_t>(map)].objects;
    to.push_back(from[static_cast<std::size_t>(motion.object)]);
    from.erase(from.begin() + motion.object);
    for (ObjectMotion& other : world.movingObjects.motions) {
        if (other.map == motion.map && other.object > motion.object) --other.object;
    }
    motion.map = map;
    motion.object = static_cast<int>(to.size()) - 1;
}

// Puts the object where its body has arrived after moving by `way`. Portals turn everything that
// has a direction.
void put(World& world, ObjectMotion& motion, const Traveller& body, GroundPoint way) {
    Object& object = movedObject(world, motion);
    GroundPoint fromHome = {object.x + way.x - motion.homeX, object.y + way.y - motion.homeY};
    object.x = body.eye.x;
    object.y = body.eye.y;
    object.z = body.box.bottom;
    motion.eye = body.eye.z - body.box.bottom;
    motion.behind = body.behind;
    if (body.leaps == 0) return;
    turnArrow(body.turn, fromHome.x, fromHome.y);
    turnArrow(body.turn, motion.wayX, motion.wayY);
    motion.homeX = object.x - fromHome.x;
    motion.homeY = object.y - fromHome.y;
    motion.headingDegrees = wrapDegrees(motion.headingDegrees + 90.0 * body.turn);
    motion.phase += static_cast<std::uint32_t>(body.turn) << 30;
    if (body.map != motion.map) changeMap(world, motion, body.map);
}

void face(ObjectMotion& motion, double degrees) {
    motion.headingDegrees = wrapDegrees(degrees);
    const SineCosine heading = sineCosineDegrees(motion.headingDegrees);
    motion.wayX = toCoordinate(heading.cosine * motion.speed * kStepSeconds);
    motion.wayY = toCoordinate(heading.sine * motion.speed * kStepSeconds);
}

// Raises or lowers the eye to half height after a step up or down.
void straighten(const World& world, const Object& object, Traveller& body) {
    const Coordinate lag = body.box.bottom + Coordinate{object.height.raw / 2} - body.eye.z;
    if (lag.raw != 0) moveEye(world, body, lag);
}

// Puts a body onto the ground, if there is any within a step below it.
bool comeDown(const World& world, Traveller& body) {
    const Coordinate drop = sweepZ(world, body, {-kStepHeight.raw});
    const Box above = body.box;
    body.box = moved(above, {.x = {}, .y = {}, .z = drop});
    if (drop.raw > -kStepHeight.raw || isSupported(world, body)) return true;
    body.box = above;
    return false;
}

// Falls straight down.
void fall(World& world, ObjectMotion& motion) {
    Traveller body = travellerOf(motion, movedObject(world, motion));
    motion.fallen = std::min(motion.fallen + kFallPerStep, kFastestFall);
    motion.onGround = !rise(world, body, {-motion.fallen.raw});
    if (motion.onGround) motion.fallen = {};
    put(world, motion, body, {});
}

// The result of a step.
struct Step {
    bool stoppedX = false;
    bool stoppedY = false;
    int slip = 0;          // see Slide
    bool refused = false;  // not moved: at a ledge, or pushed off its line
};

// One step sideways and, over stairs, up or down. Starts to fall if the ground is lost.
Step walk(World& world, ObjectMotion& motion, GroundPoint way) {
    const Object& object = movedObject(world, motion);
    const Traveller before = travellerOf(motion, object);
    Traveller body = before;
    const Travelled done = slide(world, body, way.x, way.y, kStepHeight);
    Step step = {.stoppedX = done.stoppedX, .stoppedY = done.stoppedY, .slip = done.slip};
    // A pacer keeps to its line. A wanderer with a limited reach must pass a portal on a straight
    // way, because its home moves by the same way.
    const bool straight =
        motion.kind == ObjectMotion::Kind::pace || (body.leaps > 0 && motion.reach.raw > 0);
    const bool isAside = step.stoppedX || step.stoppedY || step.slip != 0;
    step.refused =
        (straight && isAside) || !comeDown(world, body) || isTooDeep(world, object, before, body);
    if (step.refused) {
        body = before;
        motion.onGround = comeDown(world, body);
    }
    straighten(world, object, body);
    put(world, motion, body, step.refused ? GroundPoint{} : way);
    return step;
}

bool isOutward(Coordinate from, Coordinate way, Coordinate reach) {
    return reach.raw > 0 && (way.raw > 0 ? from > reach : way.raw < 0 && from.raw < -reach.raw);
}

void wander(World& world, ObjectMotion& motion) {
    if (!motion.onGround) return fall(world, motion);
    if (--motion.steps <= 0) {
        motion.steps = motion.random.between(kShortestWay, kLongestWay);
        face(motion, motion.headingDegrees + motion.random.between(-kWidestTurn, kWidestTurn));
    }
    const Step step = walk(world, motion, {motion.wayX, motion.wayY});
    if (step.refused) {
        face(motion,
             motion.headingDegrees + 180.0 + motion.random.between(-kTurnAtLedge, kTurnAtLedge));
        return;
    }
    // Back from a cut as from a mirror
    if (step.slip != 0) face(motion, (step.slip > 0 ? 90.0 : 270.0) - motion.headingDegrees);
    const Object& object = movedObject(world, motion);
    if (step.stoppedX || isOutward(object.x - motion.homeX, motion.wayX, motion.reach))
        face(motion, 180.0 - motion.headingDegrees);
    if (step.stoppedY || isOutward(object.y - motion.homeY, motion.wayY, motion.reach))
        face(motion, -motion.headingDegrees);
}

void turnBack(ObjectMotion& motion) {
    motion.back = !motion.back;
    motion.headingDegrees = wrapDegrees(motion.headingDegrees + 180.0);
}

void pace(World& world, ObjectMotion& motion) {
    if (!motion.onGround) return fall(world, motion);
    const int sign = motion.back ? -1 : 1;
    if (walk(world, motion, {{sign * motion.wayX.raw}, {sign * motion.wayY.raw}}).refused)
        return turnBack(motion);
    motion.steps += sign;
    const double length = motion.steps * motion.speed * kStepSeconds;
    if (motion.back ? motion.steps <= 0 : length >= motion.reach.value()) turnBack(motion);
}

GroundPoint onCircle(GroundPoint centre, Coordinate radius, std::uint32_t phase) {
    const SineCosine at = sineCosineDegrees(phase * (360.0 / kPhases));
    return {toCoordinate(centre.x.value() + radius.value() * at.cosine),
            toCoordinate(centre.y.value() + radius.value() * at.sine)};
}

// The phase of an object that flies clockwise along this heading.
std::uint32_t phaseOf(double headingDegrees) {
    return static_cast<std::uint32_t>(
        static_cast<std::int64_t>(wrapDegrees(headingDegrees - 90.0) / 360.0 * kPhases));
}

void faceAlongCircle(ObjectMotion& motion) {
    motion.headingDegrees =
        wrapDegrees(motion.phase * (360.0 / kPhases) + (motion.back ? -90.0 : 90.0));
}

void circle(World& world, ObjectMotion& motion) {
    const Object& object = movedObject(world, motion);
    const double turns = motion.speed * kStepSeconds / (2.0 * kPi * motion.reach.value());
    const auto turned = static_cast<std::uint32_t>(std::min(turns, 0.25) * kPhases);
    const std::uint32_t phase = motion.back ? motion.phase - turned : motion.phase + turned;
    const GroundPoint next = onCircle({motion.homeX, motion.homeY}, motion.reach, phase);
    const GroundPoint way = {next.x - object.x, next.y - object.y};
    Traveller body = travellerOf(motion, object);
    const Travelled done = slide(world, body, way.x, way.y, {});
    if (done.stoppedX || done.stoppedY || done.slip != 0) {
        motion.back = !motion.back;
    } else {
        motion.phase = phase;
        put(world, motion, body, way);
    }
    faceAlongCircle(motion);
}

}  // namespace

Box objectBody(const Object& object) {
    const Coordinate half = {std::clamp(object.width, kNarrowestBody, kWidestBody).raw / 2};
    return {object.x - half, object.x + half, object.y - half,
            object.y + half, object.z,        object.z + object.height};
}

GroundPoint beginning(const ObjectMotion& motion, GroundPoint put) {
    return motion.kind == ObjectMotion::Kind::circle
               ? onCircle(put, motion.reach, phaseOf(motion.headingDegrees))
               : put;
}

void startObjects(World& world) {
    floatObjects(world);
    MovingObjects& moving = world.movingObjects;
    if (moving.motions.empty()) return;
    for (ObjectMotion& motion : moving.motions) {
        Object& object = movedObject(world, motion);
        motion.homeX = object.x;
        motion.homeY = object.y;
        motion.eye = {object.height.raw / 2};
        motion.behind = {};
        const GroundPoint begins = beginning(motion, {object.x, object.y});
        object.x = begins.x;
        object.y = begins.y;
        if (motion.kind == ObjectMotion::Kind::circle) {
            motion.phase = phaseOf(motion.headingDegrees);
            faceAlongCircle(motion);
        } else {
            face(motion, motion.headingDegrees);
            if (motion.kind == ObjectMotion::Kind::wander)
                motion.steps = motion.random.between(kShortestWay, kLongestWay);
            motion.onGround = isSupported(world, travellerOf(motion, object));
        }
    }
    moving.motionsAtStart = moving.motions;
    moving.objectsAtStart.clear();
    for (Map& map : world.maps) {
        moving.objectsAtStart.push_back(map.objects);
        if (!world.portals.empty())
            // Room for visitors through portals
            map.objects.reserve(map.objects.size() + moving.motions.size());
    }
}

void stepObjects(World& world) {
    for (ObjectMotion& motion : world.movingObjects.motions) {
        switch (motion.kind) {
            case ObjectMotion::Kind::wander:
                wander(world, motion);
                break;
            case ObjectMotion::Kind::pace:
                pace(world, motion);
                break;
            case ObjectMotion::Kind::circle:
                circle(world, motion);
                break;
        }
    }
}

void resetObjects(World& world) {
    MovingObjects& moving = world.movingObjects;
    moving.motions = moving.motionsAtStart;
    for (std::size_t i = 0; i < moving.objectsAtStart.size(); ++i)
        world.maps[i].objects = moving.objectsAtStart[i];
}

void addBodies(const World& world, std::vector<Body>& bodies) {
    for (const ObjectMotion& motion : world.movingObjects.motions) {
        const Object& object = world.maps[static_cast<std::size_t>(motion.map)]
                                   .objects[static_cast<std::size_t>(motion.object)];
        bodies.push_back(bodyOf(travellerOf(motion, object), motion.onGround));
    }
}

void liftObjects(World& world, std::span<const Body> bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Object& object = movedObject(world, world.movingObjects.motions[i]);
        object.x = object.x + bodies[i].shift.x;
        object.y = object.y + bodies[i].shift.y;
        object.z = object.z + bodies[i].shift.z;
    }
}

void addMovingObjects(Hash& hash, const World& world) {
    for (const ObjectMotion& motion : world.movingObjects.motions) {
        const Object& object = world.maps[static_cast<std::size_t>(motion.map)]
                                   .objects[static_cast<std::size_t>(motion.object)];
        Random next = motion.random;
        for (const std::int64_t number :
             {std::int64_t{motion.map}, std::int64_t{motion.object}, std::int64_t{object.x.raw},
              std::int64_t{object.y.raw}, std::int64_t{object.z.raw}, std::int64_t{motion.wayX.raw},
              std::int64_t{motion.wayY.raw}, std::int64_t{motion.fallen.raw},
              std::int64_t{motion.onGround}, std::int64_t{motion.back}, std::int64_t{motion.steps},
              std::int64_t{motion.phase}, static_cast<std::int64_t>(next.next()),
              std::int64_t{motion.homeX.raw}, std::int64_t{motion.homeY.raw},
              std::int64_t{motion.eye.raw}, std::int64_t{motion.behind.isOn},
              static_cast<std::int64_t>(motion.behind.side),
              std::int64_t{motion.behind.height.raw}}) {
            hash.add(number);
        }
        hash.add(motion.headingDegrees);
    }
}

}  // namespace slicecast
