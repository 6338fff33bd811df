// The blocks of a tile, for all columns of a strip that pass it: which faces they meet, and in
// which rows. See slice_blocks.cpp; here no column starts in the tile, so none begins inside a
// block.
#include "render/strip_walk.h"

#include <bit>

namespace slicecast {

// Finds the blocks of the current tile, from below; false if the columns cannot meet one of them
// together.
bool StripWalk::findBlocks(std::uint32_t reached) {
    const SliceWalk& any = this->any();
    blocks_ = 0;
    for (; reached != 0; reached &= reached - 1) {
        Block block = any.blockAt(tileX(v_), tileY(v_), std::countr_zero(reached));
        if (any.clipped_ && !any.cutToClip(block)) continue;
        const CellBlueprint& look = *block.blueprint;
        if (look.hasPortals || !look.plan.isWhole()) return false;
        if (look.slopes.any() && (look.seeThrough || look.mover >= 0 || block.cut)) return false;
        if (look.seeThrough && (look.mover >= 0 || !hasPlainNeighbours(block))) return false;
        block_[blocks_++] = block;
    }
    return true;
}

// Whether all neighbours of a see-through block are without portals, and those beside it without
// slopes: then a joined one hides a face as a whole, or up to a level edge.
bool StripWalk::hasPlainNeighbours(const Block& block) const {
    const int x = tileX(v_);
    const int y = tileY(v_);
    const auto isPlain = [&](int dx, int dy, int up) {
        const CellBlueprint& next =
            frame_.world->blueprints[map_->cell(x + dx, y + dy, block.level + up)];
        if (next.hasPortals || map_->tilePortal(x + dx, y + dy) != kNoPortal) return false;
        return up != 0 || next.isBox();
    };
    return isPlain(0, 0, 1) && isPlain(0, 0, -1) && isPlain(1, 0, 0) && isPlain(-1, 0, 0) &&
           isPlain(0, 1, 0) && isPlain(0, -1, 0);
}

void StripWalk::meet(unsigned bits, TextureId floor, TextureId ceiling) {
    mask_ = maskOf(bits);
    findPerRaw();
    changeCover(floor, blocks_ > 0 ? kNoTexture : ceiling);
    if (blocks_ == 0) return;
    report_.blocksMet += static_cast<std::int64_t>(blocks_) * std::popcount(bits);
    // The floor before the tile; it closes the rows below those of blocks on the floor
    takeFloor(mask_, Border::enter);
    meetFalling(ceiling);
    meetRising(ceiling);
    takeFloor(mask_, Border::leave);
}

void StripWalk::meetFalling(TextureId ceiling) {
    const SliceWalk& any = this->any();
    bool ceilingToCome = ceiling != kNoTexture && any.ceilingRise_ < 0;
    const auto ceilingAbove = [&](std::int32_t height) {
        if (ceilingToCome && any.ceilingRise_ > height) {
            takeCeilingHere(ceiling);
            ceilingToCome = false;
        }
    };
    const Lanes horizon = inAllLanes(projection_->firstFallingRow);
    std::int32_t edge = kHighest;
    Lanes edgeRows = mask_;
    bool opaqueAbove = false;
    for (std::size_t n = blocks_; n-- > 0;) {
        const Block& block = block_[n];
        if (!(any.levelsToEye_ >> block.level & 1) || block.bottom > 0) continue;
        const bool isOpaque = !block.blueprint->seeThrough;
        if (block.blueprint->slopes.any()) {
            ceilingAbove(block.top);
            const MetSlopes met = enterSlopes(block);
            ceilingAbove(block.top - 1);
            passSlopes(block, met);
            edge = kHighest;
            continue;
        }
        const Lanes top = block.top == edge ? edgeRows : rowsBelow(block.top, Border::enter);
        const bool covered = block.top == edge && opaqueAbove;
        edge = block.bottom;
        edgeRows = rowsBelow(edge, Border::enter);
        opaqueAbove = isOpaque;
        if (isOpaque) {
            takeSide(block, top, edgeRows);
        } else {
            seeSide(block, Border::enter, top, edgeRows);
        }
        ceilingAbove(block.top);
        if (block.top < 0 && !covered && !block.cut && bitsOf(mask_ & open_.reachAbove(top)) != 0)
            enterTop(block, rowsBelow(block.top, Border::leave), top);
        if (isOpaque || block.bottom >= 0) continue;
        ceilingAbove(block.bottom);
        const Lanes below = rowsBelow(block.bottom, Border::leave);
        seePlane(block, Face::bottom, greater(below, horizon), edgeRows);
        seeSide(block, Border::leave, greater(rowsBelow(block.top, Border::leave), horizon), below);
    }
    ceilingAbove(-kHighest);
}

void StripWalk::meetRising(TextureId ceiling) {
    const SliceWalk& any = this->any();
    bool ceilingToCome = ceiling != kNoTexture && any.ceilingRise_ > 0;
    const auto ceilingBelow = [&](std::int32_t height) {
        if (ceilingToCome && any.ceilingRise_ < height) {
            takeCeilingHere(ceiling);
            ceilingToCome = false;
        }
    };
    const Lanes horizon = inAllLanes(projection_->firstFallingRow);
    std::int32_t edge = -kHighest;
    Lanes edgeRows = mask_;
    bool opaqueBelow = false;
    for (std::size_t n = 0; n < blocks_; ++n) {
        const Block& block = block_[n];
        const bool isOpaque = !block.blueprint->seeThrough;
        const bool isAbove = block.bottom > 0;
        if (!isAbove && (isOpaque || block.top <= 0)) continue;
        if (block.blueprint->slopes.any()) {
            ceilingBelow(block.bottom);
            const MetSlopes met = enterSlopes(block);
            ceilingBelow(block.bottom + 1);
            passSlopes(block, met);
            edge = -kHighest;
            continue;
        }
        const bool covered = block.bottom == edge && opaqueBelow;
        Lanes bottom = mask_;
        if (isAbove)
            bottom = block.bottom == edge ? edgeRows : rowsBelow(block.bottom, Border::enter);
        edge = block.top;
        edgeRows = rowsBelow(edge, Border::enter);
        opaqueBelow = isOpaque;
        if (isAbove) {
            if (isOpaque) {
                takeSide(block, edgeRows, bottom);
            } else {
                seeSide(block, Border::enter, edgeRows, bottom);
            }
            ceilingBelow(block.bottom);
            if (!covered && !block.cut && bitsOf(mask_ & open_.reachBelow(bottom)) != 0)
                enterBottom(block, bottom, rowsBelow(block.bottom, Border::leave));
        }
        if (isOpaque) continue;
        ceilingBelow(block.top);
        // A block at the eye's height shows what is below the horizon with those below
        const Lanes end = isAbove ? inAllLanes(projection_->height) : horizon;
        const Lanes below = rowsBelow(block.top, Border::leave);
        seePlane(block, Face::top, edgeRows, lesser(below, end));
        seeSide(block, Border::leave, below, lesser(rowsBelow(block.bottom, Border::leave), end));
    }
    ceilingBelow(kHighest);
}

}  // namespace slicecast
