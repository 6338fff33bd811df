// Sprites and the objects that show them.
#include "base/angle.h"
#include "base/later_text.h"
#include "base/name_index.h"
#include "base/number_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

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

// { "sprite", "x", "y", "z", "width", "height", "light", "glow", "lamp", "float", "heading",
// "find", "message", "motion" }; a width of 0 is found from the sprite later.
std::optional<Object> readObject(Reading& reading, JsonValue value, bool hasSize, const Map& map) {
    Checker& checker = reading.checker;
    const auto fields =
        checker.fields(value,
                       {"sprite", "x", "y", "z", "width", "height", "light", "glow", "lamp",
                        "float", "heading", "find", "message", "motion"},
                       "an object: an object with \"sprite\", \"x\", \"y\" and \"height\"");
    if (!fields) return std::nullopt;
    const std::size_t faultsBefore = checker.count();
    Object object;
    if (const auto sprite = fields->require("sprite", "the name of a sprite"))
        object.sprite = checker.name(*sprite, reading.sprites, "sprite").value_or(0);
    for (const char* key : {"x", "y"}) fields->require(key, kOnMapRange.words);
    fields->require("height", kObjectSizeRange.words);
    object.x = toCoordinate(fields->number("x", kOnMapRange, 0.0));
    object.y = toCoordinate(fields->number("y", kOnMapRange, 0.0));
    object.z = toCoordinate(fields->number("z", kFeet, 0.0));
    object.height = toCoordinate(fields->number("height", kObjectSizeRange, 1.0));
    object.width = toCoordinate(fields->number("width", kObjectSizeRange, 0.0));
    object.light = fields->number("light", kUnitRange, 1.0);
    object.glow = fields->flag("glow", false);
    object.floats = fields->flag("float", false);
    const auto place = [&](JsonValue at, const char* what, Coordinate above) {
        reading.things.push_back({at, what, reading.description.world.maps.size(), object.x,
                                  object.y, object.z + above});
    };
    if (!fields->find("motion")) place(value, "an object", {object.height.raw / 2});
    if (const auto lamp = fields->find("lamp")) {
        object.lamp = readLamp(reading, *lamp);
        if (object.floats || fields->find("motion"))
            checker.add(*lamp, "a lamp on an object that moves"_later,
                        "\"lamp\" without \"float\" and \"motion\": lamps stand still"_later);
        // It hangs at four fifths of the object's height
        place(*lamp, "a lamp", {object.height.raw / 5 * 4});
        if (fields->find("find"))
            checker.add(*lamp, "a lamp on a find",
                        "\"lamp\" without \"find\": finds are taken"_later);
    }
    if (const auto heading = fields->find("heading")) {
        const SineCosine facing =
            sineCosineDegrees(checker.number(*heading, kHeadingRange).value_or(0.0));
        object.facingX = toCoordinate(facing.cosine);
        object.facingY = toCoordinate(facing.sine);
        if (fields->find("motion"))
            checker.addAtKey(*heading, "a heading beside a motion"_later,
                             "\"heading\" within \"motion\""_later);
    }
    std::optional<ReadMotion> moves;
    if (const auto motion = fields->find("motion")) moves = readObjectMotion(reading, *motion);
    if (checker.count() == faultsBefore && hasSize &&
        !map.contains(object.x.tile(), object.y.tile())) {
        checker.add(value, "an object outside the map"_later,
                    {"x below ", map.width, " and y below ", map.depth});
    }
    const auto index = static_cast<int>(map.objects.size());
    if (const auto find = fields->find("find")) readFind(reading, *find, index);
    if (const auto message = fields->find("message")) readObjectMessage(reading, *message, index);
    if (checker.count() != faultsBefore) return std::nullopt;
    if (moves) addMotion(reading, value, *moves, index);
    return object;
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
    std::size_t before = 0;
    for (const Map& other : reading.description.world.maps) before += other.objects.size();
    if (before + value.count() > static_cast<std::size_t>(kMaxObjects)) {
        checker.add(value,
                    {static_cast<std::int64_t>(before + value.count()),
                     " objects, counting those of earlier maps"_later},
                    {"at most ", kMaxObjects, " in a scene"});
        return;
    }
    for (const JsonValue element : value) {
        if (const auto object = readObject(reading, element, hasSize, map))
            map.objects.push_back(*object);
    }
}

}  // namespace slicecast
