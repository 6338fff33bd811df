// Measures pictures per second and how long each took to draw.
#pragma once

namespace slicecast {

struct FrameRates {
    double framesPerSecond = 0.0;
    double drawMilliseconds = 0.0;     // of one picture, on average
    double longestMilliseconds = 0.0;  // from one picture to the next
};

class FrameMeter {
public:
    // Call after each picture. True twice a second, when rates() is new; it covers the time since
    // then.
    bool add(double nowSeconds, double drawSeconds);

    // Call before a pause, which must not count.
    void skip() { frames_ = -1; }

    const FrameRates& rates() const { return rates_; }

private:
    int frames_ = -1;  // -1 until the first picture starts the measurement
    double beginSeconds_ = 0.0;
    double lastSeconds_ = 0.0;
    double drawSeconds_ = 0.0;
    double longestSeconds_ = 0.0;
    FrameRates rates_;
};

}  // namespace slicecast
