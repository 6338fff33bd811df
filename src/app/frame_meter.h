// How many pictures a second, and how long each took to draw.
#pragma once

namespace slicecast {

struct FrameRates {
    double framesPerSecond = 0.0;
    double drawMilliseconds = 0.0;     // of one picture, on average
    double longestMilliseconds = 0.0;  // from one picture to the next
};

class FrameMeter {
public:
    // One picture was drawn. True twice a second: then `rates` is new, over the time since it was
    // last.
    bool add(double nowSeconds, double drawSeconds);

    // A gap follows that is not to count (a pause).
    void skip() { frames_ = -1; }

    const FrameRates& rates() const { return rates_; }

private:
    int frames_ = -1;  // -1 before the picture from which time is counted
    double beginSeconds_ = 0.0;
    double lastSeconds_ = 0.0;
    double drawSeconds_ = 0.0;
    double longestSeconds_ = 0.0;
    FrameRates rates_;
};

}  // namespace slicecast
