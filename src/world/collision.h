// Finds what stops a body. A body is an axis-aligned box. All of this is integer arithmetic in
// 1/65536 units, so contacts are exact and need no tolerance.
//
// Solid are: all blocks except water, the floor (height 0), the ceiling plane of the tiles that
// have one (without thickness; bodies can stand on it and bump into it from below), and the outline
// of the grid at every height. Above the top level there is open air up to kMaxBodyHeight. Touching
// is not overlapping: a body may rest on, stand against and slide along all of these.
#pragma once

#include "base/coordinate.h"
#include "world/box.h"
#include "world/world.h"

#include <optional>

namespace slicecast {

// A displacement.
struct Offset {
    Coordinate x;
    Coordinate y;
    Coordinate z;
};

// No body rises above this height: from there a map would be a speck in the haze, and all sums of
// coordinates fit their type. Above kMaxLevels, so that bodies can stand on every roof.
inline constexpr Coordinate kMaxBodyHeight = tileEdge(48);

// Longer moves are split into parts of at most this length per axis, so that a diagonal path cannot
// cut corners.
inline constexpr Coordinate kLongestSlide = {65536 / 16};

constexpr Box moved(Box box, Offset by) {
    return {box.west + by.x,  box.east + by.x,   box.north + by.y,
            box.south + by.y, box.bottom + by.z, box.top + by.z};
}

// True if nothing solid reaches into the box. False for a map that does not exist. Here and below,
// water is solid for bodies that float.
bool isFree(const World& world, int map, const Box& box, bool floats = false);

// How far a free box gets along one axis before something stops it: between 0 and `distance`, which
// may be negative.
Coordinate sweepX(const World& world, int map, const Box& box, Coordinate distance);
Coordinate sweepY(const World& world, int map, const Box& box, Coordinate distance);
Coordinate sweepZ(const World& world, int map, const Box& box, Coordinate distance,
                  bool floats = false);

// True if a free box rests on something.
bool isSupported(const World& world, int map, const Box& box);

// The least rise from 0 to `limit` that makes the box free, even if the way up there is blocked;
// nothing if there is none.
std::optional<Coordinate> leastRise(const World& world, int map, const Box& box, Coordinate limit);

// The end of a move, and what stopped it.
struct Slide {
    Box box;
    Coordinate rise;        // the part of the upward move that was steps
    bool stoppedX = false;  // something solid lay in the way along that axis
    bool stoppedY = false;
    int slip = 0;  // went along the cut of a half: 1 if x and y grow together along it, or -1
};

// Moves a free box, wider and deeper than kLongestSlide, sideways, axis by axis, so that it slides
// along obstacles. If an obstacle's top is at most `step` above its bottom, it steps up there if it
// has room on the way. At the cut of a half, half of the rest of the way goes along each axis. The
// result is free.
Slide slide(const World& world, int map, const Box& box, Coordinate distanceX, Coordinate distanceY,
            Coordinate step, bool floats = false);

}  // namespace slicecast
