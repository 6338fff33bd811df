#include "scene/rooms.h"

#include "world/collision.h"
#include "world/player.h"

#include <algorithm>
#include <bit>

namespace slicecast {
namespace {

constexpr Coordinate kHalf = toCoordinate(0.5);

std::uint32_t bitsFrom(int first, int last) {
    return ~0u << first & ~0u >> (kMaxLevels - 1 - last);
}

// The levels of a tile with room. One without a block has it: a ceiling leaves room above or below.
std::uint32_t levelsWithRoom(const World& world, int map, int x, int y) {
    const Map& grid = world.maps[static_cast<std::size_t>(map)];
    const std::uint32_t occupied = grid.occupied[grid.tileIndex(x, y)];
    std::uint32_t found = ~occupied & bitsFrom(0, grid.levels - 1);
    for (std::uint32_t rest = occupied; rest != 0; rest &= rest - 1) {
        const int level = std::countr_zero(rest);
        for (const Coordinate feet : {tileEdge(level), tileEdge(level) + kHalf}) {
            if (isFree(world, map,
                       bodyBox(tileEdge(x) + kHalf, tileEdge(y) + kHalf, feet, kCrouchedHeight)))
                found |= 1u << level;
        }
    }
    return found;
}

}  // namespace

Rooms::Layers Rooms::layersOf(const World& world, int map) {
    const Map& grid = world.maps[static_cast<std::size_t>(map)];
    Layers layers(1);
    layers[0] = {grid.width, grid.depth, {}};
    for (int y = 0; y < grid.depth; ++y)
        for (int x = 0; x < grid.width; ++x)
            layers[0].levels.push_back(levelsWithRoom(world, map, x, y));
    while (layers.back().levels.size() > 1) {
        const Layer& fine = layers.back();
        Layer coarse = {(fine.width + 1) / 2, (fine.depth + 1) / 2, {}};
        coarse.levels.resize(static_cast<std::size_t>(coarse.width * coarse.depth));
        for (int y = 0; y < fine.depth; ++y)
            for (int x = 0; x < fine.width; ++x)
                coarse.levels[static_cast<std::size_t>(y / 2 * coarse.width + x / 2)] |=
                    fine.levels[static_cast<std::size_t>(y * fine.width + x)];
        layers.push_back(std::move(coarse));
    }
    return layers;
}

// Looks at the places of a layer that the area touches in part, and no further into those that it
// covers: these have room if their layer says so.
bool Rooms::any(const Layers& layers, std::size_t layer, int x, int y, const Box& area,
                std::uint32_t levels) {
    const Layer& at = layers[layer];
    if (x >= at.width || y >= at.depth) return false;
    const int west = x << layer;
    const int north = y << layer;
    const int east = std::min((x + 1) << layer, layers[0].width);
    const int south = std::min((y + 1) << layer, layers[0].depth);
    if (area.west >= tileEdge(east) || area.east <= tileEdge(west) ||
        area.north >= tileEdge(south) || area.south <= tileEdge(north) ||
        (at.levels[static_cast<std::size_t>(y * at.width + x)] & levels) == 0)
        return false;
    if (area.west <= tileEdge(west) && area.east >= tileEdge(east) &&
        area.north <= tileEdge(north) && area.south >= tileEdge(south))
        return true;
    for (const int down : {0, 1}) {
        for (const int right : {0, 1}) {
            if (any(layers, layer - 1, 2 * x + right, 2 * y + down, area, levels)) return true;
        }
    }
    return false;
}

bool Rooms::hasRoomIn(const World& world, int map, const Box& area) {
    const Map& grid = world.maps[static_cast<std::size_t>(map)];
    const int lowest = area.bottom.tile();
    if (lowest >= grid.levels) return true;  // above all blocks
    const int highest = std::clamp(Coordinate{area.top.raw - 1}.tile(), lowest, grid.levels - 1);
    if (maps_.empty()) maps_.resize(world.maps.size());
    Layers& layers = maps_[static_cast<std::size_t>(map)];
    if (layers.empty()) layers = layersOf(world, map);
    return any(layers, layers.size() - 1, 0, 0, area, bitsFrom(lowest, highest));
}

}  // namespace slicecast
