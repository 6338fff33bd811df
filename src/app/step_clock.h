// Turns real time into whole steps of 1/120 s.
//
// Time that was long in coming (a slow machine, a window being dragged, a hidden tab) is dropped
// rather than made up for: at most kLongestFrameSeconds are played per frame, so the game slows
// down instead of jumping.
#pragma once

namespace slicecast {

inline constexpr double kLongestFrameSeconds =
    0.1;  // 12 steps; more would let a slow machine fall behind ever further

class StepClock {
public:
    // How many steps to play now. `nowSeconds` is any clock that goes steadily forward; the first
    // call, and the first one after stop, start it.
    int advance(double nowSeconds);

    // Time does not pass until the next advance.
    void stop() { running_ = false; }

    // How far, 0 to 1, the time of the last advance lies beyond the last step.
    double fraction() const;

private:
    bool running_ = false;
    double lastSeconds_ = 0.0;
    double owedSeconds_ = 0.0;  // time passed that no step has played yet, less than one step
};

}  // namespace slicecast
