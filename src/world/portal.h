// Portals: faces of blocks and whole tiles through which another map, or another place of the same
// one, is seen and entered.
//
//      entry map                 exit map                 The portal's tile is laid on the exit tile, turned clockwise (as seen from above) about its middle by
//      +---+---+                 +---+---+                quarter turns and shifted by whole levels; headings grow by 90 degrees for each quarter turn. What
//      |   | P |   turn = 1      | Q |   |                enters the portal goes on from there: seen from inside the block, or for an eye within the tile, the
//   -> |  ->>>>|  ========>      | v |   |                portal does nothing, and the exit tile's
//   own portal does not act on what arrives.
//      +---+---+                 +-v-+---+
//
// Where a portal puts things is a turn in integers: all of it is exact, and the reversed portal
// puts them back. How bodies go through is in traveller.h.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"

namespace slicecast {

struct Portal {
    int fromMap = 0;  // indices into World::maps
    int fromX = 0;    // the portal's own tile
    int fromY = 0;
    int toMap = 0;
    int toX = 0;  // the exit tile, on the exit map's grid
    int toY = 0;
    int turn = 0;    // quarter turns clockwise, 0 to 3
    int levels = 0;  // added to every height

    friend bool operator==(const Portal&, const Portal&) = default;
};

// The plane of a portal that a body has passed and still reaches back through.
struct Threshold {
    bool isOn = false;
    Portal back;             // from the tile that the eye has come into to where it came from
    Face side = Face::west;  // of that tile: what reaches out there is still on the other side
    Coordinate height;       // of the plane, where the side is the top or the bottom

    friend bool operator==(const Threshold&, const Threshold&) = default;
};

// A place in a map.
struct Position {
    Coordinate x;
    Coordinate y;
    Coordinate z;

    friend constexpr bool operator==(const Position&, const Position&) = default;
};

struct GridTile {
    int x = 0;
    int y = 0;

    friend constexpr bool operator==(const GridTile&, const GridTile&) = default;
};

// Where a place of the entry map comes to lie in the exit map. The tile is what matters: a place on
// its western or northern edge, which belongs to it, may come to lie on the exit tile's eastern or
// southern edge, which does not (see `keptInside`).
Position carried(const Portal& portal, Position place);
GridTile carried(const Portal& portal, GridTile tile);
double carriedHeading(const Portal& portal, double degrees);

// The same place, at most one 65536th of a unit to the west and to the north, so that it is in the
// tile on whose edge it lies.
Position keptInside(GridTile tile, Position place);

// A side of a block, turned; the top and the bottom stay what they are.
Face turned(Face face, int turn);

// An arrow along the ground, turned clockwise by quarter turns.
template <typename Number>
constexpr void turnArrow(int turn, Number& x, Number& y) {
    for (int i = 0; i < turn; ++i) {
        const Number oldX = x;
        x = Number{} - y;
        y = oldX;
    }
}

// True if both put every place at the same other place.
bool leadOnTogether(const Portal& a, const Portal& b);

// The portal that leads back.
Portal reversed(const Portal& portal);

// A portal that changes nothing, at a tile.
Portal identityPortal(int map, GridTile tile);

}  // namespace slicecast
