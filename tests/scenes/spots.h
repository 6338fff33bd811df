// The places of a map at which a player can stand, as a graph: one for each height of a tile at
// which there is room. From a place one gets to places of the four tiles beside it, up to the
// height of a jump above it. There must be room for the head above the higher of the two.
#pragma once

#include "world/player.h"
#include "world/world.h"

#include <cstddef>
#include <vector>

namespace slicecast {

// Room to stand: from the ground to what is above the head.
struct Gap {
    Coordinate ground;
    Coordinate above;
    bool isWater = false;  // the ground is the surface that one swims at
};

struct Spot {
    int x, y;
    Gap gap;
};

using Steps = std::vector<std::vector<std::size_t>>;  // from each spot to others

struct Spots {
    std::vector<Spot> all;
    Steps there;
    Steps back;

    // Those of a tile: [first(x, y), last(x, y)).
    std::size_t first(const Map& map, int x, int y) const { return firsts[map.tileIndex(x, y)]; }
    std::size_t last(const Map& map, int x, int y) const { return firsts[map.tileIndex(x, y) + 1]; }
    std::vector<std::size_t> firsts;  // by tile, and the end
};

Spots spotsOf(const World& world, const Map& map);

// The spot where the game starts, in the start's map; the number of spots if it is none.
std::size_t startSpot(const World& world, const Spots& spots);

// Which spots can be reached from some.
std::vector<bool> reachable(const Steps& steps, std::vector<std::size_t> open);

}  // namespace slicecast
