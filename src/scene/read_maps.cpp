#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

namespace slicecast {
namespace {

constexpr NumberRange kFar = {0.0, kMaxFar, true, "a number above 0 and at most 100000"};
static_assert(kMaxFar == 1.0e5, "as the words say");

void readName(Reading& reading, const Fields& fields, std::uint16_t index, Map& map) {
    const auto member = fields.require("name", "the map's name");
    if (!member) return;
    const auto name = reading.checker.text(*member, kMaxNameLength, "the map's name");
    if (!name) return;
    map.name = *name;
    if (reading.maps.find(*name)) {
        reading.checker.add(*member, {"the name ", quoted(*name), " a second time"},
                            "a name that no other map has"_later);
    } else {
        reading.maps.add(member->text(), index);
    }
}

// A ceiling must not pass between the lowest and the highest point of a block with slopes.
void checkCeiling(Reading& reading, JsonValue value, const Map& map) {
    const int level = map.ceiling.height.tile();
    if (map.ceiling.tiles.empty() || level >= map.levels) return;
    const Coordinate height = map.ceiling.height - tileEdge(level);
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const CellBlueprint& block =
                reading.description.world.blueprints[map.cell(x, y, level)];
            if (!block.slopes.any() || height <= block.bottom || height >= block.top ||
                map.ceiling.tiles[map.tileIndex(x, y)] == kNoTexture)
                continue;
            reading.checker.add(value,
                                {"a ceiling through the block "_later, quoted(block.name), " at x ",
                                 x, ", y ", y, ", level ", level, ", which has slopes"},
                                "a ceiling above or below it, or none in its tile"_later);
            return;
        }
    }
}

Map readMap(Reading& reading, JsonValue value, std::size_t index) {
    Checker& checker = reading.checker;
    Map map;
    const auto fields = checker.fields(
        value,
        {"name", "legend", "size", "levels", "places", "floor", "ceiling", "objects", "objectRows",
         "sow", "messages", "portals", "sky", "light", "baked", "fog", "haze", "far"},
        "a map: an object with \"name\", \"levels\" and \"floor\""_onFault);
    reading.places.resize(index + 1);
    if (!fields) return map;
    readName(reading, *fields, static_cast<std::uint16_t>(index), map);

    // The grid comes first: the rest needs its size.
    Legend legend = reading.legend;
    if (const auto own = fields->find("legend"))
        readLegend(checker, *own, &reading.blueprints, "blueprint", legend);
    for (const auto& [sign, blueprint] : legend.entries())
        map.legend.push_back({std::string(sign), blueprint});
    if (const auto levels = fields->require("levels", "an array of levels"))
        readLevels(reading, *levels, fields->find("size"), legend, map);
    const bool hasSize = map.width > 0;
    if (const auto places = fields->find("places")) readPlaces(reading, *places, hasSize, map);

    if (const auto floor = fields->require("floor", "the floor's texture"))
        readFloor(reading, *floor, hasSize, map);
    if (const auto ceiling = fields->find("ceiling")) {
        const std::size_t faultsBefore = checker.count();
        readCeiling(reading, *ceiling, hasSize, map);
        if (checker.count() == faultsBefore && reading.areBlueprintsSound)
            checkCeiling(reading, *ceiling, map);
    }
    if (const auto objects = fields->find("objects")) readObjects(reading, *objects, hasSize, map);
    if (const auto rows = fields->find("objectRows")) readObjectRows(reading, *rows, hasSize, map);
    if (const auto sow = fields->find("sow")) readSowing(reading, *sow);
    if (const auto messages = fields->find("messages")) readMessages(reading, *messages);
    if (const auto portals = fields->find("portals")) reading.portals.push_back({*portals, index});
    if (const auto light = fields->find("light")) readLight(reading, *light, map.light);
    if (const auto baked = fields->find("baked")) {
        readBakedLight(reading, *baked, hasSize, map);
        if (map.light.on) reading.addAim(Aim::What::light, *baked, index);
    }
    if (const auto sky = fields->find("sky")) readSky(reading, *sky, index, map);
    if (const auto fog = fields->find("fog")) readFog(reading, *fog, map.fog);
    map.haze = fields->colour("haze", map.haze);
    map.far = fields->number("far", kFar, kDefaultFar);
    return map;
}

void readMapAt(Reading& reading, std::size_t index) {
    const std::size_t faultsBefore = reading.checker.count();
    reading.description.world.maps.push_back(readMap(reading, reading.mapValues[index], index));
    reading.isMapSound.push_back(reading.checker.count() == faultsBefore);
}

}  // namespace

void readMaps(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isArray() || value.count() == 0) {
        checker.refuse(value, "an array of at least one map"_later);
        reading.maps.takeAny();
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxMaps)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "map"},
                    {"at most ", kMaxMaps});
        reading.maps.takeAny();
        return;
    }
    for (const JsonValue element : value) {
        reading.tasks.add<readMapAt>(reading, reading.mapValues.size());
        reading.mapValues.push_back(element);
    }
}

}  // namespace slicecast
