// Where a player has room, of areas of a map.
#pragma once

#include "world/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast {

class Rooms {
public:
    // True if a crouched player fits into a tile of the area, in its middle, with the feet on a
    // level that the area touches: at the level's base or half a level above. The area must lie on
    // the map. A map is looked at once, when it is first asked for; then an area takes a time that
    // grows with its sides, not with its tiles.
    bool hasRoomIn(const World& world, int map, const Box& area);

private:
    // A square grid of tiles, or of squares of 2 x 2 places of the layer before it.
    struct Layer {
        int width;
        int depth;
        std::vector<std::uint32_t> levels;  // [y * width + x]: bit n is set if level n has room
    };
    // The first one has a place for each tile, the last one a single place.
    using Layers = std::vector<Layer>;

    static Layers layersOf(const World& world, int map);
    static bool any(const Layers& layers, std::size_t layer, int x, int y, const Box& area,
                    std::uint32_t levels);

    std::vector<Layers> maps_;  // empty for maps that nobody has asked for
};

}  // namespace slicecast
