#include "world/crowd.h"

#include "world/body.h"
#include "world/object_walk.h"
#include "world/player.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr int kCells = 1024;  // a power of two

std::size_t cellOf(int map, int x, int y) {
    const std::uint32_t mixed = static_cast<std::uint32_t>(x) * 73856093u ^
                                static_cast<std::uint32_t>(y) * 19349663u ^
                                static_cast<std::uint32_t>(map) * 83492791u;
    return mixed % kCells;
}

CrowdBody bodyOf(int map, int motion, const Box& box) {
    const Coordinate half = {(box.east.raw - box.west.raw) / 2};
    return {.map = map,
            .motion = motion,
            .x = box.west + half,
            .y = box.north + half,
            .half = half,
            .bottom = box.bottom,
            .top = box.top,
            .tileX = (box.west + half).tile(),
            .tileY = (box.north + half).tile()};
}

void addToCrowd(MovingObjects& moving, CrowdBody body) {
    int& first = moving.crowdCells[cellOf(body.map, body.tileX, body.tileY)];
    body.next = first;
    first = static_cast<int>(moving.crowd.size());
    moving.crowd.push_back(body);
}

// Bodies are round here, so that whoever goes round another comes no closer.
bool overlap(const CrowdBody& a, const CrowdBody& b) {
    const std::int64_t least = std::int64_t{a.half.raw} + b.half.raw;
    const std::int64_t x = a.x.raw - b.x.raw;
    const std::int64_t y = a.y.raw - b.y.raw;
    return x * x + y * y < least * least && a.bottom < b.top && b.bottom < a.top;
}

// Calls action(other) for bodies in the tiles around, until it returns true or enough are seen.
template <typename Action>
void eachNeighbour(const MovingObjects& moving, const CrowdBody& body, Action action) {
    int seen = 0;
    for (int y = body.y.tile() - 1; y <= body.y.tile() + 1; ++y) {
        for (int x = body.x.tile() - 1; x <= body.x.tile() + 1; ++x) {
            for (int i = moving.crowdCells[cellOf(body.map, x, y)]; i >= 0;) {
                const CrowdBody& other = moving.crowd[static_cast<std::size_t>(i)];
                i = other.next;
                if (other.motion == body.motion || other.map != body.map || other.tileX != x ||
                    other.tileY != y)
                    continue;
                if (++seen > kMostNeighbours || action(other)) return;
            }
        }
    }
}

// A way to the right of another body, seen from this one.
GroundPoint asideOf(const CrowdBody& body, const CrowdBody& other, GroundPoint way) {
    const double x = (other.x - body.x).value();
    const double y = (other.y - body.y).value();
    const double length = std::sqrt(x * x + y * y);
    if (length == 0.0) return way;
    const double pace = std::sqrt(way.x.value() * way.x.value() + way.y.value() * way.y.value());
    return {toCoordinate(-y / length * pace), toCoordinate(x / length * pace)};
}

const CrowdBody* inTheWay(const MovingObjects& moving, const CrowdBody& body, GroundPoint way) {
    CrowdBody moved = body;
    moved.x = body.x + way.x;
    moved.y = body.y + way.y;
    const CrowdBody* found = nullptr;
    eachNeighbour(moving, body, [&](const CrowdBody& other) {
        const std::int64_t nearer = std::int64_t{way.x.raw} * (other.x.raw - body.x.raw) +
                                    std::int64_t{way.y.raw} * (other.y.raw - body.y.raw);
        if (nearer <= 0 || !overlap(moved, other)) return false;
        found = &other;
        return true;
    });
    return found;
}

}  // namespace

void gatherCrowd(World& world, const Body* player) {
    MovingObjects& moving = world.movingObjects;
    moving.crowdCells.assign(kCells, -1);
    moving.crowd.clear();
    moving.crowd.reserve(moving.motions.size() + 1);
    if (player != nullptr) addToCrowd(moving, bodyOf(player->map, -1, player->box));
    for (std::size_t i = 0; i < moving.motions.size(); ++i) {
        ObjectMotion& motion = moving.motions[i];
        if (!motion.solid) continue;
        motion.crowdBody = static_cast<int>(moving.crowd.size());
        addToCrowd(moving,
                   bodyOf(motion.map, static_cast<int>(i), objectBody(movedObject(world, motion))));
    }
}

void noteMoved(World& world, const ObjectMotion& motion) {
    if (!motion.solid) return;
    CrowdBody& body = world.movingObjects.crowd[static_cast<std::size_t>(motion.crowdBody)];
    const Object& object = movedObject(world, motion);
    body.map = motion.map;
    body.x = object.x;
    body.y = object.y;
    body.bottom = object.z;
    body.top = object.z + object.height;
}

GroundPoint besideOthers(World& world, ObjectMotion& motion, GroundPoint way) {
    const MovingObjects& moving = world.movingObjects;
    if (!motion.solid || (way.x.raw == 0 && way.y.raw == 0)) return way;
    const auto index = static_cast<int>(&motion - moving.motions.data());
    const CrowdBody body = bodyOf(motion.map, index, objectBody(movedObject(world, motion)));
    const CrowdBody* other = inTheWay(moving, body, way);
    if (other == nullptr) {
        motion.crowdSteps = std::max(0, motion.crowdSteps - 1);
        return way;
    }
    if (motion.crowdSteps >= kCrowdPatience) return way;
    ++motion.crowdSteps;
    const GroundPoint aside = asideOf(body, *other, way);
    return inTheWay(moving, body, aside) == nullptr ? aside : GroundPoint{};
}

void pushApart(World& world, Player& player) {
    MovingObjects& moving = world.movingObjects;
    if (!moving.anySolid || player.flying || moving.crowdCells.empty()) return;
    const CrowdBody body = bodyOf(player.map, -1, bodyBox(player));
    GroundPoint push;
    eachNeighbour(moving, body, [&](const CrowdBody& other) {
        ObjectMotion& motion = moving.motions[static_cast<std::size_t>(other.motion)];
        if (motion.map != player.map) return false;
        const CrowdBody now =
            bodyOf(motion.map, other.motion, objectBody(movedObject(world, motion)));
        if (!overlap(body, now)) return false;
        const double x = (now.x - body.x).value();
        const double y = (now.y - body.y).value();
        const double length = std::sqrt(x * x + y * y);
        if (length == 0.0) return false;
        const GroundPoint way = {toCoordinate(x / length * kPush.value()),
                                 toCoordinate(y / length * kPush.value())};
        push.x = push.x - Coordinate{way.x.raw / 2};
        push.y = push.y - Coordinate{way.y.raw / 2};
        const bool keepsToLine =
            motion.kind == ObjectMotion::Kind::pace || motion.kind == ObjectMotion::Kind::circle;
        if (motion.onGround && !keepsToLine) walk(world, motion, way);
        return false;
    });
    if (push.x.raw != 0 || push.y.raw != 0) nudge(world, player, push.x, push.y);
}

}  // namespace slicecast
