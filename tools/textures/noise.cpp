#include "noise.h"

#include <algorithm>
#include <cmath>

namespace slicecast::textures {

namespace {

int wrapped(int value, int period) {
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

}  // namespace

std::uint32_t hashOf(int x, int y, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9e3779b1U + 0x7f4a7c15U;
    h ^= static_cast<std::uint32_t>(x) * 0x85ebca6bU;
    h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
    h ^= static_cast<std::uint32_t>(y) * 0xc2b2ae35U;
    h = (h ^ (h >> 12)) * 0x297a2d39U;
    h = (h ^ (h >> 15)) * 0x85ebca6bU;
    return h ^ (h >> 16);
}

double randomAt(int x, int y, std::uint32_t seed) {
    return (hashOf(x, y, seed) >> 8) / 16777216.0;
}

double smoothStep(double low, double high, double value) {
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double valueNoise(double x, double y, int cellsX, int cellsY, std::uint32_t seed) {
    const double floorX = std::floor(x);
    const double floorY = std::floor(y);
    const double u = smoothStep(0.0, 1.0, x - floorX);
    const double v = smoothStep(0.0, 1.0, y - floorY);
    const int left = wrapped(static_cast<int>(floorX), cellsX);
    const int top = wrapped(static_cast<int>(floorY), cellsY);
    const int right = wrapped(left + 1, cellsX);
    const int bottom = wrapped(top + 1, cellsY);
    const double upper = randomAt(left, top, seed) * (1.0 - u) + randomAt(right, top, seed) * u;
    const double lower =
        randomAt(left, bottom, seed) * (1.0 - u) + randomAt(right, bottom, seed) * u;
    return upper * (1.0 - v) + lower * v;
}

double fractalNoise(double x, double y, int cellsX, int cellsY, int count, std::uint32_t seed) {
    return octaves(x, y, cellsX, cellsY, count, seed, valueNoise);
}

double wave(double phase) {
    const double part = phase - std::floor(phase);
    const double half = part < 0.5 ? part * 2.0 : part * 2.0 - 1.0;
    const double arch = 4.0 * half * (1.0 - half);
    return part < 0.5 ? arch : -arch;
}

}  // namespace slicecast::textures
