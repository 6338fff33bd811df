// A hash of numbers in order, the same on every machine: each is mixed in by the finisher of
// SplitMix64.
#pragma once

#include "base/bits.h"

#include <cstdint>

namespace slicecast {

class Hash {
public:
    void add(std::int64_t number) {
        std::uint64_t z = state_ + static_cast<std::uint64_t>(number) + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        state_ = z ^ (z >> 31);
    }
    void add(double number) { add(bitCast<std::int64_t>(number)); }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

}  // namespace slicecast
