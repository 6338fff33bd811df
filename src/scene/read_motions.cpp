// Motions of blocks, and gates.
#include "base/number_text.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/player.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr NumberRange kOffset = {-kGreatestOffset, kGreatestOffset, false,
                                 "a number from -32 to 32, in units"};
constexpr NumberRange kPeriod = {kShortestPeriod, kLongestPeriod, false,
                                 "a number from 0.1 to 3600, in seconds"};
constexpr NumberRange kOpening = {kStepSeconds, kLongestGate, false,
                                  "a number from 1/120 to 60, in seconds"};
constexpr NumberRange kHold = {0.0, kLongestGate, false, "a number from 0 to 60, in seconds"};
constexpr NumberRange kGateReach = {0.0, kFarthestGate, false, "a number from 0 to 64, in units"};
static_assert(kGreatestOffset == 32.0 && kShortestPeriod == 0.1 && kLongestPeriod == 3600.0 &&
                  kLongestGate == 60.0 && kFarthestGate == 64.0 && kStepsPerSecond == 120 &&
                  kFastestMotion == 4.0,
              "as the words say");

constexpr Named<MovingEdges> kEdges[] = {
    {MovingEdges::top, "top"}, {MovingEdges::bottom, "bottom"}, {MovingEdges::both, "both"}};
constexpr Named<MotionShape> kShapes[] = {{MotionShape::smooth, "smooth"},
                                          {MotionShape::even, "even"},
                                          {MotionShape::stopAndGo, "stop-and-go"}};

int stepsOf(double seconds) {
    return static_cast<int>(std::floor(seconds * kStepsPerSecond + 0.5));
}

// { "moves", "from", "to", "period", "phase", "shape" }
Motion readMotion(Checker& checker, JsonValue value) {
    Motion motion;
    motion.name = std::string(value.key());
    const auto fields = checker.fields(value, {"moves", "from", "to", "period", "phase", "shape"},
                                       "a motion: an object with \"moves\", \"to\" and \"period\"");
    if (!fields) return motion;
    const std::size_t faultsBefore = checker.count();
    fields->requireChoice("moves", kEdges);
    fields->require("to", kOffset.words);
    fields->require("period", kPeriod.words);
    const double from = fields->number("from", kOffset, 0.0);
    const double to = fields->number("to", kOffset, 1.0);
    const double period = fields->number("period", kPeriod, 1.0);
    const double phase = fields->number("phase", kUnitRange, 0.0);
    motion.edges = fields->choice("moves", kEdges, MovingEdges::both);
    motion.shape = fields->choice("shape", kShapes, MotionShape::smooth);
    motion.from = toCoordinate(from);
    motion.to = toCoordinate(to);
    motion.periodSteps = stepsOf(period);
    motion.phaseSteps =
        static_cast<int>(std::floor(phase * motion.periodSteps + 0.5)) % motion.periodSteps;
    const double fastest = fastestSpeed(motion.shape, to - from, period);
    if (checker.count() == faultsBefore && fastest > kFastestMotion) {
        checker.add(value, {"a motion that reaches ", roundedText(fastest, 4), " units per second"},
                    "at most 4 units per second; a longer period makes it slower");
    }
    return motion;
}

}  // namespace

void readMotions(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isObject()) {
        checker.refuse(value, "the motions: an object with a motion for each name");
        reading.motions.takeAny();
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxBlueprints)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "motion"},
                    {"at most ", kMaxBlueprints});
        reading.motions.takeAny();
        return;
    }
    std::vector<Motion>& motions = reading.description.world.motions;
    for (const JsonValue member : value) {
        if (member.key().empty() || countCharacters(member.key()) > kMaxNameLength) {
            checker.addAtKey(member, {"the name ", quoted(member.key())},
                             {"a name of 1 to ", kMaxNameLength, " characters"});
        }
        reading.motions.add(member.key(), static_cast<std::uint16_t>(motions.size()));
        motions.push_back(readMotion(checker, member));
    }
}

// { "seconds", "reach", "keyed", "approach", "hold", "open" }
int readGate(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    GateKind kind;
    const auto fields =
        checker.fields(value, {"seconds", "reach", "keyed", "approach", "hold", "open"},
                       "a gate: an object, which may be {}");
    if (fields) {
        kind.steps = std::max(1, stepsOf(fields->number("seconds", kOpening, 0.8)));
        kind.reach = toCoordinate(fields->number("reach", kGateReach, 2.0));
        kind.keyed = fields->flag("keyed", true);
        kind.opensOnApproach = static_cast<bool>(fields->find("approach"));
        kind.approach = toCoordinate(fields->number("approach", kGateReach, 0.0));
        kind.holdSteps = stepsOf(fields->number("hold", kHold, 1.0));
        kind.startsOpen = fields->flag("open", false);
        if (!kind.keyed && !kind.opensOnApproach)
            checker.add(value, "a gate that nothing opens",
                        "\"keyed\": true, or \"approach\", or both");
    }
    reading.description.world.gateKinds.push_back(kind);
    return static_cast<int>(reading.description.world.gateKinds.size()) - 1;
}

}  // namespace slicecast
