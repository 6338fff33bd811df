// Coordinates and heights: units (one block is 1 unit), kept as whole multiples of 1/65536.
//
//     raw = floor(65536 v + 0.5)        tile = raw >> 16        fraction = (raw & 65535) / 65536
//
// A coordinate is rounded once, when it is loaded or at the end of a step. Sums and differences are
// exact as long as they stay within the limit, and so are their values as doubles. x grows east, y
// grows south, z grows up. Tile i is the half-open interval [i, i + 1).
#pragma once

#include <compare>
#include <cstdint>

namespace slicecast {

// The range that a coordinate can hold: -kCoordinateLimit <= v <= kCoordinateLimit.
inline constexpr double kCoordinateLimit = 32767.0;

struct Coordinate {
    std::int32_t raw = 0;  // in 1/65536 units

    constexpr int tile() const { return raw >> 16; }
    constexpr double fraction() const { return (raw & 0xffff) / 65536.0; }
    constexpr double value() const { return raw / 65536.0; }

    friend constexpr bool operator==(Coordinate, Coordinate) = default;
    friend constexpr auto operator<=>(Coordinate, Coordinate) = default;
    friend constexpr Coordinate operator+(Coordinate a, Coordinate b) { return {a.raw + b.raw}; }
    friend constexpr Coordinate operator-(Coordinate a, Coordinate b) { return {a.raw - b.raw}; }
};

// The nearest coordinate to `units`, halves going up. Values beyond the limit are clamped to it,
// NaN gives 0.
constexpr Coordinate toCoordinate(double units) {
    if (!(units > -kCoordinateLimit))
        return units <= -kCoordinateLimit ? Coordinate{-32767 * 65536} : Coordinate{0};
    if (units >= kCoordinateLimit) return {32767 * 65536};
    const double scaled = units * 65536.0 + 0.5;
    auto whole = static_cast<std::int64_t>(scaled);
    if (static_cast<double>(whole) > scaled) --whole;
    return {static_cast<std::int32_t>(whole)};
}

// The place at a part of the way, 0 to 1, from one to another. Only the way is rounded, so all that
// goes the same way goes alike: an eye, and the mover under it.
constexpr Coordinate between(Coordinate from, Coordinate to, double part) {
    return from + toCoordinate((to - from).value() * part);
}

// Where a tile begins: its west or north border, or the base of a level. From -32767 to 32767.
constexpr Coordinate tileEdge(int tile) {
    return {tile * 65536};
}

}  // namespace slicecast
