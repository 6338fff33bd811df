#include "overlay/minimap_tiles.h"

#include "overlay/blend.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {
namespace {

constexpr Colour kLowBlock = {122, 66, 46, 255};
constexpr Colour kHighBlock = {226, 142, 92, 255};
constexpr Colour kWholeBlock = {112, 142, 182, 255};
constexpr double kFloatingShade = 0.5;  // part of a floating block's colour, over the ground's
constexpr Colour kNearGround = {104, 110, 108, 255};
constexpr Colour kDeepGround = {34, 38, 46, 255};
// Part of the way to the darkest, for ground just below the level.
constexpr double kLeastShade = 0.25;
constexpr double kDeepestShade = 5.0;  // units below the level at which the ground is darkest
// For all water: the colour seen under water may be grey or dark.
constexpr Colour kMinimapWater = {24, 108, 156, 255};
constexpr double kWaterShade = 0.75;  // part of water's colour, over the ground's
constexpr double kPortalTint = 0.5;   // part of the portal colour on a portal tile

Colour mixed(Colour a, Colour b, double part) {
    const auto mix = [part](int from, int to) {
        return static_cast<std::uint8_t>(
            from + static_cast<int>((to - from) * part + (to < from ? -0.5 : 0.5)));
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
}

// The level of the highest block of a tile below a level that fills the tile; -1 without one.
int levelBelow(const World& world, const Map& map, int x, int y, int level) {
    const auto isGround = [&](BlueprintId id) {
        return id != kEmptyCell && world.blueprints[id].plan.isWhole();
    };
    do --level;
    while (level >= 0 && !isGround(map.cell(x, y, level)));
    return level;
}

// The colour of a tile. `block` is the level's, or null; the ground is `drop` units below the
// level.
Colour colourOf(const CellBlueprint* block, double drop, bool isWater) {
    const Colour ground = minimapGround(drop);
    if (isWater) return mixed(ground, kMinimapWater, kWaterShade);
    if (block == nullptr) return ground;
    if (block->gate >= 0) return block->passable ? ground : kMinimapGate;
    const Slant& top = block->slopes.top;
    const double height =
        top.isLevel() ? block->top.value()
                      : std::clamp(top.valueAt(0.5), block->bottom.value(), block->top.value());
    const Colour colour = height == 1.0 ? kWholeBlock : mixed(kLowBlock, kHighBlock, height);
    return block->bottom.raw > 0 ? mixed(ground, colour, kFloatingShade) : colour;
}

}  // namespace

Colour minimapGround(double drop) {
    return mixed(
        kNearGround, kDeepGround,
        drop > 0.0 ? std::min(kLeastShade + (1.0 - kLeastShade) * drop / kDeepestShade, 1.0) : 0.0);
}

MinimapTile minimapTile(const World& world, const Map& map, int x, int y, int level) {
    MinimapTile tile;
    if (!map.contains(x, y)) return tile;
    const auto blockAt = [&](int at) {
        const BlueprintId id = at >= 0 ? map.cell(x, y, at) : kEmptyCell;
        return id != kEmptyCell ? &world.blueprints[id] : nullptr;
    };
    const int below = levelBelow(world, map, x, y, level);
    const CellBlueprint* const ground = blockAt(below);
    const CellBlueprint* const block = blockAt(level);
    const CellBlueprint* const seen = block != nullptr ? block : ground;
    if (ground != nullptr) tile.surface = tileEdge(below) + ground->top;
    tile.water = seen != nullptr ? seen->isWater : map.isWaterFloor(map.tileIndex(x, y));
    tile.over = (map.occupied[map.tileIndex(x, y)] >> level >> 1) != 0;
    const double drop = (tileEdge(level) - tile.surface).value();
    tile.colour = colourOf(block, drop, tile.water);
    bool leads = map.tilePortal(x, y) != kNoPortal;
    if (block != nullptr) {
        tile.openGate = block->gate >= 0 && block->passable;
        tile.block = !tile.openGate && !block->isWater;
        tile.moves = block->motion >= 0;
        if (!block->plan.isWhole()) {
            // At its borders the tile is marked as its ground is
            tile.plan = block->plan;
            tile.ground = minimapGround(drop);
            tile.ground.a = kMinimapTileAlpha;
            tile.block = false;
        }
        if (tile.block) tile.surface = tileEdge(level) + block->top;
        for (int i = 0; i < kFaces; ++i) {
            const auto face = static_cast<Face>(i);
            if (block->face(face).portal == kNoPortal) continue;
            if (face == Face::top || face == Face::bottom) {
                leads = true;
            } else {
                tile.portals |= 1u << i;
            }
        }
    }
    // Portal tiles, and portals in top and bottom faces, tint the tile
    if (leads) tile.colour = mixed(tile.colour, kMinimapPortal, kPortalTint);
    tile.colour.a = kMinimapTileAlpha;
    return tile;
}

}  // namespace slicecast
