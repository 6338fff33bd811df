// How an object moves, and what it does when the player comes.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/player.h"

#include <cmath>

namespace slicecast {
namespace {

constexpr NumberRange kSpeed = {0.0, kMaxObjectSpeed, true,
                                "a number above 0 and at most 16, in units per second"};
constexpr NumberRange kObjectReach = {0.0, kMaxObjectReach, true,
                                      "a number above 0 and at most 1000, in units"};
constexpr NumberRange kAlertNear = {0.0, kFarthestNotice, true,
                                    "a number above 0 and at most 32, in units"};
constexpr NumberRange kCalm = {0.5, 60.0, false, "a number from 0.5 to 60, in seconds"};
constexpr NumberRange kWait = {0.0, 3600.0, false, "a number from 0 to 3600, in seconds"};
constexpr NumberRange kPointFeet = {0.0, kMaxHeight, false, "a number from 0 to 1000"};
static_assert(kMaxObjectSpeed == 16.0 && kMaxObjectReach == 1000.0 && kFarthestNotice == 32.0 &&
                  kMaxHeight == 1000.0 && kMaxPathPoints == 64,
              "as the words say");

using Kind = ObjectMotion::Kind;
constexpr Named<Kind> kKinds[] = {{Kind::wander, "wander"},
                                  {Kind::pace, "pace"},
                                  {Kind::circle, "circle"},
                                  {Kind::stand, "stand"},
                                  {Kind::patrol, "patrol"}};
using Reaction = ObjectMotion::Reaction;
constexpr Named<Reaction> kReactions[] = {
    {Reaction::greet, "greet"}, {Reaction::follow, "follow"}, {Reaction::flee, "flee"}};

int motionSteps(double seconds) {
    return static_cast<int>(std::floor(seconds * kStepsPerSecond + 0.5));
}

// { "do", "near", "keep", "speed", "seconds" }
void readAlert(Reading& reading, JsonValue value, ObjectMotion& motion) {
    Checker& checker = reading.checker;
    const auto fields = checker.fields(value, {"do", "near", "keep", "speed", "seconds"},
                                       "what it does: an object with \"do\" and \"near\""_onFault);
    if (!fields) return;
    fields->requireChoice("do", kReactions);
    fields->require("near", kAlertNear.words);
    motion.reaction = fields->choice("do", kReactions, Reaction::greet);
    motion.near = toCoordinate(fields->number("near", kAlertNear, 4.0));
    motion.keep = toCoordinate(fields->number("keep", kAlertNear, 0.9));
    motion.alertSpeed = fields->number("speed", kSpeed, motion.speed);
    motion.calmSteps = motionSteps(fields->number("seconds", kCalm, 3.0));
    const bool keepsToLine = motion.kind == Kind::pace || motion.kind == Kind::circle;
    if (keepsToLine && motion.reaction != Reaction::greet)
        checker.add(value, "an object that leaves its line"_later,
                    "\"do\": \"greet\", or the kind \"stand\", \"wander\" or \"patrol\""_later);
}

void readLooks(Reading& reading, JsonValue value, ObjectMotion& motion) {
    const auto fields = reading.checker.fields(
        value, {"walk", "alert"}, "sprites: an object with \"walk\" and \"alert\""_onFault);
    if (!fields) return;
    if (const auto walk = fields->find("walk"))
        motion.walking = reading.checker.name(*walk, reading.sprites, "sprite");
    if (const auto alert = fields->find("alert"))
        motion.alert = reading.checker.name(*alert, reading.sprites, "sprite");
}

// { "map", "place", "x", "y", "z", "wait" }, or the name of a place
std::optional<PathPoint> readPoint(Reading& reading, JsonValue value, int ownMap) {
    Checker& checker = reading.checker;
    const std::size_t faultsBefore = checker.count();
    PathPoint point;
    point.map = ownMap;
    NamedPlace place = {value};
    if (value.isText()) {
        place = findPlace(reading, value, static_cast<std::uint16_t>(ownMap));
    } else {
        const auto fields =
            checker.fields(value, {"map", "place", "x", "y", "z", "wait"},
                           "a point: an object with \"x\" and \"y\", or a place's name"_onFault);
        if (!fields) return std::nullopt;
        const auto map = fields->mapOr(reading.maps, ownMap);
        point.map = map.value_or(0);
        place = readPosition(reading, value, *fields, false, map);
        if (fields->find("z")) place.z = fields->number("z", kPointFeet, 0.0);
        point.waitSteps = motionSteps(fields->number("wait", kWait, 0.0));
    }
    point.place.x = toCoordinate(place.x);
    point.place.y = toCoordinate(place.y);
    if (place.z) {
        point.feet = toCoordinate(*place.z);
        reading.things.push_back({value, "a point of a path", static_cast<std::size_t>(point.map),
                                  point.place.x, point.place.y, *point.feet});
    }
    if (checker.count() != faultsBefore) return std::nullopt;
    const Map& map = reading.description.world.maps[static_cast<std::size_t>(point.map)];
    if (map.width > 0 && !map.contains(point.place.x.tile(), point.place.y.tile())) {
        checker.add(value, "a point outside the map"_later,
                    {"x below ", map.width, " and y below ", map.depth});
        return std::nullopt;
    }
    return point;
}

}  // namespace

ReadMotion readObjectMotion(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    ReadMotion read;
    const auto fields = checker.fields(
        value, {"kind", "speed", "heading", "reach", "path", "loop", "alert", "solid", "sprites"},
        "a motion: an object with \"kind\" and \"speed\""_onFault);
    if (!fields) return read;
    ObjectMotion& motion = read.motion;
    fields->requireChoice("kind", kKinds);
    motion.kind = fields->choice("kind", kKinds, Kind::wander);
    if (motion.kind != Kind::stand) fields->require("speed", kSpeed.words);
    motion.speed = fields->number("speed", kSpeed, 1.0);
    motion.headingDegrees = fields->number("heading", kHeadingRange, 0.0);
    read.hasHeading = static_cast<bool>(fields->find("heading"));
    if (motion.kind == Kind::pace || motion.kind == Kind::circle)
        fields->require("reach", kObjectReach.words);
    motion.reach = toCoordinate(fields->number("reach", kObjectReach, 0.0));
    read.path = motion.kind == Kind::patrol
                    ? fields->require("path", "an array of points with \"x\" and \"y\"")
                    : fields->find("path");
    if (read.path && motion.kind != Kind::patrol)
        checker.addAtKey(*read.path, "a path of an object that does not patrol"_later,
                         "\"path\" only with \"kind\": \"patrol\""_later);
    motion.loops = fields->flag("loop", true);
    if (const auto alert = fields->find("alert")) readAlert(reading, *alert, motion);
    motion.solid =
        fields->flag("solid", motion.kind == Kind::stand || motion.kind == Kind::patrol ||
                                  motion.reaction != Reaction::none);
    if (const auto sprites = fields->find("sprites")) readLooks(reading, *sprites, motion);
    return read;
}

void placePaths(Reading& reading) {
    Checker& checker = reading.checker;
    World& world = reading.description.world;
    for (const PlacedPath& placed : reading.paths) {
        ObjectMotion& motion = world.movingObjects.motions[placed.motion];
        std::vector<PathPoint>& points =
            world.movingObjects.paths[static_cast<std::size_t>(motion.path)];
        if (!placed.value.isArray() || placed.value.count() == 0 ||
            placed.value.count() > kMaxPathPoints) {
            checker.refuse(placed.value, "an array of 1 to 64 points"_later);
            continue;
        }
        for (const JsonValue element : placed.value)
            if (const auto point = readPoint(reading, element, motion.map))
                points.push_back(*point);
    }
}

}  // namespace slicecast
