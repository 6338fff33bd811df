// Measures how long the parts of a picture take, with a clock that the caller provides. Without one
// it measures nothing.
#pragma once

#include "overlay/panels.h"

#include <functional>

namespace slicecast {

class PhaseClock {
public:
    // Seconds on any steady clock; empty for none.
    using Now = std::function<double()>;

    void set(Now now);
    // Null until the first averages are complete.
    const ProcessTimes* times() const { return known_ ? &times_ : nullptr; }

    // Mark the parts in the order in which they run; the time since the previous call counts for
    // the part that ends.
    void begin() { last_ = read(); }
    void endSteps() { add(steps_); }
    void endView() { add(view_); }
    // Ends the last part of a picture.
    void endOverlays();

private:
    double read() const { return now_ ? now_() : 0.0; }
    void add(double& part) {
        const double now = read();
        part += now - last_;
        last_ = now;
    }

    Now now_;
    ProcessTimes times_;
    bool known_ = false;
    double last_ = 0.0;    // of the clock, seconds
    double period_ = 0.0;  // start of the present averages, seconds of the clock
    double steps_ = 0.0;   // spent since then, seconds
    double view_ = 0.0;
    double overlays_ = 0.0;
    int pictures_ = -1;  // drawn since then; -1 before the first one
};

}  // namespace slicecast
