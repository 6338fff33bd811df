#include "world/motion.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr std::int64_t kOne = 65536;

// 3 p^2 - 2 p^3, for p from 0 to kOne.
constexpr std::int64_t eased(std::int64_t p) {
    return p * p * (3 * kOne - 2 * p) >> 32;
}

}  // namespace

Coordinate offsetAt(const Motion& motion, int steps) {
    const std::int64_t period = motion.periodSteps;
    const std::int64_t at = (std::int64_t{steps} + motion.phaseSteps) % period;
    const std::int64_t part = 2 * std::min(at, period - at) * kOne / period;
    std::int64_t way = part;
    if (motion.shape == MotionShape::smooth) way = eased(part);
    if (motion.shape == MotionShape::stopAndGo)
        way = eased(std::clamp(2 * part - kOne / 2, std::int64_t{0}, kOne));
    const std::int64_t distance = std::int64_t{motion.to.raw} - motion.from.raw;
    return {static_cast<std::int32_t>(motion.from.raw + (distance * way >> 16))};
}

double fastestSpeed(MotionShape shape, double distance, double periodSeconds) {
    const double even = 2.0 * (distance < 0.0 ? -distance : distance) / periodSeconds;
    return shape == MotionShape::even     ? even
           : shape == MotionShape::smooth ? 1.5 * even
                                          : 3.0 * even;
}

}  // namespace slicecast
