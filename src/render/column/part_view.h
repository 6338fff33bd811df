// What the columns of a strip that walk together have in common: the map that they see, from where,
// and between which heights. All numbers are in the coordinates of that map (see vista.h).
#pragma once

#include "render/spans/parts.h"
#include "render/spans/texel_cut.h"
#include "render/view/frame.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace slicecast {

// A height that no block reaches, 1/65536 units above the eye.
inline constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

// One of the two ends of the way through a tile, or through a stretch of it.
enum class Border : std::uint8_t { enter, leave };

// A block in a tile. Heights are in 1/65536 units, relative to the eye.
struct Block {
    const CellBlueprint* blueprint;
    int level;
    std::int32_t bottom;
    std::int32_t top;
    bool cut = false;  // by the part's height clip, or at a border of levels within a mover: no
                       // face at that end, and rays that start there are inside
};

struct PartView {
    // The frame must outlive this.
    PartView(const Frame& f, bool cutsTexels) : frame(f), cuts(cutsTexels) {}

    const Frame& frame;
    // Whether the texels of see-through sides and objects are examined: rows of holes are left out,
    // and opaque rows are closed, so that nothing behind them is found. Rows of roofs that touch
    // are one run, too. A trace takes all as they are.
    const bool cuts;

    Vista* vista = nullptr;
    const Map* map = nullptr;
    const Projection* projection = nullptr;
    std::int32_t eyeZ = 0;       // 1/65536 units; may be below the floor
    double eyeHeight = 0.0;      // the same in units
    std::int32_t floorRise = 0;  // 1/65536 units above the eye
    std::int32_t ceilingRise = 0;
    std::uint32_t levelsToEye = 0;  // a bit for each level that starts at or below the eye
    const TextureId* ceilingTiles = nullptr;  // null if no ceiling can be met
    int floorMirror = 0;                      // strength
    bool hasTilePortals = false;
    HeightClip clip;
    bool clipped = false;
    double lowest = 0.0;  // no ray runs lower, units
    int portals = 0;      // passed so far
    int startX = 0;       // the tile where the part starts
    int startY = 0;
    Before before;

    void lookAt(const Part& part);

    Block blockAt(int x, int y, int level) const {
        const BlueprintId id = map->cells[map->cellIndex(x, y, level)];
        const CellBlueprint& blueprint = frame.world->blueprints[id];
        const std::int32_t base = baseOf(level);
        return {&blueprint, level, base + blueprint.bottom.raw, base + blueprint.top.raw, false};
    }
    const CellBlueprint& blueprintAt(int x, int y, int level) const {
        return frame.world->blueprints[map->cell(x, y, level)];  // empty outside the grid
    }
    // Of a level, above the eye.
    std::int32_t baseOf(int level) const { return tileEdge(level).raw - eyeZ; }
    bool cutToClip(Block& block) const;
    std::uint32_t levelsWithPlans(int x, int y) const;
    // Of some levels of a tile in the grid, those whose blocks still add to a column with
    // kMaxLayers.
    std::uint32_t withoutLayers(int x, int y, std::uint32_t levels) const;

    // How far along the ray to walk while the rows [first, last) are open; infinite for ever.
    double whereToStop(int first, int last) const;

    // Whether a portal acts on rays of this part. With `atExit` it does not: it is where they have
    // just come out of another one, as the exit tile's portal or a face in the same plane.
    // Otherwise rays could circle for ever.
    bool acts(PortalId portal, bool atExit) const {
        return portal != kNoPortal && portals < frame.world->portalLimit && !atExit;
    }
    bool isArrival(int x, int y) const { return portals > 0 && x == startX && y == startY; }

    Plane planeOf(const Block& block, Face face) const;
    PlaneLook& lookOf(const Plane& plane) const {
        return vista->planeLooks.find(plane, frame.textures[plane.texture], frame.detail);
    }
    // Faces of water may be missing.
    bool isThere(const Block& block, Face face) const {
        const TextureId texture = block.blueprint->face(face).texture;
        return texture != kNoTexture && !(cuts && frame.textures[texture].invisible);
    }
    int mirrorStrength(std::uint8_t strength) const {
        return strength == 0
                   ? 0
                   : static_cast<int>(std::min(255.0, std::floor(strength * frame.mirrors + 0.5)));
    }
    CutMargin cutMargin() const { return {frame.rippleRows, projection->firstFallingRow}; }
};

}  // namespace slicecast
