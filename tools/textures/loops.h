// Noise that changes over time and comes back to where it began.
#pragma once

#include <cstdint>

namespace slicecast::textures {

inline constexpr int kLoopFrames = 8;  // frames of every square sheet

// Like valueNoise and fractalNoise, with time as a third coordinate of period 1: `cellsT` lattice
// cells to the loop. A little above 1 and below 0 at times.
double loopNoise(double x, double y, int cellsX, int cellsY, double time, int cellsT,
                 std::uint32_t seed);
double loopFractal(double x, double y, int cellsX, int cellsY, double time, int cellsT, int count,
                   std::uint32_t seed);

}  // namespace slicecast::textures
