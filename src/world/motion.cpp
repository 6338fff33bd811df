#include "world/motion.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr double eased(double p) {
    return p * p * (3.0 - 2.0 * p);
}

}  // namespace

// #region offset-at
// Rounds once, at the end. The product of integers is exact, so `even` is exact to the last bit.
Coordinate offsetAt(const Motion& motion, int steps) {
    const std::int64_t period = motion.periodSteps;
    const std::int64_t at = (std::int64_t{steps} + motion.phaseSteps) % period;
    const std::int64_t twice = 2 * std::min(at, period - at);
    const std::int64_t distance = std::int64_t{motion.to.raw} - motion.from.raw;
    const double part = static_cast<double>(twice) / static_cast<double>(period);
    const double way =
        motion.shape == MotionShape::even
            ? static_cast<double>(distance * twice) / static_cast<double>(period)
            : static_cast<double>(distance) * eased(motion.shape == MotionShape::smooth
                                                        ? part
                                                        : std::clamp(2.0 * part - 0.5, 0.0, 1.0));
    return {motion.from.raw + static_cast<std::int32_t>(std::floor(way + 0.5))};
}
// #endregion

int nextStep(const Motion& motion, int steps) {
    const std::int64_t at = (std::int64_t{steps} + motion.phaseSteps) % motion.periodSteps;
    const bool isAtEnd = 2 * at == motion.periodSteps;
    return motion.once && isAtEnd ? steps : (steps + 1) % motion.periodSteps;
}

Coordinate offsetWhenOpen(const Motion& motion, int progress, int steps) {
    Motion halfWay = motion;
    halfWay.periodSteps = 2 * steps;
    halfWay.phaseSteps = 0;
    if (motion.shape == MotionShape::stopAndGo) halfWay.shape = MotionShape::smooth;
    return offsetAt(halfWay, progress);
}

double fastestSpeed(MotionShape shape, double distance, double periodSeconds) {
    const double even = 2.0 * (distance < 0.0 ? -distance : distance) / periodSeconds;
    return shape == MotionShape::even     ? even
           : shape == MotionShape::smooth ? 1.5 * even
                                          : 3.0 * even;
}

}  // namespace slicecast
