#include "world/map.h"

#include <utility>

namespace slicecast {

void Map::setCell(int x, int y, int level, BlueprintId blueprint) {
    cells[cellIndex(x, y, level)] = blueprint;
    const std::uint32_t bit = 1u << level;
    std::uint32_t& column = occupied[tileIndex(x, y)];
    column = blueprint == kEmptyCell ? column & ~bit : column | bit;
}

Map makeMap(std::string name, int width, int depth, int levels, TextureId floorTexture) {
    Map map;
    map.name = std::move(name);
    map.width = width;
    map.depth = depth;
    map.levels = levels;
    const std::size_t tiles = static_cast<std::size_t>(width) * static_cast<std::size_t>(depth);
    map.cells.assign(tiles * static_cast<std::size_t>(levels), kEmptyCell);
    map.occupied.assign(tiles, 0);
    map.floor.texture = floorTexture;
    map.floor.tiles.assign(tiles, floorTexture);
    return map;
}

}  // namespace slicecast
