#include "many_objects.h"

#include "base/angle.h"
#include "base/random.h"
#include "render/options.h"
#include "world/line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slicecast {
namespace {

constexpr int kSamples = 9;  // points of an object that are looked for, each way

// True if a block is between two places of a map.
bool isBlocked(const World& world, const Map& map, const Place& from, const Place& to) {
    const double wayX = to.x - from.x;
    const double wayY = to.y - from.y;
    int x = static_cast<int>(std::floor(from.x));
    int y = static_cast<int>(std::floor(from.y));
    double along = 0.0;  // part of the way
    while (along < 1.0) {
        constexpr double kNever = std::numeric_limits<double>::infinity();
        const double leaveX = wayX > 0.0   ? (x + 1 - from.x) / wayX
                              : wayX < 0.0 ? (x - from.x) / wayX
                                           : kNever;
        const double leaveY = wayY > 0.0   ? (y + 1 - from.y) / wayY
                              : wayY < 0.0 ? (y - from.y) / wayY
                                           : kNever;
        const double leave = std::min({leaveX, leaveY, 1.0});
        const double z0 = from.z + (to.z - from.z) * along;
        const double z1 = from.z + (to.z - from.z) * leave;
        for (int level = 0; level < map.levels; ++level) {
            const BlueprintId id = map.cell(x, y, level);
            if (id == kEmptyCell || world.blueprints[id].seeThrough) continue;
            const double bottom = level + world.blueprints[id].bottom.value();
            const double top = level + world.blueprints[id].top.value();
            if (std::max(z0, z1) > bottom && std::min(z0, z1) < top) return true;
        }
        if (leaveX < leaveY) {
            x += wayX > 0.0 ? 1 : -1;
        } else {
            y += wayY > 0.0 ? 1 : -1;
        }
        along = leave;
    }
    return false;
}

// True if some of the object's rectangle is in the field of view with no block before it.
bool isInSight(const World& world, const Map& map, const Eye& eye, const Object& object) {
    const SineCosine heading = sineCosineDegrees(eye.headingDegrees);
    const double widest = tanDegrees(RenderOptions{}.fovDegrees / 2.0);
    const Place from = {eye.x.value(), eye.y.value(), eye.z.value()};
    for (int i = 0; i < kSamples; ++i) {
        const double aside = object.width.value() * (static_cast<double>(i) / (kSamples - 1) - 0.5);
        const double x = object.x.value() - heading.sine * aside;
        const double y = object.y.value() + heading.cosine * aside;
        const double depth = heading.cosine * (x - from.x) + heading.sine * (y - from.y);
        const double right = -heading.sine * (x - from.x) + heading.cosine * (y - from.y);
        if (depth <= 0.0 || std::abs(right) > widest * depth) continue;
        for (int j = 0; j < kSamples; ++j) {
            const double z =
                object.z.value() + object.height.value() * (j + 0.01) / (kSamples - 1 + 0.02);
            if (!isBlocked(world, map, from, {x, y, z})) return true;
        }
    }
    return false;
}

// A bush, a tree, whatever the world has, on the floor where no block stands.
std::optional<Object> scatter(const World& world, const Map& map, Random& random) {
    const int x = random.below(map.width);
    const int y = random.below(map.depth);
    Object object;
    object.x = tileEdge(x) + Coordinate{random.below(65536)};
    object.y = tileEdge(y) + Coordinate{random.below(65536)};
    object.height = toCoordinate(random.between(0.3, 0.9));
    object.sprite = static_cast<SpriteId>(random.below(static_cast<int>(world.sprites.size())));
    const SpriteLevel& shape = world.sprites[object.sprite].frames[0][0];
    object.width = toCoordinate(object.height.value() * shape.width / shape.height);
    return map.cell(x, y, 0) == kEmptyCell ? std::optional(object) : std::nullopt;
}

}  // namespace

std::optional<ManyObjects> spreadObjects(const World& world, const Eye& eye, int count, int seen) {
    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    Random random(10'000);
    std::vector<Object> all;
    std::vector<Object> inSight;
    int outOfSight = 0;
    for (int attempt = 0; attempt < 100 * count && static_cast<int>(all.size()) < count;
         ++attempt) {
        const std::optional<Object> object = scatter(world, map, random);
        if (!object) continue;
        const bool isSeen = isInSight(world, map, eye, *object);
        if (isSeen ? static_cast<int>(inSight.size()) == seen : outOfSight == count - seen)
            continue;
        outOfSight += !isSeen;
        if (isSeen) inSight.push_back(*object);
        all.push_back(*object);
    }
    if (static_cast<int>(all.size()) < count) return std::nullopt;
    ManyObjects many = {world.copy(), world.copy()};
    many.all.movingObjects = {};
    many.seenOnly.movingObjects = {};
    many.all.maps[static_cast<std::size_t>(eye.map)].objects = all;
    many.seenOnly.maps[static_cast<std::size_t>(eye.map)].objects = inSight;
    return many;
}

}  // namespace slicecast
