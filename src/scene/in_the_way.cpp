#include "scene/in_the_way.h"

#include "base/later_text.h"
#include "scene/readers.h"

#include <algorithm>
#include <string_view>

namespace slicecast {
namespace {

constexpr double kNear = 0.15;  // units from a figure's way to the middle of what is in it
constexpr double kLow = 0.3;    // units; whoever walks steps over what is no higher
constexpr std::size_t kMostLooks = 4'000'000;  // of a figure's way at an object

struct Range {
    Coordinate low;
    Coordinate high;
    bool contains(Coordinate at) const { return at > low && at < high; }
};

// Where a shaft is at some time, along its axis.
Range reachOf(const Shaft& shaft, const Motion& motion) {
    const auto [least, most] = std::minmax(motion.from, motion.to);
    return {motion.edges == MovingEdges::high ? shaft.low : shaft.low + least,
            motion.edges == MovingEdges::low ? shaft.high : shaft.high + most};
}

// True if the part of a mover that can be in this cell passes through the thing's middle.
bool passesThrough(const World& world, BlueprintId id, const PlacedThing& thing) {
    const CellBlueprint& part = world.blueprints[id];
    if (part.mover < 0 || part.isWater) return false;
    const Mover& mover = world.movers[static_cast<std::size_t>(part.mover)];
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    const Coordinate x = tileEdge(thing.x.tile());
    const Coordinate y = tileEdge(thing.y.tile());
    Range ranges[] = {
        {x + part.plan.west, x + part.plan.east},
        {y + part.plan.north, y + part.plan.south},
        {tileEdge(thing.z.tile()) + part.bottom, tileEdge(thing.z.tile()) + part.top}};
    for (const Shaft& shaft : mover.shafts) {
        if (id < shaft.firstPart || id > shaft.firstPart + (shaft.last - shaft.first)) continue;
        ranges[static_cast<std::size_t>(motion.axis)] = reachOf(shaft, motion);
    }
    return ranges[0].contains(thing.x) && ranges[1].contains(thing.y) &&
           ranges[2].contains(thing.z);
}

void addMistake(Reading& reading, JsonValue at, std::string found, const char* expected) {
    reading.addAim(Aim::What::mistake, at, 0);
    Fault& fault = reading.description.aims.back().place;
    fault.found = std::move(found);
    fault.expected = expected;
}

bool isObject(const PlacedThing& thing) {
    return thing.what == std::string_view("an object");
}

void findInBlocks(Reading& reading) {
    const World& world = reading.description.world;
    for (const PlacedThing& thing : reading.things) {
        const Map& map = world.maps[thing.map];
        if (!isObject(thing) || !map.contains(thing.x.tile(), thing.y.tile()) ||
            thing.z.tile() >= map.levels)
            continue;
        const BlueprintId id = map.cell(thing.x.tile(), thing.y.tile(), thing.z.tile());
        if (!passesThrough(world, id, thing)) continue;
        addMistake(reading, thing.value,
                   words("an object that the moving block "_later,
                         quoted(world.blueprints[world.blueprints[id].origin].name),
                         " passes through: it does not move along"_later),
                   "a place out of the block's way"_later);
    }
}

// A straight part of a figure's way.
struct Leg {
    std::size_t map;
    GroundPoint from;
    GroundPoint to;
    double low;
    double high;
};

bool leadsThrough(const Leg& leg, const PlacedThing& thing) {
    const FoundValue height = thing.value.find("height");
    if (thing.map != leg.map || !height || height->number() < kLow) return false;
    const double half = height->number() / 2.0;
    if (thing.z.value() - half >= leg.high || thing.z.value() + half <= leg.low) return false;
    const double wayX = (leg.to.x - leg.from.x).value();
    const double wayY = (leg.to.y - leg.from.y).value();
    const double toX = (thing.x - leg.from.x).value();
    const double toY = (thing.y - leg.from.y).value();
    const double squared = wayX * wayX + wayY * wayY;
    const double share =
        squared > 0.0 ? std::clamp((toX * wayX + toY * wayY) / squared, 0.0, 1.0) : 0.0;
    const double offX = toX - share * wayX;
    const double offY = toY - share * wayY;
    return offX * offX + offY * offY < kNear * kNear;
}

void findOnPaths(Reading& reading) {
    const World& world = reading.description.world;
    std::size_t looks = 0;
    for (const PlacedPath& placed : reading.paths) {
        const ObjectMotion& motion = world.movingObjects.motions[placed.motion];
        const auto& points = world.movingObjects.paths[static_cast<std::size_t>(motion.path)];
        const Object& object = world.maps[static_cast<std::size_t>(motion.map)]
                                   .objects[static_cast<std::size_t>(motion.object)];
        PathPoint before = {motion.map, {object.x, object.y}, object.z};
        auto at = placed.value.begin();
        for (const PathPoint& point : points) {
            const double feet = point.feet.value_or(object.z).value();
            const Leg leg = {static_cast<std::size_t>(point.map), before.place, point.place, feet,
                             feet + object.height.value()};
            looks += reading.things.size();
            if (looks > kMostLooks) return;
            for (const PlacedThing& thing : reading.things) {
                if (point.map != before.map || !isObject(thing) || !leadsThrough(leg, thing))
                    continue;
                addMistake(reading, *at,
                           words("a way to this point through the object at x "_later,
                                 Fixed{thing.x.value(), 2}, ", y ", Fixed{thing.y.value(), 2},
                                 ": the figure walks through it"_later),
                           "a way around it"_later);
                break;
            }
            before = point;
            ++at;
        }
    }
}

}  // namespace

void findThingsInTheWay(Reading& reading) {
    findInBlocks(reading);
    findOnPaths(reading);
}

}  // namespace slicecast
