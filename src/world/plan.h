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
//
// Or a plan is a half of its tile, cut from corner to corner; its name says where the half's own
// corner is. What lies exactly on the cut belongs to the eastern half.
//
//     +-----+        .+     +.        +-----+
//      `.   |      .' |     | `.      |   .'
//        `. |    .'   |     |   `.    | .'
//          `+   +-----+     +-----+   +'
//     north-east  south-east  south-west  north-west
#pragma once

#include "base/coordinate.h"
#include "base/named.h"
#include "slicecast/face.h"
#include "slicecast/half.h"

#include <algorithm>
#include <optional>

namespace slicecast {

// No plan is narrower, either way: see kLongestSlide in collision.h.
inline constexpr Coordinate kThinnest = {65536 / 16};

inline constexpr Named<Half> kHalves[] = {{Half::northEast, "north-east"},
                                          {Half::southEast, "south-east"},
                                          {Half::southWest, "south-west"},
                                          {Half::northWest, "north-west"}};

constexpr bool isEastern(Half half) {
    return half == Half::northEast || half == Half::southEast;
}
constexpr bool isSouthern(Half half) {
    return half == Half::southEast || half == Half::southWest;
}
// Whether the cut runs from the north-western corner to the south-eastern one, so that x and y grow
// together along it.
constexpr bool isCutFalling(Half half) {
    return half == Half::northEast || half == Half::southWest;
}
// The face that the half has at its cut: the one of north and south that looks that way. It has no
// other side there.
constexpr Face cutFace(Half half) {
    return isSouthern(half) ? Face::north : Face::south;
}
// Whether the half has that side of its tile.
constexpr bool hasSide(Half half, Face side) {
    return side == (isEastern(half) ? Face::east : Face::west) ||
           side == (isSouthern(half) ? Face::south : Face::north);
}

struct Plan {
    Coordinate west;
    Coordinate north;
    Coordinate east = tileEdge(1);
    Coordinate south = tileEdge(1);
    Half half = Half::none;  // else the edges are those of the tile

    constexpr bool isWhole() const {
        return (west.raw | north.raw | (east.raw ^ 65536) | (south.raw ^ 65536)) == 0 &&
               half == Half::none;
    }
    friend constexpr bool operator==(const Plan&, const Plan&) = default;
};

inline constexpr Plan kWholeTile;

// The same place after quarter turns of the tile, clockwise seen from above.
constexpr Plan turned(Plan plan, int quarterTurns) {
    for (int i = 0; i < quarterTurns; ++i) {
        const auto half = static_cast<Half>(static_cast<int>(plan.half) % 4 + 1);
        plan = {tileEdge(1) - plan.south, plan.west, tileEdge(1) - plan.north, plan.east,
                plan.half == Half::none ? Half::none : half};
    }
    return plan;
}

// A part of a way, in multiples of its direction.
struct WayPart {
    double from = 0.0;
    double to = 0.0;
};

// The part of a way over a plan in tile (x, y) that lies within `part`; nothing if there is none.
// Rounded: for pictures see render/spans/plan_walk.h.
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
    if (plan.half == Half::none) return part;
    // How far the way's start is on the half's side of the cut, and how fast it goes there
    const bool isFalling = isCutFalling(plan.half);
    const double sign = isEastern(plan.half) ? 1.0 : -1.0;
    const double inside =
        sign * (isFalling ? (fromX - x) - (fromY - y) : (fromX - x) + (fromY - y) - 1.0);
    const double inwards = sign * (isFalling ? directionX - directionY : directionX + directionY);
    if (inwards == 0.0) return inside > 0.0 ? std::optional(part) : std::nullopt;
    (inwards > 0.0 ? part.from : part.to) = inwards > 0.0 ? std::max(part.from, -inside / inwards)
                                                          : std::min(part.to, -inside / inwards);
    return part.from < part.to ? std::optional(part) : std::nullopt;
}

}  // namespace slicecast
