// Sprites and the objects that show them.
#include "base/angle.h"
#include "base/later_text.h"
#include "base/name_index.h"
#include "base/number_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr NumberRange kFeet = {0.0, kMaxHeight, false, "a number from 0 to 1000"};
static_assert(kMaxHeight == 1000.0, "as the words say");

// Adds the motion of the next object of the map being read. Its number among all moving objects
// seeds its random numbers.
void addMotion(Reading& reading, JsonValue value, const ReadMotion& read, int object) {
    ObjectMotion motion = read.motion;
    std::vector<ObjectMotion>& motions = reading.description.world.movingObjects.motions;
    if (motions.size() == static_cast<std::size_t>(kMaxMovingObjects)) {
        reading.checker.add(value, words("more than ", kMaxMovingObjects, " moving objects"),
                            {"at most ", kMaxMovingObjects, " in a scene"});
        return;
    }
    motion.map = static_cast<int>(reading.description.world.maps.size());
    motion.object = object;
    motion.random = Random(motions.size());
    if (read.path) {
        std::vector<std::vector<PathPoint>>& paths = reading.description.world.movingObjects.paths;
        motion.path = static_cast<int>(paths.size());
        paths.emplace_back();
        reading.paths.push_back({*read.path, motions.size()});
    }
    reading.placedMotions.push_back({value, motions.size()});
    motions.push_back(motion);
}

// An object but for its place; read once, it may stand in many.
struct ReadObject {
    JsonValue value;
    Object object = {};
    FoundValue lamp = {};
    FoundValue find = {};
    FoundValue message = {};
    std::optional<ReadMotion> moves = {};
    std::optional<Find> found = {};
    std::optional<Notice> notice = {};
};

// { "sprite", "z", "width", "height", "light", "glow", "lamp", "float", "heading", "find",
// "message", "motion" }; a width of 0 is found from the sprite later.
ReadObject readObject(Reading& reading, JsonValue value, const Fields& fields) {
    Checker& checker = reading.checker;
    ReadObject read = {value};
    Object& object = read.object;
    if (const auto sprite = fields.require("sprite", "the name of a sprite"))
        object.sprite = checker.name(*sprite, reading.sprites, "sprite").value_or(0);
    fields.require("height", kObjectSizeRange.words);
    object.z = toCoordinate(fields.number("z", kFeet, 0.0));
    object.height = toCoordinate(fields.number("height", kObjectSizeRange, 1.0));
    object.width = toCoordinate(fields.number("width", kObjectSizeRange, 0.0));
    object.light = fields.number("light", kUnitRange, 1.0);
    object.glow = fields.flag("glow", false);
    object.floats = fields.flag("float", false);
    const auto motion = fields.find("motion");
    read.find = fields.find("find");
    read.message = fields.find("message");
    read.lamp = fields.find("lamp");
    if (read.lamp) {
        object.lamp = readLamp(reading, *read.lamp);
        if (object.floats || motion)
            checker.add(*read.lamp, "a lamp on an object that moves"_later,
                        "\"lamp\" without \"float\" and \"motion\": lamps stand still"_later);
        if (read.find)
            checker.add(*read.lamp, "a lamp on a find",
                        "\"lamp\" without \"find\": finds are taken"_later);
    }
    if (const auto heading = fields.find("heading")) {
        const SineCosine facing =
            sineCosineDegrees(checker.number(*heading, kHeadingRange).value_or(0.0));
        object.facingX = toCoordinate(facing.cosine);
        object.facingY = toCoordinate(facing.sine);
        if (motion)
            checker.addAtKey(*heading, "a heading beside a motion"_later,
                             "\"heading\" within \"motion\""_later);
    }
    if (motion) read.moves = readObjectMotion(reading, *motion);
    if (read.find) read.found = readFindKind(reading, *read.find);
    if (read.message) read.notice = readObjectMessage(reading, *read.message);
    return read;
}

// Puts it into a place of the map, with all that belongs to it. False after a fault.
bool placeObject(Reading& reading, const ReadObject& read, Coordinate x, Coordinate y, Map& map) {
    const std::size_t faultsBefore = reading.checker.count();
    Object object = read.object;
    object.x = x;
    object.y = y;
    const auto add = [&](JsonValue at, const char* what, Coordinate above) {
        reading.things.push_back(
            {at, what, reading.description.world.maps.size(), x, y, object.z + above});
    };
    if (!read.moves) add(read.value, "an object", {object.height.raw / 2});
    // It hangs at four fifths of the object's height
    if (read.lamp) add(*read.lamp, "a lamp", {object.height.raw / 5 * 4});
    const auto index = static_cast<int>(map.objects.size());
    if (read.found) placeFind(reading, *read.find, *read.found, index);
    if (read.notice) placeObjectMessage(reading, *read.message, *read.notice, index);
    if (reading.checker.count() != faultsBefore) return false;
    if (read.moves) addMotion(reading, read.value, *read.moves, index);
    map.objects.push_back(object);
    return reading.checker.count() == faultsBefore;
}

// { "x", "y" and the keys of readObject }
void readOneObject(Reading& reading, JsonValue value, bool hasSize, Map& map) {
    Checker& checker = reading.checker;
    const auto fields =
        checker.fields(value,
                       {"sprite", "x", "y", "z", "width", "height", "light", "glow", "lamp",
                        "float", "heading", "find", "message", "motion"},
                       "an object: an object with \"sprite\", \"x\", \"y\" and \"height\""_onFault);
    if (!fields) return;
    const std::size_t faultsBefore = checker.count();
    for (const char* key : {"x", "y"}) fields->require(key, kOnMapRange.words);
    const Coordinate x = toCoordinate(fields->number("x", kOnMapRange, 0.0));
    const Coordinate y = toCoordinate(fields->number("y", kOnMapRange, 0.0));
    const ReadObject read = readObject(reading, value, *fields);
    if (checker.count() == faultsBefore && hasSize && !map.contains(x.tile(), y.tile())) {
        checker.add(value, "an object outside the map"_later,
                    {"x below ", map.width, " and y below ", map.depth});
    }
    if (checker.count() == faultsBefore) placeObject(reading, read, x, y, map);
}

std::size_t objectsBefore(const Reading& reading) {
    std::size_t before = 0;
    for (const Map& other : reading.description.world.maps) before += other.objects.size();
    return before;
}

void refuseObjects(Reading& reading, JsonValue value, std::size_t count) {
    reading.checker.add(
        value, {static_cast<std::int64_t>(count), " objects, counting those of earlier maps"_later},
        {"at most ", kMaxObjects, " in a scene"});
}

}  // namespace

void readSprites(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isObject()) {
        checker.refuse(value, "the sprites: an object with a PNG file for each name"_later);
        reading.sprites.takeAny();
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxTextures)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "sprite"},
                    {"at most ", kMaxTextures});
        reading.sprites.takeAny();
        return;
    }
    NameIndex ids;
    std::vector<std::string> sheets;  // the names in the index; reserved, so that none moves
    sheets.reserve(value.count());
    for (const JsonValue member : value) {
        checker.checkName(member);
        // Names of the same picture are one sprite
        TextureReference reference = readPicture(checker, member, false);
        const auto next = static_cast<std::uint32_t>(reading.description.sprites.size());
        const std::uint32_t id =
            ids.add(sheets.emplace_back(words(reference.image.file, "\n", reference.frames, " ",
                                              Shortest{reference.rate}, " ", reference.views)),
                    next);
        reading.sprites.add(member.key(), static_cast<SpriteId>(id));
        if (id != next) continue;
        Sprite sprite;
        sprite.name = std::string(member.key());
        reading.description.world.sprites.push_back(std::move(sprite));
        reading.description.sprites.push_back(std::move(reference));
    }
}

void readObjects(Reading& reading, JsonValue value, bool hasSize, Map& map) {
    Checker& checker = reading.checker;
    if (!value.isArray()) {
        checker.refuse(value, "an array of objects");
        return;
    }
    const std::size_t count = objectsBefore(reading) + value.count();
    if (count > static_cast<std::size_t>(kMaxObjects)) return refuseObjects(reading, value, count);
    for (const JsonValue element : value) readOneObject(reading, element, hasSize, map);
}

__attribute__((noinline)) void readObjectRows(Reading& reading, JsonValue value, bool hasSize,
                                              Map& map) {
    constexpr std::uint16_t kNobody = 0xffff;
    Checker& checker = reading.checker;
    const auto fields =
        checker.fields(value, {"legend", "rows"},
                       "objects by character: an object with \"legend\" and \"rows\""_onFault);
    if (!fields) return;
    const std::size_t faultsBefore = checker.count();
    const auto list = fields->require("legend", "an object for each character");
    const auto rows = fields->require("rows", "an array of rows");
    if (!list || !rows) return;
    Legend legend(kNobody, kNobody);
    readLegend(checker, *list, nullptr, "object", legend);
    if (!list->isObject() || list->count() > kMaxLegend) return;
    std::vector<ReadObject> kinds;
    for (const JsonValue member : *list) {
        const auto parts =
            checker.fields(member,
                           {"sprite", "z", "width", "height", "light", "glow", "lamp", "float",
                            "heading", "find", "message", "motion"},
                           "an object: an object with \"sprite\" and \"height\""_onFault);
        kinds.push_back(parts ? readObject(reading, member, *parts) : ReadObject{member});
    }
    std::vector<std::uint16_t> tiles(map.floor.tiles.size(), kNobody);
    readTileRows(reading, *rows, legend, kNobody, map, hasSize, tiles);
    const auto count = static_cast<std::size_t>(
        std::count_if(tiles.begin(), tiles.end(), [](auto kind) { return kind != kNobody; }));
    const std::size_t all = objectsBefore(reading) + map.objects.size() + count;
    if (all > static_cast<std::size_t>(kMaxObjects)) return refuseObjects(reading, *rows, all);
    if (checker.count() != faultsBefore) return;
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
        if (tiles[tile] == kNobody) continue;
        const auto width = static_cast<std::size_t>(map.width);
        const Coordinate half = toCoordinate(0.5);
        if (!placeObject(reading, kinds[tiles[tile]],
                         tileEdge(static_cast<int>(tile % width)) + half,
                         tileEdge(static_cast<int>(tile / width)) + half, map))
            return;
    }
}

}  // namespace slicecast
