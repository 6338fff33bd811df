// A picture in memory. Places outside it wrap around, so that drawing over an edge comes in again
// on the other side.
#pragma once

#include <cstddef>
#include <vector>

#include "palette.h"

namespace slicecast::textures {

inline constexpr int kSide = 128;  // texels along one side of a block texture
// The same of one that people stand close to. Its painters count in texels of the others: `kFine`
// of its own are one of those.
inline constexpr int kFine = 2;
inline constexpr int kFineSide = kFine * kSide;

constexpr int wrap(int value, int period) {
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

struct Picture {
    Picture(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    Colour& at(int x, int y) { return pixels[indexOf(x, y)]; }
    const Colour& at(int x, int y) const { return pixels[indexOf(x, y)]; }

    int width;
    int height;
    std::vector<Colour> pixels;

private:
    std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(wrap(y, height)) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(wrap(x, width));
    }
};

}  // namespace slicecast::textures
