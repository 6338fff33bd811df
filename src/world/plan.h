// The part of a tile that a block fills, seen from above.
//
//     0    west   east    1
//     +-----------------+   0
//     |     +-----+     |   north
//     |     |     |     |
//     |     +-----+     |   south
//     +-----------------+   1
//
// Edges are units from the tile's western or northern border. Like a tile, a plan is half open: it
// holds west <= x < east and north <= y < south.
#pragma once

#include "base/coordinate.h"

#include <algorithm>
#include <optional>

namespace slicecast {

// No plan is narrower, either way: see kLongestSlide in collision.h.
inline constexpr Coordinate kThinnest = {65536 / 16};

struct Plan {
    Coordinate west;
    Coordinate north;
    Coordinate east = tileEdge(1);
    Coordinate south = tileEdge(1);

    constexpr bool isWhole() const {
        return (west.raw | north.raw | (east.raw ^ 65536) | (south.raw ^ 65536)) == 0;
    }
    friend constexpr bool operator==(const Plan&, const Plan&) = default;
};

inline constexpr Plan kWholeTile;

// The same place after quarter turns of the tile, clockwise seen from above.
constexpr Plan turned(Plan plan, int quarterTurns) {
    for (int i = 0; i < quarterTurns; ++i)
        plan = {tileEdge(1) - plan.south, plan.west, tileEdge(1) - plan.north, plan.east};
    return plan;
}

// A part of a way, in multiples of its direction.
struct WayPart {
    double from = 0.0;
    double to = 0.0;
};

// The part of a way over a plan in tile (x, y) that lies within `part`; nothing if there is none.
// Rounded: for pictures see render/plan_walk.h.
constexpr std::optional<WayPart> wayOver(const Plan& plan, int x, int y, double fromX, double fromY,
                                         double directionX, double directionY, WayPart part) {
    const auto cut = [&part](double low, double high, double from, double direction) {
        if (direction == 0.0) return low <= from && from < high;
        const double a = (low - from) / direction;
        const double b = (high - from) / direction;
        part = {std::max(part.from, std::min(a, b)), std::min(part.to, std::max(a, b))};
        return part.from < part.to;
    };
    if (!cut(x + plan.west.value(), x + plan.east.value(), fromX, directionX) ||
        !cut(y + plan.north.value(), y + plan.south.value(), fromY, directionY))
        return std::nullopt;
    return part;
}

}  // namespace slicecast
