// Sows objects and checks that moving ones have room, once all maps, portals and the start are
// known; and finds what is hidden in blocks.
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/collision.h"

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
                        {"a moving object that starts at z ", Shortest{object.z.value()},
                         " inside something solid, or outside the map"},
                        "free room for its body: as high as the object and at most 0.4 wide");
}

void refuse(Reading& reading, JsonValue value, Sown sown) {
    const std::int64_t most = sown == Sown::tooMany        ? kMaxObjects
                              : sown == Sown::tooManyFinds ? std::int64_t{kMaxFinds}
                                                           : kMaxMovingObjects;
    const char* noun = sown == Sown::tooMany        ? " objects"
                       : sown == Sown::tooManyFinds ? " finds"
                                                    : " moving objects";
    reading.checker.add(value, {"more than ", most, noun, ", counting those before"},
                        {"at most ", most, " in a scene"});
}

// Adds up the levels that the bodies of the motions from `first` to before `end` reach into. False
// if all together are too many.
bool takeLevels(Reading& reading, JsonValue value, std::size_t first, std::size_t end,
                int& levels) {
    const World& world = reading.description.world;
    for (std::size_t i = first; i < end && levels <= kMaxMovingLevels; ++i) {
        const ObjectMotion& motion = world.movingObjects.motions[i];
        levels += levelsOf(world.maps[static_cast<std::size_t>(motion.map)]
                               .objects[static_cast<std::size_t>(motion.object)]);
    }
    if (levels <= kMaxMovingLevels) return true;
    reading.checker.add(value,
                        {"moving objects that reach into more than ", kMaxMovingLevels,
                         " levels, counting those before"},
                        {"at most ", kMaxMovingLevels,
                         " in a scene: each counts as two for each unit of its height"});
    return false;
}

}  // namespace

void placeObjects(Reading& reading) {
    World& world = reading.description.world;
    int levels = 0;  // of moving objects
    for (const PlacedMotion& placed : reading.placedMotions) {
        if (!isSound(reading,
                     static_cast<std::size_t>(world.movingObjects.motions[placed.motion].map)))
            continue;
        if (!takeLevels(reading, placed.value, placed.motion, placed.motion + 1, levels)) return;
        checkRoom(reading, placed);
    }
    for (std::size_t map = 0; map < world.maps.size(); ++map) {
        if (!isSound(reading, map)) continue;
        std::optional<TakenSpots> taken;
        for (const SowingOrder& order : reading.sowings) {
            if (order.map != map) continue;
            if (!taken) taken.emplace(world.maps[map]);
            const std::size_t finds = world.quest.finds.size();
            const std::size_t motions = world.movingObjects.motions.size();
            const Sown sown = sowObjects(world, static_cast<int>(map), order.sowing, *taken);
            if (sown != Sown::all) {
                refuse(reading, order.value, sown);
                return;
            }
            if (!takeLevels(reading, order.value, motions, world.movingObjects.motions.size(),
                            levels))
                return;
            if (!order.sowing.find) continue;
            const std::size_t count = world.quest.finds.size() - finds;
            if (count == 0) {
                reading.checker.warn(order.value, "a find that is sown nowhere",
                                     "more density, or ground where it has room");
            } else {
                reading.addAim(Aim::What::finds, order.value, finds, count);
            }
        }
    }
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
