// The blocks of a tile: which faces a slice meets, and in which rows.
#include "base/bits.h"
#include "render/slice_walk.h"

#include <algorithm>
#include <bit>

namespace slicecast {

// Meets the blocks of one tile, nearest first: for each block the side that the walk enters, then
// its roof or underside, first from the eye's height downwards, then upwards. The floor comes last,
// with its run.
void SliceWalk::meetBlocks(std::uint32_t reached, TextureId ceilingTexture) {
    report_.blocksMet += std::popcount(reached);
    const std::uint32_t falling = reached & levelsToEye_;
    const std::uint32_t rising = reached & ~(levelsToEye_ >> 1);
    if (falling != 0 || ceilingTexture != kNoTexture) meetFalling(falling, ceilingTexture);
    if (rising != 0 || ceilingTexture != kNoTexture) meetRising(rising, ceilingTexture);
}

// For rays inside a block: they leave it downwards or through the far side. Returns the level of
// the block below if that is a part of the same mover: then it has no roof, and rays enter it from
// inside.
int SliceWalk::leaveDownwards(const Block& block, int edgeRow) {
    const int falling = projection_->firstFallingRow;
    const int below = rowBelow(block.bottom, leave_);
    leaveBottom(block, std::max(below, falling), edgeRow);
    leaveSide(block, std::max(rowBelow(block.top, leave_), falling), below);
    return insideOf(block, -1);
}

// Meets blocks that are not entirely above the eye, downwards. At depth 0 the eye may be inside a
// block, or on its roof. A face at depth 0 is not drawn: the ray counts as inside the block, and
// leaves it downwards or through the far side.
void SliceWalk::meetFalling(std::uint32_t levels, TextureId ceilingTexture) {
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise_ < 0;
    const auto ceilingAbove = [&](std::int32_t height) {
        if (ceilingToCome && ceilingRise_ > height) {
            takeCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    // The lower edge of the block above; if it is this block's upper edge and that block is opaque,
    // nothing sees this roof
    std::int32_t edge = kHighest;
    int edgeRow = 0;
    bool opaqueAbove = false;
    int inside = kNoLevel;  // see leaveDownwards
    for (std::uint32_t rest = levels; rest != 0;) {
        const int level = static_cast<int>(std::bit_width(rest)) - 1;
        rest ^= std::uint32_t{1} << level;
        Block block = blockAt(walk_.tileX, walk_.tileY, level);
        if ((clipped_ && !cutToClip(block)) || block.bottom > 0) continue;
        const bool atEye = isAtEye(level);
        block.cut |= level == inside;
        if (block.blueprint->slopes.any()) {
            ceilingAbove(block.top);
            const MetSlopes met = enterSlopes(block);
            ceilingAbove(block.top - 1);
            passSlopes(block, met);
            inside = insideOf(block, -1);
            edge = kHighest;
            continue;
        }
        const int topRow = block.top == edge ? edgeRow : rowBelow(block.top, enter_);
        const bool covered = block.top == edge && opaqueAbove;
        edge = block.bottom;
        edgeRow = rowBelow(block.bottom, enter_);
        const bool isPlain =
            !(block.blueprint->seeThrough | block.blueprint->hasPortals | block.cut);
        opaqueAbove = isPlain;
        if (!isPlain) {
            enterSide(block, topRow, edgeRow);
            ceilingAbove(block.top);
            if (!block.cut && !covered && block.top < 0)
                enterTop(block, rowBelow(block.top, leave_), topRow);
            // An eye exactly on a portal looks through it at once
            if (block.top == 0 && !walk_.hasEntered() && actsAtTop(block))
                enterTop(block, projection_->firstFallingRow, projection_->height);
            if (block.bottom < 0 &&
                (block.blueprint->seeThrough || block.cut || (atEye && block.top >= 0))) {
                ceilingAbove(block.bottom);
                inside = leaveDownwards(block, edgeRow);
            }
            continue;
        }
        if (!atEye && entersAt(level) && open_.mayHold(topRow, edgeRow))
            takeEnteredSide(block, topRow, edgeRow);
        if (block.top < 0) {
            ceilingAbove(block.top);
            if (!covered && topRow > open_.first())
                takeRoof(block, rowBelow(block.top, leave_), topRow);
        } else if (atEye && block.bottom < 0) {
            ceilingAbove(block.bottom);
            inside = leaveDownwards(block, edgeRow);
        }
    }
    ceilingAbove(-kHighest);
}

// Meets blocks that are not entirely below the eye, upwards. The side of a block at the eye's
// height is drawn with those below.
void SliceWalk::meetRising(std::uint32_t levels, TextureId ceilingTexture) {
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise_ > 0;
    const auto ceilingBelow = [&](std::int32_t height) {
        if (ceilingToCome && ceilingRise_ < height) {
            takeCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    std::int32_t edge = -kHighest;
    int edgeRow = 0;
    bool opaqueBelow = false;
    int inside = kNoLevel;  // as in meetFalling
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1) {
        const int level = std::countr_zero(rest);
        Block block = blockAt(walk_.tileX, walk_.tileY, level);
        if (clipped_ && !cutToClip(block)) continue;
        const bool atEye = isAtEye(level);
        block.cut |= level == inside;
        if (block.blueprint->slopes.any()) {
            if (block.bottom > 0) {  // else it was met as falling
                ceilingBelow(block.bottom);
                const MetSlopes met = enterSlopes(block);
                ceilingBelow(block.bottom + 1);
                passSlopes(block, met);
            }
            inside = insideOf(block, 1);
            edge = -kHighest;
            continue;
        }
        const bool isPlain =
            !(block.blueprint->seeThrough | block.blueprint->hasPortals | block.cut);
        if (block.bottom > 0) {
            const int bottomRow = block.bottom == edge ? edgeRow : rowBelow(block.bottom, enter_);
            const bool covered = block.bottom == edge && opaqueBelow;
            edge = block.top;
            edgeRow = rowBelow(block.top, enter_);
            opaqueBelow = isPlain;
            if (!isPlain) {
                enterSide(block, edgeRow, bottomRow);
                ceilingBelow(block.bottom);
                if (!block.cut && !covered)
                    enterBottom(block, bottomRow, rowBelow(block.bottom, leave_));
                if (block.blueprint->seeThrough || block.cut) {
                    ceilingBelow(block.top);
                    const int below = rowBelow(block.top, leave_);
                    leaveTop(block, edgeRow, below);
                    leaveSide(block, below, rowBelow(block.bottom, leave_));
                    inside = insideOf(block, 1);
                }
                continue;
            }
            if (!atEye && entersAt(level) && open_.mayHold(edgeRow, bottomRow))
                takeEnteredSide(block, edgeRow, bottomRow);
            ceilingBelow(block.bottom);
            if (!covered && bottomRow < open_.last())
                takeUnderside(block, bottomRow, rowBelow(block.bottom, leave_));
        } else if (block.top > 0 && (block.blueprint->seeThrough || atEye)) {
            edge = block.top;
            edgeRow = rowBelow(block.top, enter_);
            opaqueBelow = false;
            ceilingBelow(block.top);
            const int below = rowBelow(block.top, leave_);
            leaveTop(block, edgeRow, std::min(below, projection_->firstFallingRow));
            leaveSide(block, below,
                      std::min(rowBelow(block.bottom, leave_), projection_->firstFallingRow));
            inside = insideOf(block, 1);
        }
    }
    ceilingBelow(kHighest);
}

Plane SliceWalk::planeOf(const Block& block, Face face) const {
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

void SliceWalk::takeRoof(const Block& block, int firstRow, int lastRow, bool fromInside) {
    const FaceBlueprint& look = block.blueprint->face(Face::top);
    const int strength = fromInside ? 0 : mirrorStrength(look.mirror);
    Plane plane = planeOf(block, Face::top);
    plane.mirror = strength > 0;
    for (const auto& [first, last] : open_.take(firstRow, lastRow)) {
        if (strength > 0) mirror(block.top, first, last, strength, look.ripples);
        addFace(What::roof, lookOf(plane), first, last, here_, block.level);
    }
}

void SliceWalk::takeUnderside(const Block& block, int firstRow, int lastRow) {
    for (const auto& [first, last] : open_.take(firstRow, lastRow))
        addFace(What::underside, lookOf(planeOf(block, Face::bottom)), first, last, here_,
                block.level);
}

// A roof or an underside. In a picture, rows that touch those of the last span are one run with it;
// a trace tells each tile.
void SliceWalk::addFace(What what, PlaneLook& look, int first, int last, const TileRange& tiles,
                        int level) {
    const bool isRoof = what == What::roof;
    if (SpanList& spans = found_->spans; cuts_ && spans.count() > 0) {
        Span& before = spans[spans.count() - 1];
        if (before.what == what && !before.layer && before.look == &look && before.part == part_ &&
            before.level == level && (isRoof ? before.first == last : before.last == first)) {
            (isRoof ? before.first : before.last) = isRoof ? first : last;
            before.tiles.toX = tiles.toX;
            before.tiles.toY = tiles.toY;
            return;
        }
    }
    Span& span = addPlane(what, look, first, last, tiles);
    span.level = level;
    span.face = isRoof ? Face::top : Face::bottom;
}

void SliceWalk::takeCeilingHere(TextureId texture) {
    startCeiling(texture);
    endCeiling(Border::leave);
}

}  // namespace slicecast
