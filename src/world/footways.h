// Where a player can get to from the world's start on foot: walking, jumping, swimming, on lifts,
// through portals, and through gates that open to a player who has come so far.
//
//     const Footways ways(world);
//     if (!ways.comesWithin(map, box, distance)) ...     nobody gets there
//
//     |#######|#######|
//     |       |       |  A room is the space in one tile between what bodies stand on and what is
//     |       |   .---|  above their heads. Blocks that fill only a part of their tile, slopes,
//     |   .---|   |   |  water, movers and gates that open do not end a room: whoever gets as high
//     |   |   |   |   |  as their top stands on it.
//     |#######|#######|
//
// It looks at rooms, not at bodies: whoever is anywhere in a room gets to all of its sides. So it
// finds more ways than there are. What it does not reach, nobody reaches who does not fly.
#pragma once

#include "world/world.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

namespace slicecast {

// In a tile, above the floor.
struct RoomHeights {
    Coordinate low;
    Coordinate high;
};

class Footways {
public:
    // Looks at every place that can be reached, so it may take seconds in a large world. The world
    // must be complete, at its start, and outlive this.
    explicit Footways(const World& world);
    // Looks while next() is called, at so many places at most. Ask it after that.
    Footways(const World& world, std::int64_t mostPlaces);
    // Looks at some places. False if there are no more.
    bool next();
    // True if there were too many: then it does not know what can be reached.
    bool gaveUp() const { return places_ < 0; }

    // True if the body of a player who gets somewhere is at most so far from the box.
    bool comesWithin(int map, const Box& box, Coordinate distance) const;
    // True if a player's middle gets into the box, which has the edges of tiles.
    bool comesInto(int map, const Box& box) const;

    // Where a player can stand: the middle of a tile.
    struct Place {
        int x = 0;  // tile
        int y = 0;
        Coordinate feet;
    };
    // The nearest such place to the box; none if nobody gets into the map.
    std::optional<Place> nearestTo(int map, const Box& box) const;

    // True if a player gets to where the gate hears keys, or notices who comes.
    bool isMet(const Gate& gate) const;
    // True if the find of this index can be taken. One that moves may come to the player.
    bool takes(std::size_t index) const;

private:
    static constexpr Coordinate kNowhere = tileEdge(-1);

    struct Room {
        Coordinate ground;
        Coordinate above;
        Coordinate feet = kNowhere;  // the highest place to stand in it
        Coordinate high = kNowhere;  // the highest that feet get, in the air
        // The last jump that came here, how high it was, and behind how many tiles.
        std::size_t jump = 0;
        Coordinate jumped = kNowhere;
        int tiles = 0;
    };
    struct Wall {
        RoomHeights heights;
        unsigned sides = 0;  // of its tile that it closes: bit n is Face n
    };
    // A tile, once somebody has come near.
    struct Column {
        bool isKnown = false;
        std::uint32_t firstRoom = 0;  // indices into the lists of the grid
        std::uint32_t rooms = 0;
        std::uint32_t firstClimb = 0;
        std::uint32_t climbs = 0;
        std::uint32_t firstWall = 0;
        std::uint32_t walls = 0;
    };
    struct Grid {
        std::vector<Column> columns;  // by tile
        std::vector<Room> rooms;
        std::vector<RoomHeights> climbs;  // who gets as high as the low end gets to the high end
        std::vector<Wall> walls;
    };
    struct Spot {
        int map = 0;
        int x = 0;
        int y = 0;
        std::size_t room = 0;
        Coordinate feet = {};  // when it was listed in waiting_

        friend bool operator<(const Spot& a, const Spot& b) { return a.feet < b.feet; }
    };

    void begin();
    bool openMore();
    bool canOpen(const Gate& gate) const;
    bool canHold(const Needs& needs) const;
    const Column& columnAt(int map, int x, int y);
    void addWalls(const Spot& spot, Face side, std::vector<RoomHeights>& walls);
    void arrive(int map, int x, int y, Coordinate low, Coordinate high, Coordinate feet);
    void stand(const Spot& spot, Coordinate feet, Coordinate least);
    void jumpFrom(const Spot& spot);
    bool goThroughTile(const Spot& from, int x, int y, Coordinate feet);
    void goThroughSides(const Spot& from, Face side, int x, int y, Coordinate feet);
    void goThroughEnds(const Spot& spot);
    Room& roomAt(const Spot& spot) {
        return grids_[static_cast<std::size_t>(spot.map)].rooms[spot.room];
    }
    template <typename Test>
    bool anyRoom(int map, const Box& tiles, Test test) const;

    const World& world_;
    std::vector<Grid> grids_;  // by map
    // Rooms whose ways on are still to be looked at; from the highest one gets furthest.
    std::priority_queue<Spot> waiting_;
    std::vector<bool> isShut_;     // by gate
    std::vector<bool> isMoving_;   // by find
    std::vector<bool> hasMovers_;  // by map: whether objects move there
    std::size_t jumps_ = 0;
    std::int64_t places_;  // that it may still look at
};

}  // namespace slicecast
