// Records the steps of a game and replays them: the same inputs give the same states and pictures
// on every machine.
//
//     Recorder recorder("harbour-town");
//     session.record(&recorder);         before the first step
//     std::string text = writeRecording(recorder.finish(session));      (recording_text.h)
//
//     Replay replay(recording);
//     while (replay.step(sessionOfTheSameScene)) ...
//     while (!replay.seek(session, 1200, 100)) ...       to any step, 100 at a time
//
// Inputs are stored as whole numbers of small units, and the session acts on the stored values. So
// replaying them rounds nothing differently.
#pragma once

#include "session/session_moment.h"
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

inline constexpr int kRecordedAxis = 256;         // per full axis
inline constexpr int kRecordedDegree = 1024;      // per degree
inline constexpr int kRecordedHeight = 65536;     // per screen height or unit
inline constexpr int kMaxRecordedDegrees = 3600;  // turned in one step
inline constexpr int kMaxRecordedHeights = 64;    // looked up in one step, screen heights
inline constexpr std::int64_t kMaxRecordedSteps =
    120 * 36000;  // ten hours; the rest is not recorded

// An Input in the units of the recording.
struct RecordedInput {
    int forward = 0;  // in 1 / kRecordedAxis, like the next four
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

// A recording is a list of entries. All entries but steps take place between two steps.
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
    int x = 0;  // in 1 / kRecordedHeight, like y, z and look
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
    std::string sign;  // of the map's legend
};
struct RecordedOption {
    std::string name;
    std::string value;
};
// Names a moment, with a hash of where the eye is then. Changes nothing.
struct RecordedMark {
    std::string name;
    std::uint64_t pose = 0;
};
using RecordedEntry =
    std::variant<RecordedSteps, RecordedFlying, RecordedLevelLook, RecordedHeading, RecordedReset,
                 RecordedEye, RecordedCell, RecordedOption, RecordedMark>;

struct Recording {
    std::string scene;  // its file's name without folder and extension
    std::vector<RecordedEntry> entries;
    std::int64_t steps = 0;     // of all entries
    std::uint64_t endPose = 0;  // of the eye after all of them
};

// True for options that affect steps. The others change pictures only, so each viewer has their
// own.
bool isRecordedOption(std::string_view name);

// A hash of the eye's place and direction, to compare two sessions.
std::uint64_t poseOf(const Session& session);

class Recorder {
public:
    explicit Recorder(std::string scene) { recording_.scene = std::move(scene); }

    // Stores one step's input and returns it as stored. A full recorder returns it unchanged.
    Input step(const Input& input);
    void add(RecordedEntry entry);
    void mark(const std::string& name, const Session& session) {
        add(RecordedMark{name, poseOf(session)});
    }
    bool isFull() const { return recording_.steps >= kMaxRecordedSteps; }

    // Everything so far. Recording may continue.
    Recording finish(const Session& session) const;

private:
    Recording recording_;
};

// A mark that a replay has passed, and whether the eye was at the same place as in the recording.
struct PassedMark {
    std::string name;
    std::int64_t step = 0;
    bool isSame = false;
};

// A replay keeps moments of the session, so that seek() plays few steps: at first one for so many
// steps; when there are too many, or they take too much memory, every other one is dropped, and
// from then on it keeps half as many.
inline constexpr std::int64_t kStepsOfMoment = 240;
inline constexpr std::size_t kMostMoments = 256;
inline constexpr std::size_t kMostMomentBytes = 16u << 20;  // of all but the first

class Replay {
public:
    explicit Replay(Recording recording) : recording_(std::move(recording)) {}
    ~Replay();  // not inline: a page without a recording need not load it

    // Plays the next step. False after the last one; then nothing is stepped.
    bool step(Session& session);

    // Goes to the moment after so many steps, clamped to those of the recording. The session is
    // then what it was, or will be, when all steps were played one after another. Plays at most so
    // many of them, and returns whether it is there; if not, call it again.
    bool seek(Session& session, std::int64_t step, int mostSteps);
    // Somebody else steps the session from now on; seek() takes it back.
    void leave() { isLeft_ = true; }

    std::size_t moments() const { return moments_.size(); }
    const Recording& recording() const { return recording_; }
    std::int64_t stepsDone() const { return stepsDone_; }
    bool isOver() const { return next_ >= recording_.entries.size(); }
    const std::vector<PassedMark>& marks() const { return marks_; }
    // False once a mark or the end differs from the recording: the scene or the engine has changed.
    bool isSame() const { return isSame_; }

private:
    // The replay and the session after so many steps.
    struct Moment {
        std::int64_t stepsDone = 0;
        std::size_t next = 0;
        std::int64_t doneOfEntry = 0;
        std::size_t marks = 0;
        bool isSame = true;
        SessionMoment session;
        std::size_t bytes = 0;
    };

    void passMarks(const Session& session);
    void keepMoment(const Session& session);
    void dropMoments();
    void restore(Session& session, const Moment& moment);

    Recording recording_;
    std::size_t next_ = 0;          // entry
    std::int64_t doneOfEntry_ = 0;  // steps
    std::int64_t stepsDone_ = 0;
    std::vector<PassedMark> marks_;
    bool isSame_ = true;
    bool isLeft_ = false;
    std::vector<Moment> moments_;  // by stepsDone; the first one is of the start
    std::int64_t stepsOfMoment_ = kStepsOfMoment;
    std::size_t momentBytes_ = 0;
};

}  // namespace slicecast
