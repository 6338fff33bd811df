#include "app/step_clock.h"

#include "world/player.h"

#include <algorithm>

namespace slicecast {

int StepClock::advance(double nowSeconds) {
    const double passed = running_ ? nowSeconds - lastSeconds_ : 0.0;
    running_ = true;
    lastSeconds_ = nowSeconds;
    owedSeconds_ += std::clamp(passed, 0.0, kLongestFrameSeconds);
    const int steps = static_cast<int>(owedSeconds_ * kStepsPerSecond);
    owedSeconds_ = std::max(0.0, owedSeconds_ - steps * kStepSeconds);
    return steps;
}

double StepClock::fraction() const {
    return std::min(1.0, owedSeconds_ * kStepsPerSecond);
}

}  // namespace slicecast
