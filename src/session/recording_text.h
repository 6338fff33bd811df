// Recordings as text that a person can read:
//
//     slicecast recording 1
//     scene harbour-town
//     set speed 1
//     90 forward 256                    steps (of 1/120 s), and what was asked for during them: 256
//                                       is all of an axis
//     1 forward 256 turn-degrees 3072   turned at once, by a mouse: 1024 is a degree
//     12 forward 128 strafe -256 turn 1 look 1 fly 1 look-heights 655 jump fast slow use open close
//                                       every word
//     fly on                            or off
//     level                             looked ahead
//     heading 92160                     turned there at once: 90 degrees
//     eye 0 98304 98304 32768 0 0       put there: map, x, y, z (65536 is a unit), heading, look
//                                       (65536 is a screen height)
//     cell 0 1 12 7 35                  a cell changed: map, level, x, y, the number of a character
//                                       (35 is #)
//     reset                             back to the start
//     mark on-the-bridge 1f0c...        a name for what is reached by then, and a number for where
//                                       the eye is (poseOf)
//     end 103 77ab...                   all steps, and where the eye is after them
//
// Words stand apart by single spaces or more; lines that begin with # say something to people. The
// last line tells a whole file from half a one.
#pragma once

#include "scene/scene.h"
#include "session/recording.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

inline constexpr int kRecordingVersion = 1;
inline constexpr std::size_t kMaxRecordingBytes = 64u << 20;  // of ten hours of restless mice
inline constexpr std::size_t kMaxRecordedName = 60;  // characters of a scene's or mark's name

std::string writeRecording(const Recording& recording);

struct ReadRecording {
    std::optional<Recording> recording;  // empty when there are faults
    std::vector<Fault> faults;           // in the order of the text, one for each line at most
};

// `fileName` stands in the faults.
ReadRecording readRecording(std::string_view text, const std::string& fileName);

}  // namespace slicecast
