// The picture that all measurements draw, and how long that takes.
#pragma once

#include "processor_time.h"
#include "slicecast/picture.h"

#include <vector>

namespace slicecast {

inline constexpr int kWidth = 1280;
inline constexpr int kHeight = 720;

struct Canvas {
    std::vector<Pixel> pixels = std::vector<Pixel>(static_cast<std::size_t>(kWidth) * kHeight);

    Picture picture() { return {pixels.data(), kWidth, kHeight, kWidth}; }
};

inline double nsPerPixel(double seconds) {
    return seconds * 1e9 / (kWidth * kHeight);
}

// Of the processor.
template <typename Draw>
double secondsOf(Draw&& draw) {
    const double begin = processorSeconds();
    draw();
    return processorSeconds() - begin;
}

}  // namespace slicecast
