// A map: a grid of width x depth tiles with stacked levels, and its surroundings (floor, ceiling,
// sky, light, fog).
//
//        x ->                       level n lies between heights n and n + 1;
//      +---+---+---+                cell (x, y, n) is empty or a block from a blueprint
//   y  |0,0|1,0|2,0|  north
//   |  +---+---+---+
//   v  |0,1|1,1|2,1|  south
//      +---+---+---+
#pragma once

#include "base/coordinate.h"
#include "slicecast/colour.h"
#include "world/baked_light.h"
#include "world/blueprint.h"
#include "world/limits.h"
#include "world/object.h"
#include "world/sky.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace slicecast {

// The plane at height 0. It is endless: one `texture` outside the grid, a texture per tile inside.
struct Floor {
    TextureId texture = kNoTexture;
    std::vector<TextureId> tiles;  // [y * width + x]
    double light = 1.0;            // factor on the map's light, 0 to 1
    bool glow = false;             // see FaceBlueprint
    std::uint8_t mirror = 0;       // see FaceBlueprint
    std::uint8_t ripples = 0;
    TextureId water = kNoTexture;  // tiles with this texture are water, in which bodies wade
};

// A plane above some or all tiles of the grid, seen from both sides.
struct Ceiling {
    Coordinate height;  // units, > 0
    std::vector<TextureId>
        tiles;  // [y * width + x], kNoTexture where there is no ceiling; empty if the map has none
    double light = 1.0;
    bool glow = false;
};

// Brightness at depth t is clamp(intensity * multiplier / t, darkest, brightest), or 1 if the light
// is off, times the face's own factor.
struct Light {
    bool on = true;
    double intensity = 1.5;
    double multiplier = 5.0;  // units
    double darkest = 0.1;
    double brightest = 1.0;
};

// Blends towards the haze colour from depth `start` on, completely at depth `end`.
struct Fog {
    bool on = false;
    double start = 0.0;  // units
    double end = 1.0;    // units, > start
};

// A sign of the scene's rows (scene/source_text.h), and its blueprint.
struct LegendEntry {
    std::string sign;  // UTF-8
    BlueprintId blueprint = kEmptyCell;
};

// A number that no other state of a map has had: what is worked out from a map's blocks is valid
// while it stays the same. A copy of a map keeps it.
std::uint64_t nextEdition();

struct Map {
    std::string name;
    std::uint64_t edition = nextEdition();  // of cells, floor and ceiling; setCell() changes it
    int width = 0;                          // tiles eastward
    int depth = 0;                          // tiles southward
    int levels = 0;                         // stacked levels
    std::vector<BlueprintId> cells;         // [(y * width + x) * levels + level]
    std::vector<LegendEntry> legend;        // as in the scene, with the blueprints of its text
    std::vector<Object> objects;            // at equal depth the order decides
    std::vector<std::uint32_t> occupied;    // [y * width + x]: bit n is set if level n has a block
    std::vector<std::uint32_t> changing;    // [y * width + x]: bit n is set if level n may hold a
                                          // part of a mover or a gate; empty if the map has neither
    std::vector<PortalId> tilePortals;   // [y * width + x], kNoPortal for none; may be empty
    std::vector<std::uint8_t> openLand;  // [y * width + x]: see findOpenLand; may be empty
    Floor floor;
    Ceiling ceiling;
    Sky sky;
    Light light;
    Fog fog;
    BakedLight baked;
    Colour haze = {150, 160, 170, 255};  // of the fog, and of the floor beyond `far`
    double far = kDefaultFar;            // units

    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < depth; }
    std::size_t tileIndex(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    std::size_t cellIndex(int x, int y, int level) const {
        return tileIndex(x, y) * static_cast<std::size_t>(levels) + static_cast<std::size_t>(level);
    }

    bool isOccupied(int x, int y, int level) const {
        return contains(x, y) && level >= 0 && level < levels &&
               (occupied[tileIndex(x, y)] >> level & 1u) != 0;
    }
    // The blueprint of a cell; empty if it holds no block at present, and outside the grid and the
    // levels.
    BlueprintId cell(int x, int y, int level) const {
        return isOccupied(x, y, level) ? cells[cellIndex(x, y, level)] : kEmptyCell;
    }
    bool isWaterFloor(std::size_t tile) const {
        return floor.water != kNoTexture && floor.tiles[tile] == floor.water;
    }
    PortalId tilePortal(int x, int y) const {
        return tilePortals.empty() || !contains(x, y) ? kNoPortal : tilePortals[tileIndex(x, y)];
    }
    void setCell(int x, int y, int level, BlueprintId blueprint);
    // The same for a part of a mover or a gate.
    void setChangingCell(int x, int y, int level, BlueprintId blueprint);

    // Finds for each tile how much open land surrounds it: all tiles of the grid less than this
    // many tiles away, in x and in y, never hold a block, and have the floor's own texture, no
    // ceiling and no portal. At most 255. Speeds up views over wide land. Call it again after any
    // of that has changed; setCell() clears it.
    void findOpenLand();
};

// A map of empty cells with one floor texture.
Map makeMap(std::string name, int width, int depth, int levels, TextureId floorTexture);

}  // namespace slicecast
