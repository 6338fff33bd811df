// Marks that many materials share: cracks, studs, grain, stains, carved rectangles and discs.
#pragma once

#include <cstdint>

#include "surface.h"

namespace slicecast::textures {

// A crack that starts at (x, y) and wanders; each step goes down or up by `fall` (1 or -1), now and
// then sideways.
struct Crack {
    int x;
    int y;
    int length;
    int fall = 1;
    double depth = 1.2;
    double darkening = 1.0;
    std::uint32_t seed = 1;
};
void drawCrack(Surface& surface, const Crack& crack);

// A round boss: nail, rivet, pebble. Its height is added to what is there.
struct Stud {
    double x;
    double y;
    double radius;
    double height;
    double tone;
    const Ramp* ramp;
};
void drawStud(Surface& surface, const Stud& stud);

// Small hollows, on average one in every `rarity` texels.
void drawPits(Surface& surface, int rarity, double depth, std::uint32_t seed);

// A flat rectangle with bevelled edges, standing out by `height`.
struct Slab {
    int left;
    int top;
    int right;
    int bottom;
    double height;
    double bevel;  // texels over which its edge rises
    double tone;
    const Ramp* ramp;
};
void drawSlab(Surface& surface, const Slab& slab);

// Tone of wood: streaks along the grain. Both coordinates in texels, each of period kSide.
double woodGrain(double along, double across, std::uint32_t seed);

}  // namespace slicecast::textures
