#include "world/object_walk.h"

#include "base/angle.h"
#include "base/sort.h"
#include "world/player.h"
#include "world/water.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr Coordinate kFallPerStep = toCoordinate(kGravity * kStepSeconds * kStepSeconds);
constexpr Coordinate kFastestFall = toCoordinate(kGreatestFall * kStepSeconds);

// True if the water has become too deep for a walker: deeper than half its height.
bool isTooDeep(const World& world, const Object& object, const Traveller& before,
               const Traveller& body) {
    const Coordinate depth = waterDepth(world, body);
    return depth.raw > object.height.raw / 2 && depth > waterDepth(world, before);
}

// Moves an object from its map's list to the end of another map's.
void changeMap(World& world, ObjectMotion& motion, int map) {
    std::vector<Object>& to = world.maps[static_cast<std::size_t>(map)].objects;
    to.push_back(movedObject(world, motion));
    const int object = static_cast<int>(to.size()) - 1;
    world.movingObjects.gone.push_back({motion.map, motion.object, map, object});
    motion.map = map;
    motion.object = object;
}

bool isBefore(const GoneObject& a, const GoneObject& b) {
    return a.map != b.map ? a.map < b.map : a.object < b.object;
}

// Takes the objects out of their maps' lists.
void erase(World& world, const std::vector<GoneObject>& gone) {
    for (auto next = gone.begin(); next != gone.end();) {
        const int map = next->map;
        std::vector<Object>& objects = world.maps[static_cast<std::size_t>(map)].objects;
        auto to = objects.begin() + next->object;
        for (auto from = to; from != objects.end(); ++from) {
            if (next != gone.end() && next->map == map && from - objects.begin() == next->object) {
                ++next;
            } else {
                *to++ = *from;
            }
        }
        objects.erase(to, objects.end());
    }
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

}  // namespace

Object& movedObject(World& world, const ObjectMotion& motion) {
    return world.maps[static_cast<std::size_t>(motion.map)]
        .objects[static_cast<std::size_t>(motion.object)];
}

const Object& movedObject(const World& world, const ObjectMotion& motion) {
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

void put(World& world, ObjectMotion& motion, const Traveller& body, GroundPoint way) {
    Object& object = movedObject(world, motion);
    GroundPoint fromHome = {object.x + way.x - motion.homeX, object.y + way.y - motion.homeY};
    object.x = body.eye.x;
    object.y = body.eye.y;
    object.z = body.box.bottom;
    motion.eye = body.eye.z - body.box.bottom;
    motion.behind = body.behind;
    if (body.leaps == 0) return;
    motion.before = placeOf(object);
    turnArrow(body.turn, fromHome.x, fromHome.y);
    turnArrow(body.turn, motion.wayX, motion.wayY);
    motion.homeX = object.x - fromHome.x;
    motion.homeY = object.y - fromHome.y;
    motion.headingDegrees = wrapDegrees(motion.headingDegrees + 90.0 * body.turn);
    turnArrow(body.turn, object.facingX, object.facingY);
    motion.phase += static_cast<std::uint32_t>(body.turn) << 30;
    if (body.map != motion.map) changeMap(world, motion, body.map);
}

void closeGaps(World& world) {
    MovingObjects& moving = world.movingObjects;
    std::vector<GoneObject>& gone = moving.gone;
    if (gone.empty()) return;
    mergeSort(gone, moving.goneRoom, isBefore);
    erase(world, gone);
    const auto goneFrom = [&](const auto& thing) {
        return std::lower_bound(gone.begin(), gone.end(), GoneObject{thing.map, thing.object},
                                isBefore);
    };
    // False if it is nowhere. What has no object, as the message of an area, stays as it is.
    const auto settle = [&](auto& thing) {
        if (thing.object < 0) return true;
        auto place = goneFrom(thing);
        while (place != gone.end() && place->map == thing.map && place->object == thing.object) {
            thing.object = place->toObject;
            if (thing.object < 0) return false;
            thing.map = place->toMap;
            place = goneFrom(thing);
        }
        const auto first =
            std::lower_bound(gone.begin(), gone.end(), GoneObject{thing.map, 0}, isBefore);
        thing.object -= static_cast<int>(place - first);
        return true;
    };
    std::erase_if(moving.motions, [&](ObjectMotion& motion) { return !settle(motion); });
    for (Find& find : world.quest.finds) settle(find);
    std::erase_if(world.quest.notices, [&](Notice& notice) { return !settle(notice); });
    gone.clear();
}

void setFacing(Object& object, double degrees) {
    const SineCosine heading = sineCosineDegrees(degrees);
    object.facingX = toCoordinate(heading.cosine);
    object.facingY = toCoordinate(heading.sine);
}

void face(World& world, ObjectMotion& motion, double degrees) {
    motion.headingDegrees = wrapDegrees(degrees);
    const SineCosine heading = sineCosineDegrees(motion.headingDegrees);
    motion.wayX = toCoordinate(heading.cosine * motion.speed * kStepSeconds);
    motion.wayY = toCoordinate(heading.sine * motion.speed * kStepSeconds);
    setFacing(movedObject(world, motion), motion.headingDegrees);
}

void fall(World& world, ObjectMotion& motion) {
    Traveller body = travellerOf(motion, movedObject(world, motion));
    motion.fallen = std::min(motion.fallen + kFallPerStep, kFastestFall);
    motion.onGround = !rise(world, body, {-motion.fallen.raw});
    if (motion.onGround) motion.fallen = {};
    put(world, motion, body, {});
}

WalkStep walk(World& world, ObjectMotion& motion, GroundPoint way) {
    const Object& object = movedObject(world, motion);
    const Traveller before = travellerOf(motion, object);
    Traveller body = before;
    const Travelled done = slide(world, body, way.x, way.y, kStepHeight);
    WalkStep step = {.stoppedX = done.stoppedX, .stoppedY = done.stoppedY, .slip = done.slip};
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

Aim aimAt(const Object& object, GroundPoint target, double speed) {
    const Coordinate x = target.x - object.x;
    const Coordinate y = target.y - object.y;
    const double length = std::sqrt(x.value() * x.value() + y.value() * y.value());
    const double reach = speed * kStepSeconds;
    if (length == 0.0) return {.way = {}, .arrives = true};
    Aim aim = {.way = {x, y}, .x = x.value() / length, .y = y.value() / length, .arrives = true};
    if (length <= reach) return aim;
    aim.way = {toCoordinate(aim.x * reach), toCoordinate(aim.y * reach)};
    aim.arrives = false;
    return aim;
}

}  // namespace slicecast
