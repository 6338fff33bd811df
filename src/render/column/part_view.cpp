#include "render/column/part_view.h"

#include <algorithm>
#include <bit>

namespace slicecast {
namespace {

// A walk that stops at a border must be past it by more than the rounding error.
constexpr double kBeyond = 1.0 + 1.0 / 1099511627776.0;

}  // namespace

void PartView::lookAt(const Part& part) {
    vista = part.vista;
    map = vista->map;
    projection = vista->projection;
    hasTilePortals = !map->tilePortals.empty();
    floorMirror = mirrorStrength(map->floor.mirror);
    eyeZ = vista->viewpoint.z;
    eyeHeight = Coordinate{eyeZ}.value();
    const int eyeLevel = std::min(eyeZ >> 16, kMaxLevels - 1);
    levelsToEye = eyeLevel < 0 ? 0 : static_cast<std::uint32_t>((std::uint64_t{2} << eyeLevel) - 1);
    floorRise = -eyeZ;
    ceilingRise = map->ceiling.height.raw - eyeZ;
    clip = part.clip;
    clipped = clip.any();
    lowest = clip.low / 65536.0 + eyeHeight;
    portals = part.portals;
    startX = part.walk.tileX;
    startY = part.walk.tileY;
    before = part.before;
    const bool ceilingMet =
        !clipped || (clip.isMirror ? ceilingRise > clip.low
                                   : ceilingRise >= clip.low && ceilingRise <= clip.high);
    ceilingTiles = map->ceiling.tiles.empty() || !ceilingMet ? nullptr : map->ceiling.tiles.data();
}

// Cuts a block to the heights of the part's rays; false if nothing remains.
bool PartView::cutToClip(Block& block) const {
    if (block.top <= clip.low || block.bottom >= clip.high) return false;
    if (block.blueprint->slopes.any()) {  // see firstRowsNotReflected
        block.cut =
            clip.isMirror && block.bottom == clip.low && block.blueprint->slopes.bottom.isLevel();
        return true;
    }
    block.cut = block.bottom < clip.low || block.top > clip.high ||
                (clip.isMirror && block.bottom == clip.low);
    block.bottom = std::max(block.bottom, clip.low);
    block.top = std::min(block.top, clip.high);
    return true;
}

// The levels with plans of a tile in the grid.
std::uint32_t PartView::levelsWithPlans(int x, int y) const {
    std::uint32_t found = 0;
    if (!frame.world->hasPlans) return found;
    for (std::uint32_t rest = map->occupied[map->tileIndex(x, y)]; rest != 0; rest &= rest - 1) {
        if (!blockAt(x, y, std::countr_zero(rest)).blueprint->plan.isWhole()) found |= rest & -rest;
    }
    return found;
}

// A mirror is opaque; but what mirrors show is seen from below.
std::uint32_t PartView::withoutLayers(int x, int y, std::uint32_t levels) const {
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1) {
        const CellBlueprint& block = *blockAt(x, y, std::countr_zero(rest)).blueprint;
        if (block.seeThrough && !block.hasPortals &&
            (clip.isMirror || block.face(Face::top).mirror == 0))
            levels ^= rest & -rest;
    }
    return levels;
}

// Beyond that the rows can meet only the present floor and the sky. If all open rows look down, it
// is where the flattest of them meets the floor; if all look up, where the flattest of them is
// above everything but portal tiles, which act at all heights.
double PartView::whereToStop(int first, int last) const {
    if (first >= last) return 0.0;
    const int firstFalling = projection->firstFallingRow;
    if (first >= firstFalling)
        return kBeyond * eyeHeight * vista->inverseOffsets[static_cast<std::size_t>(first)];
    if (last > firstFalling || hasTilePortals) return kNever;
    const double rise = vista->highest - eyeHeight;
    return rise <= 0.0 ? 0.0
                       : kBeyond * rise * vista->inverseOffsets[static_cast<std::size_t>(last - 1)];
}

Plane PartView::planeOf(const Block& block, Face face) const {
    const FaceBlueprint& look = block.blueprint->face(face);
    const bool isTop = face == Face::top;
    return {isTop ? block.top : block.bottom,
            look.texture,
            look.light,
            look.glow,
            !isTop,
            false,
            false,
            block.blueprint->textureEast,
            block.blueprint->textureSouth};
}

}  // namespace slicecast
