// Motions: how an edge of a moving block goes to and fro. Time counts in whole steps, and an offset
// is rounded once, to 1/65536 of a unit.
//
//     offset  to |      ___                                A period takes the offset from `from` to `to` and back again. `even` goes at one speed,
//                |    /     \            smooth            `smooth` begins and ends slowly, `stopAndGo` does so too and rests for a quarter of the
//           from |__/         \__                          period at either end.
//                +----------------> steps
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
inline constexpr double kGreatestOffset = 32.0;   // units either way: all levels of a map
// Units per second. In a step an edge gets no further than 1/30, which is less than any body is
// high: nothing passes through anything.
inline constexpr double kFastestMotion = 4.0;

struct Motion {
    std::string name;
    MovingEdges edges = MovingEdges::both;
    Coordinate from = {};  // added to the edges' height
    Coordinate to = {};
    int periodSteps = 240;  // > 1
    int phaseSteps = 0;     // into the period at the beginning; 0 <= phaseSteps < periodSteps
    MotionShape shape = MotionShape::smooth;
};

// After so many steps, at least 0.
Coordinate offsetAt(const Motion& motion, int steps);

// Units per second at the fastest, of a motion over such a distance.
double fastestSpeed(MotionShape shape, double distance, double periodSeconds);

}  // namespace slicecast
