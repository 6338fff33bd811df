// Turns real time into whole steps of 1/120 s.
//
// Late time (a slow machine, a window being dragged, a hidden tab) is dropped: a frame plays at
// most kLongestFrameSeconds, so the game slows down instead of jumping.
#pragma once

namespace slicecast {

// 12 steps; with more, a slow machine would fall behind further and further.
inline constexpr double kLongestFrameSeconds = 0.1;

class StepClock {
public:
    // The number of steps to play now. `nowSeconds` is of any steady clock; the first call, and the
    // first after stop(), start it.
    int advance(double nowSeconds);

    // Stops time until the next advance().
    void stop() { running_ = false; }

    // How far the time of the last advance() lies beyond the last step, 0 to 1.
    double fraction() const;

private:
    bool running_ = false;
    double lastSeconds_ = 0.0;
    double owedSeconds_ = 0.0;  // time that no step has played yet, less than one step
};

}  // namespace slicecast
