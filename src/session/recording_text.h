// Recordings as readable text:
//
//     slicecast recording 1
//     scene harbour-town
//     set speed 1
//     90 forward 256                    steps (of 1/120 s), and the input during them: 256
//                                       is a full axis
//     1 forward 256 turn-degrees 3072   turned by a mouse: 1024 is a degree
//     12 forward 128 strafe -256 turn 1 look 1 fly 1 look-heights 655 jump fast slow use open close
//                                       every word
//     fly on                            or off
//     level                             looks straight ahead
//     heading 92160                     faces 90 degrees
//     eye 0 98304 98304 32768 0 0       moves the eye: map, x, y, z (65536 is a unit), heading,
//                                       look (65536 is a screen height)
//     cell 0 1 12 7 35                  changes a cell: map, level, x, y, and the sign as the
//                                       numbers of its Unicode characters
//                                       (35 is #)
//     reset                             back to the start
//     mark on-the-bridge 1f0c...        names this moment; with a hash of the eye's pose
//                                       (poseOf)
//     end 103 77ab...                   number of steps, and the pose after them
//
// Spaces separate words; lines that begin with # are comments. The last line proves that the file
// is complete.
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
// Enough for ten hours of play in which the mouse moves in every step.
inline constexpr std::size_t kMaxRecordingBytes = 64u << 20;
inline constexpr std::size_t kMaxRecordedName = 60;  // characters of a scene's or mark's name

std::string writeRecording(const Recording& recording);

struct ReadRecording {
    std::optional<Recording> recording;  // empty when there are faults
    std::vector<Fault> faults;           // in the order of the text, at most one per line
};

// The recording, or all faults. `fileName` is the file's name in the faults.
ReadRecording readRecording(std::string_view text, const std::string& fileName);

}  // namespace slicecast
