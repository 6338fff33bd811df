// Tops and undersides of blocks that rise along one of the four directions.
//
//            .-'|  to           A slant is the plane over two level lines: at height `from` over
//         .-'   |               the tile's western or northern edge, and at `to` over its eastern
//      .-'      |               or southern edge. It rises by (to - from) per unit.
//  from ========+
//     west     east
//
// Heights are above the base of the block's level. Nothing on a slant is rounded: a point of the
// grid of coordinates has a height that is a multiple of 1/2^32.
//
// A block that moves takes its slants along: up and down they get other heights, which may be those
// of other levels; along their axis both lines are shifted.
#pragma once

#include "base/coordinate.h"
#include "slicecast/face.h"
#include "world/plan.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace slicecast {

// Bodies stand on what rises at most so much per unit, and slide down what is steeper.
inline constexpr Coordinate kSteepest = {65536 * 3 / 4};

struct Slant {
    Coordinate from;
    Coordinate to;
    Coordinate shift = {};  // of both lines, east or south

    constexpr bool isLevel() const { return from == to; }
    constexpr Coordinate least() const { return std::min(from, to); }
    constexpr Coordinate most() const { return std::max(from, to); }
    constexpr std::int32_t rise() const { return to.raw - from.raw; }  // per unit, in 1/65536
    // At a place of the tile, in 1/2^32 units; `at` may lie beyond the tile.
    constexpr std::int64_t heightAt(std::int64_t at) const {
        return std::int64_t{from.raw} * 65536 + std::int64_t{rise()} * (at - shift.raw);
    }
    // The same in units, rounded.
    constexpr double valueAt(double at) const {
        return from.value() + Coordinate{rise()}.value() * (at - shift.value());
    }
    friend constexpr bool operator==(const Slant&, const Slant&) = default;
};

// The top and the underside of a block. Both are level unless `any()`.
struct Slopes {
    bool alongX = true;  // they rise along x, or else along y
    Slant bottom;
    Slant top = {tileEdge(1), tileEdge(1)};

    constexpr bool any() const { return !bottom.isLevel() || !top.isLevel(); }
    constexpr const Slant& of(Face face) const { return face == Face::top ? top : bottom; }
    friend constexpr bool operator==(const Slopes&, const Slopes&) = default;
};

// Slopes that have the first heights at the edge opposite the side `rise`, and the second at it.
constexpr Slopes slopesTo(Face rise, Slant bottom, Slant top) {
    if (rise == Face::west || rise == Face::north) {
        std::swap(bottom.from, bottom.to);
        std::swap(top.from, top.to);
        bottom.shift = Coordinate{} - bottom.shift;
        top.shift = Coordinate{} - top.shift;
    }
    return {rise == Face::east || rise == Face::west, bottom, top};
}

// The same after quarter turns of the tile, clockwise seen from above.
constexpr Slopes turned(Slopes slopes, int quarterTurns) {
    for (int i = 0; i < quarterTurns; ++i) {
        if (slopes.alongX) {
            slopes.alongX = false;
        } else {
            slopes = slopesTo(Face::west, slopes.bottom, slopes.top);
        }
    }
    return slopes;
}

// The same, moved by a way.
constexpr Slopes moved(Slopes slopes, Coordinate east, Coordinate south, Coordinate up) {
    const Coordinate ahead = slopes.alongX ? east : south;
    for (Slant* const slant : {&slopes.bottom, &slopes.top}) {
        slant->from = slant->from + up;
        slant->to = slant->to + up;
        if (!slant->isLevel()) slant->shift = slant->shift + ahead;
    }
    return slopes;
}

// A point of a way in units, or a direction.
struct WayPoint {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

// The part of a way between the underside and the top of a block in tile (x, y), whose level's base
// is at height `base`, that lies within `part`; nothing if there is none. Rounded: for pictures see
// render/spans/sloped_plane.h.
constexpr std::optional<WayPart> wayBetween(const Slopes& slopes, int x, int y, double base,
                                            const WayPoint& from, const WayPoint& direction,
                                            WayPart part) {
    // Keeps what has a height over the slant, or under it, that is greater than 0
    const auto keep = [&](const Slant& slant, double sign) {
        const double rise = Coordinate{slant.rise()}.value();
        const double at = slopes.alongX ? from.x - x : from.y - y;
        const double first =
            sign * (from.z - base - slant.from.value() - rise * (at - slant.shift.value()));
        const double every =
            sign * (direction.z - rise * (slopes.alongX ? direction.x : direction.y));
        if (every == 0.0) return first > 0.0;
        if (every > 0.0) part.from = std::max(part.from, -first / every);
        if (every < 0.0) part.to = std::min(part.to, -first / every);
        return part.from < part.to;
    };
    if (!keep(slopes.bottom, 1.0) || !keep(slopes.top, -1.0)) return std::nullopt;
    return part;
}

}  // namespace slicecast
