#include "world/object_behaviour.h"

#include "base/hash.h"
#include "world/body.h"
#include "world/crowd.h"
#include "world/line_of_sight.h"
#include "world/object_walk.h"
#include "world/player.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr int kPatience = kStepsPerSecond * 3 / 2;    // for walls and closed gates
constexpr int kLedgePatience = kStepsPerSecond * 60;  // where a lift may come
constexpr int kDetourSteps = kStepsPerSecond / 2;
constexpr int kMostDetours = 6;
constexpr int kFreeAgain = kStepsPerSecond;  // steps after which detours are forgotten
constexpr int kVeerSteps = kStepsPerSecond / 3;
constexpr Coordinate kAtHome = toCoordinate(0.03);
constexpr Coordinate kAtHeight = toCoordinate(0.25);
// A follower that has stopped starts again this much further away, or it would tremble.
constexpr Coordinate kSlack = toCoordinate(0.25);
constexpr Coordinate kHighest = tileEdge(4);  // between the feet of one who sees and of the player

GroundPoint middleOf(const Box& box) {
    return {{box.west.raw + (box.east.raw - box.west.raw) / 2},
            {box.north.raw + (box.south.raw - box.north.raw) / 2}};
}

bool isWithin(const Object& object, GroundPoint place, Coordinate distance) {
    const std::int64_t x = object.x.raw - place.x.raw;
    const std::int64_t y = object.y.raw - place.y.raw;
    return x * x + y * y <= std::int64_t{distance.raw} * distance.raw;
}

bool sees(const World& world, const ObjectMotion& motion, const Body& player) {
    const Object& object = movedObject(world, motion);
    if (player.map != motion.map || !isWithin(object, middleOf(player.box), motion.near) ||
        std::abs(object.z.raw - player.box.bottom.raw) > kHighest.raw)
        return false;
    const GroundPoint at = middleOf(player.box);
    const Coordinate eye = {player.box.bottom.raw +
                            (player.box.top.raw - player.box.bottom.raw) / 3 * 2};
    return isInSight(world, world.maps[static_cast<std::size_t>(motion.map)],
                     {object.x.value(), object.y.value(), (object.z + motion.eye).value()},
                     {at.x.value(), at.y.value(), eye.value()});
}

void turnTo(World& world, const ObjectMotion& motion, GroundPoint place) {
    Object& object = movedObject(world, motion);
    const Aim aim = aimAt(object, place, 1.0);
    if (aim.x == 0.0 && aim.y == 0.0) return;
    object.facingX = toCoordinate(aim.x);
    object.facingY = toCoordinate(aim.y);
}

// Stays where it is, and falls if the ground is lost.
void stay(World& world, ObjectMotion& motion) {
    if (!motion.onGround) return fall(world, motion);
    walk(world, motion, {});
}

// The nearest portal from a map to another one.
NearestPortal nearestPortal(const World& world, int map, GroundPoint near, int toMap) {
    NearestPortal best = {map, toMap, near, {}};
    double least = 0.0;
    for (const Portal& portal : world.portals) {
        if (portal.fromMap != map || portal.toMap != toMap) continue;
        const GroundPoint middle = {tileEdge(portal.fromX) + Coordinate{32768},
                                    tileEdge(portal.fromY) + Coordinate{32768}};
        const double x = (middle.x - near.x).value();
        const double y = (middle.y - near.y).value();
        if (best.middle && x * x + y * y >= least) continue;
        best.middle = middle;
        least = x * x + y * y;
    }
    return best;
}

// The middle of the portal where those go who follow the player to another map.
std::optional<GroundPoint> portalAfter(World& world, int map, GroundPoint seen, int toMap) {
    MovingObjects& moving = world.movingObjects;
    for (const NearestPortal& known : moving.nearest) {
        if (known.map == map && known.toMap == toMap && known.near == seen) return known.middle;
    }
    NearestPortal& next = moving.nearest[moving.nextNearest];
    moving.nextNearest = (moving.nextNearest + 1) % kKeptPortals;
    next = nearestPortal(world, map, seen, toMap);
    return next.middle;
}

// Finds the portal of a patrol to another map. False while it waits for its turn to ask.
bool findPortal(World& world, ObjectMotion& motion, int toMap) {
    const MovingObjects& moving = world.movingObjects;
    const auto index = static_cast<std::size_t>(&motion - moving.motions.data());
    if ((index + moving.turn) % turnsOfPatrols(world) == 0) {
        const Object& object = movedObject(world, motion);
        motion.portal = nearestPortal(world, motion.map, {object.x, object.y}, toMap);
    }
    return motion.portal.map == motion.map && motion.portal.toMap == toMap;
}

enum class Progress : std::uint8_t { going, arrived, stuck };

// Counts what stops a walker. It waits first, as a gate may open; then it goes aside to the right
// and to the left in turn, each time further, and gives up in the end. At a ledge it waits much
// longer.
Progress noteProgress(ObjectMotion& motion, bool isStopped, bool isAtLedge) {
    if (!isStopped) {
        if (motion.detourSteps > 0) return Progress::going;
        motion.blockedSteps = std::max(-kFreeAgain, motion.blockedSteps - 1);
        if (motion.blockedSteps == -kFreeAgain) motion.detours = 0;
        return Progress::going;
    }
    motion.blockedSteps = std::max(0, motion.blockedSteps) + 1;
    if (motion.blockedSteps < (isAtLedge ? kLedgePatience : kPatience)) return Progress::going;
    motion.blockedSteps = 0;
    if (isAtLedge || motion.detours == kMostDetours) {
        motion.detours = 0;
        return Progress::stuck;
    }
    ++motion.detours;
    motion.detourSteps = kDetourSteps * motion.detours;
    return Progress::going;
}

Progress walkTo(World& world, ObjectMotion& motion, GroundPoint target, double speed) {
    if (!motion.onGround) {
        fall(world, motion);
        return Progress::going;
    }
    Object& object = movedObject(world, motion);
    const Aim aim = aimAt(object, target, speed);
    if (aim.x != 0.0 || aim.y != 0.0) {
        object.facingX = toCoordinate(aim.x);
        object.facingY = toCoordinate(aim.y);
    }
    GroundPoint way = aim.way;
    if (motion.detourSteps > 0) {
        --motion.detourSteps;
        turnArrow(motion.detours % 2 != 0 ? 1 : 3, way.x, way.y);
    } else {
        way = besideOthers(world, motion, way);
    }
    const GroundPoint before = {object.x, object.y};
    const int map = motion.map;
    const WalkStep step = walk(world, motion, way);
    const Object& now = movedObject(world, motion);
    if (motion.map != map) return Progress::going;
    if (aim.arrives && now.x == target.x && now.y == target.y) {
        motion.blockedSteps = motion.detours = motion.detourSteps = 0;
        return Progress::arrived;
    }
    // Half of the way is enough: along a wall it may be less than all
    const double x = (now.x - before.x).value();
    const double y = (now.y - before.y).value();
    const bool isStopped = (x * x + y * y) * 4.0 < speed * speed * kStepSeconds * kStepSeconds;
    return noteProgress(motion, isStopped && way.x == aim.way.x && way.y == aim.way.y,
                        step.refused);
}

void follow(World& world, ObjectMotion& motion, const Body& player) {
    if (player.map != motion.map) {
        const auto portal = portalAfter(world, motion.map, motion.seen, player.map);
        if (!portal) return stay(world, motion);
        walkTo(world, motion, *portal, motion.alertSpeed);
        return;
    }
    const GroundPoint target = middleOf(player.box);
    const Coordinate keep = motion.isWalking ? motion.keep : motion.keep + kSlack;
    if (!isWithin(movedObject(world, motion), target, keep)) {
        walkTo(world, motion, target, motion.alertSpeed);
        return;
    }
    turnTo(world, motion, target);
    stay(world, motion);
}

// Turns an arrow clockwise by eighths of a turn.
void turnByEighths(int eighths, double& x, double& y) {
    constexpr double kHalfRoot = 0.70710678118654752440;  // the sine of 45 degrees
    for (int i = 0; i < (eighths & 7); ++i) {
        const double oldX = x;
        x = (oldX - y) * kHalfRoot;
        y = (oldX + y) * kHalfRoot;
    }
}

// Runs straight away; where something stops it, it tries one heading after another.
void flee(World& world, ObjectMotion& motion) {
    if (!motion.onGround) return fall(world, motion);
    Object& object = movedObject(world, motion);
    const Aim to = aimAt(object, motion.seen, motion.alertSpeed);
    double x = to.x == 0.0 && to.y == 0.0 ? object.facingX.value() : -to.x;
    double y = to.x == 0.0 && to.y == 0.0 ? object.facingY.value() : -to.y;
    turnByEighths(motion.veer, x, y);
    object.facingX = toCoordinate(x);
    object.facingY = toCoordinate(y);
    const double reach = motion.alertSpeed * kStepSeconds;
    const GroundPoint before = {object.x, object.y};
    const int map = motion.map;
    const WalkStep step =
        walk(world, motion,
             besideOthers(world, motion, {toCoordinate(x * reach), toCoordinate(y * reach)}));
    const Object& now = movedObject(world, motion);
    const bool isStopped = motion.map == map && now.x == before.x && now.y == before.y;
    if (step.refused || isStopped || (step.stoppedX && step.stoppedY)) {
        // 0, then 1, -1, 2, -2, 3 and -3 eighths
        constexpr int kAfter[] = {1, 7, 6, 5, 0, 0, 3, 2};
        motion.veer = kAfter[motion.veer];
        motion.veerSteps = kVeerSteps;
    } else if (motion.veerSteps > 0 && --motion.veerSteps == 0) {
        motion.veer = 0;
    }
}

// The next point of a path, along it or back.
void takeNextPoint(ObjectMotion& motion, const std::vector<PathPoint>& path) {
    const int last = static_cast<int>(path.size()) - 1;
    motion.blockedSteps = 0;
    if (motion.loops) {
        motion.point = motion.point == last ? 0 : motion.point + 1;
        return;
    }
    if (motion.point == last) motion.back = true;
    if (motion.point == 0) motion.back = false;
    motion.point += last == 0 ? 0 : motion.back ? -1 : 1;
}

}  // namespace

bool watch(const World& world, ObjectMotion& motion, const Body* player) {
    if (motion.reaction == ObjectMotion::Reaction::none || player == nullptr) return false;
    if (motion.alertSteps > 0) --motion.alertSteps;
    if (--motion.lookSteps <= 0) {
        motion.lookSteps = kLookSteps;
        if (sees(world, motion, *player)) motion.alertSteps = motion.calmSteps;
    }
    if (motion.alertSteps == 0) return false;
    if (player->map == motion.map) motion.seen = middleOf(player->box);
    return true;
}

void react(World& world, ObjectMotion& motion, const Body& player) {
    switch (motion.reaction) {
        case ObjectMotion::Reaction::follow:
            return follow(world, motion, player);
        case ObjectMotion::Reaction::flee:
            return flee(world, motion);
        case ObjectMotion::Reaction::greet:
        case ObjectMotion::Reaction::none:
            turnTo(world, motion, motion.seen);
            return stay(world, motion);
    }
}

void stand(World& world, ObjectMotion& motion) {
    const Object& object = movedObject(world, motion);
    const GroundPoint home = {motion.homeX, motion.homeY};
    if (isWithin(object, home, kAtHome)) {
        face(world, motion, motion.headingDegrees);
        return stay(world, motion);
    }
    // Where it cannot get home, it has a new one
    if (walkTo(world, motion, home, motion.speed) == Progress::stuck) {
        const Object& now = movedObject(world, motion);
        motion.homeX = now.x;
        motion.homeY = now.y;
    }
}

void patrol(World& world, ObjectMotion& motion) {
    const std::vector<PathPoint>& path =
        world.movingObjects.paths[static_cast<std::size_t>(motion.path)];
    if (motion.waitSteps > 0) {
        --motion.waitSteps;
        return stay(world, motion);
    }
    const PathPoint& point = path[static_cast<std::size_t>(motion.point)];
    if (point.map != motion.map) {
        if (!findPortal(world, motion, point.map)) return stay(world, motion);
        const auto portal = motion.portal.middle;
        if (!portal) stay(world, motion);
        if (!portal || walkTo(world, motion, *portal, motion.speed) == Progress::stuck)
            takeNextPoint(motion, path);
        return;
    }
    const Progress progress = walkTo(world, motion, point.place, motion.speed);
    if (progress == Progress::going) return;
    const Object& now = movedObject(world, motion);
    if (progress == Progress::arrived && point.feet &&
        std::abs(now.z.raw - point.feet->raw) > kAtHeight.raw) {
        if (++motion.liftSteps < kLedgePatience) return;
    }
    motion.liftSteps = 0;
    if (progress == Progress::arrived) motion.waitSteps = point.waitSteps;
    takeNextPoint(motion, path);
}

void showState(World& world, ObjectMotion& motion, GroundPoint before) {
    Object& object = movedObject(world, motion);
    motion.isWalking = object.x != before.x || object.y != before.y;
    if (motion.isWalking && motion.walking) {
        object.sprite = *motion.walking;
    } else if (motion.alertSteps > 0 && motion.alert) {
        object.sprite = *motion.alert;
    } else {
        object.sprite = motion.standing;
    }
}

void addActor(Hash& hash, const ObjectMotion& motion, const Object& object) {
    for (const int number :
         {motion.lookSteps, motion.alertSteps, motion.seen.x.raw, motion.seen.y.raw,
          int{motion.isWalking}, motion.point, motion.waitSteps, motion.blockedSteps,
          motion.detours, motion.detourSteps, motion.crowdSteps, motion.liftSteps, motion.veer,
          motion.veerSteps, int{object.sprite}, object.facingX.raw, object.facingY.raw})
        hash.add(std::int64_t{number});
}

}  // namespace slicecast
