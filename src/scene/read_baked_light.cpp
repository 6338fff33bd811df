// Baked light: the sun, the ambient light and lamps.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace slicecast {
namespace {

constexpr NumberRange kAltitude = {0.0, 90.0, true, "a number above 0 and at most 90, in degrees"};
constexpr NumberRange kStrength = {0.0, kStrongestLamp, false, "a number from 0 to 16"};
constexpr NumberRange kRadius = {1.0 / 65536.0, kFarthestLamp.value(), false,
                                 "a number above 0 and at most 16, in units"};
constexpr NumberRange kLampHeight = {0.0, kMaxHeight, false, "a number from 0 to 1000"};
static_assert(kStrongestLamp == 16.0 && kFarthestLamp == tileEdge(16) && kMaxHeight == 1000.0,
              "as the words say");

constexpr Colour kSunlight = {255, 244, 224, 255};

void readSun(Reading& reading, JsonValue value, BakedLight& baked) {
    const auto fields =
        reading.checker.fields(value, {"azimuth", "altitude", "colour"},
                               "an object such as { \"azimuth\": 225, \"altitude\": 40 }"_onFault);
    if (!fields) return;
    baked.azimuth = fields->number("azimuth", kHeadingRange, 225.0);
    baked.altitude = fields->number("altitude", kAltitude, 45.0);
    baked.sun = fields->colour("colour", kSunlight);
}

void readLamps(Reading& reading, JsonValue value, bool hasSize, Map& map) {
    Checker& checker = reading.checker;
    if (!value.isArray()) {
        checker.refuse(value, "an array of lamps");
        return;
    }
    if (value.count() > kMaxLamps) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "lamp"},
                    {"at most ", kMaxLamps});
        return;
    }
    for (const JsonValue element : value) {
        const auto fields = checker.fields(element, {"x", "y", "z", "colour", "strength", "radius"},
                                           "a lamp: an object with \"x\", \"y\" and \"z\""_onFault);
        if (!fields) continue;
        const std::size_t faultsBefore = checker.count();
        for (const char* key : {"x", "y"}) fields->require(key, kOnMapRange.words);
        fields->require("z", kLampHeight.words);
        const Lamp lamp = {toCoordinate(fields->number("x", kOnMapRange, 0.0)),
                           toCoordinate(fields->number("y", kOnMapRange, 0.0)),
                           toCoordinate(fields->number("z", kLampHeight, 0.0)),
                           readLampKind(*fields)};
        if (checker.count() == faultsBefore && hasSize &&
            !map.contains(lamp.x.tile(), lamp.y.tile())) {
            checker.add(element, "a lamp outside the map"_later,
                        {"x below ", map.width, " and y below ", map.depth});
        }
        map.baked.lamps.push_back(lamp);
        reading.things.push_back(
            {element, "a lamp", reading.description.world.maps.size(), lamp.x, lamp.y, lamp.z});
    }
}

}  // namespace

LampKind readLampKind(const Fields& fields) {
    LampKind kind;
    kind.colour = fields.colour("colour", kind.colour);
    kind.strength = fields.number("strength", kStrength, kind.strength);
    kind.radius = toCoordinate(fields.number("radius", kRadius, kind.radius.value()));
    return kind;
}

LampId readLamp(Reading& reading, JsonValue value) {
    const auto fields = reading.checker.fields(
        value, {"colour", "strength", "radius"},
        "an object such as { \"colour\": \"#ffc070\", \"radius\": 4 }"_onFault);
    if (!fields) return kNoLamp;
    if (!reading.lamp) reading.lamp = value;
    const LampKind kind = readLampKind(*fields);
    std::vector<LampKind>& kinds = reading.description.world.lampKinds;
    const auto order = [&](LampId a, const LampKind& b) {
        const auto key = [](const LampKind& lamp) {
            return std::tuple(toPixel(lamp.colour), lamp.strength, lamp.radius);
        };
        return key(kinds[a]) < key(b);
    };
    std::vector<LampId>& sorted = reading.lampOrder;
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), kind, order);
    if (place != sorted.end() && kinds[*place] == kind) return *place;
    if (kinds.size() == kNoLamp) {
        reading.checker.add(value, {"more than ", std::int64_t{kNoLamp}, " kinds of lamp"},
                            "fewer; lamps with equal values are of one kind"_later);
        return kNoLamp;
    }
    const auto id = static_cast<LampId>(kinds.size());
    sorted.insert(place, id);
    kinds.push_back(kind);
    return id;
}

void readBakedLight(Reading& reading, JsonValue value, bool hasSize, Map& map) {
    const auto fields =
        reading.checker.fields(value, {"sun", "ambient", "lamps"},
                               "an object with \"sun\", \"ambient\" and \"lamps\""_onFault);
    if (!fields) return;
    map.baked.on = true;
    if (const auto sun = fields->find("sun")) readSun(reading, *sun, map.baked);
    map.baked.ambient = fields->colour("ambient", map.baked.ambient);
    if (const auto lamps = fields->find("lamps")) readLamps(reading, *lamps, hasSize, map);
}

}  // namespace slicecast
