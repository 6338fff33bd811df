// One column of a strip: the spans that its walk has found, and what is its own on the way. The
// tiles that it passes are met for several columns at once (strip_tile.h).
//
// slice_column.cpp    spans, the parts of a column, and what lies beyond the grid
// slice_sides.cpp     sides of blocks
// slice_objects.cpp   objects
#pragma once

#include "render/column/object_cursor.h"
#include "render/column/part_view.h"
#include "render/spans/slice_spans.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

// Where a column sees the sides at a border.
struct SideView {
    std::uint32_t fraction;  // of a tile, from its northern or western end, in 1/2^32
    double along;            // see Crossing
    double depth;            // units
    double brightness;       // see Lighting
    std::uint32_t fog;
};

// Rounding may put a point on the border of two texels just before it: positions are moved on by
// this part of a tile, far less than a pixel and far more than the rounding error.
inline constexpr double kSideSnap = 1.0 / 17179869184.0;
inline std::uint32_t fractionBits(double fraction) {
    constexpr double kEnd = 4294967295.0;  // of 1 << 32
    return static_cast<std::uint32_t>(
        std::min(kEnd, std::max(0.0, fraction + kSideSnap) * 4294967296.0));
}

// A side of a block, for any column. Positions are along the texture, as in TexelColumn.
struct BlockSide {
    const FaceBlueprint* look;
    const FrameTexture* texture;
    int level;
    Face face;
    bool layer;
    bool reversed;       // its texture's columns run northward or westward
    double upperEdge;    // of the level, above the eye, units
    std::int64_t start;  // the block's part of the level
    std::int64_t end;
    std::int64_t rise;
    std::uint32_t least = 0;  // what the block covers of its tile, in 1/2^32: both included
    std::uint32_t most = 0xffffffff;
    Coordinate slide = {};  // of its texture, eastward or southward
    TileRange tile = {};

    // Where a column sees it.
    std::uint32_t shown(const SideView& view) const {
        return std::clamp(view.fraction, least, most);
    }
};

// The side of a block in a tile.
BlockSide sideOf(const PartView& view, const Block& block, Face face, const TileRange& tile,
                 bool layer);

class SliceColumn {
public:
    using What = FilledRows::What;

    // All must outlive the column; `open` keeps its memory from slice to slice.
    __attribute__((noinline))
    SliceColumn(const PartView& view, OpenRows& open, FrameReport& report);

    // Makes the first part of a column.
    void begin(int column, SliceSpans& found);
    // Makes parts of what the column's mirrors show: each mirror becomes one of an upside-down
    // column. False without mirrors.
    bool beginReflection(SliceSpans& found);
    // Stands before the first tile of the present part, at which the view looks. `nearest` is the
    // least place along their rays where columns begin that walk together.
    void beginPart(double nearest);
    // False if the present part was the last one.
    bool endPart();
    const Part& part() const { return found_->parts[static_cast<std::size_t>(part_)]; }
    void countTiles(int tiles);

    // Before these, `open` holds the column's open rows.
    void endBeyond(TextureId floor, const TileRange& tiles);
    void meetObjectsBefore(double along, TextureId floor, const TileRange& tiles);
    void sendThrough(PortalId id, Vista& beyond, int first, int last, int hazeRow,
                     const HeightClip& clip, const Before& before);
    void endInPortal() { found_->parts[static_cast<std::size_t>(part_)].endsInPortal = true; }

    Span& add(What what, int first, int last);
    Span& addPlane(What what, PlaneLook& look, int first, int last, const TileRange& tiles);
    __attribute__((noinline)) void addFace(What what, PlaneLook& look, int first, int last,
                                           const TileRange& tiles, int level);
    void addFloor(TextureId texture, int first, int last, const TileRange& tiles);
    void mirror(std::int32_t rise, int first, int last, int strength, int ripples);
    bool countLayer();  // false if the column is full
    bool isFull() const { return found_->isFull(); }

    // ---- slice_sides.cpp
    void addSide(const BlockSide& side, const SideView& view, int first, int last);
    // These add layers to the open ones of some rows.
    void seeThroughSide(const BlockSide& side, const SideView& view, int firstRow, int lastRow);
    void seeThroughPlane(What what, const Plane& plane, int firstRow, int lastRow,
                         const TileRange& tiles, int level = kNoLevel);

    // ---- slice_objects.cpp
    // Adds what the column sees of the next object, and goes on behind it.
    void meetObject();

    int number = 0;  // of the picture's columns
    GroundDirection ray;
    GridWalk walk{{}, {}, {}};
    ObjectCursor objects;
    OpenRows& open;

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    TexelColumn sideColumn(const BlockSide& side, const SideView& view, int first, int last) const;
    void addSideRows(const BlockSide& side, const SideView& view, const TexelColumn& column,
                     int first, int last);
    void addSideSpan(const BlockSide& side, const SideView& view, const TexelColumn& column,
                     int first, int last);
    void takeFloor(int row, TextureId floor, const TileRange& tiles);

    const PartView& view_;
    FrameReport& report_;
    ColumnSpans* found_ = nullptr;
    int part_ = 0;                   // index of the part
    int tiles_ = 0;                  // tiles of the part so far
    std::size_t floorSpan_ = kNone;  // the last floor span of the part
};

inline Span& SliceColumn::add(What what, int first, int last) {
    Span& span = found_->spans.add();
    span.what = what;
    span.face = Face::top;
    span.layer = false;
    span.first = first;
    span.last = last;
    span.level = kNoLevel;
    span.object = -1;
    span.part = part_;
    span.portals = view_.portals;
    span.vista = view_.vista;
    return span;
}

inline Span& SliceColumn::addPlane(What what, PlaneLook& look, int first, int last,
                                   const TileRange& tiles) {
    Span& span = add(what, first, last);
    span.look = &look;
    span.tiles = tiles;
    return span;
}

inline bool SliceColumn::countLayer() {
    if (isFull()) return false;
    ++found_->layers;
    return true;
}

}  // namespace slicecast
