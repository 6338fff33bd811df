// How an object moves.
#include "scene/limits.h"
#include "scene/readers.h"

namespace slicecast {
namespace {

constexpr NumberRange kSpeed = {0.0, kMaxObjectSpeed, true,
                                "a number above 0 and at most 16, in units per second"};
constexpr NumberRange kObjectReach = {0.0, kMaxObjectReach, true,
                                      "a number above 0 and at most 1000, in units"};
static_assert(kMaxObjectSpeed == 16.0 && kMaxObjectReach == 1000.0, "as the words say");

using Kind = ObjectMotion::Kind;
constexpr Named<Kind> kKinds[] = {
    {Kind::wander, "wander"}, {Kind::pace, "pace"}, {Kind::circle, "circle"}};

}  // namespace

ReadMotion readObjectMotion(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    ReadMotion read;
    const auto fields = checker.fields(value, {"kind", "speed", "heading", "reach"},
                                       "a motion: an object with \"kind\" and \"speed\"");
    if (!fields) return read;
    fields->requireChoice("kind", kKinds);
    read.motion.kind = fields->choice("kind", kKinds, Kind::wander);
    fields->require("speed", kSpeed.words);
    read.motion.speed = fields->number("speed", kSpeed, 1.0);
    read.motion.headingDegrees = fields->number("heading", kHeadingRange, 0.0);
    read.hasHeading = static_cast<bool>(fields->find("heading"));
    // Only "wander" works without "reach".
    if (read.motion.kind != Kind::wander) fields->require("reach", kObjectReach.words);
    read.motion.reach = toCoordinate(fields->number("reach", kObjectReach, 0.0));
    return read;
}

}  // namespace slicecast
