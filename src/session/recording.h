// What was done in a game, step by step, so that it can be done again: the same inputs give the
// same states and pictures on every machine.
//
//     Recorder recorder("harbour-town");
//     session.record(&recorder);                            from the first step on; the session notes down what it is asked for
//     std::string text = writeRecording(recorder.finish(session));                       (recording_text.h)
//
//     Replay replay(recording);
//     while (replay.step(sessionOfTheSameScene)) ...
//
// Inputs are kept as whole numbers of small units, and the session acts on the input as it was
// kept. So nothing is rounded differently when it is read again.
#pragma once

#include "slicecast/input.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace slicecast {

class Session;

inline constexpr int kRecordedAxis = 256;         // an axis of 1
inline constexpr int kRecordedDegree = 1024;      // a degree
inline constexpr int kRecordedHeight = 65536;     // a screen height, a unit
inline constexpr int kMaxRecordedDegrees = 3600;  // turned in one step
inline constexpr int kMaxRecordedHeights = 64;    // looked up in one step, screen heights
inline constexpr std::int64_t kMaxRecordedSteps =
    120 * 36000;  // ten hours; the recorder keeps no more

// An Input on the grid of the recording.
struct RecordedInput {
    int forward = 0;  // in 1 / kRecordedAxis, as the others
    int strafe = 0;
    int turn = 0;
    int look = 0;
    int fly = 0;
    int turnDegrees = 0;  // in 1 / kRecordedDegree
    int lookHeights = 0;  // in 1 / kRecordedHeight
    bool jump = false;
    bool fast = false;
    bool slow = false;
    bool use = false;
    bool open = false;
    bool close = false;

    friend bool operator==(const RecordedInput&, const RecordedInput&) = default;
};

RecordedInput toRecorded(const Input& input);
Input toInput(const RecordedInput& input);

// A recording is a list of these. What is no step happens between two steps.
struct RecordedSteps {
    std::int64_t count = 0;
    RecordedInput input;
};
struct RecordedFlying {
    bool flying = false;
};
struct RecordedLevelLook {};
struct RecordedHeading {
    int heading = 0;  // in 1 / kRecordedDegree
};
struct RecordedReset {};
struct RecordedEye {
    int map = 0;
    int x = 0;  // in 1 / kRecordedHeight, as y, z and look
    int y = 0;
    int z = 0;
    int heading = 0;  // in 1 / kRecordedDegree
    int look = 0;
};
struct RecordedCell {
    int map = 0;
    int level = 0;
    int x = 0;
    int y = 0;
    int character = 0;  // of the map's legend, its number in Unicode
};
struct RecordedOption {
    std::string name;
    std::string value;
};
// A place on the way with a name, and where the eye is then. It changes nothing.
struct RecordedMark {
    std::string name;
    std::uint64_t pose = 0;
};
using RecordedEntry =
    std::variant<RecordedSteps, RecordedFlying, RecordedLevelLook, RecordedHeading, RecordedReset,
                 RecordedEye, RecordedCell, RecordedOption, RecordedMark>;

struct Recording {
    std::string scene;  // its file's name without folder and ending
    std::vector<RecordedEntry> entries;
    std::int64_t steps = 0;     // of all entries
    std::uint64_t endPose = 0;  // of the eye after all of them
};

// True for the options that bear on steps. The others change pictures only, and belong to who looks
// on.
bool isRecordedOption(std::string_view name);

// A number that two sessions share if their eyes are at the same place and look the same way.
std::uint64_t poseOf(const Session& session);

class Recorder {
public:
    explicit Recorder(std::string scene) { recording_.scene = std::move(scene); }

    // Keeps one step's input, and gives it back as it was kept. A recorder that is full gives it
    // back as it is.
    Input step(const Input& input);
    void add(RecordedEntry entry);
    void mark(const std::string& name, const Session& session) {
        add(RecordedMark{name, poseOf(session)});
    }
    bool isFull() const { return recording_.steps >= kMaxRecordedSteps; }

    // Everything so far. The session may go on.
    Recording finish(const Session& session) const;

private:
    Recording recording_;
};

// Where a replay has passed a mark, and whether the eye was where it was when the mark was made.
struct PassedMark {
    std::string name;
    std::int64_t step = 0;
    bool isSame = false;
};

class Replay {
public:
    explicit Replay(Recording recording) : recording_(std::move(recording)) {}

    // The next step. False after the last one: nothing was stepped.
    bool step(Session& session);

    const Recording& recording() const { return recording_; }
    std::int64_t stepsDone() const { return stepsDone_; }
    bool isOver() const { return next_ >= recording_.entries.size(); }
    const std::vector<PassedMark>& marks() const { return marks_; }
    // False once a mark, or the end, was found elsewhere than in the recording: the scene has
    // changed since, or the engine.
    bool isSame() const { return isSame_; }

private:
    void passMarks(const Session& session);

    Recording recording_;
    std::size_t next_ = 0;          // entry
    std::int64_t doneOfEntry_ = 0;  // steps
    std::int64_t stepsDone_ = 0;
    std::vector<PassedMark> marks_;
    bool isSame_ = true;
};

}  // namespace slicecast
