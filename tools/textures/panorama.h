// Shared by the skies: a panorama in units of equal length, and the hills along its foot.
#pragma once

#include <cstdint>

#include "skies.h"

namespace slicecast::textures {

inline constexpr double kAround = 6.283185307179586;  // width of a panorama in the units of `up`:
                                                      // radians, slopes near the horizon

// Middle of column x, 0 to kAround, and of row y, 0 at the horizon to 1.
inline double acrossOf(int x) {
    return (x + 0.5) * kAround / kSkyWidth;
}
inline double upOf(int y) {
    return (kSkyHeight - 0.5 - y) / kSkyHeight;
}

// The shorter way around from one place to another.
double aroundFrom(double from, double to);

// A ridge of hills or mountains before the sky.
struct Ridge {
    double low;  // height of its saddles and of its peaks, as slopes
    double high;
    int peaks;         // about as many around the horizon
    double sharpness;  // 0 for round hills, 1 for pointed mountains
    Colour lit;        // slopes towards the light, and away from it
    Colour shaded;
    Colour mist;        // its foot fades to this
    double mistHeight;  // up to this slope
    double snowLine;    // slopes above this get `snow`; more than 1 for none
    Colour snow;
    std::uint32_t seed;
};

void drawRidge(Picture& sky, const Ridge& ridge);

// Lays haze over the lowest rows; the last row becomes haze altogether.
void drawHaze(Picture& sky, Colour haze, int rows);

// Lets the highest rows end in the commonest colour of the first one, which becomes plain: it is
// what one sees above the picture.
void drawZenith(Picture& sky, int rows, std::uint32_t seed);

}  // namespace slicecast::textures
