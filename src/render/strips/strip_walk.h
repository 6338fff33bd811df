// The walk of a strip's 16 columns together over the grid: each tile is examined once, front to
// back, for all columns that pass it. It finds what their rays meet, as spans.
//
//      +---+---+---+---+        The rays run mostly along the major axis, u. A slab is the
//      |   |   | . |.  |  ^     tiles between two borders of u. Within it the columns pass
//      |   | . |.' |   |  |     a few neighbouring tiles. Tiles are examined slab by slab,
//      | o:' ' |   |   |  v     and in a slab from the eye's row outward: for each column
//      +---+---+---+---+        that is front to back.
//        u -->
//
// A filled row is closed, so each pixel has one opaque span, and the walk of a column ends when no
// row is open. Columns go on behind portals and in mirrors by parts (parts.h): those that begin
// there alike walk together again. A single column is a strip, too.
//
// strip_walk.cpp        from part to part and from tile to tile
// strip_slabs.cpp       which columns pass which tiles of a slab
// strip_stretches.cpp   tiles that are divided: by plans and by objects, and the first one
// strip_ends.cpp        what lies outside the grid, or beyond all that can be met
// strip_meet.h          what is in a tile
#pragma once

#include "render/spans/plan_walk.h"
#include "render/strips/strip_meet.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace slicecast {

// The stretches of a column in a divided tile.
struct ColumnStretches {
    Stretch stretch;  // the present one
    PlanEdges edges;
    const PlanEdge* edge = nullptr;  // the next one
    Crossing leave;                  // how the tile is left
};

// Memory kept from strip to strip and from frame to frame.
struct StripScratch {
    OpenLanes::Scratch open;
    std::array<SliceSpans, kLanes> found;
    StripTile::Ends enters = StripTile::Ends(kLanes);
    StripTile::Ends leaves = StripTile::Ends(kLanes);
    std::vector<ColumnStretches> stretches = std::vector<ColumnStretches>(kLanes);
};

class StripWalk {
public:
    // `cut` examines the texels of see-through sides and objects, `whole` takes them as they are:
    // see PartView::cuts.
    enum class SeeThrough { whole, cut };

    // All must outlive the walk.
    StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report,
              SeeThrough seeThrough = SeeThrough::cut);

    // Finds what all rows of the columns [first, first + count) show, 1 to 16 of them; writes the
    // first elements of scratch.found.
    void find(int first, int count, bool withReflection = true);

private:
    template <std::size_t... index>
    StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report, SeeThrough seeThrough,
              std::index_sequence<index...>);

    // ---- strip_walk.cpp
    void walkParts(unsigned bits);
    unsigned beginAlike(unsigned bits);
    void walk(unsigned bits);
    void walkSlab();
    void visit(int v);
    bool areFull(unsigned bits) const;
    bool isAtEye(unsigned bits) const;
    unsigned crossing(int v);
    __attribute__((noinline)) unsigned withObjects(unsigned bits);
    void noticeChange(unsigned live);
    void countTiles(int lane, int v);

    // ---- strip_ends.cpp
    bool isBeyond(double along) const;
    bool isOutside(int lane) const;
    unsigned leavingSideways() const;
    TileRange endlessFrom(int lane) const;
    void endBeyond(unsigned bits, bool isOut);
    void endCover(unsigned bits, int v, bool isOut);
    void meetObjectsOutside();

    // ---- strip_slabs.cpp
    void findFarTiles();
    int farTile(int lane, double v) const;
    bool passOpenLand();

    // ---- strip_stretches.cpp
    void meetStretches(unsigned bits, std::uint32_t plans, std::uint32_t reached, TextureId floor,
                       TextureId ceiling);
    void beginStretches(unsigned bits, std::uint32_t plans);
    void findEdges(int lane, std::uint32_t plans);
    bool endStretch(int lane);
    bool goOnBehind(int lane);

    ColumnStretches& stretchesOf(int lane) { return scratch_.stretches[indexOf(lane)]; }
    bool isFirstTile(int v) const { return tile_.u == startU_ && v == startV_; }

    StripScratch& scratch_;
    PartView view_;
    StripRays rays_;
    OpenLanes open_;
    StripTile::Columns columns_;
    StripTile tile_;

    // Of the strip
    int first_ = 0;
    int count_ = 0;

    // Of the walk
    int startU_ = 0;  // the tile where it starts
    int startV_ = 0;
    bool startsInTile_ = false;  // as the eye does; else through a border
    double nextObject_ = 0.0;    // `along` of the nearest object that has not been met

    // Of the slab
    LaneValues nearV_;  // the tiles in which columns enter and leave it
    LaneValues farV_;
    bool slabIsOpen_ = false;  // nothing was met in this slab so far, nor in the last one
};

}  // namespace slicecast
