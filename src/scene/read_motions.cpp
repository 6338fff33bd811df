// Motions of blocks.
#include "base/later_text.h"
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
static_assert(kGreatestOffset == 32.0 && kShortestPeriod == 0.1 && kLongestPeriod == 3600.0 &&
                  kFastestMotion == 4.0,
              "as the words say");
constexpr const char* kSlower = "at most 4 units per second; a longer period makes it slower";

constexpr Named<Axis> kAxes[] = {{Axis::x, "x"}, {Axis::y, "y"}, {Axis::z, "z"}};
// Of the axes x, y and z
constexpr Named<MovingEdges> kEdges[][3] = {
    {{MovingEdges::high, "east"}, {MovingEdges::low, "west"}, {MovingEdges::both, "both"}},
    {{MovingEdges::high, "south"}, {MovingEdges::low, "north"}, {MovingEdges::both, "both"}},
    {{MovingEdges::high, "top"}, {MovingEdges::low, "bottom"}, {MovingEdges::both, "both"}}};
constexpr Named<MotionShape> kShapes[] = {{MotionShape::smooth, "smooth"},
                                          {MotionShape::even, "even"},
                                          {MotionShape::stopAndGo, "stop-and-go"}};

// "along" and "moves".
void readAxis(Checker& checker, const Fields& fields, Motion& motion) {
    motion.axis = fields.choice("along", kAxes, Axis::z);
    const FoundValue moves = fields.find("moves");
    if (moves && moves->isText() && moves->text() != "both" && !fields.find("along")) {
        for (const auto& [axis, name] : {kAxes[0], kAxes[1]}) {
            if (!valueOf(kEdges[static_cast<std::size_t>(axis)], moves->text())) continue;
            checker.add(*moves, {quoted(moves->text()), " without \"along\""},
                        {"\"along\": ", quoted(name), " beside it"});
            return;
        }
    }
    const auto& edges = kEdges[static_cast<std::size_t>(motion.axis)];
    fields.requireChoice("moves", edges);
    motion.edges = fields.choice("moves", edges, MovingEdges::both);
}

// "period" and what only makes sense with one. A motion without it is for gates; its period is 0.
void readPeriod(Checker& checker, const Fields& fields, Motion& motion) {
    const bool hasPeriod = static_cast<bool>(fields.find("period"));
    motion.periodSteps = hasPeriod ? stepsOf(fields.number("period", kPeriod, 1.0)) : 0;
    const double phase = fields.number("phase", kUnitRange, 0.0);
    motion.once = fields.flag("once", false);
    for (const char* const key : {"phase", "once"}) {
        const auto member = fields.find(key);
        if (member && !hasPeriod)
            checker.addAtKey(*member, {quoted(key), " without a \"period\""_later},
                             "a \"period\"; a motion without one is for gates"_later);
    }
    if (!hasPeriod) return;
    // It comes to rest in the middle of its period.
    if (motion.once) motion.periodSteps += motion.periodSteps % 2;
    motion.phaseSteps =
        static_cast<int>(std::floor(phase * motion.periodSteps + 0.5)) % motion.periodSteps;
}

// { "along", "moves", "from", "to", "period", "phase", "shape", "once" }
Motion readMotion(Checker& checker, JsonValue value) {
    Motion motion;
    motion.name = std::string(value.key());
    const auto fields =
        checker.fields(value, {"along", "moves", "from", "to", "period", "phase", "shape", "once"},
                       "a motion: an object with \"moves\", \"to\" and \"period\""_onFault);
    if (!fields) return motion;
    const std::size_t faultsBefore = checker.count();
    readAxis(checker, *fields, motion);
    fields->require("to", kOffset.words);
    motion.from = toCoordinate(fields->number("from", kOffset, 0.0));
    motion.to = toCoordinate(fields->number("to", kOffset, 1.0));
    motion.shape = fields->choice("shape", kShapes, MotionShape::smooth);
    readPeriod(checker, *fields, motion);
    if (checker.count() != faultsBefore || motion.periodSteps == 0) return motion;
    const double fastest = fastestSpeed(motion.shape, (motion.to - motion.from).value(),
                                        static_cast<double>(motion.periodSteps) / kStepsPerSecond);
    if (fastest > kFastestMotion) {
        checker.add(value,
                    {"a motion that reaches "_later, roundedText(fastest, 4), " units per second"},
                    kSlower);
    }
    return motion;
}

}  // namespace

int stepsOf(double seconds) {
    return static_cast<int>(std::floor(seconds * kStepsPerSecond + 0.5));
}

void readMotions(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isObject()) {
        checker.refuse(value, "the motions: an object with a motion for each name"_later);
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
        checker.checkName(member);
        reading.motions.add(member.key(), static_cast<std::uint16_t>(motions.size()));
        motions.push_back(readMotion(checker, member));
    }
}

}  // namespace slicecast
