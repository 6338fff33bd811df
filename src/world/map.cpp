#include "world/map.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace slicecast {

std::uint64_t nextEdition() {
    static std::atomic<std::uint64_t> last = 0;
    return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

void Map::setCell(int x, int y, int level, BlueprintId blueprint) {
    edition = nextEdition();
    cells[cellIndex(x, y, level)] = blueprint;
    const std::uint32_t bit = 1u << level;
    std::uint32_t& column = occupied[tileIndex(x, y)];
    column = blueprint == kEmptyCell ? column & ~bit : column | bit;
    openLand.clear();
}

void Map::setChangingCell(int x, int y, int level, BlueprintId blueprint) {
    setCell(x, y, level, blueprint);
    if (changing.empty()) changing.resize(occupied.size());
    changing[tileIndex(x, y)] |= 1u << level;
}

// One more than the least neighbour: first from the north and west, then from the south and east.
void Map::findOpenLand() {
    constexpr int kMost = 255;
    openLand.assign(floor.tiles.size(), 0);
    const auto isOpen = [&](std::size_t tile) {
        const auto cell = cells.begin() + static_cast<std::ptrdiff_t>(tile) * levels;
        return floor.tiles[tile] == floor.texture &&
               (ceiling.tiles.empty() || ceiling.tiles[tile] == kNoTexture) &&
               (tilePortals.empty() || tilePortals[tile] == kNoPortal) &&
               std::all_of(cell, cell + levels, [](BlueprintId id) { return id == kEmptyCell; });
    };
    const auto at = [&](int x, int y) -> int {
        return contains(x, y) ? openLand[tileIndex(x, y)] : kMost;
    };
    const auto around = [&](int x, int y, int side) {
        return 1 + std::min({at(x - 1, y + side), at(x, y + side), at(x + 1, y + side),
                             at(x + side, y), kMost - 1});
    };
    for (int y = 0; y < depth; ++y)
        for (int x = 0; x < width; ++x)
            if (isOpen(tileIndex(x, y)))
                openLand[tileIndex(x, y)] = static_cast<std::uint8_t>(around(x, y, -1));
    for (int y = depth - 1; y >= 0; --y)
        for (int x = width - 1; x >= 0; --x) {
            std::uint8_t& here = openLand[tileIndex(x, y)];
            here = static_cast<std::uint8_t>(std::min<int>(here, around(x, y, 1)));
        }
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
