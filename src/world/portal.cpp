#include "world/portal.h"

#include "base/angle.h"

namespace slicecast {
namespace {

constexpr Coordinate kHalfTile = {tileEdge(1).raw / 2};

}  // namespace

Position carried(const Portal& portal, Position place) {
    Coordinate x = place.x - tileEdge(portal.fromX) - kHalfTile;
    Coordinate y = place.y - tileEdge(portal.fromY) - kHalfTile;
    turnArrow(portal.turn, x, y);
    return {tileEdge(portal.toX) + kHalfTile + x, tileEdge(portal.toY) + kHalfTile + y,
            place.z + tileEdge(portal.levels)};
}

GridTile carried(const Portal& portal, GridTile tile) {
    int x = tile.x - portal.fromX;
    int y = tile.y - portal.fromY;
    turnArrow(portal.turn, x, y);
    return {portal.toX + x, portal.toY + y};
}

double carriedHeading(const Portal& portal, double degrees) {
    return portal.turn == 0 ? degrees : wrapDegrees(degrees + 90.0 * portal.turn);
}

Position keptInside(GridTile tile, Position place) {
    if (place.x == tileEdge(tile.x + 1)) place.x = place.x - Coordinate{1};
    if (place.y == tileEdge(tile.y + 1)) place.y = place.y - Coordinate{1};
    return place;
}

Face turned(Face face, int turn) {
    if (face == Face::top || face == Face::bottom) return face;
    return static_cast<Face>((static_cast<int>(face) + turn) % 4);
}

bool leadOnTogether(const Portal& a, const Portal& b) {
    return a.fromMap == b.fromMap && a.toMap == b.toMap && a.turn == b.turn &&
           a.levels == b.levels && carried(a, GridTile{b.fromX, b.fromY}) == GridTile{b.toX, b.toY};
}

Portal reversed(const Portal& portal) {
    return {.fromMap = portal.toMap,
            .fromX = portal.toX,
            .fromY = portal.toY,
            .toMap = portal.fromMap,
            .toX = portal.fromX,
            .toY = portal.fromY,
            .turn = (4 - portal.turn) % 4,
            .levels = -portal.levels};
}

Portal identityPortal(int map, GridTile tile) {
    return {.fromMap = map,
            .fromX = tile.x,
            .fromY = tile.y,
            .toMap = map,
            .toX = tile.x,
            .toY = tile.y};
}

}  // namespace slicecast
