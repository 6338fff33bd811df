#include "world/map_entry.h"

#include "world/player.h"
#include "world/water.h"
#include "world/world.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace slicecast {

std::optional<Coordinate> findFooting(const World& world, int mapIndex, int tileX, int tileY,
                                      Coordinate wanted) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const Coordinate x = {tileEdge(tileX).raw + tileEdge(1).raw / 2};
    const Coordinate y = {tileEdge(tileY).raw + tileEdge(1).raw / 2};
    std::optional<Coordinate> best;
    const auto offer = [&](Coordinate feet) {
        if (waterAt(world, map, tileX, tileY, feet).water != nullptr ||
            !fitsStanding(world, mapIndex, x, y, feet))
            return;
        // On a slope the feet are lower than its highest point
        const Coordinate ground =
            feet + sweepZ(world, mapIndex, bodyBox(x, y, feet, kStandingHeight), {-65536});
        if (!best || std::abs((ground - wanted).raw) < std::abs((*best - wanted).raw))
            best = ground;
    };
    offer({});
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId id = map.cell(tileX, tileY, level);
        if (id == kEmptyCell || world.blueprints[id].isWater) continue;
        offer(tileEdge(level) + world.blueprints[id].top);
    }
    return best;
}

namespace {

// Begins at a tile of the map.
MapEntry findAround(const World& world, int mapIndex, int middleX, int middleY, Coordinate wanted) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
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
                if (const std::optional<Coordinate> feet =
                        findFooting(world, mapIndex, x, y, wanted)) {
                    return {tileEdge(x) + half, tileEdge(y) + half, *feet, true};
                }
            }
        }
    }
    return {tileEdge(middleX) + half, tileEdge(middleY) + half, tileEdge(map.levels + 1), false};
}

}  // namespace

MapEntry findMapEntry(const World& world, int map) {
    const Map& entered = world.maps[static_cast<std::size_t>(map)];
    return findAround(world, map, entered.width / 2, entered.depth / 2, {});
}

MapEntry findGround(const World& world, int map, const Position& eye) {
    const Map& around = world.maps[static_cast<std::size_t>(map)];
    return findAround(world, map, std::clamp(eye.x.tile(), 0, around.width - 1),
                      std::clamp(eye.y.tile(), 0, around.depth - 1), eye.z - kStandingEye);
}

}  // namespace slicecast
