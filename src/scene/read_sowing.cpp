// What is sown over a map.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <cmath>

namespace slicecast {
namespace {

constexpr NumberRange kAbove = {0.0, kMaxHeight, false, "a number from 0 to 1000, in units"};
constexpr NumberRange kClear = {0.0, 4096.0, false, "a number from 0 to 4096, in units"};
constexpr NumberRange kSeed = {0.0, 9007199254740992.0, false, "a whole number from 0 to 2^53"};
static_assert(kMaxHeight == 1000.0 && kMaxMapWidth == 4096 && kMaxMapDepth == 4096,
              "as the words say");

constexpr Coordinate kDefaultClear = toCoordinate(1.0);

// A number, or an array of the least and the greatest number.
std::optional<CoordinateRange> readRange(Checker& checker, JsonValue value,
                                         const NumberRange& range) {
    if (!value.isArray()) {
        const auto number = checker.number(value, range);
        if (!number) return std::nullopt;
        return CoordinateRange{toCoordinate(*number), toCoordinate(*number)};
    }
    std::vector<double> numbers;
    for (const JsonValue element : value) {
        const auto number = checker.number(element, range);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    if (numbers.size() != 2 || numbers[0] > numbers[1]) {
        checker.add(value,
                    numbers.size() == 2 ? "a range from a greater to a smaller number"_later
                                        : checker.shown(value),
                    "a number, or an array of the least and the greatest number"_later);
        return std::nullopt;
    }
    return CoordinateRange{toCoordinate(numbers[0]), toCoordinate(numbers[1])};
}

// A name, or an array of names: calls read(value) for each.
template <typename Read>
void readNames(Checker& checker, JsonValue value, const char* expected, Read read) {
    if (value.isText()) return read(value);
    if (!value.isArray() || value.count() == 0) {
        checker.refuse(value, expected);
        return;
    }
    for (const JsonValue element : value) read(element);
}

void readGround(Reading& reading, const Fields& fields, Sowing& sowing) {
    Checker& checker = reading.checker;
    if (const auto on = fields.find("on")) {
        sowing.onFloor = false;
        readNames(
            checker, *on, "\"floor\", the name of a blueprint, or an array of these",
            [&](JsonValue value) {
                if (value.isText() && value.text() == "floor") {
                    sowing.onFloor = true;
                } else if (const auto id = checker.name(value, reading.blueprints, "blueprint")) {
                    sowing.on.push_back(*id);
                }
            });
    }
    if (const auto textures = fields.find("textures")) {
        readNames(checker, *textures, "the name of a texture, or an array of these",
                  [&](JsonValue value) {
                      if (const auto id = checker.name(value, reading.textures, "texture"))
                          sowing.textures.push_back(*id);
                  });
    }
}

void readSown(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    const auto fields = checker.fields(
        value,
        {"sprite", "density", "seed", "height", "width", "above", "on", "textures", "clear",
         "light", "glow", "float", "find", "motion"},
        "something to sow: an object with \"sprite\", \"density\" and \"height\""_onFault);
    if (!fields) return;
    Sowing sowing;
    if (const auto sprite = fields->require("sprite", "the name of a sprite")) {
        sowing.object.sprite = checker.name(*sprite, reading.sprites, "sprite").value_or(0);
    }
    fields->require("density", kUnitRange.words);
    sowing.density = fields->number("density", kUnitRange, 0.0);
    if (const auto seed = fields->find("seed")) {
        const double number = checker.number(*seed, kSeed).value_or(0.0);
        if (number != std::floor(number)) checker.refuse(*seed, kSeed.words);
        sowing.seed = static_cast<std::uint64_t>(number);
    }
    if (const auto height = fields->require("height", kObjectSizeRange.words))
        sowing.height = readRange(checker, *height, kObjectSizeRange).value_or(CoordinateRange{});
    if (const auto above = fields->find("above"))
        sowing.above = readRange(checker, *above, kAbove).value_or(CoordinateRange{});
    readGround(reading, *fields, sowing);
    sowing.object.width = toCoordinate(fields->number("width", kObjectSizeRange, 0.0));
    sowing.clear = toCoordinate(fields->number("clear", kClear, kDefaultClear.value()));
    sowing.object.light = fields->number("light", kUnitRange, 1.0);
    sowing.object.glow = fields->flag("glow", false);
    sowing.object.floats = fields->flag("float", false);
    if (const auto find = fields->find("find")) sowing.find = readFindKind(reading, *find);
    if (const auto motion = fields->find("motion")) {
        const ReadMotion read = readObjectMotion(reading, *motion);
        if (read.motion.kind == ObjectMotion::Kind::patrol)
            checker.add(*motion, "a sown object that patrols"_later,
                        "another kind: a path begins at one place"_later);
        sowing.motion = read.motion;
        sowing.anyHeading = !read.hasHeading;
    }
    reading.sowings.push_back({value, reading.description.world.maps.size(), sowing});
}

}  // namespace

void readSowing(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isArray()) {
        checker.refuse(value, "an array of objects that each say what to sow"_later);
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxSowings)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "element"},
                    {"at most ", kMaxSowings});
        return;
    }
    for (const JsonValue element : value) readSown(reading, element);
}

}  // namespace slicecast
