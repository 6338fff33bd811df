// Compares a picture with what the tracer sees, pixel by pixel.
//
// Colours count as equal within 1 of 255 per channel. If a pixel differs, the tracer is asked again
// at 32 points around its centre: in 8 directions at 1/64, 1/512, 1/4096 and 1/32768 of a pixel.
// The pixel is excused only if the tracer sees its colour at one of them, or with a point moved
// onto the border of a texel that it lies less than 1/2^32 before. The other side of a threshold on
// the depth (level of detail, far, fog) is accepted within one part in a million. In a column full
// of see-through things the farthest may be missing. Any other difference is a bug.
#pragma once

#include "tracer.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slicecast::judge {

struct Verdict {
    std::int64_t pixels = 0;
    std::int64_t excused = 0;
    std::int64_t unexcused = 0;
    std::int64_t crowded = 0;                      // pictures with too many excused pixels
    std::vector<std::string> complaints;           // the first few unexcused pixels, in words
    std::map<std::string, std::int64_t> coverage;  // pixels by what they show

    void add(const Verdict& other);
};

// At most this share of a suite's pixels, and of any picture's (or kExcusedAtLeast pixels, if that
// is more), may be excused.
inline constexpr double kExcusedShareOfSuite = 0.0005;
inline constexpr double kExcusedShareOfPicture = 0.01;
inline constexpr std::int64_t kExcusedAtLeast = 10;

// `pixels` are the picture's rows, `pitch` pixels apart. `name` stands in the complaints.
Verdict judge(const World& world, const View& view, const Pixel* pixels, int pitch,
              const std::string& name);

}  // namespace slicecast::judge
