// Random numbers and noise that are the same on every compiler: integer hashes, then only + - * /
// sqrt and floor.
//
// All noise here is periodic: it repeats after `cellsX` by `cellsY` lattice cells, so whatever is
// painted from it is seamless. Coordinates are in lattice cells.
#pragma once

#include <cstdint>

namespace slicecast::textures {

// A well-mixed number from a place and a seed.
std::uint32_t hashOf(int x, int y, std::uint32_t seed);

// The same as a fraction in [0, 1).
double randomAt(int x, int y, std::uint32_t seed);

// A stream of random numbers, for scattering things.
class Random {
public:
    explicit Random(std::uint32_t seed) : seed_(seed) {}

    double fraction() { return randomAt(static_cast<int>(count_++), 7, seed_); }  // [0, 1)
    double between(double low, double high) {
        return low + (high - low) * fraction();
    }                                                                      // [low, high)
    int below(int limit) { return static_cast<int>(fraction() * limit); }  // 0 to limit - 1

private:
    std::uint32_t seed_;
    std::uint32_t count_ = 0;
};

// 0 at 0, 1 at 1, level at both ends; held outside.
double smoothStep(double low, double high, double value);

// Smooth noise in [0, 1).
double valueNoise(double x, double y, int cellsX, int cellsY, std::uint32_t seed);

// Several octaves of a noise in [0, 1), each twice as fine and half as strong, scaled to [0, 1):
// noise(x, y, cellsX, cellsY, seed).
template <typename Noise>
double octaves(double x, double y, int cellsX, int cellsY, int count, std::uint32_t seed,
               Noise&& noise) {
    double sum = 0.0;
    double whole = 0.0;
    double strength = 1.0;
    for (int octave = 0; octave < count; ++octave) {
        sum += strength *
               noise(x, y, cellsX, cellsY, seed + static_cast<std::uint32_t>(octave) * 101U);
        whole += strength;
        strength *= 0.5;
        x *= 2.0;
        y *= 2.0;
        cellsX *= 2;
        cellsY *= 2;
    }
    return sum / whole;
}

// Octaves of the smooth noise.
double fractalNoise(double x, double y, int cellsX, int cellsY, int count, std::uint32_t seed);

// A smooth wave of period 1 in [-1, 1], in place of a sine.
double wave(double phase);

}  // namespace slicecast::textures
