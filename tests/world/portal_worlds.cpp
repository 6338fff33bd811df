#include "portal_worlds.h"

#include <utility>
#include <vector>

namespace slicecast {
namespace {

PortalId addPortal(World& world, const Portal& portal) {
    world.portals.push_back(portal);
    return static_cast<PortalId>(world.portals.size() - 1);
}

Map& mapOf(World& world, const Portal& portal) {
    return world.maps[static_cast<std::size_t>(portal.fromMap)];
}

}  // namespace

void putTilePortal(World& world, const Portal& portal) {
    Map& map = mapOf(world, portal);
    if (map.tilePortals.empty()) map.tilePortals.assign(map.occupied.size(), kNoPortal);
    map.tilePortals[map.tileIndex(portal.fromX, portal.fromY)] = addPortal(world, portal);
}

void putFacePortal(World& world, const Portal& portal, int level, Face face) {
    Map& map = mapOf(world, portal);
    BlueprintId id = map.cell(portal.fromX, portal.fromY, level);
    if (!world.blueprints[id].hasPortals) {
        world.blueprints.push_back(world.blueprints[id]);
        id = static_cast<BlueprintId>(world.blueprints.size() - 1);
        world.blueprints[id].plan = {};  // a block with portals fills all of the tile
        world.blueprints[id].slopes = {};
        map.setCell(portal.fromX, portal.fromY, level, id);
    }
    world.blueprints[id].faces[static_cast<std::size_t>(face)].portal = addPortal(world, portal);
    world.blueprints[id].hasPortals = true;
}

Portal appendCopy(World& world, int mapIndex, int turn, int levels) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    // Where the corner (0, 0) of the map comes to lie.
    const int x0 = turn == 1 ? map.depth - 1 : turn == 2 ? map.width - 1 : 0;
    const int y0 = turn == 2 ? map.depth - 1 : turn == 3 ? map.width - 1 : 0;
    const Portal portal = {.fromMap = mapIndex,
                           .fromX = 0,
                           .fromY = 0,
                           .toMap = static_cast<int>(world.maps.size()),
                           .toX = x0,
                           .toY = y0,
                           .turn = turn,
                           .levels = levels};

    Map copy = makeMap("copy", turn % 2 == 0 ? map.width : map.depth,
                       turn % 2 == 0 ? map.depth : map.width, map.levels + levels, kNoTexture);
    CellBlueprint whole;
    whole.name = "ground";
    world.blueprints.push_back(whole);
    const auto ground = static_cast<BlueprintId>(world.blueprints.size() - 1);
    // What fills a part of its tile turns with it
    std::vector<BlueprintId> turnedIds(world.blueprints.size());
    for (std::size_t i = 0; i < turnedIds.size(); ++i) {
        turnedIds[i] = static_cast<BlueprintId>(i);
        CellBlueprint block = world.blueprints[i];
        if (turn == 0 || block.isBox()) continue;
        block.plan = turned(block.plan, turn);
        block.slopes = turned(block.slopes, turn);
        turnedIds[i] = static_cast<BlueprintId>(world.blueprints.size());
        world.blueprints.push_back(std::move(block));
    }
    copy.ceiling.height = map.ceiling.height + tileEdge(levels);
    if (!map.ceiling.tiles.empty()) copy.ceiling.tiles.assign(copy.occupied.size(), kNoTexture);
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const GridTile tile = carried(portal, GridTile{x, y});
            for (int level = 0; level < levels; ++level)
                copy.setCell(tile.x, tile.y, level, ground);
            for (int level = 0; level < map.levels; ++level) {
                if (const BlueprintId id = map.cell(x, y, level))
                    copy.setCell(tile.x, tile.y, level + levels, turnedIds[id]);
            }
            if (!map.ceiling.tiles.empty())
                copy.ceiling.tiles[copy.tileIndex(tile.x, tile.y)] =
                    map.ceiling.tiles[map.tileIndex(x, y)];
        }
    }
    world.maps.push_back(std::move(copy));
    return portal;
}

Portal portalAt(const Portal& portal, int x, int y) {
    const GridTile there = carried(portal, GridTile{x, y});
    Portal moved = portal;
    moved.fromX = x;
    moved.fromY = y;
    moved.toX = there.x;
    moved.toY = there.y;
    return moved;
}

}  // namespace slicecast
