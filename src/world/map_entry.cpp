#include "world/map_entry.h"

#include "world/player.h"
#include "world/water.h"
#include "world/world.h"

#include <algorithm>
#include <optional>

namespace slicecast {
namespace {

// The lowest height at which a player can stand in the middle of a tile.
std::optional<Coordinate> lowestPlace(const World& world, int mapIndex, int tileX, int tileY) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const Coordinate x = {tileEdge(tileX).raw + tileEdge(1).raw / 2};
    const Coordinate y = {tileEdge(tileY).raw + tileEdge(1).raw / 2};
    const auto isDry = [&](Coordinate feet) {
        return waterAt(world, map, tileX, tileY, feet).water == nullptr;
    };
    if (isDry({}) && fitsStanding(world, mapIndex, x, y, {})) return Coordinate{};
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId id = map.cell(tileX, tileY, level);
        if (id == kEmptyCell || world.blueprints[id].isWater) continue;
        const Coordinate top = tileEdge(level) + world.blueprints[id].top;
        if (!isDry(top) || !fitsStanding(world, mapIndex, x, y, top)) continue;
        // On a slope the feet are lower than its highest point
        return top + sweepZ(world, mapIndex, bodyBox(x, y, top, kStandingHeight), {-65536});
    }
    return std::nullopt;
}

}  // namespace

MapEntry findMapEntry(const World& world, int mapIndex) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const int middleX = map.width / 2;
    const int middleY = map.depth / 2;
    const Coordinate half = {tileEdge(1).raw / 2};
    for (int ring = 0; ring <= std::max(map.width, map.depth); ++ring) {
        // The tiles of a ring that are on the map: a row, or its two ends
        const int west = std::max(0, middleX - ring);
        const int east = std::min(map.width - 1, middleX + ring);
        const bool hasEnds = middleX - ring >= 0 || middleX + ring < map.width;
        for (int y = std::max(0, middleY - ring); y <= std::min(map.depth - 1, middleY + ring);
             ++y) {
            const bool wholeRow = y == middleY - ring || y == middleY + ring;
            if (!wholeRow && !hasEnds) {
                y = middleY + ring - 1;  // the last row is next
                continue;
            }
            const int last = wholeRow ? east : middleX + ring;
            for (int x = wholeRow ? west : middleX - ring; x <= last;
                 x += wholeRow ? 1 : 2 * ring) {
                if (!map.contains(x, y)) continue;
                if (const std::optional<Coordinate> feet = lowestPlace(world, mapIndex, x, y)) {
                    return {tileEdge(x) + half, tileEdge(y) + half, *feet, true};
                }
            }
        }
    }
    return {tileEdge(middleX) + half, tileEdge(middleY) + half, tileEdge(map.levels + 1), false};
}

}  // namespace slicecast
