#include "app/frame_meter.h"

#include <algorithm>

namespace slicecast {

namespace {
constexpr double kPeriodSeconds = 0.5;
}

bool FrameMeter::add(double nowSeconds, double drawSeconds) {
    if (frames_ < 0) {
        frames_ = 0;
        beginSeconds_ = lastSeconds_ = nowSeconds;
        drawSeconds_ = longestSeconds_ = 0.0;
        return false;
    }
    ++frames_;
    drawSeconds_ += drawSeconds;
    longestSeconds_ = std::max(longestSeconds_, nowSeconds - lastSeconds_);
    lastSeconds_ = nowSeconds;
    const double passed = nowSeconds - beginSeconds_;
    if (passed < kPeriodSeconds) return false;
    rates_ = {frames_ / passed, 1000.0 * drawSeconds_ / frames_, 1000.0 * longestSeconds_};
    frames_ = 0;
    beginSeconds_ = nowSeconds;
    drawSeconds_ = longestSeconds_ = 0.0;
    return true;
}

}  // namespace slicecast
