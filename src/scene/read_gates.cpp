// Gates of blueprints, and which motions they, and moving blocks, may have.
#include "base/later_text.h"
#include "base/number_text.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/player.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr NumberRange kOpening = {kStepSeconds, kLongestGate, false,
                                  "a number from 1/120 to 60, in seconds"};
constexpr NumberRange kHold = {0.0, kLongestGate, false, "a number from 0 to 60, in seconds"};
constexpr NumberRange kGateReach = {0.0, kFarthestGate, false, "a number from 0 to 64, in units"};
constexpr NumberRange kEvery = {kShortestPeriod, kLongestPeriod, false,
                                "a number from 0.1 to 3600, in seconds"};
static_assert(kLongestGate == 60.0 && kFarthestGate == 64.0 && kStepsPerSecond == 120 &&
                  kShortestPeriod == 0.1 && kLongestPeriod == 3600.0 && kFastestMotion == 4.0,
              "as the words say");

// "lever" or ["lever", "bell"], looked up when all blueprints are known.
void readFollowed(Reading& reading, JsonValue value, int kind) {
    if (value.isText()) {
        reading.followed.push_back({value, kind});
        return;
    }
    if (!value.isArray() || value.count() == 0) {
        reading.checker.refuse(value, "the name of a gate's blueprint, or a list of names"_later);
        return;
    }
    for (const JsonValue name : value) reading.followed.push_back({name, kind});
}

// "needs" and "locked" of the next gate; the names of finds are known once all maps are read.
void readLock(Reading& reading, const Fields& fields, GateKind& kind) {
    Checker& checker = reading.checker;
    const auto needs = fields.find("needs");
    if (needs) {
        reading.needs.push_back(
            {*needs, PlacedNeeds::Of::gate, reading.description.world.gateKinds.size()});
        if (kind.startsOpen)
            checker.add(*needs, "a gate that starts open and needs finds"_later,
                        "\"needs\" of a gate that starts closed"_later);
    }
    const auto locked = fields.find("locked");
    if (!locked) return;
    kind.locked = checker
                      .text(*locked, kMaxMessageLength,
                            {"a message of 1 to ", kMaxMessageLength, " characters"})
                      .value_or("");
    if (!needs)
        checker.addAtKey(*locked, "a message of a gate that needs nothing"_later,
                         "\"locked\" together with \"needs\""_later);
}

}  // namespace

// { "seconds", "reach", "keyed", "approach", "hold", "every", "once", "follows", "open", "needs",
// "locked" }
int readGate(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    std::vector<GateKind>& kinds = reading.description.world.gateKinds;
    const int number = static_cast<int>(kinds.size());
    GateKind kind;
    const auto fields = checker.fields(value,
                                       {"seconds", "reach", "keyed", "approach", "hold", "every",
                                        "once", "follows", "open", "needs", "locked"},
                                       "a gate: an object, which may be {}"_onFault);
    if (fields) {
        const auto followed = fields->find("follows");
        kind.steps = std::max(1, stepsOf(fields->number("seconds", kOpening, 0.8)));
        kind.reach = toCoordinate(fields->number("reach", kGateReach, 2.0));
        // What follows others has no key unless it says so
        kind.keyed = fields->flag("keyed", !followed);
        kind.opensOnApproach = static_cast<bool>(fields->find("approach"));
        kind.approach = toCoordinate(fields->number("approach", kGateReach, 0.0));
        kind.holdSteps = std::max(1, stepsOf(fields->number("hold", kHold, 1.0)));
        if (fields->find("every")) kind.everySteps = stepsOf(fields->number("every", kEvery, 1.0));
        kind.once = fields->flag("once", false);
        kind.startsOpen = fields->flag("open", false);
        readLock(reading, *fields, kind);
        if (followed) readFollowed(reading, *followed, number);
        if (!kind.keyed && !kind.opensOnApproach && kind.everySteps == 0 && !followed)
            checker.add(value, "a gate that nothing opens"_later,
                        "\"keyed\": true, \"approach\", \"every\" or \"follows\""_later);
        const auto once = fields->find("once");
        if (once && kind.once && kind.startsOpen)
            checker.addAtKey(*once, "a gate that is open for ever"_later,
                             "\"once\" or \"open\", not both"_later);
    }
    reading.addAim(Aim::What::gates, value, kinds.size());
    kinds.push_back(kind);
    return number;
}

void findFollowedGates(Reading& reading) {
    World& world = reading.description.world;
    std::vector<int> lastFollower(world.gateKinds.size(), -1);  // by kind
    for (const FollowedGate& followed : reading.followed) {
        const auto id = reading.checker.name(followed.name, reading.blueprints, "blueprint");
        if (!id || *id >= world.blueprints.size()) continue;
        const int gate = world.blueprints[*id].gate;
        if (gate < 0) {
            reading.checker.add(followed.name,
                                {"the blueprint ", quoted(world.blueprints[*id].name),
                                 ", which has no \"gate\""_later},
                                "the name of a gate's blueprint"_later);
        } else if (gate == followed.kind) {
            reading.checker.add(followed.name, "a gate that follows itself"_later,
                                "the name of another gate's blueprint"_later);
        } else if (std::exchange(lastFollower[static_cast<std::size_t>(gate)], followed.kind) !=
                   followed.kind) {
            world.gateKinds[static_cast<std::size_t>(followed.kind)].follows.push_back(gate);
        }
    }
}

// Checks that a gate fits its blueprint.
void checkGate(Reading& reading, JsonValue value, const CellBlueprint& blueprint) {
    if (blueprint.isWater)
        reading.checker.add(value, "a gate that is water"_later,
                            "\"gate\" or \"water\", not both"_later);
    const bool isSeen =
        std::any_of(blueprint.faces.begin(), blueprint.faces.end(), [&](const FaceBlueprint& face) {
            // With faulty textures, this one may be right.
            if (face.texture >= reading.description.textures.size()) return true;
            const TextureReference& texture = reading.description.textures[face.texture];
            return texture.frames > 1 && texture.rate == 0.0;
        });
    if (!isSeen && blueprint.motion < 0) {
        reading.checker.add(value, "a gate that looks the same open and shut"_later,
                            "a \"motion\", or a face whose texture has \"frames\" and no "
                            "\"rate\": the first frame is shut, the last open"_later);
    }
}

// Checks that a motion fits its blueprint.
void checkMotion(Reading& reading, JsonValue value, const CellBlueprint& blueprint) {
    Checker& checker = reading.checker;
    const World& world = reading.description.world;
    if (blueprint.motion < 0 || static_cast<std::size_t>(blueprint.motion) >= world.motions.size())
        return;
    const Motion& motion = world.motions[static_cast<std::size_t>(blueprint.motion)];
    if (blueprint.gate < 0 && !motion.hasPeriod()) {
        checker.add(value, {"the motion ", quoted(motion.name), ", which has no \"period\""_later},
                    "a motion with a \"period\", or a \"gate\" that moves the block"_later);
    } else if (blueprint.gate >= 0 && motion.hasPeriod()) {
        checker.add(
            value, {"the motion ", quoted(motion.name), " of a gate, which has a \"period\""_later},
            "a motion without \"period\": the gate's \"seconds\" say how long it takes"_later);
    } else if (blueprint.gate >= 0) {
        const int steps = world.gateKinds[static_cast<std::size_t>(blueprint.gate)].steps;
        const MotionShape shape =
            motion.shape == MotionShape::stopAndGo ? MotionShape::smooth : motion.shape;
        const double fastest =
            fastestSpeed(shape, (motion.to - motion.from).value(), 2.0 * steps / kStepsPerSecond);
        if (fastest > kFastestMotion)
            checker.add(
                value, {"a gate that reaches "_later, roundedText(fastest, 4), " units per second"},
                "at most 4 units per second; more \"seconds\" make it slower"_later);
    }
    if (blueprint.slopes.any() && motion.edges != MovingEdges::both)
        checker.add(value, "a block with slopes of which only some edges move"_later,
                    "a motion with \"moves\": \"both\""_later);
    if (!motion.isSideways()) return;
    if (blueprint.plan.half != Half::none)
        checker.add(value, "a half of a tile that moves sideways"_later,
                    "a motion along z, or a block without \"diagonal\""_later);
    if (blueprint.isWater)
        checker.add(value, "water that moves sideways"_later,
                    "a motion along z, or no \"water\""_later);
}

}  // namespace slicecast
