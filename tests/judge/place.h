// Where a ray is: the map that it goes through, and how that map lies along it. A ray keeps the
// coordinates of the map that it began in. Behind a portal, the other map is laid along the ray:
// turned clockwise (seen from above) by quarter turns and moved by whole tiles and levels. So
// nothing is rounded anew:
//
//     map point = ray point, turned about the origin by `turn`, plus (x, y)        map height = ray height + levels
#pragma once

#include "world/portal.h"

namespace slicecast::judge {

struct Tile {
    int x = 0;
    int y = 0;
};

struct Point {
    double x = 0.0;
    double y = 0.0;
};

struct Place {
    int map = 0;
    int turn = 0;
    int x = 0;
    int y = 0;
    int levels = 0;

    // A direction, or a step from one tile to the next, turned by quarter turns: east becomes
    // south, south becomes west.
    template <typename Vector>
    static Vector turned(Vector v, int quarters) {
        switch (quarters & 3) {
            case 1:
                return {-v.y, v.x};
            case 2:
                return {-v.x, -v.y};
            case 3:
                return {v.y, -v.x};
            default:
                return v;
        }
    }

    // The map's tile that lies over a tile of the ray. Middles of tiles are turned, in halves,
    // which are whole numbers.
    Tile tileOf(Tile tile) const {
        const Tile middle = turned(Tile{2 * tile.x + 1, 2 * tile.y + 1}, turn);
        return {(middle.x - 1) / 2 + x, (middle.y - 1) / 2 + y};
    }

    Point pointOf(Point point) const {
        const Point p = turned(point, turn);
        return {p.x + x, p.y + y};
    }

    // The ray's point for a point of the map.
    Point rayPointOf(Point point) const {
        return turned(Point{point.x - x, point.y - y}, 4 - turn);
    }

    // The way on behind a portal of this place's map: the portal's tile is laid on the exit tile.
    Place through(const Portal& portal) const {
        const Tile beforeTurn = {2 * (x - portal.fromX) - 1, 2 * (y - portal.fromY) - 1};
        const Tile offset = turned(beforeTurn, portal.turn);
        return {portal.toMap, (turn + portal.turn) & 3, (offset.x + 1) / 2 + portal.toX,
                (offset.y + 1) / 2 + portal.toY, levels + portal.levels};
    }
};

}  // namespace slicecast::judge
