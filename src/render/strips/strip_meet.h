// Meets what is in a tile, or in a stretch of it, for all columns that pass it together. Rows are
// given by lane; [first, last) is empty where they are not in order.
//
// Functions named "take" close rows and add opaque spans; "see" adds layers; "enter" and "leave"
// take the faces of a block as rays come in and go out, whatever these faces are.
//
// strip_cover.cpp      floor and ceiling
// strip_blocks.cpp     the blocks of a tile: which faces are met, and in which rows
// strip_slopes.cpp     blocks with slopes
// strip_sides.cpp      sides
// strip_planes.cpp     roofs and undersides
// strip_joins.cpp      which blocks join, so that no face is between them
// strip_passages.cpp   portals
#pragma once

#include "render/strips/strip_tile.h"

#include <cstdint>

namespace slicecast {

// ---- strip_cover.cpp
// Begins the floor and the ceiling of a tile where they are not those of before.
void changeCover(StripTile& tile, TextureId floor, TextureId ceiling);
void takeFloor(StripTile& tile, Lanes mask, Border at);
void endCeiling(StripTile& tile, Lanes mask, Border at);
void takeCeilingHere(StripTile& tile, TextureId texture);

// ---- strip_blocks.cpp
// The blocks of a tile in some levels and its floor and ceiling.
void meetStretch(StripTile& tile, std::uint32_t levels, TextureId floor, TextureId ceiling);

// ---- strip_slopes.cpp
// The top or the underside of a block with slopes.
struct FaceOfSlopes {
    Face face = Face::top;
    bool isSloped = false;  // else level
    double height = 0.0;    // of its plane: see SlopedPlane
    LaneDoubles horizon;
    Lanes atEnter;  // the first rows below it there
    Lanes atLeave;
};
struct MetSlopes {
    FaceOfSlopes top;
    FaceOfSlopes bottom;
};
// First the side that rays enter, and the level face at the block's end nearer to the eye's height;
// then the rest. A ceiling may lie between, at the height of the block's end.
MetSlopes enterSlopes(StripTile& tile, const Block& block);
void passSlopes(StripTile& tile, const Block& block, const MetSlopes& met);
// The first rows below the top or the underside of a block in tile (x, y).
Lanes rowsOfFace(const StripTile& tile, const CellBlueprint& block, Face face, int x, int y,
                 int level, Border at);

// ---- strip_sides.cpp
void enterSide(StripTile& tile, const Block& block, Lanes first, Lanes last);
void leaveSide(StripTile& tile, const Block& block, Lanes first, Lanes last);

// ---- strip_planes.cpp
void enterTop(StripTile& tile, const Block& block, Lanes first, Lanes last);
void enterBottom(StripTile& tile, const Block& block, Lanes first, Lanes last);
void leavePlane(StripTile& tile, const Block& block, Face face, Lanes first, Lanes last);

// ---- strip_joins.cpp
// Whether a block and the one above it, or below, are parts of one mover: then nothing is between
// them, whether or not they are see-through.
bool goesOn(const StripTile& tile, const Block& block, int up);
// Whether a block of the current tile joins the one above it, or below: a touching block of its
// kind or of the same mover. A ray that leaves the block may go through a portal there.
bool joinsNext(const StripTile& tile, const Block& block, int up, bool leaving);
// The block in the tile before, or behind, that joins `block`; null for none. Plans decide column
// by column: in `lanes` stay those for which it is true.
const CellBlueprint* joinedBefore(const StripTile& tile, const Block& block,
                                  const CrossingLanes& at, Lanes& lanes);
const CellBlueprint* joinedNear(const StripTile& tile, const Block& block, const CrossingLanes& at,
                                Border border, Lanes& lanes);
// The same behind a portal, through which two blocks join only if both fill their tiles and have no
// slopes.
const CellBlueprint* joinedBeyond(const StripTile& tile, const Block& block, const Map& map, int x,
                                  int y, int level);
const CellBlueprint* joinedBeyond(const StripTile& tile, const Block& block, const Portal& portal,
                                  int level);

// ---- strip_passages.cpp
// Whether the portal of a roof, or of an underside, acts.
bool actsAtTop(const StripTile& tile, const Block& block);
bool actsAtBottom(const StripTile& tile, const Block& block);
void sendThrough(StripTile& tile, PortalId portal, Lanes mask, Lanes first, Lanes last,
                 const HeightClip& clip);
// Sends all open rows through the tile's portal. If it does not act, they end in the haze of the
// present map.
void enterPortalTile(StripTile& tile);

}  // namespace slicecast
