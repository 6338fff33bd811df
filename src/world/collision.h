// What stands in a body's way. A body is an upright box with its sides along the grid; all of it is
// integer arithmetic in 1/65536 units, so a contact is exact and there is no tolerance anywhere.
//
// Solid are: the blocks but those of water, the floor (height 0), the ceiling plane of the tiles
// that have one (it has no thickness: it can be stood on, and bumped into from below), and the
// outline of the grid at every height. Above the top level there is open air up to kMaxBodyHeight.
// Touching is not overlapping: a body may rest on, stand against and slide along all of these.
#pragma once

#include "base/coordinate.h"
#include "world/world.h"

#include <optional>

namespace slicecast {

// The space that a body takes up, without its surface: west < x < east, north < y < south, bottom <
// z < top.
struct Box {
    Coordinate west;
    Coordinate east;
    Coordinate north;
    Coordinate south;
    Coordinate bottom;
    Coordinate top;

    friend constexpr bool operator==(const Box&, const Box&) = default;
};

// How far something moves, or may move.
struct Offset {
    Coordinate x;
    Coordinate y;
    Coordinate z;
};

// No body rises above this: from higher up a map would be a speck in the haze, and every sum of
// coordinates stays within its type. More than kMaxLevels, so that all roofs can be stood on.
inline constexpr Coordinate kMaxBodyHeight = tileEdge(48);

// Displacements are walked in parts of at most this length per axis, so that a slanting path is
// followed and not cut short around a corner.
inline constexpr Coordinate kLongestSlide = {65536 / 16};

constexpr Box moved(Box box, Offset by) {
    return {box.west + by.x,  box.east + by.x,   box.north + by.y,
            box.south + by.y, box.bottom + by.z, box.top + by.z};
}

// True if nothing solid reaches into the box. False for a map that does not exist. Here and below,
// water is solid to who floats.
bool isFree(const World& world, int map, const Box& box, bool floats = false);

// How far a free box gets along one axis on a way of `distance`, of either sign, before something
// stops it: between 0 and `distance`.
Coordinate sweepX(const World& world, int map, const Box& box, Coordinate distance);
Coordinate sweepY(const World& world, int map, const Box& box, Coordinate distance);
Coordinate sweepZ(const World& world, int map, const Box& box, Coordinate distance,
                  bool floats = false);

// True if a free box rests on something.
bool isSupported(const World& world, int map, const Box& box);

// The least rise, from 0 to `limit`, with which the box would be free, whether or not there is a
// way up there; nothing if there is none.
std::optional<Coordinate> leastRise(const World& world, int map, const Box& box, Coordinate limit);

// Where a move ended, and what it ran into.
struct Slide {
    Box box;
    Coordinate rise;        // how much of the move upwards was steps
    bool stoppedX = false;  // something solid lay in the way along that axis
    bool stoppedY = false;
};

// Moves a free box, wider and deeper than kLongestSlide, sideways, axis by axis, so that it slides
// along what it meets. Where it is stopped by something whose top is at most `step` above its
// bottom, it is put onto that top if there is room for it on the way there. The result is free.
Slide slide(const World& world, int map, const Box& box, Coordinate distanceX, Coordinate distanceY,
            Coordinate step, bool floats = false);

}  // namespace slicecast
