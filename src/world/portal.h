// Portals: faces of blocks and whole tiles through which one sees and enters another map, or
// another place of the same map.
//
//      entry map                 exit map
//      +---+---+                 +---+---+
//      |   | P |   turn = 1      | Q |   |
//   -> |  ->>>>|  ========>      | v |   |
//      +---+---+                 +-v-+---+
//
// The portal's tile is laid on the exit tile, turned clockwise (seen from above) about its middle
// by quarter turns and shifted by whole levels; headings grow by 90 degrees for each quarter turn.
// Whatever enters the portal continues from there. A portal face does nothing seen from inside its
// block, and a portal tile nothing for an eye within it. Where something arrives, neither the exit
// tile's own portal nor a face in the plane of the exit acts.
//
// All of this is integer arithmetic and therefore exact, and the reversed portal undoes it. How
// bodies go through is in traveller.h.
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

// The plane of a portal that a body has passed and still reaches through.
struct Threshold {
    bool isOn = false;
    Portal back;             // leads from the eye's tile back to where the eye came from
    Face side = Face::west;  // of that tile: parts beyond it are still on the other side
    Coordinate height;       // of the plane, if the side is top or bottom

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

// Maps a place of the entry map to the exit map. The western and northern edges belong to the entry
// tile. A place on them may land on the eastern or southern edge of the exit tile, which does not
// belong to that tile: see `keptInside`.
Position carried(const Portal& portal, Position place);
GridTile carried(const Portal& portal, GridTile tile);
double carriedHeading(const Portal& portal, double degrees);

// Moves a place on the eastern or southern edge by 1/65536 unit into the tile.
Position keptInside(GridTile tile, Position place);

// A side of a block, turned; top and bottom stay.
Face turned(Face face, int turn);

// Turns a vector along the ground clockwise by quarter turns.
template <typename Number>
constexpr void turnArrow(int turn, Number& x, Number& y) {
    for (int i = 0; i < turn; ++i) {
        const Number oldX = x;
        x = Number{} - y;
        y = oldX;
    }
}

// True if both map every place to the same place.
bool leadOnTogether(const Portal& a, const Portal& b);

// The portal that leads back.
Portal reversed(const Portal& portal);

// A portal at a tile that changes nothing.
Portal identityPortal(int map, GridTile tile);

}  // namespace slicecast
