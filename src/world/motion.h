// Motions: how the edges of a moving block move back and forth. Time is counted in whole steps, and
// offsets are rounded once, to 1/65536 unit.
//
//     offset  to |      ___                      A period takes the offset from `from` to `to`
//                |    /     \            smooth  and back. `even` has constant speed, `smooth`
//           from |__/         \__                starts and ends slowly, `stopAndGo` does so too
//                +----------------> steps        and rests for a quarter of the period at each end.
//
//     part   = 2 * min(at, period - at) / period, at = (steps + phase) modulo period
//     way    = part                                 even
//              3 part^2 - 2 part^3                  smooth
//              3 q^2 - 2 q^3                        stopAndGo, q = clamp(2 part - 1/2, 0, 1)
//     offset = from + (to - from) * way
#pragma once

#include "base/coordinate.h"

#include <cstdint>
#include <string>

namespace slicecast {

enum class MovingEdges : std::uint8_t { top, bottom, both };
enum class MotionShape : std::uint8_t { smooth, even, stopAndGo };

inline constexpr double kShortestPeriod = 0.1;    // seconds
inline constexpr double kLongestPeriod = 3600.0;  // seconds
inline constexpr double kGreatestOffset = 32.0;   // units up or down: all levels of a map
// Units per second. In a step an edge moves at most 1/30 unit, less than the height of any body, so
// nothing passes through anything.
inline constexpr double kFastestMotion = 4.0;

struct Motion {
    std::string name;
    MovingEdges edges = MovingEdges::both;
    Coordinate from = {};  // added to the edges' height
    Coordinate to = {};
    int periodSteps = 240;  // > 1
    int phaseSteps = 0;     // position in the period at the start; 0 <= phaseSteps < periodSteps
    MotionShape shape = MotionShape::smooth;
};

// The offset after this many steps, >= 0.
Coordinate offsetAt(const Motion& motion, int steps);

// The highest speed of a motion over this distance, units per second.
double fastestSpeed(MotionShape shape, double distance, double periodSeconds);

}  // namespace slicecast
