#include "palette.h"

#include <algorithm>
#include <cmath>

namespace slicecast::textures {

namespace {

Colour colourInParts(const Ramp& ramp, double tone, int parts) {
    const double held = std::clamp(tone, 0.0, static_cast<double>(ramp.count - 1));
    const int place = static_cast<int>(std::floor(held * parts + 0.5));
    const auto index = static_cast<std::size_t>(place / parts);
    const int rest = place % parts;
    if (rest == 0) {
        return ramp.colours[index];
    }
    return blend(ramp.colours[index], ramp.colours[index + 1], rest * 256 / parts);
}

}  // namespace

Colour colourAt(const Ramp& ramp, double tone) {
    return colourInParts(ramp, tone, 2);
}

Colour softColourAt(const Ramp& ramp, double tone) {
    return colourInParts(ramp, tone, 16);
}

int greyOf(Colour colour) {
    return (54 * colour.r + 183 * colour.g + 19 * colour.b + 128) / 256;
}

}  // namespace slicecast::textures
