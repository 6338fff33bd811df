#include "headless/replay_file.h"

#include <cstdlib>
#include <optional>
#include <variant>

namespace slicecast {
namespace {

// The number of steps before a mark; nothing if there is no such mark.
std::optional<std::int64_t> stepOfMark(const Recording& recording, const std::string& name) {
    std::int64_t steps = 0;
    for (const RecordedEntry& entry : recording.entries) {
        if (const auto* played = std::get_if<RecordedSteps>(&entry)) steps += played->count;
        const auto* mark = std::get_if<RecordedMark>(&entry);
        if (mark != nullptr && mark->name == name) return steps;
    }
    return std::nullopt;
}

std::string marksOf(const Recording& recording) {
    std::string names;
    for (const RecordedEntry& entry : recording.entries) {
        if (const auto* mark = std::get_if<RecordedMark>(&entry))
            names += (names.empty() ? " or one of the marks " : ", ") + mark->name;
    }
    return names;
}

}  // namespace

std::string replayUpTo(Session& session, Replay& replay, const std::string& stepOrMark) {
    std::int64_t last = replay.recording().steps;
    if (!stepOrMark.empty()) {
        const bool isNumber = stepOrMark.size() <= 9 &&
                              stepOrMark.find_first_not_of("0123456789") == std::string::npos;
        std::optional<std::int64_t> target = stepOfMark(replay.recording(), stepOrMark);
        if (isNumber) target = std::atoll(stepOrMark.c_str());
        if (!target || *target > last)
            return "found \"" + stepOrMark + "\", expected a step from 0 to " +
                   std::to_string(last) + marksOf(replay.recording());
        last = *target;
    }
    while (replay.stepsDone() < last && replay.step(session)) {
    }
    return {};
}

}  // namespace slicecast
