// A free ray: a level ray from any point of a world, without an eye or a picture. For figures and
// tools.
//
//     const CastRay told = cast(world, {.map = 0, .x = x, .y = y, .z = z, .headingDegrees = 30.0});
//
// It walks over the grid as slices do, with the same ties (projection.h) and portals. Its direction
// has length 1, so `distance` is in units along the ground.
//
//     without a height    every block of the tiles on its way is a hit, on all levels; it ends at
//                         the edge of the map. Portal tiles lead on, portal faces do not.
//     with a height z     only blocks with bottom <= z < top are hits. The first one that is not
//                         see-through ends it. Portal tiles and portal faces lead on.
#pragma once

#include "base/coordinate.h"
#include "render/projection.h"
#include "world/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast {

struct CastFrom {
    int map = 0;   // index into World::maps
    Coordinate x;  // units; outside the grid too
    Coordinate y;
    std::optional<Coordinate> z = {};
    double headingDegrees = 0.0;
};

// A tile that the ray enters, and the borders ahead of it: the smaller one leads on.
struct CastTile {
    int map = 0;
    int portals = 0;  // passed before
    int x = 0;
    int y = 0;
    bool entered = false;   // false in the tile in which the ray begins
    bool alongX = false;    // entered through a border of constant x
    double distance = 0.0;  // where it is entered
    double nextX = 0.0;     // distance of the next border of constant x; infinite for never
    double nextY = 0.0;
};

struct CastHit {
    int map = 0;
    int portals = 0;
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    BlueprintId blueprint = kEmptyCell;
    bool entered = false;  // false for a block in the tile in which the ray begins
    Face face = Face::north;
    double distance = 0.0;      // where the ray enters the block's tile
    double backDistance = 0.0;  // and where it leaves it
    double x = 0.0;             // where it enters, in the coordinates of the map
    double y = 0.0;
    Coordinate bottom;  // above the map's floor
    Coordinate top;
};

struct CastPortal {
    PortalId portal = kNoPortal;
    int portals = 0;
    double distance = 0.0;
};

struct CastRay {
    // What ends it: a block, the edge of the map, a portal past the limit (World::portalLimit), or
    // a height below the floor behind a portal.
    enum class End : std::uint8_t { block, edge, portal, floor };

    GroundDirection direction;  // in the first map
    std::vector<CastTile> tiles;
    std::vector<CastHit> hits;
    std::vector<CastPortal> portals;
    End end = End::edge;
    double distance = 0.0;  // where it ends
    int map = 0;            // and in which map
    double x = 0.0;
    double y = 0.0;
};

// The map exists, the heading is a number.
CastRay cast(const World& world, const CastFrom& from);

}  // namespace slicecast
