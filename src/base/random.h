// Random numbers that are the same on every machine: the SplitMix64 generator (Steele, Lea, Flood
// 2014). Integers only at heart; `unit` is an exact conversion.
#pragma once

#include <cstdint>

namespace slicecast {

class Random {
public:
    explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

    constexpr std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    // A whole number in [0, count), count >= 1.
    constexpr int below(int count) {
        return static_cast<int>((next() >> 32) * static_cast<std::uint64_t>(count) >> 32);
    }

    // A whole number in [low, high].
    constexpr int between(int low, int high) { return low + below(high - low + 1); }

    // A real number in [0, 1), a multiple of 2^-53.
    constexpr double unit() {
        return static_cast<double>(next() >> 11) * (1.0 / 9007199254740992.0);
    }

    constexpr double between(double low, double high) { return low + (high - low) * unit(); }

    // True once in `count` times on average.
    constexpr bool oneIn(int count) { return below(count) == 0; }

private:
    std::uint64_t state_;
};

}  // namespace slicecast
