// Motions: how the edges of a moving block move back and forth along one axis. Time is counted in
// whole steps, and offsets are rounded once, to 1/65536 unit.
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
//
// A motion of a gate has no period: `part` is how far the gate is open, and stopAndGo is smooth.
#pragma once

#include "base/coordinate.h"

#include <cstdint>
#include <string>

namespace slicecast {

enum class Axis : std::uint8_t { x, y, z };
// Along the axis: the eastern, southern or upper edges are the high ones.
enum class MovingEdges : std::uint8_t { high, low, both };
enum class MotionShape : std::uint8_t { smooth, even, stopAndGo };

inline constexpr double kShortestPeriod = 0.1;    // seconds
inline constexpr double kLongestPeriod = 3600.0;  // seconds
inline constexpr double kGreatestOffset = 32.0;   // units either way: all levels of a map
// Units per second. In a step an edge moves at most 1/30 unit, less than the height of any body, so
// nothing passes through anything.
inline constexpr double kFastestMotion = 4.0;

struct Motion {
    std::string name;
    Axis axis = Axis::z;
    MovingEdges edges = MovingEdges::both;
    Coordinate from = {};  // added to the edges' place
    Coordinate to = {};
    int periodSteps = 240;  // > 1; 0 if a gate moves what has it
    int phaseSteps = 0;     // position in the period at the start; 0 <= phaseSteps < periodSteps
    MotionShape shape = MotionShape::smooth;
    bool once = false;  // rests for ever when it has first reached `to`; its period is even then

    bool hasPeriod() const { return periodSteps > 0; }
    bool isSideways() const { return axis != Axis::z; }
};

// The offset after this many steps, >= 0. Here and in the next one it must have a period.
Coordinate offsetAt(const Motion& motion, int steps);

// The step after this one, modulo the period; the same one if the motion has come to its end.
int nextStep(const Motion& motion, int steps);

// The offset when a gate is open by this share of its way, 0 <= progress <= steps.
Coordinate offsetWhenOpen(const Motion& motion, int progress, int steps);

// The highest speed of a motion over this distance, units per second.
double fastestSpeed(MotionShape shape, double distance, double periodSeconds);

}  // namespace slicecast
