#include "session/phase_clock.h"

#include <utility>

namespace slicecast {
namespace {

constexpr double kPeriodSeconds = 0.5;
// After a longer time without averages, drawing has paused: the averages start anew.
constexpr double kGapSeconds = 2.0;

}  // namespace

void PhaseClock::set(Now now) {
    now_ = std::move(now);
    known_ = false;
    pictures_ = -1;
}

void PhaseClock::endOverlays() {
    if (!now_) return;
    add(overlays_);
    ++pictures_;
    const double passed = last_ - period_;
    if (pictures_ > 0 && passed < kPeriodSeconds) return;
    if (pictures_ > 0 && passed < kGapSeconds) {
        const double milliseconds = 1000.0 / pictures_;
        times_ = {pictures_ / passed, steps_ * milliseconds, view_ * milliseconds,
                  overlays_ * milliseconds};
        known_ = true;
    }
    pictures_ = 0;
    period_ = last_;
    steps_ = view_ = overlays_ = 0.0;
}

}  // namespace slicecast
