// A free ray: a horizontal ray from any point of a world, without an eye or a picture. For figures
// and tools.
//
//     const CastRay ray = cast(world, {.map = 0, .x = x, .y = y, .z = z, .headingDegrees = 30.0});
//
// It walks over the grid like slices, with the same ties (projection.h) and portals. Its direction
// has length 1, so `distance` is in units along the ground.
//
//     without a height    all blocks on all levels of its tiles are hits; it ends at
//                         the edge of the map. Portal tiles lead on, portal faces do not.
//     with a height z     only blocks with bottom <= z < top are hits, of blocks with slopes
//                         where that is so. The first opaque one ends it. Portal tiles and
//                         portal faces lead on.
#pragma once

#include "base/coordinate.h"
#include "render/view/projection.h"
#include "world/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast {

struct CastFrom {
    int map = 0;   // index into World::maps
    Coordinate x;  // units; may be outside the grid
    Coordinate y;
    std::optional<Coordinate> z = {};
    double headingDegrees = 0.0;
};

// A tile that the ray enters, and the borders ahead: the nearer one leads on.
struct CastTile {
    int map = 0;
    int portals = 0;  // passed before
    int x = 0;
    int y = 0;
    bool entered = false;   // false in the tile where the ray starts
    bool alongX = false;    // entered through a border of constant x
    double distance = 0.0;  // to where the ray enters it
    double nextX = 0.0;     // to the next border of constant x; infinite for never
    double nextY = 0.0;
};

struct CastHit {
    int map = 0;
    int portals = 0;
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    BlueprintId blueprint = kEmptyCell;
    bool entered = false;  // false if the ray starts inside
    Face face = Face::north;
    double distance = 0.0;      // to where the ray enters the block
    double backDistance = 0.0;  // to where it leaves it
    double x = 0.0;             // the point where it enters, in the coordinates of the map
    double y = 0.0;
    Coordinate bottom;  // above the map's floor: its lowest and its highest point
    Coordinate top;
};

struct CastPortal {
    PortalId portal = kNoPortal;
    int portals = 0;
    double distance = 0.0;
};

struct CastRay {
    // The reason why it ends: a block, the edge of the map, a portal beyond the limit
    // (World::portalLimit), or a height below the floor behind a portal.
    enum class End : std::uint8_t { block, edge, portal, floor };

    GroundDirection direction;  // in the first map
    std::vector<CastTile> tiles;
    std::vector<CastHit> hits;
    std::vector<CastPortal> portals;
    End end = End::edge;
    double distance = 0.0;  // to the end
    int map = 0;            // at the end
    double x = 0.0;
    double y = 0.0;
};

// The map must exist and the heading be finite.
CastRay cast(const World& world, const CastFrom& from);

}  // namespace slicecast
