#include "world/object_motion.h"

#include "base/angle.h"
#include "base/hash.h"
#include "world/body.h"
#include "world/crowd.h"
#include "world/object_behaviour.h"
#include "world/object_walk.h"
#include "world/player.h"
#include "world/water.h"
#include "world/world.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr int kShortestWay = kStepsPerSecond / 2;  // steps for which a wanderer keeps its heading
constexpr int kLongestWay = kStepsPerSecond * 4;
constexpr double kWidestTurn = 70.0;      // degrees, at each change of heading
constexpr double kTurnAtLedge = 60.0;     // degrees to either side of straight back
constexpr double kPhases = 4294967296.0;  // per turn
constexpr std::size_t kUsualVisitors = 256;
constexpr double kPi = 3.14159265358979323846;

bool isOutward(Coordinate from, Coordinate way, Coordinate reach) {
    return reach.raw > 0 && (way.raw > 0 ? from > reach : way.raw < 0 && from.raw < -reach.raw);
}

void wander(World& world, ObjectMotion& motion) {
    if (!motion.onGround) return fall(world, motion);
    if (--motion.steps <= 0) {
        motion.steps = motion.random.between(kShortestWay, kLongestWay);
        face(world, motion,
             motion.headingDegrees + motion.random.between(-kWidestTurn, kWidestTurn));
    }
    const WalkStep step =
        walk(world, motion, besideOthers(world, motion, {motion.wayX, motion.wayY}));
    if (step.refused) {
        face(world, motion,
             motion.headingDegrees + 180.0 + motion.random.between(-kTurnAtLedge, kTurnAtLedge));
        return;
    }
    // Back from a cut as from a mirror
    if (step.slip != 0) face(world, motion, (step.slip > 0 ? 90.0 : 270.0) - motion.headingDegrees);
    const Object& object = movedObject(world, motion);
    if (step.stoppedX || isOutward(object.x - motion.homeX, motion.wayX, motion.reach))
        face(world, motion, 180.0 - motion.headingDegrees);
    if (step.stoppedY || isOutward(object.y - motion.homeY, motion.wayY, motion.reach))
        face(world, motion, -motion.headingDegrees);
}

void turnBack(World& world, ObjectMotion& motion) {
    motion.back = !motion.back;
    motion.headingDegrees = wrapDegrees(motion.headingDegrees + 180.0);
    setFacing(movedObject(world, motion), motion.headingDegrees);
}

void pace(World& world, ObjectMotion& motion) {
    if (!motion.onGround) return fall(world, motion);
    const int sign = motion.back ? -1 : 1;
    const GroundPoint way = {{sign * motion.wayX.raw}, {sign * motion.wayY.raw}};
    // Keeps to its line, and waits there for others
    const GroundPoint beside = besideOthers(world, motion, way);
    if (beside.x != way.x || beside.y != way.y) {
        walk(world, motion, {});
        return;
    }
    if (walk(world, motion, way).refused) return turnBack(world, motion);
    motion.steps += sign;
    const double length = motion.steps * motion.speed * kStepSeconds;
    if (motion.back ? motion.steps <= 0 : length >= motion.reach.value()) turnBack(world, motion);
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

void faceAlongCircle(World& world, ObjectMotion& motion) {
    motion.headingDegrees =
        wrapDegrees(motion.phase * (360.0 / kPhases) + (motion.back ? -90.0 : 90.0));
    setFacing(movedObject(world, motion), motion.headingDegrees);
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
    faceAlongCircle(world, motion);
}

void moveCalmly(World& world, ObjectMotion& motion) {
    switch (motion.kind) {
        case ObjectMotion::Kind::wander:
            return wander(world, motion);
        case ObjectMotion::Kind::pace:
            return pace(world, motion);
        case ObjectMotion::Kind::circle:
            return circle(world, motion);
        case ObjectMotion::Kind::stand:
            return stand(world, motion);
        case ObjectMotion::Kind::patrol:
            return patrol(world, motion);
    }
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

// Puts a moving object to its beginning, and stores what it needs there.
static void begin(World& world, ObjectMotion& motion) {
    Object& object = movedObject(world, motion);
    motion.homeX = object.x;
    motion.homeY = object.y;
    motion.eye = {object.height.raw / 2};
    motion.behind = {};
    motion.standing = object.sprite;
    const GroundPoint begins = beginning(motion, {object.x, object.y});
    object.x = begins.x;
    object.y = begins.y;
    if (motion.kind == ObjectMotion::Kind::circle) {
        motion.phase = phaseOf(motion.headingDegrees);
        faceAlongCircle(world, motion);
        return;
    }
    face(world, motion, motion.headingDegrees);
    if (motion.kind == ObjectMotion::Kind::wander)
        motion.steps = motion.random.between(kShortestWay, kLongestWay);
    motion.onGround = isSupported(world, travellerOf(motion, object));
}

void startObjects(World& world) {
    floatObjects(world);
    MovingObjects& moving = world.movingObjects;
    if (moving.motions.empty() && world.quest.finds.empty()) return;
    moving.anySolid = false;
    for (std::size_t i = 0; i < moving.motions.size(); ++i) {
        ObjectMotion& motion = moving.motions[i];
        begin(world, motion);
        motion.lookSteps = static_cast<int>(i) % kLookSteps + 1;
        moving.anySolid = moving.anySolid || motion.solid;
    }
    noteObjects(world);
    moving.motionsAtStart = moving.motions;
    moving.gone.reserve(moving.motions.size());
    moving.goneRoom.reserve(moving.motions.size());
    moving.objectsAtStart.clear();
    for (Map& map : world.maps) {
        moving.objectsAtStart.push_back(map.objects);
        if (!world.portals.empty())
            // Room for visitors through portals, as many as hardly ever come
            map.objects.reserve(map.objects.size() +
                                std::min(moving.motions.size(), kUsualVisitors));
    }
}

void stepObjects(World& world, const Body* player) {
    MovingObjects& moving = world.movingObjects;
    if (moving.anySolid) gatherCrowd(world, player);
    for (ObjectMotion& motion : moving.motions) {
        if (!motion.isActor()) {
            moveCalmly(world, motion);
            continue;
        }
        const Object& object = movedObject(world, motion);
        const GroundPoint before = {object.x, object.y};
        const bool isAlert = watch(world, motion, player);
        if (isAlert) {
            react(world, motion, *player);
        } else {
            moveCalmly(world, motion);
        }
        showState(world, motion, before);
        noteMoved(world, motion);
    }
    closeGaps(world);
    ++moving.turn;
}

std::size_t turnsOfPatrols(const World& world) {
    return 1 + world.movingObjects.motions.size() * world.portals.size() / kMostPortalLooks;
}

void noteObjects(World& world) {
    for (ObjectMotion& motion : world.movingObjects.motions)
        motion.before = placeOf(movedObject(world, motion));
}

void showObjects(World& world, double part) {
    MovingObjects& moving = world.movingObjects;
    if (part == 1.0 && !moving.areBetween) return;
    for (ObjectMotion& motion : moving.motions) {
        Object& object = movedObject(world, motion);
        if (!moving.areBetween) motion.now = placeOf(object);
        const auto& [x, y, z] = motion.now;
        object.x = between(motion.before.x, x, part);
        object.y = between(motion.before.y, y, part);
        object.z = between(motion.before.z, z, part);
    }
    moving.areBetween = part < 1.0;
}

void resetObjects(World& world) {
    MovingObjects& moving = world.movingObjects;
    moving.motions = moving.motionsAtStart;
    moving.turn = 0;
    for (std::size_t i = 0; i < moving.objectsAtStart.size(); ++i)
        world.maps[i].objects = moving.objectsAtStart[i];
}

ObjectsMoment momentOfObjects(const World& world) {
    const MovingObjects& moving = world.movingObjects;
    ObjectsMoment moment = {.motions = moving.motions,
                            .counts = {},
                            .changed = {},
                            .nearest = moving.nearest,
                            .nextNearest = moving.nextNearest,
                            .turn = moving.turn};
    for (std::size_t map = 0; map < moving.objectsAtStart.size(); ++map) {
        const std::vector<Object>& atStart = moving.objectsAtStart[map];
        const std::vector<Object>& now = world.maps[map].objects;
        moment.counts.push_back(static_cast<int>(now.size()));
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (i >= atStart.size() || now[i] != atStart[i])
                moment.changed.push_back({static_cast<int>(map), static_cast<int>(i), now[i]});
        }
    }
    return moment;
}

void restoreObjects(World& world, const ObjectsMoment& moment) {
    MovingObjects& moving = world.movingObjects;
    moving.motions = moment.motions;
    moving.nearest = moment.nearest;
    moving.nextNearest = moment.nextNearest;
    moving.turn = moment.turn;
    for (std::size_t map = 0; map < moment.counts.size(); ++map) {
        world.maps[map].objects = moving.objectsAtStart[map];
        world.maps[map].objects.resize(static_cast<std::size_t>(moment.counts[map]));
    }
    for (const ChangedObject& changed : moment.changed) {
        world.maps[static_cast<std::size_t>(changed.map)]
            .objects[static_cast<std::size_t>(changed.object)] = changed.now;
    }
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
    const std::size_t turns = turnsOfPatrols(world);
    if (turns > 1) hash.add(static_cast<std::int64_t>(world.movingObjects.turn % turns));
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
        if (turns > 1) {
            const auto& [map, toMap, near, middle] = motion.portal;
            for (const int number : {map, toMap, near.x.raw, near.y.raw, int{middle.has_value()}})
                hash.add(std::int64_t{number});
        }
        if (motion.isActor()) addActor(hash, motion, object);
    }
}

}  // namespace slicecast
