// A free ray: a horizontal ray from any point, without a picture. Game::cast() follows it.
//
//     without a height    all blocks on all levels of its tiles are hits; it ends at the edge of
//                         the map. Tiles with a portal lead on, faces with one do not.
//     with a height z     only blocks at that height are hits. The first opaque one ends it. Both
//                         kinds of portals lead on.
//
// Distances are units along the ground, from the start.
#pragma once

#include "slicecast/face.h"
#include "slicecast/trace.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slicecast {

struct RayStart {
    int map = 0;     // index in Scene::maps
    double x = 0.0;  // units, -32767 to 32767; may lie outside the map
    double y = 0.0;
    std::optional<double> z = {};  // the same range
    double headingDegrees = 0.0;   // 0 = east, 90 = south; any finite number
};

// A tile that the ray enters, and the borders ahead: the nearer one leads on.
struct RayTile {
    int map = 0;
    int portals = 0;  // passed before
    int x = 0;
    int y = 0;
    bool entered = false;  // false in the tile where the ray starts
    bool alongX = false;   // entered through a border of constant x
    double distance = 0.0;
    double nextX = 0.0;  // distance of the next border of constant x; infinite for never
    double nextY = 0.0;
};

// A block that the ray meets.
struct RayHit {
    int map = 0;
    int portals = 0;  // passed before
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    std::string block;         // name of its blueprint
    std::optional<Face> face;  // where the ray enters; none if it starts inside
    double x = 0.0;            // the point where it enters, in the map's units
    double y = 0.0;
    double distance = 0.0;      // to that point
    double backDistance = 0.0;  // to where the ray leaves it
    double bottom = 0.0;        // heights above the map's floor, units
    double top = 0.0;
};

struct RayPortal {
    PortalEnds ends;
    double distance = 0.0;
};

// Why a ray ends: an opaque block, the edge of the map, one portal more than the scene's limit, or
// a height below the floor behind a portal.
enum class RayEnd : std::uint8_t { block, edge, portal, floor };

struct Ray {
    double directionX = 0.0;  // of length 1, in the first map
    double directionY = 0.0;
    std::vector<RayTile> tiles;
    std::vector<RayHit> hits;
    std::vector<RayPortal> portals;
    RayEnd end = RayEnd::edge;
    int map = 0;  // at the end
    double x = 0.0;
    double y = 0.0;
    double distance = 0.0;
};

}  // namespace slicecast
