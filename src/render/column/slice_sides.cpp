// The sides of blocks: the texels that their rows show, and their light.
#include "base/bits.h"
#include "render/column/slice_column.h"
#include "render/spans/texel_cut.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr std::int64_t kPositionsPerRaw = std::int64_t{1} << (kTexturePositionBits - 16);

}  // namespace

BlockSide sideOf(const PartView& view, const Block& block, Face face, const TileRange& tile,
                 bool layer) {
    const CellBlueprint& blueprint = *block.blueprint;
    const FaceBlueprint& look = blueprint.face(face);
    const bool runsEast = face == Face::north || face == Face::south;
    const Coordinate from = runsEast ? blueprint.plan.west : blueprint.plan.north;
    const Coordinate to = runsEast ? blueprint.plan.east : blueprint.plan.south;
    return {.look = &look,
            .texture = &view.frame.textures[look.texture],
            .level = block.level,
            .face = face,
            .layer = layer,
            .reversed = face == Face::north || face == Face::east,
            .upperEdge = Coordinate{view.baseOf(block.level + 1)}.value(),
            .start = (65536 - blueprint.top.raw) * kPositionsPerRaw,
            .end = (65536 - blueprint.bottom.raw) * kPositionsPerRaw,
            .rise = blueprint.textureRise.raw * kPositionsPerRaw,
            .least = static_cast<std::uint32_t>(from.raw) << 16,
            .most = (static_cast<std::uint32_t>(to.raw) << 16) - 1,
            .slide = runsEast ? blueprint.textureEast : blueprint.textureSouth,
            .tile = tile};
}

// The texels that the rows [first, last) show.
inline TexelColumn SliceColumn::sideColumn(const BlockSide& side, const SideView& view, int first,
                                           int last) const {
    const FrameTexture& texture = *side.texture;
    // #region texel-column
    const int detail = view_.frame.detail.levelAt(view.depth, texture.size, texture.last);
    const TextureLevel& level = texture.levels[detail];
    const std::uint64_t fraction =
        std::uint32_t{side.shown(view) - (static_cast<std::uint32_t>(side.slide.raw) << 16)};
    const int column = static_cast<int>(fraction >> (32 - level.bits));
    const int u = side.reversed ? level.size - 1 - column : column;

    // v runs from 0 at the level's upper edge to 1 at its lower edge, clamped to the block. A risen
    // block shows its texture moved up
    constexpr double kPositions = 281474976710656.0;  // 1 << kTexturePositionBits
    const double v =
        side.upperEdge + (first + 0.5 - view_.projection->horizon) * view.along + kSideSnap;
    const std::int64_t start = std::clamp(v <= 0.0   ? 0
                                          : v >= 1.0 ? side.end
                                                     : nearestInteger(v * kPositions),
                                          side.start, side.end - 1);
    const int steps = last - first - 1;
    // A block of several rows is at most one tile high, so a row's step is less
    std::int64_t step = steps > 0 ? nearestInteger(std::min(view.along, 1.0) * kPositions) : 0;
    // #endregion
    if (start + steps * step >= side.end) step = (side.end - 1 - start) / steps;
    return {.texels = level.texels.data() + (static_cast<std::size_t>(u) << level.bits),
            .start = static_cast<std::uint64_t>(start + side.rise),
            .step = static_cast<std::uint64_t>(step),
            .depth = view.depth,
            .factor = view_.vista->lighting.factorOf(
                side.look->glow ? kFullBrightness : view.brightness, side.look->light),
            .fog = view.fog,
            .shift = kTexturePositionBits - level.bits,
            .detail = detail};
}

// The texture of a mover may reach its lower edge within a side and start again there: then the
// side is two spans.
void SliceColumn::addSide(const BlockSide& side, const SideView& view, int first, int last) {
    TexelColumn column = sideColumn(side, view, first, last);
    if (column.start >= kWholeTexture) column.start -= kWholeTexture;
    const auto steps = static_cast<std::uint64_t>(last - first - 1);
    if (column.start + steps * column.step >= kWholeTexture) {
        const std::uint64_t above = (kWholeTexture - column.start + column.step - 1) / column.step;
        const int turn = first + static_cast<int>(above);
        addSideRows(side, view, column, first, turn);
        column.start += above * column.step - kWholeTexture;
        first = turn;
    }
    addSideRows(side, view, column, first, last);
}

void SliceColumn::addSideRows(const BlockSide& side, const SideView& view,
                              const TexelColumn& column, int first, int last) {
    if (!side.layer || !view_.cuts) return addSideSpan(side, view, column, first, last);
    BlockSide piece = side;
    const auto add = [&](const TexelColumn& texels, int from, int to, bool layer) {
        piece.layer = layer;
        if (!layer) open.take(from, to);
        addSideSpan(piece, view, texels, from, to);
    };
    if (!side.texture->seeThrough) return cutOpaque(column, first, last, view_.cutMargin(), add);
    const TextureLevel& level = side.texture->levels[column.detail];
    const auto u = static_cast<int>((column.texels - level.texels.data()) >> level.bits);
    cutTexels(column, level.runs.of(u), first, last, view_.cutMargin(), add);
}

inline void SliceColumn::addSideSpan(const BlockSide& side, const SideView& view,
                                     const TexelColumn& column, int first, int last) {
    Span& span = add(What::side, first, last);
    span.face = side.face;
    span.layer = side.layer;
    span.glow = side.look->glow;
    span.along = side.shown(view);
    span.rise = {static_cast<std::int32_t>(side.rise / kPositionsPerRaw)};
    span.slide = side.slide;
    span.level = side.level;
    span.tiles = side.tile;
    span.image = side.look->texture;
    span.column = column;
}

void SliceColumn::seeThroughSide(const BlockSide& side, const SideView& view, int firstRow,
                                 int lastRow) {
    for (const OpenRows::Run& rows : open.within(firstRow, lastRow)) {
        if (countLayer()) addSide(side, view, rows.first, rows.last);
    }
}

void SliceColumn::seeThroughPlane(What what, const Plane& plane, int firstRow, int lastRow,
                                  const TileRange& tiles, int level) {
    for (const auto& [first, last] : open.within(firstRow, lastRow)) {
        if (!countLayer()) return;
        Span& span = addPlane(what, view_.lookOf(plane), first, last, tiles);
        span.face = what == What::roof ? Face::top : Face::bottom;
        span.level = level;
        span.layer = true;
    }
}

}  // namespace slicecast
