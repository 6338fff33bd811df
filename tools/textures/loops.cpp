#include "loops.h"

#include <cmath>

#include "noise.h"

namespace slicecast::textures {

double loopNoise(double x, double y, int cellsX, int cellsY, double time, int cellsT,
                 std::uint32_t seed) {
    const double place = (time - std::floor(time)) * cellsT;
    const int before = static_cast<int>(std::floor(place)) % cellsT;
    const int after = (before + 1) % cellsT;
    const double share = place - std::floor(place);
    const double first =
        valueNoise(x, y, cellsX, cellsY, seed + 1009U * static_cast<std::uint32_t>(before));
    const double second =
        valueNoise(x, y, cellsX, cellsY, seed + 1009U * static_cast<std::uint32_t>(after));
    // Half-way between two noises their mean is flatter than either; this brings it back
    const double kept = std::sqrt(share * share + (1.0 - share) * (1.0 - share));
    return 0.5 + (first - 0.5 + share * (second - first)) / kept;
}

double loopFractal(double x, double y, int cellsX, int cellsY, double time, int cellsT, int count,
                   std::uint32_t seed) {
    return octaves(x, y, cellsX, cellsY, count, seed,
                   [&](double u, double v, int wide, int high, std::uint32_t own) {
                       return loopNoise(u, v, wide, high, time, cellsT, own);
                   });
}

}  // namespace slicecast::textures
