#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/collision.h"
#include "world/map_entry.h"
#include "world/player.h"
#include "world/way_out.h"

namespace slicecast {
namespace {

constexpr NumberRange kHeight = {0.0, kMaxHeight, false, "a number from 0 to 1000"};
constexpr NumberRange kLook = {-kLookLimit, kLookLimit, false,
                               "a number from -1.5 to 1.5, in screen heights"};

static_assert(kMaxHeight == 1000.0 && kLookLimit == 1.5, "as the words say");

// Names what the body overlaps.
std::string obstacle(const World& world, const Map& map, const Box& body) {
    for (int y = body.north.tile(); y <= body.south.tile(); ++y) {
        for (int x = body.west.tile(); x <= body.east.tile(); ++x) {
            if (!map.contains(x, y)) return "over the edge of the map";
            for (int level = 0; level < map.levels; ++level) {
                const BlueprintId id = map.cell(x, y, level);
                const CellBlueprint& block = world.blueprints[id];
                if (id == kEmptyCell || block.isWater ||
                    tileEdge(level) + block.top <= body.bottom ||
                    tileEdge(level) + block.bottom >= body.top)
                    continue;
                const bool isBeside = tileEdge(x) >= body.east || tileEdge(y) >= body.south;
                if (isBeside) continue;
                return words("into the block \"", block.name, "\" at x ", x, ", y ", y, ", level ",
                             level);
            }
        }
    }
    return "through the ceiling";
}

// The player must not start in a block or outside the map.
void checkPosition(Reading& reading, JsonValue value, const Start& start) {
    const World& world = reading.description.world;
    const Map& map = world.maps[static_cast<std::size_t>(start.map)];
    if (!map.contains(start.x.tile(), start.y.tile())) {
        reading.checker.add(value, "a start outside the map"_later,
                            {"x below ", map.width, " and y below ", map.depth});
        return;
    }
    // The player starts crouched where there is no room to stand.
    const Box body = bodyBox(start.x, start.y, start.z, kCrouchedHeight);
    if (isFree(world, start.map, body)) {
        if (!isFree(world, {.map = start.map,
                            .box = body,
                            .eye = {start.x, start.y, start.z + kCrouchedEye},
                            .behind = {}})) {
            reading.checker.add(value,
                                "a start that reaches through a portal into something solid"_later,
                                "free room for the player on both sides of a portal"_later);
            return;
        }
        if (hasWayOut(world, start.map, start.x, start.y, start.z)) return;
        reading.checker.warn(value, "a start from which the player can walk to no other tile"_later,
                             "a way out with at least 0.35 of free height and no step above 0.79, "
                             "the height of a jump"_later);
        return;
    }
    reading.checker.add(value, {"a start that reaches "_later, obstacle(world, map, body)},
                        "free room for the player: 0.4 wide and, when crouched, 0.35 high"_later);
}

// Number keys enter every map; warns of maps where the player would be trapped.
void checkEntries(Reading& reading) {
    const World& world = reading.description.world;
    for (std::size_t map = 0; map < reading.mapValues.size(); ++map) {
        const int index = static_cast<int>(map);
        if (index == world.start.map) continue;
        const MapEntry entry = findMapEntry(world, index);
        if (!entry.stands || hasWayOut(world, index, entry.x, entry.y, entry.feet)) continue;
        reading.checker.warn(
            reading.mapValues[map],
            {"a map that its number key enters at x "_later, entry.x.tile(), ", y ", entry.y.tile(),
             ", from where the player can walk to no other tile"_later},
            "a way out of the free tile nearest to the middle of the map"_later);
    }
}

}  // namespace

void readStart(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    const auto fields = checker.fields(value, {"map", "place", "x", "y", "z", "heading", "look"},
                                       "the start: an object with \"x\" and \"y\""_onFault);
    if (!fields) return;
    const std::size_t faultsBefore = checker.count();
    Start& start = reading.description.world.start;
    const auto inMap = fields->mapOr(reading.maps, 0);
    start.map = inMap.value_or(0);
    const NamedPlace place = readPosition(reading, value, *fields, false, inMap);
    start.x = toCoordinate(place.x);
    start.y = toCoordinate(place.y);
    start.z = toCoordinate(fields->number("z", kHeight, place.z.value_or(0.0)));
    start.headingDegrees = fields->number("heading", kHeadingRange, place.heading.value_or(0.0));
    start.look = fields->number("look", kLook, 0.0);

    const auto map = static_cast<std::size_t>(start.map);
    // Not checked among faulty blocks or maps: the position may be right.
    const bool isMapSound =
        reading.areBlueprintsSound && map < reading.isMapSound.size() && reading.isMapSound[map];
    if (checker.count() == faultsBefore && isMapSound) checkPosition(reading, value, start);
    // Scenes with faults get no warnings.
    if (checker.count() == 0) checkEntries(reading);
}

}  // namespace slicecast
