// Sows objects and checks that moving ones have room, once all maps, portals and the start are
// known; and finds what is hidden in blocks.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/collision.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace slicecast {
namespace {

bool isSound(const Reading& reading, std::size_t map) {
    return reading.areBlueprintsSound && map < reading.isMapSound.size() && reading.isMapSound[map];
}

// Reports a moving object that starts inside something solid. A width of 0 depends on the sprite's
// picture, which is not read yet, so the widest body must fit.
void checkRoom(Reading& reading, const PlacedMotion& placed) {
    const World& world = reading.description.world;
    const ObjectMotion& motion = world.movingObjects.motions[placed.motion];
    Object object = world.maps[static_cast<std::size_t>(motion.map)]
                        .objects[static_cast<std::size_t>(motion.object)];
    if (object.width.raw == 0) object.width = kWidestBody;
    const GroundPoint begins = beginning(motion, {object.x, object.y});
    object.x = begins.x;
    object.y = begins.y;
    if (isFree(world, motion.map, objectBody(object))) return;
    reading.checker.add(placed.value,
                        {"a moving object that starts at z "_later, Shortest{object.z.value()},
                         " inside something solid, or outside the map"_later},
                        "free room for its body: as high as the object and at most 0.4 wide"_later);
}

void refuse(Reading& reading, JsonValue value, Sown sown) {
    const std::int64_t most = sown == Sown::tooMany        ? kMaxObjects
                              : sown == Sown::tooManyFinds ? std::int64_t{kMaxFinds}
                                                           : kMaxMovingObjects;
    const char* noun = sown == Sown::tooMany        ? " objects"
                       : sown == Sown::tooManyFinds ? " finds"
                                                    : " moving objects";
    reading.checker.add(value, {"more than ", most, noun, ", counting those before"_later},
                        {"at most ", most, " in a scene"});
}

}  // namespace

// What the tasks share.
struct Placing {
    explicit Placing(Reading& read) : reading(read), world(read.description.world) {}

    bool checkMotions();
    void beginSowing(std::size_t number);
    bool sowSome(std::size_t number);
    bool takeLevels(JsonValue value, std::size_t first, std::size_t end);

    Reading& reading;
    World& world;
    std::size_t next = 0;                  // of the motions to check
    int levels = 0;                        // of moving objects
    std::optional<std::size_t> map = {};   // the one that is sown
    std::optional<TakenSpots> taken = {};  // in it
    int nextRow = 0;
    std::size_t motionsBefore = 0;  // the sowing
    std::size_t findsBefore = 0;
    bool isOver = false;  // after a fault that ends it
};

// Adds up the levels that the bodies of the motions from `first` to before `end` reach into. False
// if all together are too many.
bool Placing::takeLevels(JsonValue value, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end && levels <= kMaxMovingLevels; ++i) {
        const ObjectMotion& motion = world.movingObjects.motions[i];
        levels += levelsOf(world.maps[static_cast<std::size_t>(motion.map)]
                               .objects[static_cast<std::size_t>(motion.object)]);
    }
    if (levels <= kMaxMovingLevels) return true;
    reading.checker.add(value,
                        {"moving objects that reach into more than "_later, kMaxMovingLevels,
                         " levels, counting those before"_later},
                        {"at most ", kMaxMovingLevels,
                         " in a scene: each counts as two for each unit of its height"_later});
    isOver = true;
    return false;
}

// Checks some of the motions. False if none is left.
bool Placing::checkMotions() {
    constexpr std::size_t kMotionsOfTask = 512;
    const std::vector<PlacedMotion>& all = reading.placedMotions;
    const std::size_t end = std::min(next + kMotionsOfTask, all.size());
    for (; next < end; ++next) {
        const PlacedMotion& placed = all[next];
        if (!isSound(reading,
                     static_cast<std::size_t>(world.movingObjects.motions[placed.motion].map)))
            continue;
        if (!takeLevels(placed.value, placed.motion, placed.motion + 1)) return false;
        checkRoom(reading, placed);
    }
    return next < all.size();
}

void Placing::beginSowing(std::size_t number) {
    const SowingOrder& order = reading.sowings[number];
    if (isOver || !isSound(reading, order.map)) return;
    if (map != order.map) taken.emplace(world.maps[order.map]);
    map = order.map;
    nextRow = 0;
    motionsBefore = world.movingObjects.motions.size();
    findsBefore = world.quest.finds.size();
    reading.tasks.add<&Placing::sowSome>(*this, number);
}

// Sows some rows. False if that is all.
bool Placing::sowSome(std::size_t number) {
    constexpr int kTilesOfTask = 16'384;
    const SowingOrder& order = reading.sowings[number];
    const Map& sown = world.maps[order.map];
    const int end = std::min(nextRow + std::max(1, kTilesOfTask / sown.width), sown.depth);
    const Sown how = sowObjects(world, static_cast<int>(order.map), order.sowing, *taken,
                                std::exchange(nextRow, end), end);
    if (how != Sown::all) {
        refuse(reading, order.value, how);
        isOver = true;
        return false;
    }
    if (end < sown.depth) return true;
    if (!takeLevels(order.value, motionsBefore, world.movingObjects.motions.size())) return false;
    if (!order.sowing.find) return false;
    const std::size_t count = world.quest.finds.size() - findsBefore;
    if (count == 0) {
        reading.checker.warn(order.value, "a find that is sown nowhere"_later,
                             "more density, or ground where it has room"_later);
    } else {
        reading.addAim(Aim::What::finds, order.value, findsBefore, count);
    }
    return false;
}

void placeObjects(Reading& reading) {
    reading.placing = std::make_shared<Placing>(reading);
    reading.tasks.add<&Placing::checkMotions>(*reading.placing);
    for (std::size_t order = 0; order < reading.sowings.size(); ++order)
        reading.tasks.add<&Placing::beginSowing>(*reading.placing, order);
}

void findHiddenThings(Reading& reading) {
    const World& world = reading.description.world;
    for (const PlacedThing& thing : reading.things) {
        const Map& map = world.maps[thing.map];
        const int x = thing.x.tile();
        const int y = thing.y.tile();
        const int level = thing.z.tile();
        if (!map.contains(x, y) || !map.isOccupied(x, y, level)) continue;
        const BlueprintId id = map.cell(x, y, level);
        const CellBlueprint& block = world.blueprints[id];
        const auto isWithin = [](Coordinate at, int tile, Coordinate low, Coordinate high) {
            return at - tileEdge(tile) >= low && at - tileEdge(tile) < high;
        };
        if (block.plan.half == Half::none && !block.slopes.any() && block.isStill() &&
            isWithin(thing.x, x, block.plan.west, block.plan.east) &&
            isWithin(thing.y, y, block.plan.north, block.plan.south) &&
            isWithin(thing.z, level, block.bottom, block.top)) {
            reading.description.hiddenThings.push_back(
                {id, reading.checker.faultAt(thing.value,
                                             {thing.what, " inside the block ", quoted(block.name)},
                                             "a place in the open")});
        }
    }
}

}  // namespace slicecast
