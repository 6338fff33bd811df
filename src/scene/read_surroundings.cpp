// What surrounds the blocks of a map: floor, ceiling, light and fog. For the sky see read_sky.cpp,
// for baked light read_baked_light.cpp.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

namespace slicecast {
namespace {

constexpr NumberRange kCeilingHeight = {1.0 / 65536.0, kMaxHeight, false,
                                        "a number above 0 and at most 1000"};
constexpr NumberRange kIntensity = {0.0, kMaxIntensity, false, "a number from 0 to 1000"};
constexpr NumberRange kMultiplier = {0.0, kMaxMultiplier, false, "a number from 0 to 1000000"};
constexpr NumberRange kFogStart = {0.0, kMaxFar, false, "a number from 0 to 100000"};
constexpr NumberRange kFogEnd = {0.0, kMaxFar, true, "a number above 0 and at most 100000"};
static_assert(kMaxHeight == 1000.0 && kMaxIntensity == 1000.0 && kMaxMultiplier == 1.0e6 &&
                  kMaxFar == 1.0e5,
              "as the words say");

// "legend" and "tiles" of a floor or ceiling: a texture for each tile.
void readTiles(Reading& reading, const Fields& fields, TextureId own, TextureId space,
               const Map& map, bool hasSize, std::vector<TextureId>& tiles) {
    Checker& checker = reading.checker;
    Legend legend(own, space);
    if (const auto member = fields.find("legend"))
        readLegend(checker, *member, &reading.textures, "texture", legend);
    if (const auto rows = fields.find("tiles"))
        readTileRows(reading, *rows, legend, own, map, hasSize, tiles);
}

}  // namespace

void readTileRows(Reading& reading, JsonValue rows, const Legend& legend, std::uint16_t otherwise,
                  const Map& map, bool hasSize, std::vector<std::uint16_t>& tiles) {
    Checker& checker = reading.checker;
    if (!rows.isArray()) {
        checker.refuse(rows, "an array of rows, as in a level"_later);
        return;
    }
    const bool fits = rows.count() == static_cast<std::size_t>(map.depth);
    if (hasSize && !fits) {
        checker.add(rows, Counted{static_cast<std::int64_t>(rows.count()), "row"},
                    {Counted{map.depth, "row"}, ", as in the map's levels"_later});
    }
    std::vector<std::uint16_t> ids;
    int y = -1;
    for (const JsonValue row : rows) {
        ++y;
        if (!row.isText()) {
            checker.refuse(row, "a row: a text with one character for each tile"_later);
            continue;
        }
        if (!hasSize) continue;
        ids.assign(static_cast<std::size_t>(map.width), otherwise);
        readRow(checker, row, y, map.width, legend, ids);
        for (int x = 0; y < map.depth && x < map.width; ++x)
            tiles[map.tileIndex(x, y)] = ids[static_cast<std::size_t>(x)];
    }
}

ReadMirror readMirror(Checker& checker, const Fields& fields) {
    const auto share = [&](const char* key) {
        return static_cast<std::uint8_t>(255.0 * fields.number(key, kUnitRange, 0.0) + 0.5);
    };
    const auto ripples = fields.find("ripples");
    if (ripples && !fields.find("mirror"))
        checker.addAtKey(*ripples, "ripples without a mirror"_later,
                         "a \"mirror\" beside them: ripples move what it reflects"_later);
    return {share("mirror"), share("ripples")};
}

void readFloor(Reading& reading, JsonValue value, bool hasSize, Map& map) {
    std::optional<Fields> fields;
    map.floor.texture = 0;
    if (value.isText()) {
        map.floor.texture = reading.checker.name(value, reading.textures, "texture").value_or(0);
    } else {
        fields = reading.checker.fields(
            value, {"texture", "light", "glow", "mirror", "ripples", "water", "legend", "tiles"},
            "a texture's name, or an object with \"texture\""_onFault);
        if (!fields) return;
        if (const auto texture = fields->require("texture", "the name of a texture")) {
            map.floor.texture =
                reading.checker.name(*texture, reading.textures, "texture").value_or(0);
        }
        map.floor.light = fields->number("light", kUnitRange, 1.0);
        map.floor.glow = fields->flag("glow", false);
        const ReadMirror mirror = readMirror(reading.checker, *fields);
        map.floor.mirror = mirror.mirror;
        map.floor.ripples = mirror.ripples;
        if (const auto water = fields->find("water")) {
            map.floor.water =
                reading.checker.name(*water, reading.textures, "texture").value_or(kNoTexture);
        }
    }
    map.floor.tiles.assign(map.floor.tiles.size(), map.floor.texture);
    if (!fields) return;
    readTiles(reading, *fields, map.floor.texture, map.floor.texture, map, hasSize,
              map.floor.tiles);
    const auto& tiles = map.floor.tiles;
    if (map.floor.water != kNoTexture && !tiles.empty() &&
        std::find(tiles.begin(), tiles.end(), map.floor.water) == tiles.end())
        reading.checker.warn(*fields->find("water"), "a water that no tile of the floor has"_later,
                             "its texture on some tiles of the floor"_later);
}

void readCeiling(Reading& reading, JsonValue value, bool hasSize, Map& map) {
    const auto fields =
        reading.checker.fields(value, {"height", "texture", "light", "glow", "legend", "tiles"},
                               "a ceiling: an object with \"height\" and \"texture\""_onFault);
    if (!fields) return;
    if (const auto height = fields->require("height", kCeilingHeight.words)) {
        map.ceiling.height =
            toCoordinate(reading.checker.number(*height, kCeilingHeight).value_or(1.0));
    }
    TextureId own = 0;
    if (const auto texture = fields->require("texture", "the name of a texture")) {
        own = reading.checker.name(*texture, reading.textures, "texture").value_or(0);
    }
    map.ceiling.light = fields->number("light", kUnitRange, 1.0);
    map.ceiling.glow = fields->flag("glow", false);
    if (hasSize) map.ceiling.tiles.assign(map.floor.tiles.size(), own);
    readTiles(reading, *fields, own, kNoTexture, map, hasSize, map.ceiling.tiles);
}

void readLight(Reading& reading, JsonValue value, Light& light) {
    const auto fields = reading.checker.fields(
        value, {"on", "intensity", "multiplier", "darkest", "brightest"},
        "an object such as { \"intensity\": 1.5, \"multiplier\": 5 }"_onFault);
    if (!fields) return;
    const std::size_t faultsBefore = reading.checker.count();
    const Light normal;
    light.on = fields->flag("on", normal.on);
    light.intensity = fields->number("intensity", kIntensity, normal.intensity);
    light.multiplier = fields->number("multiplier", kMultiplier, normal.multiplier);
    light.darkest = fields->number("darkest", kUnitRange, normal.darkest);
    light.brightest = fields->number("brightest", kUnitRange, normal.brightest);
    if (reading.checker.count() == faultsBefore && light.darkest > light.brightest) {
        const auto given =
            fields->find("darkest") ? fields->find("darkest") : fields->find("brightest");
        reading.checker.add(
            *given, "a \"darkest\" that is above \"brightest\""_later,
            "\"darkest\" at most \"brightest\"; their defaults are 0.1 and 1"_later);
    }
}

void readFog(Reading& reading, JsonValue value, Fog& fog) {
    const auto fields = reading.checker.fields(
        value, {"start", "end"}, "an object such as { \"start\": 5, \"end\": 40 }"_onFault);
    if (!fields) return;
    const std::size_t faultsBefore = reading.checker.count();
    fog.on = true;
    fog.start = fields->number("start", kFogStart, 0.0);
    const auto end = fields->require("end", kFogEnd.words);
    fog.end = fields->number("end", kFogEnd, 1.0);
    if (reading.checker.count() == faultsBefore && fog.start >= fog.end) {
        reading.checker.add(*end, "an \"end\" of the fog that is not beyond its \"start\""_later,
                            "\"end\" greater than \"start\""_later);
    }
}

}  // namespace slicecast
