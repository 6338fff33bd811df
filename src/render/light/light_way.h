// A way of light and its moments, in whole numbers.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace slicecast {

using LightVector = std::array<std::int32_t, 3>;  // east, south, up, 1/65536 units

// How far along its way light is, in such small shares that every edge of a box is met after a
// whole number of them: that of all of the way is 8 times the product of its three parts. Of what
// is met at once, the last three bits tell what comes first: the beginning of a way counts as moved
// by an infinitely small step east, a far smaller one south and a still smaller one up.
using LightMoment = std::int64_t;
inline constexpr LightMoment kNeverMet = std::numeric_limits<LightMoment>::max();

// Moments keep below 2^63. A way that ends is at most kLongestWay long, so the product of two of
// its parts is at most 2^39, that of all three below 2^58, and places are asked for up to a cell
// beyond its ends: 8 * 2^39 * 2^20.1. An endless way is the one to the sun. It is 1 unit long, so
// the product of two of its parts is at most 2^31, and it leaves the largest map, and the highest
// ceiling, within kFarthestPlace: 8 * 2^31 * 2^28.
inline constexpr std::int64_t kLongestWay = 16 * 65536;
inline constexpr std::int64_t kFarthestPlace = 4096 * 65536;

struct LightWay {
    LightVector from;
    LightVector step;
    bool isEndless;
    LightMoment whole = 8;                // of the way
    std::array<LightMoment, 3> shares{};  // in 1/65536 unit along each axis

    LightWay(const LightVector& begin, const LightVector& way, bool endless)
        : from(begin), step(way), isEndless(endless) {
        std::array<LightMoment, 3> parts{};
        for (std::size_t i = 0; i < 3; ++i) parts[i] = step[i] == 0 ? 1 : std::abs(step[i]);
        whole *= parts[0] * parts[1] * parts[2];
        shares = {8 * parts[1] * parts[2], 8 * parts[0] * parts[2], 8 * parts[0] * parts[1]};
    }

    LightMoment end() const { return isEndless ? kNeverMet : whole; }
    // When it comes to a place along an axis.
    LightMoment at(std::int32_t place, std::size_t axis) const {
        const auto order = static_cast<LightMoment>(axis) - 3;
        const std::int64_t distance = std::int64_t{place} - from[axis];
        assert(step[axis] == 0 ||
               std::abs(distance) <= (isEndless ? kFarthestPlace : kLongestWay) + 65536);
        return step[axis] > 0   ? distance * shares[axis] + order
               : step[axis] < 0 ? -distance * shares[axis] - order
                                : kNeverMet;
    }
    // Whether a way passes a place along an axis, or begins or ends there: only then, and for cells
    // that it passes, may one ask when.
    bool reaches(std::int32_t place, std::size_t axis) const {
        const std::int64_t distance = std::int64_t{place} - from[axis];
        return step[axis] > 0   ? distance >= 0 && (isEndless || distance <= step[axis])
               : step[axis] < 0 ? distance <= 0 && (isEndless || distance >= step[axis])
                                : false;
    }

    // Calls visit(cell, leave, axis) for each cell that the way passes, in its order: tile and
    // level, also outside the map; `leave` is when it would leave the cell, and along which axis.
    // Ends early if that returns false.
    template <typename Visit>
    void eachCell(Visit&& visit) const {
        LightVector cell{};
        LightVector ahead{};
        std::array<LightMoment, 3> leave{};
        std::array<LightMoment, 3> more{};
        for (std::size_t i = 0; i < 3; ++i) {
            cell[i] = from[i] >> 16;
            ahead[i] = step[i] < 0 ? -1 : 1;
            leave[i] = at((cell[i] + (step[i] > 0 ? 1 : 0)) * 65536, i);
            more[i] = 65536 * shares[i];
        }
        while (true) {
            std::size_t next = leave[0] < leave[1] ? 0 : 1;
            next = leave[2] < leave[next] ? 2 : next;
            if (!visit(cell, leave[next], next) || leave[next] >= end()) return;
            cell[next] += ahead[next];
            leave[next] += more[next];
        }
    }
};

}  // namespace slicecast
