// The blocks of a tile: which of their faces a slice meets, in which rows, and which texels those
// show.
#include "base/bits.h"
#include "render/slice_walk.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace slicecast {
namespace {

constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

// A point that lies on the border of two texels exactly may come out a rounding before it:
// positions are moved by this much of a tile, far less than a pixel and far more than a rounding.
constexpr double kSnap = 1.0 / 17179869184.0;

constexpr std::uint64_t kWholeTexture = std::uint64_t{1} << kTexturePositionBits;

}  // namespace

SliceWalk::Block SliceWalk::blockAt(int x, int y, int level) const {
    const BlueprintId id = map_->cells[map_->cellIndex(x, y, level)];
    const CellBlueprint& blueprint = frame_.world->blueprints[id];
    const std::int32_t base = tileEdge(level).raw - eyeZ_;
    return {&blueprint, level, base + blueprint.bottom.raw, base + blueprint.top.raw, false};
}

// Everything in one tile that holds blocks, nearest first: for each block its side where the walk
// enters, then its roof or underside, from the eye's height downwards and then from it upwards. The
// floor comes last, with the run that it belongs to.
void SliceWalk::meetBlocks(std::uint32_t reached, TextureId ceilingTexture) {
    report_.blocksMet += std::popcount(reached);
    const std::uint32_t falling = reached & levelsToEye_;
    const std::uint32_t rising = reached & ~(levelsToEye_ >> 1);
    if (falling != 0 || ceilingTexture != kNoTexture) meetFalling(falling, ceilingTexture);
    if (rising != 0 || ceilingTexture != kNoTexture) meetRising(rising, ceilingTexture);
}

// A block that rays are in: they leave it downwards or through the far side. True if the block
// below is a part of the same mover: then it has no roof, and rays enter it from inside.
bool SliceWalk::leaveDownwards(const Block& block, int edgeRow) {
    const int falling = projection_->firstFallingRow;
    const int below = rowBelow(block.bottom, leave_);
    leaveBottom(block, std::max(below, falling), edgeRow);
    leaveSide(block, std::max(rowBelow(block.top, leave_), falling), below);
    return !block.blueprint->seeThrough && goesOn(block, -1);
}

// Blocks that are not wholly above the eye, downwards. At depth 0 the eye may be inside a block, or
// on its roof: a face met at depth 0 is not drawn, so the ray is inside the block then and leaves
// it downwards or through the far side.
void SliceWalk::meetFalling(std::uint32_t levels, TextureId ceilingTexture) {
    const bool atEye = walk_.entered == 0.0;
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise_ < 0;
    const auto ceilingAbove = [&](std::int32_t height) {
        if (ceilingToCome && ceilingRise_ > height) {
            takeCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    // The lower edge of the block above, which may be this one's upper edge: nothing reaches a roof
    // on which an opaque block stands.
    std::int32_t edge = kHighest;
    int edgeRow = 0;
    bool opaqueAbove = false;
    bool inside = false;  // see leaveDownwards
    for (std::uint32_t rest = levels; rest != 0;) {
        const int level = static_cast<int>(std::bit_width(rest)) - 1;
        rest ^= std::uint32_t{1} << level;
        Block block = blockAt(walk_.tileX, walk_.tileY, level);
        if ((clipped_ && !cutToClip(block)) || block.bottom > 0) continue;
        block.cut |= std::exchange(inside, false);
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
            // Whoever stands exactly on a portal falls in at once.
            if (block.top == 0 && !walk_.hasEntered() && actsAtTop(block))
                enterTop(block, projection_->firstFallingRow, projection_->height);
            if (block.bottom < 0 &&
                (block.blueprint->seeThrough || block.cut || (atEye && block.top >= 0))) {
                ceilingAbove(block.bottom);
                inside = leaveDownwards(block, edgeRow);
            }
            continue;
        }
        if (!atEye && enter_.border && open_.mayHold(topRow, edgeRow))
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

// Blocks that are not wholly below the eye, upwards. The side of one at the eye's height is drawn
// with those below.
void SliceWalk::meetRising(std::uint32_t levels, TextureId ceilingTexture) {
    const bool atEye = walk_.entered == 0.0;
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
    bool inside = false;  // as in meetFalling
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1) {
        Block block = blockAt(walk_.tileX, walk_.tileY, std::countr_zero(rest));
        if (clipped_ && !cutToClip(block)) continue;
        block.cut |= std::exchange(inside, false);
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
                    inside = !block.blueprint->seeThrough && goesOn(block, 1);
                }
                continue;
            }
            if (!atEye && enter_.border && open_.mayHold(edgeRow, bottomRow))
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
            inside = !block.blueprint->seeThrough && goesOn(block, 1);
        }
    }
    ceilingBelow(kHighest);
}

void SliceWalk::takeEnteredSide(const Block& block, int firstRow, int lastRow) {
    if (!enteredSideKnown_) {
        enteredSide_ = sideView(enter_);
        enteredSideKnown_ = true;
    }
    takeSide(block, enteredFace(enter_), enter_, enteredSide_, firstRow, lastRow);
}

// What the sides at one border have in common.
SliceWalk::SideView SliceWalk::sideView(const Crossing& border) const {
    // Along x on the northern and southern sides, along y on the others.
    const double fraction =
        border.alongX
            ? eyeFractionY_ + (eyeTileY_ - here_.fromY) + ray_.y * border.distance / border.speed
            : eyeFractionX_ + (eyeTileX_ - here_.fromX) + ray_.x * border.distance / border.speed;
    const double depth = border.along * projection_->distance;
    constexpr double kEnd = 4294967295.0;  // of 1 << 32
    return {
        static_cast<std::uint32_t>(std::min(kEnd, std::max(0.0, fraction + kSnap) * 4294967296.0)),
        depth, vista_->lighting.brightnessAt(depth), vista_->lighting.fogAt(depth)};
}

// Which texels the rows [first, last) of a side show, and in what light.
__attribute__((always_inline)) inline TexelColumn SliceWalk::sideColumn(const Block& block,
                                                                        Face face,
                                                                        const Crossing& border,
                                                                        const SideView& view,
                                                                        int first, int last) const {
    const FaceBlueprint& look = block.blueprint->face(face);
    const FrameTexture& texture = frame_.textures[look.texture];
    const int detail = frame_.detail.levelAt(view.depth, texture.size, texture.last);
    const TextureLevel& level = texture.levels[detail];
    const int column = static_cast<int>(std::uint64_t{view.fraction} >> (32 - level.bits));
    const int u = face == Face::north || face == Face::east ? level.size - 1 - column : column;

    // v runs from 0 at the level's upper edge to 1 at its lower edge; it stays within what the
    // block covers of the level. What has risen shows what is farther down.
    constexpr double kPositions = 281474976710656.0;  // 1 << kTexturePositionBits
    constexpr std::int64_t kPositionsPerRaw = std::int64_t{1} << (kTexturePositionBits - 16);
    const std::int64_t lowest = (65536 - block.blueprint->top.raw) * kPositionsPerRaw;
    const std::int64_t end = (65536 - block.blueprint->bottom.raw) * kPositionsPerRaw;
    const double perRow = border.along;
    const double upperEdge = Coordinate{tileEdge(block.level + 1).raw - eyeZ_}.value();
    const double v = upperEdge + (first + 0.5 - projection_->horizon) * perRow + kSnap;
    const std::int64_t start = std::clamp(v <= 0.0   ? 0
                                          : v >= 1.0 ? end
                                                     : nearestInteger(v * kPositions),
                                          lowest, end - 1);
    const int steps = last - first - 1;
    // A block of several rows is no higher than a tile, so a row's step is less.
    std::int64_t step = steps > 0 ? nearestInteger(std::min(perRow, 1.0) * kPositions) : 0;
    if (start + steps * step >= end) step = (end - 1 - start) / steps;
    const std::int64_t rise = block.blueprint->textureRise.raw * kPositionsPerRaw;
    return {.texels = level.texels.data() + (static_cast<std::size_t>(u) << level.bits),
            .start = static_cast<std::uint64_t>(start + rise),
            .step = static_cast<std::uint64_t>(step),
            .depth = view.depth,
            .factor = vista_->lighting.factorOf(look.glow ? kFullBrightness : view.brightness,
                                                look.light),
            .fog = view.fog,
            .shift = kTexturePositionBits - level.bits,
            .detail = detail};
}

void SliceWalk::takeSide(const Block& block, Face face, const Crossing& border,
                         const SideView& view, int firstRow, int lastRow) {
    open_.take(firstRow, lastRow, [&](int first, int last) {
        addSide(block, face, border, view, first, last, false);
    });
}

// The texture of what moves may come to its lower edge within a side, and begins anew there: then
// the side is two spans.
void SliceWalk::addSide(const Block& block, Face face, const Crossing& border, const SideView& view,
                        int first, int last, bool layer) {
    TexelColumn column = sideColumn(block, face, border, view, first, last);
    if (column.start >= kWholeTexture) column.start -= kWholeTexture;
    const auto steps = static_cast<std::uint64_t>(last - first - 1);
    if (column.start + steps * column.step >= kWholeTexture) {
        const std::uint64_t above = (kWholeTexture - column.start + column.step - 1) / column.step;
        const int turn = first + static_cast<int>(above);
        addSideSpan(block, face, column, first, turn, layer);
        column.start += above * column.step - kWholeTexture;
        first = turn;
    }
    addSideSpan(block, face, column, first, last, layer);
}

void SliceWalk::addSideSpan(const Block& block, Face face, const TexelColumn& column, int first,
                            int last, bool layer) {
    Span& span = add(What::side, first, last);
    span.face = face;
    span.layer = layer;
    span.level = block.level;
    span.tiles = here_;
    span.image = block.blueprint->face(face).texture;
    span.column = column;
}

Plane SliceWalk::planeOf(const Block& block, Face face) const {
    const FaceBlueprint& look = block.blueprint->face(face);
    const bool isTop = face == Face::top;
    return {isTop ? block.top : block.bottom, look.texture, look.light, look.glow, !isTop, false};
}

void SliceWalk::takeRoof(const Block& block, int firstRow, int lastRow, bool fromInside) {
    open_.take(firstRow, lastRow, [&](int first, int last) {
        const int strength =
            fromInside ? 0 : mirrorStrength(block.blueprint->face(Face::top).mirror);
        if (strength > 0) mirror(block.top, first, last, strength);
        Plane plane = planeOf(block, Face::top);
        plane.mirror = strength > 0;
        addPlane(What::roof, lookOf(plane), first, last, here_).level = block.level;
    });
}

void SliceWalk::takeUnderside(const Block& block, int firstRow, int lastRow) {
    open_.take(firstRow, lastRow, [&](int first, int last) {
        Span& span =
            addPlane(What::underside, lookOf(planeOf(block, Face::bottom)), first, last, here_);
        span.level = block.level;
        span.face = Face::bottom;
    });
}

void SliceWalk::takeCeilingHere(TextureId texture) {
    startCeiling(texture);
    endCeiling(Border::leave);
}

}  // namespace slicecast
