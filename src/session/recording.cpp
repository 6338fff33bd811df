#include "session/recording.h"

#include "base/hash.h"
#include "session/session.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slicecast {
namespace {

constexpr std::array<std::string_view, 2> kRecordedOptions = {"speed", "bob"};

// The nearest whole number of units. NaN counts as 0, as in a step.
int inUnits(double value, int unitsOfOne, int most) {
    if (!(value == value)) return 0;
    const double bounded = std::clamp(value, -static_cast<double>(most), static_cast<double>(most));
    return static_cast<int>(std::floor(bounded * unitsOfOne + 0.5));
}

double fromUnits(int units, int unitsOfOne) {
    return static_cast<double>(units) / unitsOfOne;
}

// Applies an entry that is not a step to a session.
struct Performer {
    Session& session;

    void operator()(const RecordedSteps&) const {}
    void operator()(const RecordedMark&) const {}
    void operator()(const RecordedFlying& entry) const { session.setFlying(entry.flying); }
    void operator()(const RecordedLevelLook&) const { session.levelLook(); }
    void operator()(const RecordedHeading& entry) const {
        session.setHeading(fromUnits(entry.heading, kRecordedDegree));
    }
    void operator()(const RecordedReset&) const { session.reset(); }
    void operator()(const RecordedEye& entry) const {
        session.setEye({entry.map,
                        {entry.x},
                        {entry.y},
                        {entry.z},
                        fromUnits(entry.heading, kRecordedDegree),
                        fromUnits(entry.look, kRecordedHeight)});
    }
    void operator()(const RecordedCell& entry) const {
        session.setCell({entry.map, entry.level, entry.x, entry.y}, entry.sign);
    }
    void operator()(const RecordedOption& entry) const {
        session.setOption(entry.name, entry.value);
    }
};

}  // namespace

RecordedInput toRecorded(const Input& input) {
    // If Input gets a new field, this line fails to compile: add the field to the recording.
    const auto& [forward, strafe, turn, look, fly, turnDegrees, lookHeights, jump, fast, slow, use,
                 open, close] = input;
    return {.forward = inUnits(forward, kRecordedAxis, 1),
            .strafe = inUnits(strafe, kRecordedAxis, 1),
            .turn = inUnits(turn, kRecordedAxis, 1),
            .look = inUnits(look, kRecordedAxis, 1),
            .fly = inUnits(fly, kRecordedAxis, 1),
            .turnDegrees = inUnits(turnDegrees, kRecordedDegree, kMaxRecordedDegrees),
            .lookHeights = inUnits(lookHeights, kRecordedHeight, kMaxRecordedHeights),
            .jump = jump,
            .fast = fast,
            .slow = slow,
            .use = use,
            .open = open,
            .close = close};
}

Input toInput(const RecordedInput& input) {
    return {.forward = fromUnits(input.forward, kRecordedAxis),
            .strafe = fromUnits(input.strafe, kRecordedAxis),
            .turn = fromUnits(input.turn, kRecordedAxis),
            .look = fromUnits(input.look, kRecordedAxis),
            .fly = fromUnits(input.fly, kRecordedAxis),
            .turnDegrees = fromUnits(input.turnDegrees, kRecordedDegree),
            .lookHeights = fromUnits(input.lookHeights, kRecordedHeight),
            .jump = input.jump,
            .fast = input.fast,
            .slow = input.slow,
            .use = input.use,
            .open = input.open,
            .close = input.close};
}

bool isRecordedOption(std::string_view name) {
    return std::find(kRecordedOptions.begin(), kRecordedOptions.end(), name) !=
           kRecordedOptions.end();
}

std::uint64_t poseOf(const Session& session) {
    const Eye eye = session.eye();
    Hash hash;
    for (const std::int64_t number : {std::int64_t{eye.map}, std::int64_t{eye.x.raw},
                                      std::int64_t{eye.y.raw}, std::int64_t{eye.z.raw}})
        hash.add(number);
    hash.add(eye.headingDegrees);
    hash.add(eye.look);
    return hash.value();
}

// ---- recorder

Input Recorder::step(const Input& input) {
    if (isFull()) return input;
    const RecordedInput kept = toRecorded(input);
    auto* last = recording_.entries.empty()
                     ? nullptr
                     : std::get_if<RecordedSteps>(&recording_.entries.back());
    if (last != nullptr && last->input == kept) {
        ++last->count;
    } else {
        recording_.entries.push_back(RecordedSteps{1, kept});
    }
    ++recording_.steps;
    return toInput(kept);
}

void Recorder::add(RecordedEntry entry) {
    if (!isFull()) recording_.entries.push_back(std::move(entry));
}

Recording Recorder::finish(const Session& session) const {
    Recording finished = recording_;
    finished.endPose = poseOf(session);
    return finished;
}

// ---- replay

Replay::~Replay() = default;

bool Replay::step(Session& session) {
    // Entries before the step
    if (isOver()) return false;
    keepMoment(session);
    passMarks(session);
    while (!isOver() && !std::holds_alternative<RecordedSteps>(recording_.entries[next_])) {
        std::visit(Performer{session}, recording_.entries[next_++]);
        passMarks(session);
    }
    if (isOver()) {
        leave();  // what came after the last step is no part of a moment
        return false;
    }

    // The step
    const auto& steps = std::get<RecordedSteps>(recording_.entries[next_]);
    session.step(toInput(steps.input));
    ++stepsDone_;
    if (++doneOfEntry_ == steps.count) {
        doneOfEntry_ = 0;
        ++next_;
    }
    if (doneOfEntry_ == 0) passMarks(session);
    return true;
}

bool Replay::seek(Session& session, std::int64_t step, int mostSteps) {
    const std::int64_t target = std::clamp<std::int64_t>(step, 0, recording_.steps);
    if (!isLeft_) keepMoment(session);
    // The nearest moment before, unless the session is nearer
    const auto later = std::upper_bound(
        moments_.begin(), moments_.end(), target,
        [](std::int64_t wanted, const Moment& moment) { return wanted < moment.stepsDone; });
    const Moment& nearest = *(later - 1);
    if (isLeft_ || target < stepsDone_ || nearest.stepsDone > stepsDone_) restore(session, nearest);
    // The rest of the way
    for (int i = 0; stepsDone_ < target && i < mostSteps; ++i) {
        if (!this->step(session)) return true;
    }
    return stepsDone_ == target;
}

void Replay::keepMoment(const Session& session) {
    if (stepsDone_ % stepsOfMoment_ != 0) return;
    if (!moments_.empty() && moments_.back().stepsDone >= stepsDone_) return;
    Moment moment = {.stepsDone = stepsDone_,
                     .next = next_,
                     .doneOfEntry = doneOfEntry_,
                     .marks = marks_.size(),
                     .isSame = isSame_,
                     .session = session.moment()};
    if (!moments_.empty()) {
        moment.bytes = moment.session.bytes();
        while (moments_.size() > 1 &&
               (moments_.size() == kMostMoments || momentBytes_ + moment.bytes > kMostMomentBytes))
            dropMoments();
        if (momentBytes_ + moment.bytes > kMostMomentBytes || stepsDone_ % stepsOfMoment_ != 0)
            return;
    }
    momentBytes_ += moment.bytes;
    moments_.push_back(std::move(moment));
}

// Every other one.
void Replay::dropMoments() {
    stepsOfMoment_ *= 2;
    std::erase_if(moments_, [&](const Moment& moment) {
        const bool isDropped = moment.stepsDone % stepsOfMoment_ != 0;
        if (isDropped) momentBytes_ -= moment.bytes;
        return isDropped;
    });
}

void Replay::restore(Session& session, const Moment& moment) {
    session.restore(moment.session);
    next_ = moment.next;
    doneOfEntry_ = moment.doneOfEntry;
    stepsDone_ = moment.stepsDone;
    marks_.resize(moment.marks);
    isSame_ = moment.isSame;
    isLeft_ = false;
}

void Replay::passMarks(const Session& session) {
    for (; !isOver() && doneOfEntry_ == 0; ++next_) {
        const auto* mark = std::get_if<RecordedMark>(&recording_.entries[next_]);
        if (mark == nullptr) return;
        marks_.push_back({mark->name, stepsDone_, poseOf(session) == mark->pose});
        isSame_ = isSame_ && marks_.back().isSame;
    }
    if (isOver()) isSame_ = isSame_ && poseOf(session) == recording_.endPose;
}

}  // namespace slicecast
