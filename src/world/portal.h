// Portals: faces of blocks and whole tiles through which another map, or another place of the same one, is seen and entered.
//
//      entry map                 exit map                 The portal's tile is laid on the exit tile, turned clockwise (as seen from above) about its middle by
//      +---+---+                 +---+---+                quarter turns and shifted by whole levels; headings grow by 90 degrees for each quarter turn. What
//      |   | P |   turn = 1      | Q |   |                enters the portal goes on from there: seen from inside the block, or for an eye within the tile, the
//   -> |  ->>>>|  ========>      | v |   |                portal does nothing, and the exit tile's own portal does not act on what arrives.
//      +---+---+                 +-v-+---+
#pragma once

namespace slicecast {

struct Portal {
    int fromMap = 0;  // indices into World::maps
    int fromX = 0;    // the portal's own tile
    int fromY = 0;
    int toMap = 0;
    int toX = 0;      // the exit tile, on the exit map's grid
    int toY = 0;
    int turn = 0;     // quarter turns clockwise, 0 to 3
    int levels = 0;   // added to every height
};

}  // namespace slicecast
