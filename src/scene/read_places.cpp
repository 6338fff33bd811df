// Named places of maps, and what names them instead of giving x and y.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

namespace slicecast {
namespace {

constexpr NumberRange kPlaceHeight = {0.0, kMaxHeight, false, "a number from 0 to 1000"};
static_assert(kMaxHeight == 1000.0, "as the words say");

// { "x", "y", "z", "heading" }
__attribute__((noinline)) NamedPlace readPlace(Reading& reading, JsonValue value, bool hasSize,
                                               const Map& map) {
    Checker& checker = reading.checker;
    NamedPlace place = {value};
    const auto fields = checker.fields(value, {"x", "y", "z", "heading"},
                                       "a place: an object with \"x\" and \"y\""_onFault);
    if (!fields) return place;
    const std::size_t faultsBefore = checker.count();
    for (const char* key : {"x", "y"}) fields->require(key, kOnMapRange.words);
    place.x = fields->number("x", kOnMapRange, 0.0);
    place.y = fields->number("y", kOnMapRange, 0.0);
    if (const auto z = fields->find("z")) place.z = checker.number(*z, kPlaceHeight);
    if (const auto heading = fields->find("heading"))
        place.heading = checker.number(*heading, kHeadingRange);
    if (checker.count() == faultsBefore && hasSize &&
        !map.contains(static_cast<int>(place.x), static_cast<int>(place.y)))
        checker.add(value, "a place outside the map"_later,
                    {"x below ", map.width, " and y below ", map.depth});
    return place;
}

}  // namespace

__attribute__((noinline)) void readPlaces(Reading& reading, JsonValue value, bool hasSize,
                                          const Map& map) {
    Checker& checker = reading.checker;
    Places& places = reading.places.back();
    if (!value.isObject() || value.count() > kMaxPlaces) {
        checker.refuse(value, {"an object with at most "_later, kMaxPlaces, " places, by name"});
        places.names.takeAny();
        return;
    }
    for (const JsonValue member : value) {
        checker.checkName(member);
        places.names.add(member.key(), static_cast<std::uint16_t>(places.places.size()));
        places.places.push_back(readPlace(reading, member, hasSize, map));
    }
}

__attribute__((noinline)) NamedPlace findPlace(Reading& reading, JsonValue value,
                                               std::optional<std::uint16_t> map) {
    NamedPlace nowhere = {value};
    // In a map with a fault, the name may be right
    if (!map || *map >= reading.places.size()) return nowhere;
    Places& places = reading.places[*map];
    const auto number = reading.checker.name(value, places.names, "place");
    if (!number || *number >= places.places.size()) return nowhere;
    places.places[*number].isUsed = true;
    return places.places[*number];
}

NamedPlace readPosition(Reading& reading, JsonValue value, const Fields& fields, bool isTile,
                        std::optional<std::uint16_t> map) {
    const NumberRange& range = isTile ? kTile : kOnMapRange;
    const auto name = fields.find("place");
    for (const char* key : {"x", "y"}) {
        if (!name) {
            fields.require(key, range.words);
        } else if (const auto other = fields.find(key)) {
            reading.checker.addAtKey(*other, {quoted(key), " beside a \"place\""},
                                     "\"place\", or \"x\" and \"y\""_later);
        }
    }
    if (name) return findPlace(reading, *name, map);
    NamedPlace place = {value};
    place.x = isTile ? fields.wholeNumber("x", range, 0) : fields.number("x", range, 0.0);
    place.y = isTile ? fields.wholeNumber("y", range, 0) : fields.number("y", range, 0.0);
    return place;
}

}  // namespace slicecast
