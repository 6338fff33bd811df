#include "world/crowd.h"

#include "base/sort.h"
#include "world/body.h"
#include "world/object_walk.h"
#include "world/player.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace slicecast {
namespace {

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

bool isListedBefore(const CrowdBody& a, const CrowdBody& b) {
    return std::tie(a.map, a.tileY, a.tileX) < std::tie(b.map, b.tileY, b.tileX);
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
void eachNeighbour(MovingObjects& moving, const CrowdBody& body, Action action) {
    int seen = 0;
    CrowdBody first;  // of the tiles around in a row
    first.map = body.map;
    first.tileX = body.x.tile() - 1;
    for (int row = -1; row <= 1; ++row) {
        first.tileY = body.y.tile() + row;
        for (auto other =
                 std::lower_bound(moving.crowd.begin(), moving.crowd.end(), first, isListedBefore);
             other != moving.crowd.end() && other->map == first.map &&
             other->tileY == first.tileY && other->tileX <= first.tileX + 2;
             ++other) {
            ++moving.crowdLooks;
            if (other->motion == body.motion) continue;
            if (++seen > kMostNeighbours || action(*other)) return;
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

const CrowdBody* inTheWay(MovingObjects& moving, const CrowdBody& body, GroundPoint way) {
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
    moving.crowd.clear();
    moving.crowdLooks = 0;
    // In a tile the last one comes first, and the player last
    for (std::size_t i = moving.motions.size(); i-- > 0;) {
        const ObjectMotion& motion = moving.motions[i];
        if (!motion.solid) continue;
        moving.crowd.push_back(
            bodyOf(motion.map, static_cast<int>(i), objectBody(movedObject(world, motion))));
    }
    if (player != nullptr) moving.crowd.push_back(bodyOf(player->map, -1, player->box));
    mergeSort(moving.crowd, moving.crowdRoom, isListedBefore);
    for (std::size_t i = 0; i < moving.crowd.size(); ++i) {
        const int motion = moving.crowd[i].motion;
        if (motion >= 0)
            moving.motions[static_cast<std::size_t>(motion)].crowdBody = static_cast<int>(i);
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
    MovingObjects& moving = world.movingObjects;
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
    if (!moving.anySolid || player.flying || moving.crowd.empty()) return;
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
    closeGaps(world);
    if (push.x.raw != 0 || push.y.raw != 0) nudge(world, player, push.x, push.y);
}

}  // namespace slicecast
