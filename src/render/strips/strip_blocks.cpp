// The blocks of a tile: which faces the columns that pass it meet, and in which rows. Nearest
// first: for each block the side that they enter, then its roof or underside, first from the eye's
// height downwards, then upwards. The floor comes last, with its run.
//
//      rows
//       |    .--------.  back
//       |   /  roof  /|
//       |  .--------. |
//       |  |  side  | '
//       v  '--------'  front
//
// The side of a block fills the rows between its top and bottom edge where columns enter the tile.
// Its roof fills those up to where the top edge appears at the tile's far border; the underside is
// alike. At depth 0 the eye may be inside a block, or on its roof. A face at depth 0 is not drawn:
// the rays count as inside the block, and leave it again through another face.
#include "render/strips/strip_meet.h"

#include <array>
#include <bit>
#include <cstddef>

namespace slicecast {
namespace {

// The blocks of a stretch, from below.
struct Blocks {
    Blocks(const StripTile& tile, std::uint32_t levels) {
        const PartView& view = tile.view;
        for (; levels != 0; levels &= levels - 1) {
            const Block block = view.blockAt(tile.tileX(), tile.tileY(), std::countr_zero(levels));
            list[count] = block;
            if (!view.clipped || view.cutToClip(list[count])) ++count;
        }
    }

    std::array<Block, kMaxLevels> list;
    std::size_t count = 0;
};

bool isOpaque(const Block& block) {
    return !(block.blueprint->seeThrough | block.blueprint->hasPortals | block.cut);
}

// The level of the next block if rays go on inside it, else kNoLevel.
int insideOf(const StripTile& tile, const Block& block, int up) {
    return !block.blueprint->seeThrough && goesOn(tile, block, up) ? block.level + up : kNoLevel;
}

// For rays inside a block: they leave it downwards or through the far side. Returns the level of
// the block below if that is a part of the same mover: then it has no roof, and rays enter it from
// inside.
int leaveDownwards(StripTile& tile, const Block& block, Lanes edgeRows) {
    const Lanes horizon = inAllLanes(tile.view.projection->firstFallingRow);
    const Lanes below = tile.rowsBelow(block.bottom, Border::leave);
    leavePlane(tile, block, Face::bottom, greater(below, horizon), edgeRows);
    leaveSide(tile, block, greater(tile.rowsBelow(block.top, Border::leave), horizon), below);
    return insideOf(tile, block, -1);
}

// Meets blocks that are not entirely above the eye, downwards.
void meetFalling(StripTile& tile, const Blocks& blocks, TextureId ceiling) {
    const PartView& view = tile.view;
    bool ceilingToCome = ceiling != kNoTexture && view.ceilingRise < 0;
    const auto ceilingAbove = [&](std::int32_t height) {
        if (ceilingToCome && view.ceilingRise > height) {
            takeCeilingHere(tile, ceiling);
            ceilingToCome = false;
        }
    };
    // The lower edge of the block above; if it is this block's upper edge and that block is opaque,
    // nothing sees this roof
    std::int32_t edge = kHighest;
    Lanes edgeRows = tile.mask;
    bool opaqueAbove = false;
    int inside = kNoLevel;  // see leaveDownwards
    for (std::size_t n = blocks.count; n-- > 0;) {
        Block block = blocks.list[n];
        if (!(view.levelsToEye >> block.level & 1) || block.bottom > 0) continue;
        const bool atEye = tile.isAtEye(block.level);
        block.cut |= block.level == inside;
        if (block.blueprint->slopes.any()) {
            ceilingAbove(block.top);
            const MetSlopes met = enterSlopes(tile, block);
            ceilingAbove(block.top - 1);
            passSlopes(tile, block, met);
            inside = insideOf(tile, block, -1);
            edge = kHighest;
            continue;
        }
        const Lanes top = block.top == edge ? edgeRows : tile.rowsBelow(block.top, Border::enter);
        const bool covered = block.top == edge && opaqueAbove;
        edge = block.bottom;
        edgeRows = tile.rowsBelow(edge, Border::enter);
        opaqueAbove = isOpaque(block);
        if (!opaqueAbove || !atEye) enterSide(tile, block, top, edgeRows);
        if (block.top < 0) {
            ceilingAbove(block.top);
            if (!covered && !block.cut && bitsOf(tile.mask & tile.open.reachAbove(top)) != 0)
                enterTop(tile, block, tile.rowsBelow(block.top, Border::leave), top);
        }
        // An eye exactly on a portal looks through it at once
        if (block.top == 0 && tile.isFirst && actsAtTop(tile, block))
            enterTop(tile, block, inAllLanes(view.projection->firstFallingRow),
                     inAllLanes(view.projection->height));
        if (block.bottom < 0 &&
            (block.blueprint->seeThrough || block.cut || (atEye && block.top >= 0))) {
            ceilingAbove(block.bottom);
            inside = leaveDownwards(tile, block, edgeRows);
        }
    }
    ceilingAbove(-kHighest);
}

// Meets blocks that are not entirely below the eye, upwards. The side of a block at the eye's
// height is drawn with those below.
void meetRising(StripTile& tile, const Blocks& blocks, TextureId ceiling) {
    const PartView& view = tile.view;
    bool ceilingToCome = ceiling != kNoTexture && view.ceilingRise > 0;
    const auto ceilingBelow = [&](std::int32_t height) {
        if (ceilingToCome && view.ceilingRise < height) {
            takeCeilingHere(tile, ceiling);
            ceilingToCome = false;
        }
    };
    std::int32_t edge = -kHighest;
    Lanes edgeRows = tile.mask;
    bool opaqueBelow = false;
    int inside = kNoLevel;  // as in meetFalling
    for (std::size_t n = 0; n < blocks.count; ++n) {
        Block block = blocks.list[n];
        if (view.levelsToEye >> 1 >> block.level & 1) continue;
        const bool atEye = tile.isAtEye(block.level);
        const bool isAbove = block.bottom > 0;
        block.cut |= block.level == inside;
        if (block.blueprint->slopes.any()) {
            if (isAbove) {  // else it was met as falling
                ceilingBelow(block.bottom);
                const MetSlopes met = enterSlopes(tile, block);
                ceilingBelow(block.bottom + 1);
                passSlopes(tile, block, met);
            }
            inside = insideOf(tile, block, 1);
            edge = -kHighest;
            continue;
        }
        const bool covered = block.bottom == edge && opaqueBelow;
        if (isAbove) {
            const Lanes bottom =
                block.bottom == edge ? edgeRows : tile.rowsBelow(block.bottom, Border::enter);
            edge = block.top;
            edgeRows = tile.rowsBelow(edge, Border::enter);
            opaqueBelow = isOpaque(block);
            if (!opaqueBelow || !atEye) enterSide(tile, block, edgeRows, bottom);
            ceilingBelow(block.bottom);
            if (!covered && !block.cut && bitsOf(tile.mask & tile.open.reachBelow(bottom)) != 0)
                enterBottom(tile, block, bottom, tile.rowsBelow(block.bottom, Border::leave));
            if (!block.blueprint->seeThrough && !block.cut) continue;
        } else {
            if (block.top <= 0 || !(block.blueprint->seeThrough || atEye)) continue;
            edge = block.top;
            edgeRows = tile.rowsBelow(edge, Border::enter);
            opaqueBelow = false;
        }
        ceilingBelow(block.top);
        // A block at the eye's height shows what is below the horizon with those below
        const Lanes end =
            inAllLanes(isAbove ? view.projection->height : view.projection->firstFallingRow);
        const Lanes below = tile.rowsBelow(block.top, Border::leave);
        leavePlane(tile, block, Face::top, edgeRows, lesser(below, end));
        leaveSide(tile, block, below, lesser(tile.rowsBelow(block.bottom, Border::leave), end));
        inside = insideOf(tile, block, 1);
    }
    ceilingBelow(kHighest);
}

}  // namespace

void meetStretch(StripTile& tile, std::uint32_t levels, TextureId floor, TextureId ceiling) {
    const Blocks blocks(tile, levels);
    const bool any = blocks.count > 0;
    changeCover(tile, floor, any ? kNoTexture : ceiling);
    if (any) {
        tile.report.blocksMet +=
            static_cast<std::int64_t>(blocks.count) * std::popcount(bitsOf(tile.mask));
        // The floor before the tile; it closes the rows below those of blocks on the floor
        takeFloor(tile, tile.mask, Border::enter);
        meetFalling(tile, blocks, ceiling);
        meetRising(tile, blocks, ceiling);
    }
    // An object or an edge follows: close everything before it, the ceiling before the floor
    const bool isTileEnd = tile.stretch.leaves == End::border;
    if (!isTileEnd) endCeiling(tile, tile.mask, Border::leave);
    if (any || !isTileEnd) takeFloor(tile, tile.mask, Border::leave);
}

}  // namespace slicecast
